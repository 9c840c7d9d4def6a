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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_CYCLES_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_CYCLES_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A closed way along a rim, with the empty place on its left.
struct Rim_cycle
{
  /*!
    How the way turns to the left within the surface, in full turns. By the theorem of Gauss and Bonnet what is missing has
    a curvature of one turn less: 1 if a plane goes on, 0 if it is an end, as of a tube or a horn, -1 around a sheet or
    an island.
  */
  double turns = 0;

  /// The same on the surface as it is in the mean over 0.15 diameters. The flanks of a relief turn normals to and fro, and
  /// `turns` with them; the mean surface ends a little before the rim.
  double smooth_turns = 0;

  double leaning = 0;   ///< share of points whose direction into the empty place leans to the normal, by a cosine above 0.3
  Rim_loop rim;         ///< the points of the way and those beside it

  /// Whether a smooth surface may go on over the place, by turns that agree. Three eighths are the bound by which borders of
  /// meshes are told, too. Around a mouth of a bore in which there are no points, normals at the edge are between those of
  /// its faces, and lean.
  bool bounds_hole() const
  {
    return (std::max)(turns, smooth_turns) >= 3. / 8 && std::abs(turns - smooth_turns) <= 1. / 4 && leaning <= 0.5;
  }
};

/*!
  The closed ways along the points of a loop. A loop may have several: that of an island; and that of a border to which the
  rim of a hole is tied, by a narrow strip of the surface or along an acute edge.
*/
template <typename ConcurrencyTag>
class Rim_cycles
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                boost::property<boost::edge_weight_t, double> > Graph;

public:
  /// \param loop not copied
  Rim_cycles(const Model& model, const Rim_loop& loop)
    : m_model(model), m_loop(loop), m_beside(loop.points.size()), m_steps(loop.points.size())
  {
    link();
  }

  /// Of each point that is not beside a way before it, the shortest way from it to itself, unless it is for the most part one
  /// of those.
  std::vector<Rim_cycle> cycles() const
  {
    std::vector<Rim_cycle> result;
    std::vector<char> is_passed(m_loop.points.size(), 0);
    for(std::size_t start = 0; start < m_loop.points.size(); ++start)
    {
      if(is_passed[start])
        continue;
      const std::vector<std::size_t> way = shortest_way(start);
      if(way.empty())
        continue;
      const std::vector<std::size_t> members = with_points_beside(way);
      std::size_t again = 0;
      for(std::size_t p : members)
      {
        again += is_passed[p];
        is_passed[p] = 1;
      }
      if(2 * again <= members.size())
        result.push_back(cycle(way, members));
    }
    return result;
  }

