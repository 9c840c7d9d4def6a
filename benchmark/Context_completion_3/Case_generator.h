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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_GENERATOR_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_GENERATOR_H

#include "Case_assembly.h"
#include "Case_catalogue.h"
#include "Points_mesh.h"
#include "Synthetic_surfaces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Completion_benchmark {

/// Makes the cases that the catalogue describes; the same description gives the same case.
class Case_generator
{
  typedef std::function<double(const Vector&)> Factor;

public:
  /// \param data_folder CGAL's data, for the models
  explicit Case_generator(const std::string& data_folder) : m_data_folder(data_folder) {}

  Benchmark_case operator()(const Case_description& description) const
  {
    Random_source random(description.seed);
    const Benchmark_surface surface = surface_of(description);
    Benchmark_case result;
    result.name = description.name;
    result.kind = description.kind;
    result.seed = description.seed;
    result.noise = description.noise;
    result.source = is_model(description) ? description.surface : "synthetic";

    // samples of the whole surface
    const Factor factor = factor_of(description.density, surface, random);
    std::vector<std::size_t> all(surface.faces.size());
    double weighted_area = 0;
    for(std::size_t f = 0; f < all.size(); ++f)
    {
      all[f] = f;
      const double coarser = factor ? factor(surface.vertices[surface.faces[f][0]]) : 1.;
      weighted_area += 0.5 * surface.face_vector(f).norm() / (coarser * coarser);
    }
    const double radius = std::sqrt(0.565 * weighted_area / double(description.number_of_points));
    Surface_points points = surface.samples.size() > 0 ? surface.samples
                          : blue_noise(surface, all, radius, factor, random);
    if(description.density == Density::dropout)
      points = dropped(points, 0.3, random);
    const double spacing = median_spacing(points);
    std::vector<double> local(points.size(), spacing);
    if(factor && surface.samples.size() == 0)
      for(std::size_t i = 0; i < points.size(); ++i)
        local[i] = (std::max)(spacing, 1.1 * radius * factor(points.position[i]));
    if(description.density == Density::dropout)
      local.assign(points.size(), 1.5 * spacing);

    // the holes
    const std::vector<Vector> border = border_samples(surface, 3 * spacing);
    result.open_boundary = !border.empty();
    result.natural_holes = result.open_boundary && is_model(description);
    Hole_cutter cutter(points, local, border);
    result.shape = name_of(cut_holes(description, spacing, cutter, random));
    for(std::size_t i = 0; i < points.size(); ++i)
      (cutter.is_removed()[i] ? result.removed : result.input).push_back(points.position[i], points.normal[i]);
    result.rims = cutter.number_of_rims();
    for(const Hole_cut& cut : cutter.cuts())
      result.holes.push_back({ cut.center, cut.radius });
    result.truth = truth_samples(surface, result.holes, 0.49 * spacing, random);

    add_noise(result.input, description.noise * spacing, description.noise, random);
    add_noise(result.removed, description.noise * spacing, description.noise, random);
    if(description.is_moved)
      move(result, random);
    set_extents(result);
    return result;
  }

private:
  static bool is_model(const Case_description& description)
  {
    return description.surface.find('/') != std::string::npos;
  }

  Benchmark_surface surface_of(const Case_description& description) const
  {
    if(!is_model(description))
      return synthetic_surface(description.surface, description.variant);
    const std::string file = m_data_folder + "/" + description.surface;
    return description.surface.find("points_3/") == 0 ? read_point_model(file) : read_model(file);
  }

  // Shrinks holes that find no place, widens cuts that do not get through. Models without a strand that could be cut
  // through get round holes instead. Returns the shape that was cut.
  static Hole_shape cut_holes(const Case_description& description, double spacing, Hole_cutter& cutter,
                              Random_source& random)
  {
    Hole_shape shape = description.shape;
    double radius = description.radius * spacing;
    while(cutter.cuts().size() < description.number_of_holes)
    {
      if(cutter.cut(shape, radius, random))
        continue;
      radius *= shape == Hole_shape::two_rims ? 1.15 : 0.88;
      if(radius >= 5 * spacing && radius <= 60 * spacing)
        continue;
      if(!cutter.cuts().empty())
        break;
      if(shape == Hole_shape::round)
        throw std::runtime_error("no place for a hole");
      shape = Hole_shape::round;
      radius = description.radius * spacing;
    }
    return shape;
  }

  // how much coarser than the finest the samples are
  static Factor factor_of(Density density, const Benchmark_surface& surface, Random_source& random)
  {
    if(density != Density::ramp && density != Density::blotches)
      return Factor();
    const Vector d = random.direction();
    double low = 1e300, high = -1e300;
    for(const Vector& v : surface.vertices)
    {
      low = (std::min)(low, v.dot(d));
      high = (std::max)(high, v.dot(d));
    }
    if(density == Density::ramp)
      return [=](const Vector& p) { return 1 + 1.2 * clamped((p.dot(d) - low) / (high - low)); };
    const Random_relief relief(0.45 * (high - low), random.seed() % 1000);
    return [=](const Vector& p) { return 1 + 0.9 * clamped(0.5 + 0.5 * relief(p)); };
  }

  static Surface_points dropped(const Surface_points& points, double share, Random_source& random)
  {
    Surface_points kept;
    for(std::size_t i = 0; i < points.size(); ++i)
      if(random.uniform() >= share)
        kept.push_back(points.position[i], points.normal[i]);
    return kept;
  }

  static std::vector<Vector> border_samples(const Benchmark_surface& surface, double step)
  {
    std::vector<Vector> samples;
    for(const auto& edge : surface.border_edges())
    {
      const int parts = 1 + int((edge.second - edge.first).norm() / step);
      for(int i = 0; i < parts; ++i)
        samples.push_back(edge.first + (edge.second - edge.first) * (double(i) / parts));
    }
    return samples;
  }

  // along the normal, as a scanner's; the normals suffer, too
  static void add_noise(Surface_points& points, double deviation, double noise, Random_source& random)
  {
    if(noise > 0)
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        points.position[i] += deviation * random.normal() * points.normal[i];
        points.normal[i] = (points.normal[i] + 0.22 * noise * random.normal_vector()).normalized();
      }
  }

  static void move(Benchmark_case& c, Random_source& random)
  {
    const Matrix rotation = random.rotation();
    const double scale = std::pow(10., random.uniform(-2, 2));
    const Vector shift = 50 * scale * random.normal_vector();
    const auto moved = [&](const Vector& p) { return Vector(scale * (rotation * p) + shift); };
    for(Surface_points* points : { &c.input, &c.removed, &c.truth })
      for(std::size_t i = 0; i < points->size(); ++i)
      {
        points->position[i] = moved(points->position[i]);
        points->normal[i] = rotation * points->normal[i];
      }
    for(Ball& hole : c.holes)
    {
      hole.center = moved(hole.center);
      hole.radius *= scale;
    }
  }

  std::string m_data_folder;
};

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_GENERATOR_H
