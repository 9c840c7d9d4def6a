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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_GROUPING_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_GROUPING_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Angular_gap.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Tells which loops may bound one hole: the two ends of a cut tube, the pieces of a broken rim, an island. A loop that
  is used by a hole is not proposed again.
*/
template <typename ConcurrencyTag>
class Rim_grouping
{
  typedef Surface_model<ConcurrencyTag> Model;

public:
  /// \param loops as found by `Rim_detection`; not copied
  Rim_grouping(const Model& model, const std::vector<Rim_loop>& loops)
    : m_model(model), m_loops(loops), m_loop_of_point(model.size(), no_index), m_is_used(loops.size(), 0)
  {
    for(std::size_t l = 0; l < loops.size(); ++l)
      for(const Rim_point& p : loops[l].points)
        m_loop_of_point[p.index] = l;
    join_pieces();
  }

  bool is_used(std::size_t l) const { return m_is_used[l]; }

  void use(const std::vector<std::size_t>& group)
  {
    for(std::size_t l : group)
      m_is_used[l] = 1;
  }

  /// The same for the loops that some points belong to.
  void use_points(const std::vector<std::size_t>& points)
  {
    for(std::size_t i : points)
      if(m_loop_of_point[i] != no_index)
        m_is_used[m_loop_of_point[i]] = 1;
  }

  /// Mean cosine, of directions or of normals; a hole in a sphere reaches it when it takes off nearly half of it.
  static double least_opening() { return 0.25; }

  /// Loops that follow each other over short gaps, as the pieces of a rim do that edges cut; those in use are left out.
  std::vector<std::size_t> pieces_of_rim(std::size_t l) const
  {
    std::vector<std::size_t> pieces;
    for(std::size_t m = 0; m < m_loops.size(); ++m)
      if(m_rim_of_loop[m] == m_rim_of_loop[l] && !m_is_used[m])
        pieces.push_back(m);
    return pieces;
  }

  /// Whether some loops are pieces of one rim, over short gaps, or too small to be the end of a tube.
  bool is_one_rim(const std::vector<std::size_t>& group) const
  {
    return std::all_of(group.begin(), group.end(), [&](std::size_t l)
    {
      return m_loops[l].points.size() < fewest_tube_points() || m_rim_of_loop[l] == m_rim_of_loop[group.front()];
    });
  }

  /// Whether some loops together open towards their centre, and more so than to one side, as pieces of a border do.
  bool surrounds_hole(const std::vector<std::size_t>& group) const
  {
    const Rim_loop rim = joined(group);
    const double to_center = opening(rim, rim.center);
    return to_center >= least_opening() && to_center > sum_of_outward(rim).norm() / double(rim.points.size());
  }

  /// Some loops as one.
  Rim_loop joined(const std::vector<std::size_t>& group) const
  {
    Rim_loop result;
    for(std::size_t l : group)
      result.points.insert(result.points.end(), m_loops[l].points.begin(), m_loops[l].points.end());
    result.measure(m_model.points());
    return result;
  }

