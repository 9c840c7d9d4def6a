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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_ASSEMBLY_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_ASSEMBLY_H

#include "Benchmark_case.h"
#include "Blue_noise.h"
#include "Local_statistics.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Completion_benchmark {

/// Median distance of the points to their nearest neighbours; 0 without points.
inline double median_spacing(const Surface_points& points)
{
  return points.size() == 0 ? 0. : quantile(neighbor_distances(points.position), 0.5);
}

/// Samples of the clean surface in and around the holes, denser than the input.
inline Surface_points truth_samples(const Benchmark_surface& surface, const std::vector<Ball>& holes, double radius,
                                    Random_source& random)
{
  std::vector<std::size_t> near;
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
  {
    const Benchmark_surface::Face& v = surface.faces[f];
    const Vector middle = (surface.vertices[v[0]] + surface.vertices[v[1]] + surface.vertices[v[2]]) / 3;
    double extent = 0;
    for(std::size_t i : v)
      extent = (std::max)(extent, (surface.vertices[i] - middle).norm());
    for(const Ball& hole : holes)
      if((middle - hole.center).norm() < 2 * hole.radius + extent)
      {
        near.push_back(f);
        break;
      }
  }
  // large faces reach far beyond: draw first, crop, then thin
  double area = 0;
  for(std::size_t f : near)
    area += 0.5 * surface.face_vector(f).norm();
  const std::size_t number = std::size_t((std::min)(8 * area / (radius * radius), 4e6)) + 1;
  const Surface_points drawn = draw_samples(surface, near, number, random);
  Surface_points cropped;
  for(std::size_t i = 0; i < drawn.size(); ++i)
    for(const Ball& hole : holes)
      if((drawn.position[i] - hole.center).norm() < 2 * hole.radius)
      {
        cropped.push_back(drawn.position[i], drawn.normal[i]);
        break;
      }
  const std::vector<double> radii(cropped.size(), radius);
  return subset(cropped, thin_to_blue_noise(cropped, radii, random));
}

/// Spacing, diagonal and the largest hole, from the points and the holes.
inline void set_extents(Benchmark_case& c)
{
  c.spacing = median_spacing(c.input);
  Vector low = Vector::Constant(1e300), high = -low;
  for(const Surface_points* points : { &c.input, &c.removed })
    for(const Vector& p : points->position)
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  c.diagonal = (high - low).norm();
  c.hole_center = c.holes.front().center;
  for(const Ball& hole : c.holes)
    c.hole_radius = (std::max)(c.hole_radius, hole.radius);
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_ASSEMBLY_H
