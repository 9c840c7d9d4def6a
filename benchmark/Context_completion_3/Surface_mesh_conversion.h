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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SURFACE_MESH_CONVERSION_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SURFACE_MESH_CONVERSION_H

#include "Benchmark_case.h"
#include "Benchmark_surface.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

namespace Completion_benchmark {

typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

/// A halfedge mesh of the triangles, which are oriented alike. Vertices where that is not possible are doubled, those
/// without triangles left out.
inline Mesh to_mesh(const std::vector<Vector>& vertices, const std::vector<Benchmark_surface::Face>& faces)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Kernel::Point_3> points;
  for(const Vector& p : vertices)
    points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t> > polygons;
  for(const Benchmark_surface::Face& f : faces)
    polygons.emplace_back(f.begin(), f.end());
  PMP::orient_polygon_soup(points, polygons);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::remove_isolated_vertices(mesh);
  return mesh;
}

/// The triangles of a halfedge mesh, without normals at their corners.
inline Benchmark_surface to_surface(const Mesh& mesh)
{
  Benchmark_surface result;
  std::vector<std::size_t> index(mesh.num_vertices() + mesh.number_of_removed_vertices());
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    index[v] = result.vertices.size();
    const Kernel::Point_3& p = mesh.point(v);
    result.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    result.faces.push_back({ index[mesh.source(h)], index[mesh.target(h)], index[mesh.target(mesh.next(h))] });
  }
  return result;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SURFACE_MESH_CONVERSION_H