  /*!
    What can be the other side of a tube that was cut through: of two ends that open towards each other, or of an end
    that points at a rim in the surface from which the tube rises, a limb from a body or a bore from a wall.
    \return single loops and rims of several pieces, the nearest first
  */
  std::vector<std::vector<std::size_t> > facing_rims(const std::vector<std::size_t>& rim) const
  {
    const Rim_loop a = joined(rim);
    std::vector<std::pair<double, std::vector<std::size_t> > > found;
    if(a.points.size() < fewest_tube_points())
      return {};
    const auto consider = [&](const std::vector<std::size_t>& group)
    {
      const Rim_loop b = joined(group);
      const double distance = (a.center - b.center).norm();
      // a hole in a body can be far wider than the limb that it cuts off
      const double smallest = a.diameter * (rises(b, a) ? 0.2 : 0.4);
      if(b.points.size() >= fewest_tube_points() && b.diameter >= smallest && distance <= 2.5 * a.diameter &&
         (are_ends(a, b) || rises(a, b) || rises(b, a)))
        found.emplace_back(distance, group);
    };
    for(std::size_t m = 0; m < m_loops.size(); ++m)
    {
      if(m_is_used[m] || std::find(rim.begin(), rim.end(), m) != rim.end())
        continue;
      consider(std::vector<std::size_t>(1, m));
      const std::vector<std::size_t> pieces = pieces_of_rim(m);
      if(pieces.size() > 1 && pieces.front() == m && m_rim_of_loop[m] != m_rim_of_loop[rim.front()])
        consider(pieces);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    std::vector<std::vector<std::size_t> > result;
    for(const auto& f : found)
      result.push_back(f.second);
    return result;
  }

  /// The nearest loop that opens towards the same place as all of `group`; `no_index` if there is none.
  std::size_t nearest_fragment(const std::vector<std::size_t>& group) const
  {
    std::size_t best = no_index;
    double shortest = 0;
    for(std::size_t m = 0; m < m_loops.size(); ++m)
    {
      const double reach = m_loops[group.front()].diameter;
      if(m_is_used[m] || std::find(group.begin(), group.end(), m) != group.end() ||
         (m_loops[m].center - m_loops[group.front()].center).norm() > reach + m_loops[m].diameter)
        continue;
      std::vector<Rim_loop> members(1, m_loops[m]);
      for(std::size_t g : group)
        members.push_back(m_loops[g]);
      if(!open_to_each_other(members))
        continue;
      const double gap = distance(m_loops[m], m_loops[group.front()]);
      if(gap <= reach && (best == no_index || gap < shortest))
      {
        best = m;
        shortest = gap;
      }
    }
    return best;
  }

  /// Adds the loops of some points that the sampling of a base arrived at. \return whether there are any
  bool take_in_reached(const std::vector<std::size_t>& points, std::vector<std::size_t>& group) const
  {
    const std::size_t before = group.size();
    for(std::size_t i : points)
    {
      const std::size_t m = m_loop_of_point[i];
      if(m != no_index && !m_is_used[m] && std::find(group.begin(), group.end(), m) == group.end())
        group.push_back(m);
    }
    return group.size() > before;
  }

private:
  // A gap in which one more link would stand.
  void join_pieces()
  {
    std::vector<std::size_t> index;
    std::vector<Vector> positions;
    m_rim_of_loop.resize(m_loops.size());
    std::iota(m_rim_of_loop.begin(), m_rim_of_loop.end(), std::size_t(0));
    for(const Rim_loop& loop : m_loops)
      for(const Rim_point& p : loop.points)
      {
        index.push_back(p.index);
        positions.push_back(m_model.position(p.index));
      }
    const Neighbor_search search(positions);
    std::vector<std::size_t> ball;
    for(std::size_t i : index)
    {
      search.in_ball(m_model.position(i), 4 * m_model.gap_spacing(i), ball);
      for(std::size_t j : ball)
      {
        const std::size_t a = m_rim_of_loop[m_loop_of_point[i]], b = m_rim_of_loop[m_loop_of_point[index[j]]];
        if(a != b)
          std::replace(m_rim_of_loop.begin(), m_rim_of_loop.end(), (std::max)(a, b), (std::min)(a, b));
      }
    }
  }

  // the end of a tube is a ring
  static std::size_t fewest_tube_points() { return 6; }

  double opening(const Rim_loop& loop, const Vector& target) const { return loop.opening(m_model.points(), target); }

  static Vector sum_of_outward(const Rim_loop& loop)
  {
    Vector sum = Vector::Zero();
    for(const Rim_point& p : loop.points)
      sum += p.outward;
    return sum;
  }

  // A rim in a surface opens towards its own centre, that of an end less so.
  bool is_end(const Rim_loop& loop) const { return opening(loop, loop.center) <= 0.6; }

  // Both open more towards each other than towards their own centres. Where a cut meets the flank of a relief all around,
  // the rim leads off to all sides of the way to the other, on which the mean still does.
  bool are_ends(const Rim_loop& a, const Rim_loop& b) const
  {
    const Vector way = (b.center - a.center).normalized();
    const double ab = (std::max)(opening(a, b.center), way.dot(sum_of_outward(a)) / double(a.points.size()));
    const double ba = (std::max)(opening(b, a.center), -way.dot(sum_of_outward(b)) / double(b.points.size()));
    return ab > opening(a, a.center) && ba > opening(b, b.center) && (std::min)(ab, ba) >= 0.4 && ab + ba >= 1.1;
  }

  // The axis of an end leads through the rim, which opens towards the end, and both bound the same side of the surface.
  bool rises(const Rim_loop& end, const Rim_loop& rim) const
  {
    Vector axis = sum_of_outward(end);
    const double length = axis.norm();
    if(!is_end(end) || length < 0.6 * double(end.points.size()))
      return false;
    axis /= length;
    if(!is_ring(end, axis))
      return false;
    const Vector between = rim.center - end.center;
    const double along = between.dot(axis);
    return along > 0 && (between - along * axis).norm() < 0.5 * (std::max)(end.diameter, rim.diameter) &&
           opening(rim, end.center) >= least_opening() &&
           side(end, end.center, axis) * side(rim, end.center, axis) > 0;
  }

  // all around the axis, without the gap that a piece of a border has
  bool is_ring(const Rim_loop& loop, const Vector& axis) const
  {
    const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
    std::vector<double> angles;
    for(const Rim_point& p : loop.points)
    {
      const Vector d = m_model.position(p.index) - loop.center;
      angles.push_back(std::atan2(d.dot(v), d.dot(u)));
    }
    return Angular_gap(angles).width < 0.5 * 3.14159265358979323846;
  }

  // Positive if the normals turn away from the axis, as around a limb, and against its direction, as where a limb rises.
  // This counts more, since a rim can go over the edges of a body into which a bore leads.
  double side(const Rim_loop& loop, const Vector& origin, const Vector& axis) const
  {
    double sum = 0;
    for(const Rim_point& p : loop.points)
    {
      const Vector d = m_model.position(p.index) - origin;
      sum += m_model.normal(p.index).dot((d - d.dot(axis) * axis).normalized() - 2 * axis);
    }
    return sum;
  }

  // The outward directions meet in a place that all of them lead to. At an acute edge this is not the centre of the
  // rim: both sides lead to the edge.
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
    const Vector place = solve_damped_system(sum + weight * Matrix::Identity(), right + weight * center);
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

  const Model& m_model;
  const std::vector<Rim_loop>& m_loops;
  std::vector<std::size_t> m_loop_of_point;
  std::vector<std::size_t> m_rim_of_loop;   // the smallest of the loops that are pieces of one rim
  std::vector<char> m_is_used;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_GROUPING_H
