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

#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BENCHMARK_SURFACE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BENCHMARK_SURFACE_H

#include "Random_source.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Completion_benchmark {

struct Surface_sample { Vector position, normal; };

/*!
  A surface that can be sampled by area: triangles with data at their corners, interpolated inside the face.
  For a mesh the data is the normal of the corner, so that creases stay sharp. For a synthetic surface it is the
  parameter, which `parameter_map` takes to the exact position and normal, however coarse the triangles are.
*/
struct Benchmark_surface
{
  typedef std::array<std::size_t, 3> Face;
  typedef std::function<Surface_sample(const Vector&)> Parameter_map;

  std::vector<Vector> vertices;
  std::vector<Face> faces;
  std::vector<std::array<Vector, 3> > corners;
  Parameter_map parameter_map;                    ///< empty for a mesh
  bool is_curved = false;                         ///< a mesh whose triangles bulge as their normals say
  Surface_points samples;                         ///< of a surface that came as a point set: its own points

  Vector face_vector(std::size_t f) const         ///< normal, of the length of twice the area
  {
    const Face& v = faces[f];
    return (vertices[v[1]] - vertices[v[0]]).cross(vertices[v[2]] - vertices[v[0]]);
  }

  double area() const
  {
    double sum = 0;
    for(std::size_t f = 0; f < faces.size(); ++f)
      sum += 0.5 * face_vector(f).norm();
    return sum;
  }

  Surface_sample at(std::size_t f, double a, double b, double c) const
  {
    const Vector data = a * corners[f][0] + b * corners[f][1] + c * corners[f][2];
    if(parameter_map)
      return parameter_map(data);
    const Face& v = faces[f];
    const Vector flat = a * vertices[v[0]] + b * vertices[v[1]] + c * vertices[v[2]];
    if(!is_curved)
      return { flat, data.normalized() };
    // Phong tessellation: the mean of the projections to the tangent planes of the corners
    const double weight[3] = { a, b, c };
    Vector lifted = flat;
    for(int i = 0; i < 3; ++i)
      lifted -= weight[i] * (flat - vertices[v[i]]).dot(corners[f][i]) * corners[f][i];
    return { 0.25 * flat + 0.75 * lifted, data.normalized() };
  }

  /// Ends of the edges that have one face only.
  std::vector<std::pair<Vector, Vector> > border_edges() const
  {
    std::map<std::pair<std::size_t, std::size_t>, int> count;
    for(const Face& v : faces)
      for(int i = 0; i < 3; ++i)
        ++count[std::minmax(v[i], v[(i + 1) % 3])];
    std::vector<std::pair<Vector, Vector> > border;
    for(const auto& edge : count)
      if(edge.second == 1)
        border.emplace_back(vertices[edge.first.first], vertices[edge.first.second]);
    return border;
  }
};

/// Mean of the normals of the faces at each vertex, weighted by area; zero at a vertex without faces.
inline std::vector<Vector> vertex_normals(const Benchmark_surface& surface)
{
  std::vector<Vector> normals(surface.vertices.size(), Vector::Zero());
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    for(std::size_t v : surface.faces[f])
      normals[v] += surface.face_vector(f);
  for(Vector& n : normals)
    n.normalize();
  return normals;
}

/// Uniform samples of the given faces, `number` in all.
inline Surface_points draw_samples(const Benchmark_surface& surface, const std::vector<std::size_t>& faces,
                                   std::size_t number, Random_source& random)
{
  std::vector<double> cumulated(faces.size());
  double sum = 0;
  for(std::size_t i = 0; i < faces.size(); ++i)
    cumulated[i] = (sum += surface.face_vector(faces[i]).norm());
  Surface_points samples;
  if(!(sum > 0))
    return samples;
  for(std::size_t n = 0; n < number; ++n)
  {
    const auto hit = std::upper_bound(cumulated.begin(), cumulated.end(), random.uniform() * sum);
    const std::size_t i = (std::min)(std::size_t(hit - cumulated.begin()), faces.size() - 1);
    const double s = std::sqrt(random.uniform()), t = random.uniform();
    const Surface_sample p = surface.at(faces[i], 1 - s, s * (1 - t), s * t);
    samples.push_back(p.position, p.normal);
  }
  return samples;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BENCHMARK_SURFACE_H
