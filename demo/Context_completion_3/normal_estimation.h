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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_NORMAL_ESTIMATION_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_NORMAL_ESTIMATION_H

#include "failure.h"
#include "point_file.h"

#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace Completion_program {

/*!
  Replaces the normals by estimated ones: quadratic jets through the `k` nearest points, oriented alike along a minimum
  spanning tree, as `Point_set_processing_3` does it. The order of the points stays.
  \return the number of points whose side could not be told
*/
inline std::size_t estimate_normals(Point_file& file, std::size_t k, const std::function<bool(double)>& callback)
{
  Point_set& points = file.points;
  if(points.size() <= k)
    throw Failure(file.name + ": normals from " + std::to_string(k) + " neighbours need more than "
                  + std::to_string(k) + " points; there are " + std::to_string(points.size()));
  points.add_normal_map();
  // by reference: CGAL 5.5 keeps a reference to its own copy of the function longer than the copy lives
  CGAL::jet_estimate_normals<CGAL::Parallel_if_available_tag>(
    points, static_cast<unsigned int>(k), points.parameters().callback(std::cref(callback)));

  // The orientation sorts what it is given and reaches one connected part of it, so the rest is given to it again.
  std::vector<Point_set::Index> rest(points.begin(), points.end());
  for(std::size_t round = 0; round < 100 && rest.size() > k; ++round)
  {
    const auto first_unoriented = CGAL::mst_orient_normals(
      rest, static_cast<unsigned int>(k),
      CGAL::parameters::point_map(points.point_map()).normal_map(points.normal_map()));
    if(first_unoriented == rest.begin())
      break;
    rest.erase(rest.begin(), first_unoriented);
  }
  return rest.size();
}

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_NORMAL_ESTIMATION_H
