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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SURFACE_DISTANCE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SURFACE_DISTANCE_H

#include "Benchmark_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Completion_benchmark {

/// Distances of the points to the triangles of a surface; infinite if it has none.
inline std::vector<double> distances_to_surface(const std::vector<Vector>& points, const Benchmark_surface& surface)
{
  typedef CGAL::Simple_cartesian<double> Cartesian;
  struct Bounded_triangle { Cartesian::Triangle_3 triangle; Vector center; double radius; };
  const auto point = [](const Vector& p) { return Cartesian::Point_3(p.x(), p.y(), p.z()); };
  std::vector<Bounded_triangle> triangles;
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(surface.face_vector(f).norm() > 0)         // the neighbours of a triangle without area cover it
    {
      const Benchmark_surface::Face& v = surface.faces[f];
      const Vector &a = surface.vertices[v[0]], &b = surface.vertices[v[1]], &c = surface.vertices[v[2]];
      const Vector center = (a + b + c) / 3;
      const double radius = (std::max)({ (a - center).norm(), (b - center).norm(), (c - center).norm() });
      triangles.push_back({ Cartesian::Triangle_3(point(a), point(b), point(c)), center, radius });
    }
  // The points are those of a hole, so few that bounding balls do for a search structure; the triangle that was nearest
  // to one is near the next one, and tried first.
  std::vector<double> distances;
  std::size_t nearest = 0;
  for(const Vector& p : points)
  {
    double squared = std::numeric_limits<double>::infinity();
    const auto distance_to = [&](std::size_t i) { return CGAL::squared_distance(point(p), triangles[i].triangle); };
    if(!triangles.empty())
      squared = distance_to(nearest);
    double distance = std::sqrt(squared);
    for(std::size_t i = 0; i < triangles.size(); ++i)
    {
      const double bound = distance + triangles[i].radius;
      if((p - triangles[i].center).squaredNorm() >= bound * bound)
        continue;
      const double found = distance_to(i);
      if(found >= squared)
        continue;
      squared = found;
      distance = std::sqrt(squared);
      nearest = i;
    }
    distances.push_back(distance);
  }
  return distances;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SURFACE_DISTANCE_H
