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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MESH_REMESHING_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MESH_REMESHING_H

#include "Local_statistics.h"
#include "Surface_mesh_conversion.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace Completion_benchmark {

/// Whether the edges have about one length: nine in ten have half to twice the median.
inline bool is_even(const Benchmark_surface& surface)
{
  std::vector<double> lengths;
  for(const Benchmark_surface::Face& f : surface.faces)
    for(int i = 0; i < 3; ++i)
      lengths.push_back((surface.vertices[f[i]] - surface.vertices[f[(i + 1) % 3]]).norm());
  const double median = quantile(lengths, 0.5);
  return 2 * quantile(lengths, 0.05) > median && quantile(lengths, 0.95) < 2 * median;
}

/*!
  The surface in triangles of about one size, with between `least` and `most` vertices, which lie on it. Edges at which
  it bends by more than 60 degrees stay edges.
  \param number of vertices to aim at
  \exception std::runtime_error if there is no such mesh, as where sharp edges are finer than the triangles
*/
inline Benchmark_surface remeshed(const Benchmark_surface& surface, std::size_t number, std::size_t least,
                                  std::size_t most)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  // of the equilateral triangles with this edge, twice as many as there are vertices have the area of the surface
  double length = std::sqrt(2 * surface.area() / (std::sqrt(3.) * double(number)));
  for(int attempt = 0; attempt < 4; ++attempt)
  {
    Mesh mesh = to_mesh(surface.vertices, surface.faces);
    const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
    PMP::detect_sharp_edges(mesh, 60, is_sharp);
    PMP::isotropic_remeshing(mesh.faces(), length, mesh, CGAL::parameters::number_of_iterations(5)
      .edge_is_constrained_map(is_sharp));
    const Benchmark_surface result = to_surface(mesh);
    const std::size_t found = result.vertices.size();
    if(least <= found && found <= most && is_even(result))
      return result;
    length *= std::sqrt(double(found) / double(number));
  }
  throw std::runtime_error("no even mesh of " + std::to_string(number) + " vertices");
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MESH_REMESHING_H
