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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BENCHMARK_CASE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BENCHMARK_CASE_H

#include "Model_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Completion_benchmark {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Point_set_3<Kernel::Point_3> Point_set;

struct Ball { Vector center = Vector::Zero(); double radius = 0; };

/// A point set with a hole, what was cut out, the surface that is true there, and how it was made.
struct Benchmark_case
{
  std::string name, kind, source, shape, set = "generated";
  Surface_points input, removed, truth;
  double spacing = 0, diagonal = 0, noise = 0;
  Vector hole_center = Vector::Zero();
  double hole_radius = 0;
  std::vector<Ball> holes;
  std::vector<std::size_t> hole_sizes;            ///< points that each hole took, where they were vertices of a mesh
  Benchmark_surface mesh;                         ///< the input with its triangles, where it was a mesh; else empty
  bool open_boundary = false, natural_holes = false;
  std::size_t rims = 0;                           ///< as counted at the cut; 0: not known
  std::uint64_t seed = 0;
};

inline Point_set to_point_set(const Surface_points& points)
{
  Point_set result;
  result.add_normal_map();
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector& p = points.position[i];
    const Vector& n = points.normal[i];
    result.insert(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  return result;
}

inline Surface_points to_surface_points(const Point_set& points)
{
  Surface_points result;
  for(Point_set::Index i : points)
  {
    const Kernel::Point_3& p = points.point(i);
    const Kernel::Vector_3 n = points.has_normal_map() ? points.normal(i) : Kernel::Vector_3(0, 0, 0);
    result.push_back(Vector(p.x(), p.y(), p.z()), Vector(n.x(), n.y(), n.z()));
  }
  return result;
}

/// Binary PLY: positions in double, normals in float.
inline void write_points(const std::string& file_name, const Surface_points& points)
{
  std::ofstream file(file_name, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << points.size()
       << "\nproperty double x\nproperty double y\nproperty double z\n"
          "property float nx\nproperty float ny\nproperty float nz\nend_header\n";
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector3f n = points.normal[i].cast<float>();
    file.write(reinterpret_cast<const char*>(points.position[i].data()), 3 * sizeof(double));
    file.write(reinterpret_cast<const char*>(n.data()), 3 * sizeof(float));
  }
  if(!file.flush())
    throw std::runtime_error("cannot write " + file_name);
}

inline Surface_points read_points(const std::string& file_name)
{
  Point_set points;
  std::ifstream file(file_name, std::ios::binary);
  if(!file || !CGAL::IO::read_PLY(file, points))
    throw std::runtime_error("cannot read the points of " + file_name);
  Surface_points result = to_surface_points(points);
  for(Vector& n : result.normal)
    if(n.norm() > 1e-12)
      n.normalize();
  return result;
}

inline std::string json_array(const Vector& v)
{
  std::ostringstream text;
  text << std::setprecision(17) << v.x() << ", " << v.y() << ", " << v.z();
  return text.str();
}

inline void write_meta(const std::string& file_name, const Benchmark_case& c)
{
  std::ofstream file(file_name);
  file << std::setprecision(17) << std::boolalpha
       << "{\n \"name\": \"" << c.name << "\",\n \"kind\": \"" << c.kind << "\",\n \"source\": \"" << c.source
       << "\",\n \"shape\": \"" << c.shape << "\",\n \"n_input\": " << c.input.size() << ",\n \"n_removed\": "
       << c.removed.size() << ",\n \"spacing\": " << c.spacing << ",\n \"diag\": " << c.diagonal
       << ",\n \"hole_center\": [" << json_array(c.hole_center) << "],\n \"hole_radius\": " << c.hole_radius
       << ",\n \"seed\": " << c.seed << ",\n \"set\": \"" << c.set << "\",\n \"holes\": [";
  for(std::size_t i = 0; i < c.holes.size(); ++i)
    file << (i == 0 ? "" : ", ") << "[" << json_array(c.holes[i].center) << ", " << c.holes[i].radius << "]";
  file << "],\n \"hole_sizes\": [";
  for(std::size_t i = 0; i < c.hole_sizes.size(); ++i)
    file << (i == 0 ? "" : ", ") << c.hole_sizes[i];
  file << "],\n \"rims\": " << c.rims << ",\n \"open_boundary\": " << c.open_boundary << ",\n \"noise\": " << c.noise
       << ",\n \"natural_holes\": " << c.natural_holes << "\n}\n";
  if(!file.flush())
    throw std::runtime_error("cannot write " + file_name);
}

inline void write_case(const std::string& folder, const Benchmark_case& c)
{
  write_points(folder + "/input.ply", c.input);
  write_points(folder + "/removed.ply", c.removed);
  write_points(folder + "/truth.ply", c.truth);
  if(!c.mesh.faces.empty())
    write_mesh(folder + "/input.off", c.mesh);
  write_meta(folder + "/meta.json", c);
}

/// Reads a case in the format of `write_case()`.
inline Benchmark_case read_case(const std::string& folder)
{
  boost::property_tree::ptree meta;
  boost::property_tree::read_json(folder + "/meta.json", meta);
  const auto numbers = [](const boost::property_tree::ptree& list)
  {
    std::vector<double> values;
    for(const auto& item : list)
      values.push_back(item.second.get_value<double>());
    return values;
  };
  Benchmark_case c;
  c.name = meta.get<std::string>("name");
  c.kind = meta.get<std::string>("kind");
  c.source = meta.get<std::string>("source", "");
  c.shape = meta.get<std::string>("shape", "");
  c.set = meta.get<std::string>("set", "");
  c.spacing = meta.get<double>("spacing");
  c.diagonal = meta.get<double>("diag");
  c.noise = meta.get<double>("noise", 0.);
  c.hole_radius = meta.get<double>("hole_radius");
  c.open_boundary = meta.get<bool>("open_boundary", false);
  c.natural_holes = meta.get<bool>("natural_holes", false);
  c.seed = meta.get<std::uint64_t>("seed", 0);
  c.rims = meta.get<std::size_t>("rims", 0);
  const std::vector<double> center = numbers(meta.get_child("hole_center"));
  c.hole_center = Vector(center.at(0), center.at(1), center.at(2));
  for(const auto& item : meta.get_child("holes"))
  {
    const std::vector<double> ball = numbers(item.second);
    c.holes.push_back({ Vector(ball.at(0), ball.at(1), ball.at(2)), ball.at(3) });
  }
  if(const auto sizes = meta.get_child_optional("hole_sizes"))
    for(double size : numbers(*sizes))
      c.hole_sizes.push_back(std::size_t(size));
  if(std::filesystem::exists(folder + "/input.off"))
    c.mesh = read_mesh(folder + "/input.off");
  c.input = read_points(folder + "/input.ply");
  c.removed = read_points(folder + "/removed.ply");
  c.truth = read_points(folder + "/truth.ply");
  return c;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BENCHMARK_CASE_H
