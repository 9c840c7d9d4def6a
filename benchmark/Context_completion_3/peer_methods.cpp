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
#include "Surface_mesh_conversion.h"
#include "Time_limit.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Random.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Completion_benchmark {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

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
  return to_surface(mesh);
}

/// A mesh to be filled. The borders that the model itself has are not rims.
struct Mesh_with_holes
{
  Mesh mesh;
  std::function<bool(const Kernel::Point_3&)> is_at_rim;      ///< for points of borders
};

// of a case of vertices: its own mesh
Mesh_with_holes given_mesh(const Benchmark_case& c)
{
  // the balls enclose the rims
  const auto is_at_rim = [&c](const Kernel::Point_3& p)
  {
    return std::any_of(c.holes.begin(), c.holes.end(), [&p](const Ball& ball)
      { return (Vector(p.x(), p.y(), p.z()) - ball.center).norm() <= (1 + 1e-9) * ball.radius; });
  };
  return { to_mesh(c.mesh.vertices, c.mesh.faces), is_at_rim };
}

// of points the best that there can be: the triangles of input and removed points together, without those that touch a
// removed point, so that only the filling is compared
Mesh_with_holes best_mesh(const Benchmark_case& c)
{
  Surface_points whole = c.input;
  for(std::size_t i = 0; i < c.removed.size(); ++i)
    whole.push_back(c.removed.position[i], c.removed.normal[i]);
  std::vector<Benchmark_surface::Face> kept;
  std::set<Kernel::Point_3> rim;
  for(const Benchmark_surface::Face& f : triangles_of(whole))
    if(*std::max_element(f.begin(), f.end()) < c.input.size())
      kept.push_back(f);
    else
      for(std::size_t v : f)
        if(v < c.input.size())
        {
          const Vector& p = c.input.position[v];
          rim.insert(Kernel::Point_3(p.x(), p.y(), p.z()));
        }
  return { to_mesh(c.input.position, kept), [rim](const Kernel::Point_3& p) { return rim.count(p) != 0; } };
}

Benchmark_surface fill_and_fair(const Benchmark_case& c)
{
  Mesh_with_holes start = c.mesh.faces.empty() ? best_mesh(c) : given_mesh(c);
  Mesh& mesh = start.mesh;
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
      at_rim += start.is_at_rim(mesh.point(mesh.target(h)));
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
  return to_surface(mesh);
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
