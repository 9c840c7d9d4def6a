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
#include "Completion_method.h"
#include "Points_mesh.h"
#include "Time_limit.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Completion_benchmark {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

Benchmark_surface surface_of(const Mesh& mesh)
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

Benchmark_surface reconstruct(const Benchmark_case& c)
{
  CGAL::get_default_random() = CGAL::Random(0);      // the order of the cases must not matter
  typedef std::pair<Kernel::Point_3, Kernel::Vector_3> Point_with_normal;
  typedef CGAL::First_of_pair_property_map<Point_with_normal> Point_map;
  typedef CGAL::Second_of_pair_property_map<Point_with_normal> Normal_map;
  std::vector<Point_with_normal> points;
  for(std::size_t i = 0; i < c.input.size(); ++i)
  {
    const Vector& p = c.input.position[i];
    const Vector& n = c.input.normal[i];
    points.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  const double spacing =
    CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, 6, CGAL::parameters::point_map(Point_map()));
  Mesh mesh;
  if(!CGAL::poisson_surface_reconstruction_delaunay(points.begin(), points.end(), Point_map(), Normal_map(), mesh,
                                                    spacing))
    throw std::runtime_error("no Poisson reconstruction");
  return surface_of(mesh);
}

/*!
  Hole filling starts from a mesh. It gets the best that there can be: the triangles of input and removed points
  together, without those that touch a removed point, so that only the filling is compared.
*/
Benchmark_surface fill_and_fair(const Benchmark_case& c)
{
  Surface_points whole = c.input;
  for(std::size_t i = 0; i < c.removed.size(); ++i)
    whole.push_back(c.removed.position[i], c.removed.normal[i]);
  std::vector<Kernel::Point_3> points;
  for(const Vector& p : c.input.position)
    points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t> > kept;
  std::set<Kernel::Point_3> rim;
  for(const Benchmark_surface::Face& f : triangles_of(whole))
    if(*std::max_element(f.begin(), f.end()) < points.size())
      kept.emplace_back(f.begin(), f.end());
    else
      for(std::size_t v : f)
        if(v < points.size())
          rim.insert(points[v]);
  PMP::orient_polygon_soup(points, kept);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, kept, mesh);

  std::vector<Mesh::Halfedge_index> cycles;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  std::size_t filled = 0;
  for(Mesh::Halfedge_index cycle : cycles)
  {
    std::size_t size = 0, at_rim = 0;
    Mesh::Halfedge_index h = cycle;
    do
    {
      ++size;
      at_rim += rim.count(mesh.point(mesh.target(h)));
      h = mesh.next(h);
    }
    while(h != cycle);
    if(2 * at_rim <= size)
      continue;
    std::vector<Mesh::Face_index> faces;
    std::vector<Mesh::Vertex_index> vertices;
    PMP::triangulate_refine_and_fair_hole(mesh, cycle, std::back_inserter(faces), std::back_inserter(vertices));
    filled += !faces.empty();
  }
  if(filled == 0)
    throw std::runtime_error("no hole of the mesh could be filled");
  return surface_of(mesh);
}

// Both end within seconds where they end.
Completion_method peer(const std::string& name, const std::string& description,
                       Benchmark_surface (*compute)(const Benchmark_case&))
{
  const auto run = [compute](const Benchmark_case& c)
  {
    Completion_result result;
    result.is_surface = true;
    result.surface = surface_within(120, [&] { return compute(c); });
    return result;
  };
  return { name, description, run };
}

} // namespace

std::vector<Completion_method> peer_methods()
{
  return { peer("poisson", "poisson_surface_reconstruction_delaunay()", reconstruct),
           peer("fairing", "triangulate_refine_and_fair_hole()", fill_and_fair) };
}

} // namespace Completion_benchmark
