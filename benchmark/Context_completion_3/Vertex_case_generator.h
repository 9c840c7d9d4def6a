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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_VERTEX_CASE_GENERATOR_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_VERTEX_CASE_GENERATOR_H

#include "Case_assembly.h"
#include "Case_catalogue.h"
#include "Mesh_remeshing.h"
#include "Vertex_hole_cutter.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace Completion_benchmark {

/// All that determines a case of the vertices of a mesh with holes.
struct Vertex_case_description
{
  struct Hole { Hole_core core; std::size_t number_of_vertices; };

  std::string name;
  Model_kind model;
  std::size_t number_of_vertices = 10000;         ///< to remesh to
  bool keeps_mesh = false;                        ///< not remeshed where the model's own mesh is suitable
  std::vector<Hole> holes;
  std::uint64_t seed = 1;
};

/// `number` random cases; the i-th depends on `seed` and i only.
inline std::vector<Vertex_case_description> random_vertex_cases(std::size_t number, std::uint64_t seed)
{
  std::vector<Model_kind> models;
  for(const Model_kind& model : model_kinds())
    if(std::string(model.file).find("meshes/") == 0)
      models.push_back(model);
  std::vector<Vertex_case_description> cases;
  for(std::size_t i = 0; i < number; ++i)
  {
    Random_source random(seed * 1000003 + i);
    Vertex_case_description c;
    // every model is met before one is met again
    c.model = models[(i * 5 + seed) % models.size()];
    const std::string file = c.model.file;
    const std::size_t start = file.find('/') + 1;
    c.name = std::to_string(i) + "_" + file.substr(start, file.rfind('.') - start) + "_vertices";
    const auto logarithmic = [&random](double low, double high)
      { return std::size_t(std::exp(random.uniform(std::log(low), std::log(high)))); };
    c.number_of_vertices = logarithmic(7000, 22000);
    c.keeps_mesh = random.uniform() < 0.5;
    c.holes.resize(1 + random.index(4));
    for(Vertex_case_description::Hole& hole : c.holes)
      hole = { random.uniform() < 0.6 ? Hole_core::vertex : Hole_core::path, logarithmic(20, 501) };
    c.seed = random.seed();
    cases.push_back(c);
  }
  return cases;
}

/*!
  Makes cases as mesh inpainting is measured: the input are the vertices of a mesh, with the normals that the mesh has
  without the holes' triangles, and what is to be found are the vertices that were removed. The true surface is that of
  the model, on which the vertices lie.
*/
class Vertex_case_generator
{
  static constexpr std::size_t least = 6000, most = 25000;    // vertices

public:
  /// \param data_folder CGAL's data
  explicit Vertex_case_generator(const std::string& data_folder) : m_data_folder(data_folder) {}

  Benchmark_case operator()(const Vertex_case_description& description) const
  {
    Random_source random(description.seed);
    const Benchmark_surface model = read_model(m_data_folder + "/" + description.model.file);
    const Benchmark_surface whole = mesh_of(model, description);
    Benchmark_case result;
    result.name = description.name;
    result.kind = description.model.kind;
    result.source = description.model.file;
    result.set = "vertices";
    result.seed = description.seed;
    result.open_boundary = result.natural_holes = !whole.border_edges().empty();

    Vertex_hole_cutter cutter(whole);
    for(const Vertex_case_description::Hole& hole : description.holes)
    {
      // a hole that finds no place is made smaller, or left out
      std::size_t number = hole.number_of_vertices;
      while(number >= 20 && !cutter.cut(hole.core, number, random))
        number = number * 3 / 4;
      if(number >= 20)
        result.shape += std::string(result.shape.empty() ? "" : " ")
                      + (hole.core == Hole_core::vertex ? "blob" : "slot");
    }
    if(cutter.balls().empty())
      throw std::runtime_error("no place for a hole");
    result.holes = cutter.balls();
    result.hole_sizes = cutter.sizes();
    result.rims = cutter.balls().size();
    divide(whole, cutter.is_removed(), result);
    set_extents(result);
    result.truth = truth_samples(model, result.holes, 0.49 * result.spacing, random);
    return result;
  }

private:
  static Benchmark_surface mesh_of(const Benchmark_surface& model, const Vertex_case_description& description)
  {
    if(description.keeps_mesh)
    {
      const Benchmark_surface own = to_surface(to_mesh(model.vertices, model.faces));
      if(least <= own.vertices.size() && own.vertices.size() <= most && is_even(own))
        return own;
    }
    return remeshed(model, description.number_of_vertices, least, most);
  }

  // the vertices and what is left of the triangles
  static void divide(const Benchmark_surface& whole, const std::vector<char>& is_removed, Benchmark_case& c)
  {
    std::vector<std::size_t> index(whole.vertices.size());
    for(std::size_t v = 0; v < index.size(); ++v)
      if(!is_removed[v])
      {
        index[v] = c.mesh.vertices.size();
        c.mesh.vertices.push_back(whole.vertices[v]);
      }
    for(const Benchmark_surface::Face& f : whole.faces)
      if(!is_removed[f[0]] && !is_removed[f[1]] && !is_removed[f[2]])
        c.mesh.faces.push_back({ index[f[0]], index[f[1]], index[f[2]] });
    const std::vector<Vector> seen = vertex_normals(c.mesh), unseen = vertex_normals(whole);
    for(std::size_t v = 0; v < index.size(); ++v)
      if(is_removed[v])
        c.removed.push_back(whole.vertices[v], unseen[v]);
      else
        c.input.push_back(whole.vertices[v], seen[index[v]]);
  }

  std::string m_data_folder;
};

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_VERTEX_CASE_GENERATOR_H
