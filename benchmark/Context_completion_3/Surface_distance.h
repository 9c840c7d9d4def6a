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

#include "Surface_mesh_conversion.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#if __has_include(<CGAL/AABB_traits_3.h>)        // since CGAL 6.0
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_traits.h>
#endif
#include <CGAL/AABB_tree.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Completion_benchmark {

/// Distance of each point to the nearest triangle of the surface; infinite if it has none.
inline std::vector<double> distances_to_surface(const std::vector<Vector>& points, const Benchmark_surface& surface)
{
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if __has_include(<CGAL/AABB_traits_3.h>)
  typedef CGAL::AABB_traits_3<Kernel, Primitive> Traits;
#else
  typedef CGAL::AABB_traits<Kernel, Primitive> Traits;
#endif
  std::vector<Benchmark_surface::Face> faces;
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(surface.face_vector(f).norm() > 0)         // the neighbours of a triangle without area cover it
      faces.push_back(surface.faces[f]);
  if(faces.empty())
    return std::vector<double>(points.size(), std::numeric_limits<double>::infinity());
  const Mesh mesh = to_mesh(surface.vertices, faces);
  CGAL::AABB_tree<Traits> tree(mesh.faces().begin(), mesh.faces().end(), mesh);
  tree.accelerate_distance_queries();
  std::vector<double> distances;
  for(const Vector& p : points)
    distances.push_back(std::sqrt(tree.squared_distance(Kernel::Point_3(p.x(), p.y(), p.z()))));
  return distances;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SURFACE_DISTANCE_H
