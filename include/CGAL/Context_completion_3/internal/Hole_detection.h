// Copyright (c) 2026 The Context_completion_3 authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Context_completion_3 authors

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_DETECTION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_DETECTION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// An under-sampled place, with the base over it.
template <typename ConcurrencyTag>
struct Detected_hole
{
  std::vector<Rim_loop> loops;
  std::shared_ptr<const Smooth_patch<ConcurrencyTag> > patch;   ///< none where the rim opens outwards
  bool is_outer_border = false;
};

/*!
  Joins loops to holes. A hole is a set of rims whose common smooth base ends at them everywhere and is not covered by
  points; a rim whose base runs away is an outer border of the surface; a rim whose base is covered is no rim at all
  (sharp edges raise many).
*/
template <typename ConcurrencyTag>
class Hole_detection
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Detected_hole<ConcurrencyTag> Hole;

public:
  explicit Hole_detection(const Model& model) : m_model(model) {}

  /// \param progress called with the fraction done; `false` stops. \return whether it ran to its end
  bool run(std::vector<Hole>& holes, const std::function<bool(double)>& progress) const
  {
    const std::vector<Rim_loop> loops = Rim_detection<ConcurrencyTag>(m_model).loops();
    std::vector<std::size_t> loop_of_point(m_model.size(), no_index);
    for(std::size_t l = 0; l < loops.size(); ++l)
      for(const Rim_point& p : loops[l].points)
        loop_of_point[p.index] = l;
    std::vector<char> is_used(loops.size(), 0);
    // Large rims first: islands and fragments are then taken in by the hole that they belong to.
    std::vector<std::size_t> order(loops.size());
    for(std::size_t l = 0; l < loops.size(); ++l)
      order[l] = l;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b)
      { return loops[a].diameter > loops[b].diameter; });
    // whole rims before pieces: a piece must not take in a rim that has its own hole
    std::vector<std::size_t> left;
    for(std::size_t k = 0; k < order.size(); ++k)
    {
      if(progress && !progress(double(k) / double(2 * order.size())))
        return false;
      std::vector<std::size_t> group;
      if(is_used[order[k]])
        continue;
      if(const auto patch = base_of_whole_rim(loops, loop_of_point, is_used, order[k], group))
        add_hole(patch, group, is_used, holes);
      else
        left.push_back(order[k]);
    }
    // the border of a sheet or of an island, the end of a tube, or a piece of a rim
    for(std::size_t k = 0; k < left.size(); ++k)
    {
      if(progress && !progress(0.5 + double(k) / double(2 * left.size())))
        return false;
      std::vector<std::size_t> group;
      const Rim_loop& loop = loops[left[k]];
      if(is_used[left[k]] || loop.points.size() < fewest_rim_points())
        continue;
      if(const auto patch = base_of_broken_rim(loops, loop_of_point, is_used, left[k], group))
        add_hole(patch, group, is_used, holes);
      else if(loop.points.size() >= fewest_border_points())
      {
        Hole border;
        border.loops.push_back(loop);
        border.is_outer_border = true;
        holes.push_back(border);
      }
    }
    return true;
  }

