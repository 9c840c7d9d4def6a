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

#ifndef CGAL_CONTEXT_COMPLETION_3_TEST_SURFACE_SAMPLES_H
#define CGAL_CONTEXT_COMPLETION_3_TEST_SURFACE_SAMPLES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Sampled surfaces of known shape. All samples are evenly spread, and the same on every machine.
namespace Test_surfaces {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::pair<Point, Vector> Oriented_point;
typedef std::vector<Oriented_point> Samples;

const double pi = 3.14159265358979323846;

/// Uniform numbers in [-1, 1), the same with every standard library.
class Random_offsets
{
public:
  explicit Random_offsets(unsigned int seed) : m_engine(seed) {}
  double operator()() { return double(m_engine()) / 2147483648. - 1.; }
private:
  std::mt19937 m_engine;
};

inline Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

/*!
  A patch [0, rows * spacing]^2 of the graph z = height(x, y): rows of points, each shifted by half a spacing against
  the one before, and jittered by a share of the spacing.
  \param gradient receives x, y and returns the pair of the partial derivatives
*/
inline Samples graph(std::size_t rows, double spacing, const std::function<double(double, double)>& height,
                     const std::function<std::pair<double, double>(double, double)>& gradient,
                     double jitter = 0.15, unsigned int seed = 1)
{
  Random_offsets offset(seed);
  Samples samples;
  const double row_distance = spacing * std::sqrt(0.75);
  const std::size_t number_of_rows = std::size_t(std::floor(double(rows) * spacing / row_distance));
  for(std::size_t j = 0; j < number_of_rows; ++j)
    for(std::size_t i = 0; i < rows; ++i)
    {
      const double x = (double(i) + (j % 2 == 0 ? 0.25 : 0.75) + jitter * offset()) * spacing;
      const double y = (double(j) + 0.5 + jitter * offset()) * row_distance;
      const std::pair<double, double> d = gradient(x, y);
      samples.emplace_back(Point(x, y, height(x, y)), unit(Vector(-d.first, -d.second, 1.)));
    }
  return samples;
}

inline Samples plane(std::size_t rows, double spacing = 1., double jitter = 0.15, unsigned int seed = 1)
{
  return graph(rows, spacing, [](double, double) { return 0.; },
               [](double, double) { return std::make_pair(0., 0.); }, jitter, seed);
}

/// A flat sheet [0, width]^2 whose points are `distance(x, y)` apart from those before them.
inline Samples thinning_plane(double width, const std::function<double(double, double)>& distance,
                              unsigned int seed = 1, int darts_per_area = 12)
{
  Random_offsets offset(seed);
  Samples samples;
  for(int dart = 0; dart < darts_per_area * int(width * width); ++dart)
  {
    const double x = (1 + offset()) / 2 * width;
    const double y = (1 + offset()) / 2 * width;
    const double room = distance(x, y);
    bool is_free = true;
    for(std::size_t i = 0; i < samples.size() && is_free; ++i)
      is_free = CGAL::squared_distance(samples[i].first, Point(x, y, 0)) >= room * room;
    if(is_free)
      samples.emplace_back(Point(x, y, 0), Vector(0, 0, 1));
  }
  return samples;
}

/// An egg box: bumps of the given height that repeat with the given period in x and y.
inline Samples bumpy_plane(std::size_t rows, double spacing, double period, double bump, double jitter = 0.15,
                           unsigned int seed = 1)
{
  const double k = 2. * pi / period;
  return graph(rows, spacing,
    [=](double x, double y) { return bump * std::sin(k * x) * std::sin(k * y); },
    [=](double x, double y)
      { return std::make_pair(bump * k * std::cos(k * x) * std::sin(k * y),
                              bump * k * std::sin(k * x) * std::cos(k * y)); }, jitter, seed);
}

/// Points of the graph of a steep `height` over [0, width] x [0, depth], no two closer than `distance`.
inline Samples steep_graph(double width, double depth, double distance,
                           const std::function<double(double, double)>& height,
                           unsigned int seed = 1)
{
  Random_offsets offset(seed);
  Samples dense, even;
  const double fine = 0.35 * distance, step = 1e-5;
  for(double x = 0; x < width; x += fine)
    for(double y = 0; y < depth; y += fine)
    {
      const double u = x + 0.5 * fine * offset(), v = y + 0.5 * fine * offset();
      dense.emplace_back(Point(u, v, height(u, v)),
        unit(Vector((height(u - step, v) - height(u + step, v)) / (2 * step),
                    (height(u, v - step) - height(u, v + step)) / (2 * step), 1.)));
    }
  std::mt19937 engine(seed);
  for(std::size_t i = dense.size(); i > 1; --i)
    std::swap(dense[i - 1], dense[engine() % i]);
  std::map<std::array<int, 3>, std::vector<Point> > buckets;
  for(const Oriented_point& s : dense)
  {
    const int x = int(std::floor(s.first.x() / distance)), y = int(std::floor(s.first.y() / distance)),
              z = int(std::floor(s.first.z() / distance));
    bool is_free = true;
    for(int i = 0; i < 27; ++i)
      for(const Point& p : buckets[{{ x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1 }}])
        is_free = is_free && CGAL::squared_distance(p, s.first) >= distance * distance;
    if(!is_free)
      continue;
    buckets[{{ x, y, z }}].push_back(s.first);
    even.push_back(s);
  }
  return even;
}

/// Rows of tiles, each round across and rising along the slope to a steep edge: relief of 2.4 that a rim cuts anywhere.
inline double tiles_height(double x, double y)
{
  const double row = std::floor(y / 8), along = y / 8 - row, ramp = along < 0.1 ? along / 0.1 : (1 - along) / 0.9;
  return 2.4 * ramp * (0.5 + std::abs(std::sin(pi * (x / 6.4 + 0.5 * row))));
}

/// Bricks of 14 by 7, with joints 2.4 wide and 2 deep.
inline double bricks_height(double x, double y)
{
  const double row = std::floor(y / 7), across = y - 7 * row, shifted = x / 14 + 0.5 * row,
               along = 14 * (shifted - std::floor(shifted)),
               inside = (std::min)((std::min)(along, 14 - along), (std::min)(across, 7 - across));
  return 2 * (std::min)(1., (std::max)(0., (inside - 1.2) / 0.3));
}

/// The i-th of n directions on a spiral from pole to pole with steps of the golden angle.
inline Vector spiral_direction(std::size_t i, std::size_t n)
{
  const double z = 1. - (2. * double(i) + 1.) / double(n);
  const double angle = double(i) * pi * (3. - std::sqrt(5.));
  const double r = std::sqrt((std::max)(0., 1. - z * z));
  return Vector(r * std::cos(angle), r * std::sin(angle), z);
}

/// A sphere at the origin whose radius varies by `bump` cos(kx) cos(ky) cos(kz) of the direction (x, y, z): the relief
/// repeats in all eight octants, mirrored.
inline Samples bumpy_sphere(std::size_t n, double radius, double bump, double k)
{
  Samples samples;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Vector d = spiral_direction(i, n);
    const double cx = std::cos(k * d.x()), cy = std::cos(k * d.y()), cz = std::cos(k * d.z());
    const double r = radius + bump * cx * cy * cz;
    const Vector change = -bump * k * Vector(std::sin(k * d.x()) * cy * cz, cx * std::sin(k * d.y()) * cz,
                                             cx * cy * std::sin(k * d.z()));
    // the gradient of |p| - r(p / |p|)
    samples.emplace_back(CGAL::ORIGIN + r * d, unit(d - (change - (change * d) * d) / r));
  }
  return samples;
}

