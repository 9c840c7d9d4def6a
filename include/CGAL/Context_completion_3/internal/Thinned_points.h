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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_THINNED_POINTS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_THINNED_POINTS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Points of a surface that are as far apart as each asks for, unless they lie on different sides: the first of them, and
/// each further one for which there is room. By increasing index.
/// \param distances positive, parallel to the points
inline std::vector<std::size_t> thinned_points(const Surface_points& surface, const std::vector<double>& distances)
{
  std::vector<std::size_t> kept;
  if(surface.size() == 0)
    return kept;
  Point_grid grid(*std::max_element(distances.begin(), distances.end()));
  for(std::size_t i = 0; i < surface.size(); ++i)
  {
    bool is_free = true;
    grid.for_each_in_ball(surface.position[i], distances[i], [&](std::size_t k, double) {
      is_free = !is_same_side(surface.normal[i], surface.normal[kept[k]]);
      return is_free; });
    if(!is_free)
      continue;
    grid.insert(surface.position[i]);
    kept.push_back(i);
  }
  return kept;
}

/// The same with one distance.
inline std::vector<std::size_t> thinned_points(const Surface_points& surface, double distance)
{
  return thinned_points(surface, std::vector<double>(surface.size(), distance));
}

/// Those points with their normals.
inline Surface_points thinned_surface(const Surface_points& surface, double distance)
{
  Surface_points result;
  for(std::size_t i : thinned_points(surface, distance))
    result.push_back(surface.position[i], surface.normal[i]);
  return result;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_THINNED_POINTS_H
