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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_MISMATCH_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_MISMATCH_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Place_relief.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// How badly a place fits around a hole: a weighted mean of terms between 0 (perfect) and 1 + kappa (hopeless), those
/// of equations 1 to 3 of the paper, truncated.
class Rim_mismatch
{
public:
  /// \param spacing of points
  explicit Rim_mismatch(double spacing) : m_tau(2 * spacing) {}

  /*!
    Compares values and slopes at the centres around a hole.
    \param place, other seen from the base of the hole; no place is the hole itself
    \param weights of the centres
  */
  void add_centers(const Place_relief* place, const Place_relief& other, const std::vector<double>& weights)
  {
    for(std::size_t i = 0; i < weights.size(); ++i)
    {
      if(weights[i] == 0)
        continue;
      const bool is_found = other.is_found[i] != 0, is_expected = place == nullptr || place->is_found[i] != 0;
      if(!is_found && !is_expected)
        continue;
      if(is_found != is_expected) // a wall that only one of them has is as bad as can be
      {
        add(1 + kappa(), weights[i]);
        continue;
      }
      double d[4];
      for(Eigen::Index k = 0; k < 4; ++k)
        d[k] = other.rim[4 * Eigen::Index(i) + k] - (place != nullptr ? place->rim[4 * Eigen::Index(i) + k] : 0.);
      const double slope = Vector(d[1], d[2], d[3]).norm();
      add(of_height(d[0]) + kappa() * (std::min)(1., slope * slope / 2), weights[i]);
    }
  }

  /// Compares heights where there is no more to compare.
  void add_height(double difference, double weight) { add(of_height(difference), weight); }

  double mean() const { return m_total > 0 ? m_sum / m_total : 1 + kappa(); }

private:
  static double kappa() { return 0.5; }

  double of_height(double d) const { return (std::min)(1., (d / m_tau) * (d / m_tau)); }

  void add(double term, double weight)
  {
    m_sum += weight * term;
    m_total += weight;
  }

  double m_tau, m_sum = 0, m_total = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_MISMATCH_H
