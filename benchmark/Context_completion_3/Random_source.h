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

#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_RANDOM_SOURCE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_RANDOM_SOURCE_H

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace Completion_benchmark {

typedef CGAL::Context_completions_3::internal::Vector Vector;
typedef CGAL::Context_completions_3::internal::Matrix Matrix;
typedef CGAL::Context_completions_3::internal::Surface_points Surface_points;

constexpr double two_pi = 6.283185307179586;

/// Numbers that are the same on every platform: the distributions of the standard library are not.
class Random_source
{
public:
  explicit Random_source(std::uint64_t seed) : m_engine(seed) {}

  double uniform() { return double(m_engine() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  std::size_t index(std::size_t size) { return std::size_t(m_engine() % size); }
  std::uint64_t seed() { return m_engine(); }

  double normal()
  {
    const double radius = std::sqrt(-2. * std::log(1. - uniform()));
    return radius * std::cos(two_pi * uniform());
  }

  Vector normal_vector()
  {
    const double x = normal(), y = normal(), z = normal();
    return Vector(x, y, z);
  }

  Vector direction()
  {
    Vector v = normal_vector();
    while(v.norm() < 1e-6)
      v = normal_vector();
    return v.normalized();
  }

  Matrix rotation()
  {
    const Vector x = direction();
    const Vector y = x.cross(direction()).normalized();
    Matrix m;
    m << x, y, x.cross(y);
    return m;
  }

  std::vector<std::size_t> permutation(std::size_t size)
  {
    std::vector<std::size_t> order(size);
    for(std::size_t i = 0; i < size; ++i)
      order[i] = i;
    for(std::size_t i = size; i > 1; --i)
      std::swap(order[i - 1], order[index(i)]);
    return order;
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_RANDOM_SOURCE_H
