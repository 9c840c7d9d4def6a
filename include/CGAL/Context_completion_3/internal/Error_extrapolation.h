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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_ERROR_EXTRAPOLATION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_ERROR_EXTRAPOLATION_H

#include <CGAL/license/Context_completion_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Fake holes differ from the hole: another one may be rougher around, or have found better examples. The errors made
  there are carried to the hole along a power law of a predictor; its exponent is fitted, with 1 as the prior.

  \param errors on the fake holes
  \param weights of them, of sum 1
  \param predictors logarithms of what the errors grow with
  \param predictor that of the hole
  \param floor errors below are alike
  \param error, upper receive the error to expect, and one standard deviation above it
*/
inline void extrapolate_errors(const std::vector<double>& errors, const std::vector<double>& weights,
                               const std::vector<double>& predictors, double predictor, double floor, double& error,
                               double& upper)
{
  std::vector<double> y;
  double mean_x = 0, mean_y = 0;
  for(std::size_t i = 0; i < errors.size(); ++i)
  {
    y.push_back(std::log(errors[i] + floor));
    mean_x += weights[i] * predictors[i];
    mean_y += weights[i] * y.back();
  }
  double xx = 0, xy = 0;
  for(std::size_t i = 0; i < y.size(); ++i)
  {
    xx += weights[i] * (predictors[i] - mean_x) * (predictors[i] - mean_x);
    xy += weights[i] * (predictors[i] - mean_x) * (y[i] - mean_y);
  }
  const double prior = 1, strength = 0.1;
  const double slope = (std::max)(0., (std::min)(1., (xy + strength * prior) / (xx + strength)));
  const double step = (std::max)(-1.5, (std::min)(1.5, predictor - mean_x));
  double spread = 0;
  for(std::size_t i = 0; i < y.size(); ++i)
  {
    const double d = y[i] - mean_y - slope * (predictors[i] - mean_x);
    spread += weights[i] * d * d;
  }
  const double center = mean_y + slope * step;
  error = (std::max)(0., std::exp(center) - floor);
  // a standard deviation, and a quarter for what fake holes cannot show, by generated cases of known truth
  upper = 1.25 * std::exp(center + std::sqrt(spread + 0.06)) - floor;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_ERROR_EXTRAPOLATION_H
