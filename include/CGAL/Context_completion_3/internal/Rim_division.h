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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_DIVISION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_DIVISION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Rim_detection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Divides the rim points of a loop that bounds no hole: where a narrow strip of the surface lies between a hole and the
  border, or the hole goes up to an acute edge, whose points seem to be on a rim, too, points of both are in one loop.
*/
template <typename ConcurrencyTag>
class Rim_division
{
  typedef Surface_model<ConcurrencyTag> Model;

public:
  /// \param loop not copied
  Rim_division(const Model& model, const Rim_loop& loop) : m_model(model), m_loop(loop)
  {
    for(const Rim_point& p : loop.points)
      if(is_on_acute_edge(p))
        m_edge_points.push_back(p.index);
  }

  /// What is left of the loop without points on acute edges and without links between what turns away from each other.
  std::vector<Rim_loop> parts() const
  {
    std::vector<Rim_point> points;
    for(const Rim_point& p : m_loop.points)
      if(!std::binary_search(m_edge_points.begin(), m_edge_points.end(), p.index))
        points.push_back(p);
    return link_rim_points(m_model, points,
                           [&](const Rim_point& a, const Rim_point& b) { return bound_one_place(a, b); });
  }

  /// How many of some points, by increasing index, are on acute edges.
  std::size_t edge_points_among(const std::vector<std::size_t>& points) const
  {
    std::vector<std::size_t> common;
    std::set_intersection(points.begin(), points.end(), m_edge_points.begin(), m_edge_points.end(),
                          std::back_inserter(common));
    return common.size();
  }

private:
  // On an acute edge, where meshes have points, the normal is one between those of the faces, it leads into the empty
  // place, and both faces are beside it.
  bool is_on_acute_edge(const Rim_point& p) const
  {
    if(p.outward.dot(m_model.normal(p.index)) <= 0.5)
      return false;
    std::vector<std::size_t> beside;
    m_model.search().in_ball(m_model.position(p.index), edge_distance() * m_model.area_spacing(p.index), beside);
    for(std::size_t k = 0; k < beside.size(); ++k)
      for(std::size_t l = 0; l < k; ++l)
        if(!is_same_side(m_model.normal(beside[k]), m_model.normal(beside[l])))
          return true;
    return false;
  }

  // Whether two rim points may follow each other. Along a curve that turns, both are led towards the other, or both away
  // from it. With a narrow strip of the surface between two empty places, as a hole and the border, there are pairs that
  // turn much in all other ways. Across a narrow slot both are led towards each other.
  bool bound_one_place(const Rim_point& a, const Rim_point& b) const
  {
    const double cosine = a.outward.dot(b.outward);
    // what leads away from a wall may well be above or below it
    if(cosine > 0.5 || m_model.normal(a.index).dot(m_model.normal(b.index)) < 0.9)
      return true;
    const Vector way = (m_model.position(b.index) - m_model.position(a.index)).normalized();
    const double towards_b = a.outward.dot(way), towards_a = -b.outward.dot(way);
    if(towards_a + towards_b < -0.5 || std::abs(towards_a - towards_b) > 1)
      return false;
    return cosine > -0.5 || (towards_a > 0.3 && towards_b > 0.3);
  }

  static constexpr double edge_distance() { return 1.6; }   // area spacings

  const Model& m_model;
  const Rim_loop& m_loop;
  std::vector<std::size_t> m_edge_points;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_DIVISION_H
