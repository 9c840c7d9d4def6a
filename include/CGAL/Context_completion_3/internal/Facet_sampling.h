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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_SAMPLING_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_SAMPLING_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Facet_continuation.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Points on facets that go on into a hole, from the rim inwards, on walls as well as on what they stand on.

  \param facets that go on
  \param known points around the hole
  \param seeds places a step inwards from the rim
  \param spacing the points are to have
  \param most more points than that run off: the facets do not close the hole
  \return none if they run off
*/
inline Surface_points sample_facets(const Facet_continuation& facets, const Surface_points& known,
                                    const std::vector<Vector>& seeds, double spacing, std::size_t most)
{
  Surface_points result;
  Point_grid known_grid(1.3 * spacing), grid(spacing);
  for(const Vector& p : known.position)
    known_grid.insert(p);
  std::vector<std::size_t> front;
  const auto try_point = [&](Vector x)
  {
    Vector normal;
    if(!facets.project(x, 0.75 * spacing, normal))
      return;
    bool is_free = true, is_inside = true;
    known_grid.for_each_in_ball(x, 1.25 * spacing, [&](std::size_t k, double d) {
      if(!is_same_side(known.normal[k], normal))
        return true;
      is_inside = false;
      return is_free = d >= 0.8 * spacing; });
    if(!is_free)
      return;
    grid.for_each_in_ball(x, 0.85 * spacing, [&](std::size_t k, double) {
      return is_free = !is_same_side(result.normal[k], normal); });
    if(!is_free)
      return;
    if(is_inside)
      front.push_back(result.size());
    grid.insert(x);
    result.push_back(x, normal);
  };
  for(const Vector& seed : seeds)
    try_point(seed);
  // a step ahead, and, where the surface turns at an edge, one up or down
  for(std::size_t next = 0; next < front.size(); ++next)
  {
    if(result.size() > most)
      return Surface_points();
    const Vector p = result.position[front[next]], n = result.normal[front[next]];
    const Vector u = n.unitOrthogonal(), v = n.cross(u);
    for(double up : {0., -0.5, 0.5})
      for(int direction = 0; direction < 6; ++direction)
      {
        const double t = direction * CGAL_PI / 3;
        try_point(p + spacing * (std::cos(t) * u + std::sin(t) * v + up * n));
      }
  }
  return result;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_SAMPLING_H
