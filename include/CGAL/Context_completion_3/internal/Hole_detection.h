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
    for(std::size_t k = 0; k < order.size(); ++k)
    {
      const std::size_t l = order[k];
      if(progress && !progress(double(k) / double(order.size())))
        return false;
      if(is_used[l])
        continue;
      std::vector<std::size_t> group(1, l);
      const std::size_t partner = facing_loop(loops, is_used, l);
      if(partner != no_index)
        group.push_back(partner);
      else if(loops[l].opening(m_model.points(), loops[l].center) < least_opening())
      {
        // does not open towards its own centre: the border of a sheet or of an island, the end of a tube
        if(loops[l].points.size() >= fewest_border_points())
        {
          Hole border;
          border.loops.push_back(loops[l]);
          border.is_outer_border = true;
          holes.push_back(border);
        }
        is_used[l] = 1;
        continue;
      }
      std::shared_ptr<const Patch> patch = base(loops, group);
      for(int round = 0; round < 2 && patch->is_closed(); ++round)
        if(!take_in_reached(loop_of_point, is_used, *patch, group))
          break;
        else
          patch = base(loops, group);
      for(std::size_t g : group)
        is_used[g] = 1;
      Hole hole;
      hole.loops = patch->loops();
      hole.patch = patch;
      hole.is_outer_border = !patch->is_closed();
      if(hole.is_outer_border ? loops[l].points.size() >= fewest_border_points() : is_evident(*patch))
        holes.push_back(hole);
    }
    return true;
  }

private:
  // A hole has room for some points between its rims, and these go around it: at least half of its circumference is
  // found. Irregular samplings have groups of rim points that face each other over a covered place.
  static bool is_evident(const Patch& patch)
  {
    return patch.number_of_uncovered() >= 4 && patch.rim().size() >= 8 &&
           double(patch.rim().size()) * patch.spacing() >= patch.diameter();
  }

  // the end of a tube is a ring
  static std::size_t fewest_tube_points() { return 6; }

  // mean cosine; a hole in a sphere reaches it when it takes off nearly half of it
  static double least_opening() { return 0.25; }

  // shorter rims that bound nothing are irregularities of the sampling
  static std::size_t fewest_border_points() { return 12; }

  std::shared_ptr<const Patch> base(const std::vector<Rim_loop>& loops, const std::vector<std::size_t>& group) const
  {
    std::vector<Rim_loop> members;
    for(std::size_t g : group)
      members.push_back(loops[g]);
    return std::make_shared<const Patch>(m_model, members);
  }

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
