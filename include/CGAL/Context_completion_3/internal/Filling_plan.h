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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_FILLING_PLAN_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_FILLING_PLAN_H

#include <CGAL/license/Context_completion_3.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A way to fill a hole: the smooth base, plus a share of what the best places have over it.
struct Filling_plan
{
  std::size_t places;        ///< so many best places are averaged; 0: smooth
  double share;              ///< of their relief that is added, 0 to 1

  explicit Filling_plan(std::size_t number_of_places = 0, double share_of_them = 0)
    : places(number_of_places), share(share_of_them)
  {}

  /// Whether a copy is carried as a whole: the rest, a tenth of the smooth continuation, could but blunt it.
  bool is_whole() const { return share > 0.9; }
};

/// A plan and its error on the fake holes.
struct Plan_forecast
{
  Filling_plan plan;
  double error = 0;          ///< expected mean distance to the true surface
  double upper = 0;          ///< one standard deviation above it

  /// How far a copy is to be believed beyond doubt: not at all below a share of four fifths, 1 for a whole copy.
  double belief() const { return plan.places > 0 && plan.share > 0.8 ? 5 * (plan.share - 0.8) : 0.; }

  /// By this factor anything else must promise to be better than the smooth continuation, which is never absurd.
  static constexpr double least_margin() { return 0.92; }

  /// The same for a copy: how much to take of one that is not believed is fitted to the fake holes, which promise too much
  /// then.
  double margin() const { return 0.75 + (least_margin() - 0.75) * (std::min)(1., 2 * belief()); }
};

/// How much of a copy is believed: 1 / (1 + (mismatch / scale)^3).
struct Trust
{
  double scale = 0;          ///< the mismatch at which a copy is half believed

  double share(double mismatch) const
  {
    const double r = mismatch / scale;
    return 1 / (1 + r * r * r);
  }
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_FILLING_PLAN_H
