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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_PARAMETRIC_SURFACE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_PARAMETRIC_SURFACE_H

#include "Benchmark_surface.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Completion_benchmark {

/// (u, v) in the unit square to a point.
typedef std::function<Vector(double, double)> Surface_function;

/// Normals by central differences, turned by `side`; exact positions.
inline Benchmark_surface::Parameter_map parameter_map(const Surface_function& position, double side)
{
  return [position, side](const Vector& p)
  {
    const double e = 1e-6, u = p.x(), v = p.y();
    const Vector n = (position(u + e, v) - position(u - e, v)).cross(position(u, v + e) - position(u, v - e));
    return Surface_sample{ position(u, v), side * n.normalized() };
  };
}

/*!
  The surface of a function, as a grid of `columns` x `rows` cells; `wraps_u`, `wraps_v` say where it closes.
  The function must be defined slightly beyond the unit square. `side` is the sign of du x dv against the outside.
*/
inline Benchmark_surface parametric_surface(const Surface_function& position, std::size_t columns, std::size_t rows,
                                            bool wraps_u, bool wraps_v, double side)
{
  Benchmark_surface surface;
  const std::size_t nu = wraps_u ? columns : columns + 1, nv = wraps_v ? rows : rows + 1;
  for(std::size_t j = 0; j < nv; ++j)
    for(std::size_t i = 0; i < nu; ++i)
      surface.vertices.push_back(position(double(i) / double(columns), double(j) / double(rows)));
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const auto index = [&](std::size_t a, std::size_t b) { return (b % nv) * nu + a % nu; };
      const auto data = [&](std::size_t a, std::size_t b)
        { return Vector(double(a) / double(columns), double(b) / double(rows), 0); };
      surface.faces.push_back({ index(i, j), index(i + 1, j), index(i + 1, j + 1) });
      surface.corners.push_back({ data(i, j), data(i + 1, j), data(i + 1, j + 1) });
      surface.faces.push_back({ index(i, j), index(i + 1, j + 1), index(i, j + 1) });
      surface.corners.push_back({ data(i, j), data(i + 1, j + 1), data(i, j + 1) });
    }
  surface.parameter_map = parameter_map(position, side);
  return surface;
}

/// Unit directions of an icosahedron, each face split `splits` times into four.
inline void subdivided_icosahedron(int splits, std::vector<Vector>& vertices,
                                   std::vector<Benchmark_surface::Face>& faces)
{
  const double g = 0.5 * (1 + std::sqrt(5.));
  vertices = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
               { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } };
  for(Vector& v : vertices)
    v.normalize();
  faces = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 },
            { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 },
            { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  for(int split = 0; split < splits; ++split)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle;
    const auto middle_of = [&](std::size_t a, std::size_t b)
    {
      const auto inserted = middle.insert({ std::minmax(a, b), vertices.size() });
      if(inserted.second)
        vertices.push_back((vertices[a] + vertices[b]).normalized());
      return inserted.first->second;
    };
    std::vector<Benchmark_surface::Face> finer;
    for(const Benchmark_surface::Face& f : faces)
    {
      const std::size_t a = middle_of(f[0], f[1]), b = middle_of(f[1], f[2]), c = middle_of(f[2], f[0]);
      finer.insert(finer.end(), { { f[0], a, c }, { f[1], b, a }, { f[2], c, b }, { a, b, c } });
    }
    faces.swap(finer);
  }
}

/// The sphere of radius 1 + relief(direction).
inline Benchmark_surface star_surface(const std::function<double(const Vector&)>& relief)
{
  Benchmark_surface surface;
  std::vector<Vector> directions;
  subdivided_icosahedron(7, directions, surface.faces);
  for(const Vector& d : directions)
    surface.vertices.push_back((1 + relief(d)) * d);
  for(const Benchmark_surface::Face& f : surface.faces)
    surface.corners.push_back({ directions[f[0]], directions[f[1]], directions[f[2]] });
  surface.parameter_map = [relief](const Vector& p)
  {
    const auto position = [&relief](const Vector& q)
      { const Vector d = q.normalized(); return Vector((1 + relief(d)) * d); };
    const double e = 1e-6;
    const Vector d = p.normalized();
    const Vector s = d.unitOrthogonal(), t = d.cross(s);
    const Vector n = (position(d + e * s) - position(d - e * s)).cross(position(d + e * t) - position(d - e * t));
    return Surface_sample{ position(d), n.normalized() };
  };
  return surface;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_PARAMETRIC_SURFACE_H
