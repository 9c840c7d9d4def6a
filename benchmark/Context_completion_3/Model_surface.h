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

#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MODEL_SURFACE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MODEL_SURFACE_H

#include "Benchmark_surface.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace Completion_benchmark {

/*!
  Sets the corner normals of a mesh: mean, weighted by area, of the faces at the vertex whose normals enclose less than
  `crease_angle` degrees with the corner's face.
*/
inline void set_corner_normals(Benchmark_surface& surface, double crease_angle)
{
  std::vector<std::vector<std::size_t> > faces_of(surface.vertices.size());
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    for(std::size_t v : surface.faces[f])
      faces_of[v].push_back(f);
  const double cosine = std::cos(crease_angle * two_pi / 360.);
  surface.corners.resize(surface.faces.size());
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
  {
    const Vector own = surface.face_vector(f).normalized();
    for(int i = 0; i < 3; ++i)
    {
      Vector sum = Vector::Zero();
      for(std::size_t g : faces_of[surface.faces[f][i]])
      {
        const Vector n = surface.face_vector(g);
        if(n.normalized().dot(own) > cosine)
          sum += n;
      }
      surface.corners[f][i] = sum.norm() > 0 ? Vector(sum.normalized()) : own;
    }
  }
}

/// A mesh file as a surface: polygons cut into triangles, coincident vertices joined.
inline Benchmark_surface read_mesh(const std::string& file_name, double crease_angle = 40.)
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
  if(!CGAL::IO::read_polygon_soup(file_name, points, polygons) || polygons.empty())
    throw std::runtime_error("cannot read the mesh " + file_name);

  Benchmark_surface surface;
  std::map<std::array<double, 3>, std::size_t> index_of;
  std::vector<std::size_t> joined;
  for(const Point& p : points)
  {
    const auto inserted = index_of.insert({ { p.x(), p.y(), p.z() }, surface.vertices.size() });
    if(inserted.second)
      surface.vertices.emplace_back(p.x(), p.y(), p.z());
    joined.push_back(inserted.first->second);
  }
  for(const std::vector<std::size_t>& polygon : polygons)
    for(std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      const Benchmark_surface::Face face = { joined[polygon[0]], joined[polygon[i]], joined[polygon[i + 1]] };
      surface.faces.push_back(face);
      if(!(surface.face_vector(surface.faces.size() - 1).norm() > 0))
        surface.faces.pop_back();
    }
  set_corner_normals(surface, crease_angle);
  return surface;
}

/// Writes the triangles as an OFF file.
inline void write_mesh(const std::string& file_name, const Benchmark_surface& surface)
{
  std::ofstream file(file_name);
  file << "OFF\n" << surface.vertices.size() << ' ' << surface.faces.size() << " 0\n" << std::setprecision(17);
  for(const Vector& v : surface.vertices)
    file << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for(const Benchmark_surface::Face& f : surface.faces)
    file << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  if(!file.flush())
    throw std::runtime_error("cannot write " + file_name);
}

/// Moves and scales points to a bounding box around the origin with a diagonal of 1.
inline void normalize_extent(std::vector<Vector>& points)
{
  Vector low = Vector::Constant(1e300), high = -low;
  for(const Vector& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for(Vector& p : points)
    p = (p - 0.5 * (low + high)) / (high - low).norm();
}

/// A model of diagonal 1.
inline Benchmark_surface read_model(const std::string& file_name)
{
  Benchmark_surface surface = read_mesh(file_name);
  normalize_extent(surface.vertices);
  return surface;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MODEL_SURFACE_H