private:
  // in area spacings: of steps of a way, of points beside it
  static constexpr double longest_step() { return 3; }
  static constexpr double farthest_beside() { return 1.7; }

  Vector position(std::size_t p) const { return m_model.position(m_loop.points[p].index); }
  const Vector& normal(std::size_t p) const { return m_model.normal(m_loop.points[p].index); }

  // with the empty place on the left
  Vector direction(std::size_t p) const { return m_loop.points[p].outward.cross(normal(p)); }

  // A step leads on at both ends. The squared length makes short steps cheap, so that the way passes most points.
  void link()
  {
    std::vector<Vector> positions;
    for(const Rim_point& p : m_loop.points)
      positions.push_back(m_model.position(p.index));
    const Neighbor_search search(positions);
    std::vector<std::size_t> near;
    for(std::size_t a = 0; a < positions.size(); ++a)
    {
      const double h = m_model.gap_spacing(m_loop.points[a].index);
      search.in_ball(positions[a], longest_step() * h, near);
      for(std::size_t b : near)
      {
        if(b == a || !is_same_side(normal(a), normal(b)))
          continue;
        const Vector step = positions[b] - positions[a];
        if(step.norm() < farthest_beside() * h && m_loop.points[a].outward.dot(m_loop.points[b].outward) > 0)
          m_beside[a].push_back(b);
        if(step.dot(direction(a)) > 0 && step.dot(direction(b)) > 0)
          boost::add_edge(a, b, step.squaredNorm() / (h * h), m_steps);
      }
    }
  }

  // none if no way leads back
  std::vector<std::size_t> shortest_way(std::size_t start) const
  {
    const std::size_t n = m_loop.points.size();
    std::vector<double> length(n);
    std::vector<std::size_t> before(n);
    boost::dijkstra_shortest_paths(m_steps, start,
                                   boost::predecessor_map(before.data()).distance_map(length.data()));
    std::size_t last = no_index;
    double shortest = 0;
    for(std::size_t p = 0; p < n; ++p)
    {
      if(before[p] == p)   // the start, and what no way leads to
        continue;
      const auto step = boost::edge(p, start, m_steps);
      if(!step.second)
        continue;
      const double closed = length[p] + boost::get(boost::edge_weight, m_steps, step.first);
      if(last == no_index || closed < shortest)
      {
        shortest = closed;
        last = p;
      }
    }
    std::vector<std::size_t> way;
    if(last == no_index)
      return way;
    for(std::size_t p = last; p != start; p = before[p])
      way.push_back(p);
    way.push_back(start);
    std::reverse(way.begin(), way.end());
    return way;
  }

  // in increasing order
  std::vector<std::size_t> with_points_beside(const std::vector<std::size_t>& way) const
  {
    std::vector<std::size_t> members = way;
    for(std::size_t p : way)
      members.insert(members.end(), m_beside[p].begin(), m_beside[p].end());
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members;
  }

  Rim_cycle cycle(const std::vector<std::size_t>& way, const std::vector<std::size_t>& members) const
  {
    Rim_cycle result;
    for(std::size_t p : members)
    {
      result.rim.points.push_back(m_loop.points[p]);
      if(std::abs(m_loop.points[p].outward.dot(normal(p))) > 0.3)
        result.leaning += 1 / double(members.size());
    }
    result.rim.measure(m_model.points());
    std::vector<Surface_element> exact, smooth;
    for(std::size_t p : way)
    {
      exact.emplace_back();
      exact.back().position = position(p);
      exact.back().normal = normal(p);
      smooth.push_back(mean_element(p, 0.15 * result.rim.diameter));
    }
    result.turns = turns(way, exact);
    result.smooth_turns = turns(way, smooth);
    return result;
  }

  // of the surface around a point
  Surface_element mean_element(std::size_t p, double radius) const
  {
    std::vector<std::size_t> ball;
    m_model.search().in_ball(position(p), radius, ball);
    Surface_element sum;
    std::size_t number = 0;
    for(std::size_t i : ball)
      if(is_same_side(normal(p), m_model.normal(i)))
      {
        sum.position += m_model.position(i);
        sum.normal += m_model.normal(i);
        ++number;
      }
    sum.position /= double(number);   // the point itself is one of them
    sum.normal.normalize();
    return sum;
  }

  // From the direction at each point to the step, and from this to the direction at the next one: neither is a right angle.
  // \param places parallel to the way
  double turns(const std::vector<std::size_t>& way, const std::vector<Surface_element>& places) const
  {
    double sum = 0;
    for(std::size_t k = 0; k < way.size(); ++k)
    {
      const std::size_t next = (k + 1) % way.size();
      const Vector before = m_loop.points[way[k]].outward.cross(places[k].normal);
      const Vector after = m_loop.points[way[next]].outward.cross(places[next].normal);
      const Vector step = places[next].position - places[k].position;
      sum += angle(before, step, places[k].normal) + angle(step, after, places[next].normal);
    }
    return sum / (2 * 3.14159265358979323846);
  }

  // in the tangent plane, positive to the left
  static double angle(const Vector& from, const Vector& to, const Vector& n)
  {
    const Vector u = from - from.dot(n) * n, v = to - to.dot(n) * n;
    return std::atan2(n.dot(u.cross(v)), u.dot(v));
  }

  const Model& m_model;
  const Rim_loop& m_loop;
  std::vector<std::vector<std::size_t> > m_beside;   // near and led the same way, per point
  Graph m_steps;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_CYCLES_H
