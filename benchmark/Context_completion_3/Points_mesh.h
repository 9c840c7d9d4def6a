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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_POINTS_MESH_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_POINTS_MESH_H

#include "Benchmark_case.h"
#include "Model_surface.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Completion_benchmark {

/// Triangles between the given points by the advancing front, turned to the side of the points' normals.
inline std::vector<Benchmark_surface::Face> triangles_of(const Surface_points& points)
{
  CGAL::get_default_random() = CGAL::Random(0);      // what was triangulated before must not matter
  std::vector<Kernel::Point_3> positions;
  for(const Vector& p : points.position)
    positions.emplace_back(p.x(), p.y(), p.z());
  std::vector<Benchmark_surface::Face> faces;
  CGAL::advancing_front_surface_reconstruction(positions.begin(), positions.end(), std::back_inserter(faces));
  // the front advances in an order that depends on addresses
  for(Benchmark_surface::Face& f : faces)
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  std::sort(faces.begin(), faces.end());
  // each connected part has one orientation of its own; single faces would tear it, so the majority decides
  std::vector<std::size_t> part(points.size());
  for(std::size_t i = 0; i < part.size(); ++i)
    part[i] = i;
  const auto root = [&part](std::size_t i)
  {
    while(part[i] != i)
      i = part[i] = part[part[i]];
    return i;
  };
  for(const Benchmark_surface::Face& f : faces)
    part[root(f[0])] = part[root(f[1])] = root(f[2]);
  std::vector<double> agreement(points.size(), 0.);
  for(const Benchmark_surface::Face& f : faces)
  {
    const Vector& p = points.position[f[0]];
    const Vector n = (points.position[f[1]] - p).cross(points.position[f[2]] - p);
    agreement[root(f[0])] += n.dot(points.normal[f[0]] + points.normal[f[1]] + points.normal[f[2]]);
  }
  for(Benchmark_surface::Face& f : faces)
    if(agreement[root(f[0])] < 0)
      std::swap(f[1], f[2]);
  return faces;
}

/// A point set with normals as a surface of diagonal 1 that keeps its own points as its samples.
inline Benchmark_surface read_point_model(const std::string& file_name)
{
  Point_set read;
  std::ifstream file(file_name, std::ios::binary);
  if(!file || !(file >> read) || !read.has_normal_map() || read.empty())
    throw std::runtime_error("cannot read points with normals from " + file_name);
  Benchmark_surface surface;
  surface.samples = to_surface_points(read);
  normalize_extent(surface.samples.position);
  for(Vector& n : surface.samples.normal)
    n.normalize();
  surface.vertices = surface.samples.position;
  surface.faces = triangles_of(surface.samples);
  surface.is_curved = true;
  for(const Benchmark_surface::Face& f : surface.faces)
    surface.corners.push_back({ surface.samples.normal[f[0]], surface.samples.normal[f[1]],
                                surface.samples.normal[f[2]] });
  return surface;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_POINTS_MESH_H
