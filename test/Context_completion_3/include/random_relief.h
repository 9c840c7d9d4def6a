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


#ifndef CGAL_CONTEXT_COMPLETION_3_TEST_RANDOM_RELIEF_H
#define CGAL_CONTEXT_COMPLETION_3_TEST_RANDOM_RELIEF_H

#include "surface_samples.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace Test_surfaces {

/// A height field: the sum of plane waves of random directions and phases and of nearly the same length. It has no period.
class Random_relief
{
public:
  explicit Random_relief(unsigned int seed) : m_random(seed) {}

  void add(double root_mean_square, double wave_length, std::size_t number)
  {
    for(std::size_t i = 0; i < number; ++i)
    {
      const double direction = pi * m_random();
      const double frequency = 2 * pi / (wave_length * (1.025 + 0.225 * m_random()));
      m_waves.push_back({ frequency * std::cos(direction), frequency * std::sin(direction), pi * m_random(),
                          root_mean_square * std::sqrt(2. / double(number)) });
    }
  }

  double height(double x, double y) const
  {
    double sum = 0;
    for(const Wave& w : m_waves)
      sum += w.amplitude * std::cos(w.x * x + w.y * y + w.phase);
    return sum;
  }

  std::pair<double, double> gradient(double x, double y) const
  {
    std::pair<double, double> sum(0., 0.);
    for(const Wave& w : m_waves)
    {
      const double slope = -w.amplitude * std::sin(w.x * x + w.y * y + w.phase);
      sum.first += w.x * slope;
      sum.second += w.y * slope;
    }
    return sum;
  }

  /// Of `p` to the surface, to first order.
  template <typename Point_>
  double distance(const Point_& p) const
  {
    const std::pair<double, double> d = gradient(p.x(), p.y());
    return std::abs(p.z() - height(p.x(), p.y())) / std::sqrt(1 + d.first * d.first + d.second * d.second);
  }

private:
  struct Wave { double x, y, phase, amplitude; };

  Random_offsets m_random;
  std::vector<Wave> m_waves;
};

} // namespace Test_surfaces

#endif // CGAL_CONTEXT_COMPLETION_3_TEST_RANDOM_RELIEF_H
