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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SYNTHETIC_SURFACES_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SYNTHETIC_SURFACES_H

#include "Block_solid.h"
#include "Parametric_surface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Completion_benchmark {

inline double fraction(double x) { return x - std::floor(x); }

/// Periodic tile with flat top and steep but finite flanks: 0 in the gap, 1 on the tile; t counts tiles.
inline double tile_profile(double t, double gap, double flank)
{
  const double f = fraction(t);
  return (std::min)(1., (std::max)(0., ((std::min)(f, 1 - f) - gap) / flank));
}

/// A random field that is smooth at one wave length: a sum of plane waves with standard deviation 1.
class Random_relief
{
public:
  Random_relief(double wave_length, std::size_t seed)
  {
    Random_source random(seed * 7919 + 17);
    for(int i = 0; i < 48; ++i)
    {
      m_waves.push_back(random.direction() * two_pi / (wave_length * random.uniform(0.7, 1.5)));
      m_phases.push_back(random.uniform(0, two_pi));
    }
  }

  double operator()(const Vector& p) const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_waves.size(); ++i)
      sum += std::sin(m_waves[i].dot(p) + m_phases[i]);
    return sum / std::sqrt(0.5 * double(m_waves.size()));
  }

private:
  std::vector<Vector> m_waves;
  std::vector<double> m_phases;
};

typedef std::function<double(double, double)> Height;

inline Benchmark_surface torus(double tube, const Height& height)
{
  return parametric_surface([tube, height](double u, double v)
  {
    const double r = tube + height(u, v), a = two_pi * u, b = two_pi * v;
    return Vector((1 + r * std::cos(b)) * std::cos(a), (1 + r * std::cos(b)) * std::sin(a), r * std::sin(b));
  }, 720, 320, true, true, 1);
}

inline Benchmark_surface cylinder(double length, const Height& height)
{
  return parametric_surface([length, height](double u, double v)
  {
    const double r = 0.5 + height(u, v), a = two_pi * u;
    return Vector(r * std::cos(a), r * std::sin(a), length * (v - 0.5));
  }, 560, 400, true, false, 1);
}

/// The graph of a function over a rectangle; with `bend` > 0 no two places are merely shifted copies.
inline Benchmark_surface sheet(double bend, const Height& height)
{
  return parametric_surface([bend, height](double u, double v)
  {
    const double x = 2 * u - 1, y = 1.6 * v - 0.8;
    return Vector(x, y, height(x, y) + bend * (x * x - 0.6 * y * y + 0.3 * x * y * y));
  }, 560, 448, false, false, 1);
}