inline Samples sphere(std::size_t n, double radius)
{
  return bumpy_sphere(n, radius, 0., 1.);
}

/// An open tube around the z axis, from z = 0 to z = rows * distance of the rows.
inline Samples cylinder(std::size_t around, std::size_t rows, double radius, double jitter = 0.15,
                        unsigned int seed = 1)
{
  Random_offsets offset(seed);
  Samples samples;
  const double spacing = 2. * pi * radius / double(around), row_distance = spacing * std::sqrt(0.75);
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < around; ++i)
    {
      const double angle = (double(i) + (j % 2 == 0 ? 0. : 0.5) + jitter * offset()) * spacing / radius;
      const Vector n(std::cos(angle), std::sin(angle), 0.);
      const double z = (double(j) + 0.5 + jitter * offset()) * row_distance;
      samples.emplace_back(Point(radius * n.x(), radius * n.y(), z), n);
    }
  return samples;
}

/// Removes the samples inside a ball, and appends them to `removed` if it is given.
inline Samples without_ball(const Samples& samples, const Point& center, double radius, Samples* removed = nullptr)
{
  Samples rest;
  for(const Oriented_point& s : samples)
    if(CGAL::squared_distance(s.first, center) > radius * radius)
      rest.push_back(s);
    else if(removed != nullptr)
      removed->push_back(s);
  return rest;
}

/// A flat sheet with a round hole of 8 spacings in the middle.
inline Samples plane_with_hole()
{
  return without_ball(plane(32), Point(16, 16, 0), 4.);
}

/// An egg box of 6 by 6 periods, with a round hole of a good part of a period.
inline Samples bumpy_plane_with_hole()
{
  return without_ball(bumpy_plane(48, 1., 8., 1.), Point(25, 23, 0), 4.);
}

/// Four patterns that meet at (40, 40): what is around that point is there only once, what is around each part of it,
/// many times.
inline double four_patterns_height(double x, double y)
{
  const double u = x - 40, v = y - 40, w = 2 * pi / 8;
  const double along = 1.5 * std::cos(w * u), across = 1.5 * std::cos(w * v);
  return u < 0 ? (v < 0 ? along : across) : (v < 0 ? across : along);
}

/// [0, 80]^2, with a hole of radius 11 where the patterns meet.
inline Samples four_patterns_with_hole()
{
  return without_ball(steep_graph(80, 80, 1., four_patterns_height), Point(40, 40, 0), 11.);
}

/// A sheet with two holes of different size, far from each other.
inline Samples plane_with_two_holes()
{
  return without_ball(without_ball(plane(44), Point(14, 14, 0), 4.), Point(29, 30, 0), 5.5);
}

/// The same points in another kernel.
template <typename Kernel_>
std::vector<std::pair<typename Kernel_::Point_3, typename Kernel_::Vector_3> > converted(const Samples& samples)
{
  typedef typename Kernel_::FT FT;
  std::vector<std::pair<typename Kernel_::Point_3, typename Kernel_::Vector_3> > result;
  for(const Oriented_point& s : samples)
    result.emplace_back(typename Kernel_::Point_3(FT(s.first.x()), FT(s.first.y()), FT(s.first.z())),
                        typename Kernel_::Vector_3(FT(s.second.x()), FT(s.second.y()), FT(s.second.z())));
  return result;
}

template <typename Kernel_ = Kernel>
CGAL::Point_set_3<typename Kernel_::Point_3> point_set(const Samples& samples)
{
  CGAL::Point_set_3<typename Kernel_::Point_3> points(true);
  for(const auto& s : converted<Kernel_>(samples))
    points.insert(s.first, s.second);
  return points;
}

} // namespace Test_surfaces

#endif // CGAL_CONTEXT_COMPLETION_3_TEST_SURFACE_SAMPLES_H