private:
  static void add_hole(const std::shared_ptr<const Patch>& patch, const std::vector<std::size_t>& group,
                       std::vector<char>& is_used, std::vector<Hole>& holes)
  {
    for(std::size_t g : group)
      is_used[g] = 1;
    if(!is_evident(*patch))
      return;
    Hole hole;
    hole.loops = patch->loops();
    hole.patch = patch;
    holes.push_back(hole);
  }

  // A hole has room for some points between its rims, and these go around it: at least half of its circumference is
  // found. Irregular samplings have groups of rim points that face each other over a covered place.
  static bool is_evident(const Patch& patch)
  {
    return patch.number_of_uncovered() >= 4 && patch.rim().size() >= fewest_rim_points() &&
           double(patch.rim().size()) * patch.spacing() >= patch.diameter();
  }

  static std::size_t fewest_rim_points() { return 8; }

  // the end of a tube is a ring
  static std::size_t fewest_tube_points() { return 6; }

  // Mean cosine, of directions or of normals; a hole in a sphere reaches it when it takes off nearly half of it.
  static double least_opening() { return 0.25; }

  // The base continues the surface at the rim, on the whole; the end of a tube would have to be capped across.
  bool is_faced(const Patch& patch) const
  {
    Vector mean = Vector::Zero();
    for(const Base_sample& s : patch.samples())
      mean += s.normal;
    double sum = 0;
    for(std::size_t i : patch.rim())
      sum += m_model.normal(i).dot(mean.normalized());
    return sum >= least_opening() * double(patch.rim().size());
  }

  // shorter rims that bound nothing are irregularities of the sampling
  static std::size_t fewest_border_points() { return 12; }

  // The base over some loops and those that its sampling arrives at; none if it runs off.
  std::shared_ptr<const Patch> closed_base(const std::vector<Rim_loop>& loops,
                                           const std::vector<std::size_t>& loop_of_point,
                                           const std::vector<char>& is_used, std::vector<std::size_t>& group,
                                           bool is_stiff = false) const
  {
    for(int round = 0; ; ++round)
    {
      std::vector<Rim_loop> members;
      for(std::size_t g : group)
        members.push_back(loops[g]);
      const std::shared_ptr<const Patch> patch = std::make_shared<const Patch>(m_model, members, is_stiff);
      if(!patch->is_closed())
        return nullptr;
      if(round == 2 || !take_in_reached(loop_of_point, is_used, *patch, group))
        return patch;
    }
  }

  // A rim, alone or with the other end of a cut tube.
  std::shared_ptr<const Patch> base_of_whole_rim(const std::vector<Rim_loop>& loops,
                                                 const std::vector<std::size_t>& loop_of_point,
                                                 const std::vector<char>& is_used, std::size_t l,
                                                 std::vector<std::size_t>& group) const
  {
    const std::size_t partner = facing_loop(loops, is_used, l);
    if(partner != no_index)
    {
      group = { l, partner };
      if(const auto patch = closed_base(loops, loop_of_point, is_used, group))
        return patch;
    }
    group.assign(1, l);
    const double opening = loops[l].opening(m_model.points(), loops[l].center);
    // turned away altogether: the border of a sheet or of an island
    if(opening < -least_opening())
      return nullptr;
    const auto patch = closed_base(loops, loop_of_point, is_used, group);
    // neither this nor that: the end of a tube, or the rim of a hole around sharp edges
    if(patch && opening < least_opening() &&
       (!is_faced(*patch) || 2 * patch->number_of_uncovered() < patch->samples().size()))
      return nullptr;
    return patch;
  }

  // A rim that sharp edges cut into pieces: each piece alone lets the base run off, or opens to nowhere. Loops that
  // open towards a common place are added, the nearest first, until the base is closed. Relief or edges at a whole rim
  // can lead the base away, too, which a stiff one resists.
  std::shared_ptr<const Patch> base_of_broken_rim(const std::vector<Rim_loop>& loops,
                                                  const std::vector<std::size_t>& loop_of_point,
                                                  const std::vector<char>& is_used, std::size_t l,
                                                  std::vector<std::size_t>& group) const
  {
    group.assign(1, l);
    for(std::size_t n = 0; n < most_fragments(); ++n)
    {
      const std::size_t next = nearest_fragment(loops, is_used, group);
      if(next == no_index)
        break;
      group.push_back(next);
      std::vector<std::size_t> joined = group;
      const auto patch = closed_base(loops, loop_of_point, is_used, joined, true);
      if(patch && is_evident(*patch) && is_faced(*patch))
      {
        group = joined;
        return patch;
      }
    }
    group.assign(1, l);
    if(loops[l].opening(m_model.points(), loops[l].center) < least_opening())
      return nullptr;
    const auto patch = closed_base(loops, loop_of_point, is_used, group, true);
    return patch && is_faced(*patch) ? patch : nullptr;
  }

  std::size_t nearest_fragment(const std::vector<Rim_loop>& loops, const std::vector<char>& is_used,
                               const std::vector<std::size_t>& group) const
  {
    std::size_t best = no_index;
    double shortest = 0;
    for(std::size_t m = 0; m < loops.size(); ++m)
    {
      const double reach = loops[group.front()].diameter;
      if(is_used[m] || std::find(group.begin(), group.end(), m) != group.end() ||
         (loops[m].center - loops[group.front()].center).norm() > reach + loops[m].diameter)
        continue;
      std::vector<Rim_loop> members(1, loops[m]);
      for(std::size_t g : group)
        members.push_back(loops[g]);
      if(!open_to_each_other(members))
        continue;
      const double gap = distance(loops[m], loops[group.front()]);
      if(gap <= reach && (best == no_index || gap < shortest))
      {
        best = m;
        shortest = gap;
      }
    }
    return best;
  }

  // The outward directions meet in a place that all of them lead to. At an acute edge this is not the centre of the rim:
  // both sides lead to the edge.
  bool open_to_each_other(const std::vector<Rim_loop>& members) const
  {
    Vector center = Vector::Zero(), right = Vector::Zero();
    Matrix sum = Matrix::Zero();
    std::size_t number = 0;
    for(const Rim_loop& loop : members)
      for(const Rim_point& p : loop.points)
      {
        const Matrix across = Matrix::Identity() - p.outward * p.outward.transpose();
        sum += across;
        right += across * m_model.position(p.index);
        center += m_model.position(p.index);
        ++number;
      }
    center /= double(number);
    // keeps the place near where all directions are parallel
    const double weight = 0.01 * double(number);
    const Vector place = (sum + weight * Matrix::Identity()).ldlt().solve(right + weight * center);
    return std::all_of(members.begin(), members.end(), [&](const Rim_loop& loop) {
      return loop.opening(m_model.points(), place) >= least_opening(); });
  }

  double distance(const Rim_loop& a, const Rim_loop& b) const
  {
    double shortest = (a.center - b.center).norm();
    for(const Rim_point& p : a.points)
      for(const Rim_point& q : b.points)
        shortest = (std::min)(shortest, (m_model.position(p.index) - m_model.position(q.index)).norm());
    return shortest;
  }

  static std::size_t most_fragments() { return 4; }

  // The other end of a tube that was cut through: both rims open towards each other.
  std::size_t facing_loop(const std::vector<Rim_loop>& loops, const std::vector<char>& is_used, std::size_t l) const
  {
    const Rim_loop& a = loops[l];
    if(a.points.size() < fewest_tube_points() || a.opening(m_model.points(), a.center) > 0.6)
      return no_index;
    std::size_t best = no_index;
    double shortest = 0;
    for(std::size_t m = 0; m < loops.size(); ++m)
    {
      const Rim_loop& b = loops[m];
      if(m == l || is_used[m] || b.points.size() < fewest_tube_points() || b.diameter < 0.4 * a.diameter)
        continue;
      const double distance = (a.center - b.center).norm();
      if(distance > 2.5 * a.diameter || a.opening(m_model.points(), b.center) < 0.6 ||
         b.opening(m_model.points(), a.center) < 0.6)
        continue;
      if(best == no_index || distance < shortest)
      {
        best = m;
        shortest = distance;
      }
    }
    return best;
  }

  // rims that the sampling of the base arrived at
  bool take_in_reached(const std::vector<std::size_t>& loop_of_point, const std::vector<char>& is_used,
                       const Patch& patch, std::vector<std::size_t>& group) const
  {
    const std::size_t before = group.size();
    for(std::size_t i : patch.reached())
    {
      const std::size_t m = loop_of_point[i];
      if(m != no_index && !is_used[m] && std::find(group.begin(), group.end(), m) == group.end())
        group.push_back(m);
    }
    return group.size() > before;
  }

  const Model& m_model;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_DETECTION_H
