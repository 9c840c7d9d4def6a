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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_MESH_FACES_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_MESH_FACES_H

#include "failure.h"
#include "point_file.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// What the faces of a file tell of its points: the sides of the surface, and where it has no hole.

namespace Completion_program {

/*!
  Gives the points normals: at each the mean of its faces, by their area.
  \throw Failure if there is a point without
*/
inline void compute_normals(Point_file& file)
{
  std::vector<Vector> normals(file.points.size(), CGAL::NULL_VECTOR);
  for(const std::vector<std::size_t>& face : file.faces)
  {
    Vector area = CGAL::NULL_VECTOR;
    for(std::size_t i = 2; i < face.size(); ++i)
    {
      const Point &p = file.points.point(face[0]), &q = file.points.point(face[i - 1]), &r = file.points.point(face[i]);
      area = area + CGAL::cross_product(q - p, r - p);
    }
    for(std::size_t v : face)
      normals[v] = normals[v] + area;
  }
  const auto number = std::count_if(normals.begin(), normals.end(), [](const Vector& n)
    { return !(n.squared_length() > 0) || !CGAL::is_finite(n.squared_length()); });
  if(number > 0)
    throw Failure(file.name + ": the points have no normals, and at " + std::to_string(number)
                  + " of them the faces give none; --estimate-normals 18 makes them from the 18 nearest points");
  file.points.add_normal_map();
  for(std::size_t i = 0; i < normals.size(); ++i)
    file.points.normal(i) = normals[i] / CGAL::approximate_sqrt(normals[i].squared_length());
}

/// Per point whether a hole may lie there: it has no face, or an edge at it has one face only.
inline std::vector<char> points_at_border(const std::vector<std::vector<std::size_t> >& faces,
                                          std::size_t number_of_points)
{
  std::vector<std::pair<std::size_t, std::size_t> > edges;
  std::vector<char> is_at_border(number_of_points, 1);
  for(const std::vector<std::size_t>& face : faces)
    for(std::size_t i = 0; i < face.size(); ++i)
    {
      edges.push_back(std::minmax(face[i], face[(i + 1) % face.size()]));
      is_at_border[face[i]] = 0;
    }
  std::sort(edges.begin(), edges.end());
  for(std::size_t i = 0; i < edges.size(); )
  {
    std::size_t end = i + 1;
    while(end < edges.size() && edges[end] == edges[i])
      ++end;
    if(end == i + 1)
      is_at_border[edges[i].first] = is_at_border[edges[i].second] = 1;
    i = end;
  }
  return is_at_border;
}

/// Whether faces cover an under-sampled place: less than half of its rim is at a border.
inline bool is_covered(const std::vector<std::vector<std::size_t> >& loops, const std::vector<char>& is_at_border)
{
  std::size_t number = 0, at_border = 0;
  for(const std::vector<std::size_t>& loop : loops)
    for(std::size_t point : loop)
    {
      ++number;
      at_border += is_at_border[point] ? 1 : 0;
    }
  return 2 * at_border < number;
}

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_MESH_FACES_H