/// A tube along the trefoil knot, of radius `radius(u, v)`.
inline Benchmark_surface trefoil_tube(const Height& radius)
{
  return parametric_surface([radius](double u, double v)
  {
    const double t = two_pi * u, b = two_pi * v;
    const Vector c(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
    const Vector d(std::cos(t) + 4 * std::cos(2 * t), -std::sin(t) + 4 * std::sin(2 * t), -3 * std::cos(3 * t));
    const Vector dd(-std::sin(t) - 8 * std::sin(2 * t), -std::cos(t) + 8 * std::cos(2 * t), 9 * std::sin(3 * t));
    const Vector binormal = d.cross(dd).normalized(), normal = binormal.cross(d).normalized();
    return Vector(c + radius(u, v) * (std::cos(b) * normal + std::sin(b) * binormal));
  }, 1400, 160, true, true, -1);
}

inline double woven_height(double x, double y)
{
  const double i = std::floor(x), j = std::floor(y), pi = 0.5 * two_pi;
  const auto thread = [](double offset) { return 0.5 * (1 - std::pow(std::abs(offset - 0.5) / 0.4, 4)); };
  const double over = 0.18 * std::cos(pi * (x - 0.5) + pi * j), under = -0.18 * std::cos(pi * (y - 0.5) + pi * i);
  return (std::max)((std::max)(over + thread(y - j), under + thread(x - i)), -0.3);
}

/// Distance to the border of the hexagon of a honeycomb, 0.5 in its centre.
inline double honeycomb_distance(double x, double y)
{
  const double s = std::sqrt(3.);
  double best = 1e300;
  Vector q = Vector::Zero();
  for(int k = 0; k < 2; ++k)
  {
    const double cx = std::floor(x - 0.5 * k + 0.5) + 0.5 * k, cy = (std::floor(y / s - 0.5 * k + 0.5) + 0.5 * k) * s;
    const double distance = (x - cx) * (x - cx) + (y - cy) * (y - cy);
    if(distance < best)
    {
      best = distance;
      q = Vector(x - cx, y - cy, 0);
    }
  }
  const double a = std::abs(q.x()), b = std::abs(0.5 * q.x() + 0.5 * s * q.y()),
               c = std::abs(0.5 * q.x() - 0.5 * s * q.y());
  return 0.5 - (std::max)(a, (std::max)(b, c));
}

inline double clamped(double x) { return (std::min)(1., (std::max)(0., x)); }

/// One bump around each vertex of a subdivided icosahedron.
inline Benchmark_surface bumpy_sphere(int splits, double width, double height)
{
  std::vector<Vector> centers;
  std::vector<Benchmark_surface::Face> faces;
  subdivided_icosahedron(splits, centers, faces);
  return star_surface([centers, width, height](const Vector& d)
  {
    double cosine = -1;
    for(const Vector& c : centers)
      cosine = (std::max)(cosine, c.dot(d));
    const double angle = std::acos((std::min)(1., cosine)) / width;
    return height * std::exp(-angle * angle);
  });
}

/// The kinds of surfaces that the catalogue names; `variant` changes sizes and seeds.
struct Synthetic_kind { const char* name; const char* kind; };

inline const std::vector<Synthetic_kind>& synthetic_kinds()
{
  static const std::vector<Synthetic_kind> kinds = {
    { "block_torus", "structured" }, { "ribbed_torus", "structured" }, { "knurled_torus", "structured" },
    { "bumpy_sphere", "structured" }, { "studded_sphere", "structured" }, { "woven_sheet", "structured" },
    { "honeycomb", "structured" }, { "egg_crate", "structured" }, { "brick_wall", "structured" },
    { "roof_tiles", "structured" }, { "chevron_cylinder", "structured" }, { "fluted_cylinder", "structured" },
    { "rope_knot", "structured" }, { "beaded_ring", "structured" },
    { "staircase", "cad" }, { "comb", "cad" }, { "crossing_beams", "cad" }, { "pegs", "cad" },
    { "notched_frame", "cad" }, { "stepped_bracket", "cad" },
    { "rough_sphere", "stochastic" }, { "rough_torus", "stochastic" }, { "wave_sheet", "stochastic" },
    { "dune_sheet", "stochastic" },
    { "plain_torus", "smooth" }, { "plain_knot", "smooth" } };
  return kinds;
}

inline Benchmark_surface synthetic_surface(const std::string& name, std::size_t variant)
{
  const double n = 1 + 0.25 * double(variant % 3);                    // 1, 1.25, 1.5 times as many repeats
  const auto times = [n](double count) { return std::round(count * n); };
  if(name == "block_torus")
    return torus(0.38, [=](double u, double v)
      { return 0.06 * (std::min)(tile_profile(times(16) * u, 0.1, 0.08), tile_profile(times(6) * v, 0.1, 0.08)); });
  if(name == "ribbed_torus")
    return torus(0.35, [=](double u, double v) { return 0.03 * std::sin(two_pi * (times(24) * u + 3 * v)); });
  if(name == "knurled_torus")
    return torus(0.36, [=](double u, double v)
    {
      const double s = times(16) * u, t = times(6) * v;
      return 0.05 * (1 - std::abs(2 * fraction(s + t) - 1)) * (1 - std::abs(2 * fraction(s - t) - 1));
    });
  if(name == "bumpy_sphere")
    return bumpy_sphere(2, 0.12, 0.08);
  if(name == "studded_sphere")
    return bumpy_sphere(3, 0.045, 0.04);
  if(name == "woven_sheet")
    return sheet(0.1, [=](double x, double y)
      { const double p = 0.24 / n; return 0.8 * p * woven_height(x / p, y / p); });
  if(name == "honeycomb")
    return sheet(0.15, [=](double x, double y)
      { const double p = 0.2 / n; return 0.05 * (1 - clamped((honeycomb_distance(x / p, y / p) - 0.06) / 0.1)); });
  if(name == "egg_crate")
    return sheet(0.2, [=](double x, double y)
      { const double p = 0.25 / n; return 0.04 * std::cos(two_pi * x / p) * std::cos(two_pi * y / p); });
  if(name == "brick_wall")
    return sheet(0., [=](double x, double y)
    {
      const double row = std::floor(y / 0.14 * n);
      return 0.03 * (std::min)(tile_profile(y / 0.14 * n, 0.06, 0.08),
                               tile_profile(x / 0.3 * n + 0.5 * row, 0.03, 0.04));
    });
  if(name == "roof_tiles")
    return sheet(0.1, [=](double x, double y)
    {
      const double t = y / 0.2 * n, row = std::floor(t), f = fraction(t);
      const double ramp = f < 0.1 ? f / 0.1 : (1 - f) / 0.9;
      return 0.06 * ramp * (0.5 + std::abs(std::sin(0.5 * two_pi * (x / 0.16 * n + 0.5 * row))));
    });
  if(name == "chevron_cylinder")
    return cylinder(2., [=](double u, double v)
    {
      const double zigzag = std::abs(2 * fraction(times(8) * u) - 1);
      return 0.035 * tile_profile(times(12) * v + 0.8 * zigzag, 0.1, 0.15);
    });
  if(name == "fluted_cylinder")
    return cylinder(2., [=](double u, double v)
      { return 0.04 * std::abs(std::sin(0.5 * two_pi * times(20) * u)) + 0.02 * std::cos(two_pi * 3 * v); });
  if(name == "rope_knot")
    return trefoil_tube([=](double u, double v)
      { return 0.5 + 0.12 * std::abs(std::cos(1.5 * two_pi * v + 0.5 * two_pi * times(30) * u * 3)); });
  if(name == "beaded_ring")
    return torus(0.14, [=](double u, double) { return 0.1 * std::abs(std::sin(0.5 * two_pi * times(18) * u)); });
  if(name == "staircase")
    return staircase();
  if(name == "comb")
    return comb();
  if(name == "crossing_beams")
    return crossing_beams();
  if(name == "pegs")
    return pegs();
  if(name == "notched_frame")
    return notched_frame();
  if(name == "stepped_bracket")
    return stepped_bracket();
  if(name == "rough_sphere")
  {
    const Random_relief relief(0.22 / n, variant);
    return star_surface([relief](const Vector& d) { return 0.012 * relief(d); });
  }
  if(name == "rough_torus")
  {
    const Random_relief relief(0.25 / n, variant);
    return torus(0.38, [relief](double u, double v)
    {
      const double a = two_pi * u, b = two_pi * v;
      return 0.014 * relief(Vector((1 + 0.38 * std::cos(b)) * std::cos(a), (1 + 0.38 * std::cos(b)) * std::sin(a),
                                   0.38 * std::sin(b)));
    });
  }
  if(name == "wave_sheet")
    return sheet(0.05, [=](double x, double y)
    {
      return 0.02 * std::sin(n * (19 * x + 7 * y)) + 0.014 * std::sin(n * (-9 * x + 23.7 * y) + 1)
           + 0.01 * std::sin(n * (31.3 * x - 17 * y) + 2);
    });
  if(name == "dune_sheet")
  {
    const Random_relief relief(0.3 / n, variant);
    return sheet(0.1, [relief](double x, double y) { return 0.03 * std::abs(relief(Vector(x, 2 * y, 0))); });
  }
  if(name == "plain_torus")
    return torus(0.22, [](double, double) { return 0.; });
  if(name == "plain_knot")
    return trefoil_tube([](double, double) { return 0.5; });
  throw std::runtime_error("unknown synthetic surface " + name);
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SYNTHETIC_SURFACES_H
