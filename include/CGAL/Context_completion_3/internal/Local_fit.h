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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_FIT_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_FIT_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Local_approximation.h>
#include <CGAL/Context_completion_3/internal/Quadric_fit.h>
#include <CGAL/Context_completion_3/internal/Sharp_fit.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Constants of the multi-level partition of unity that the paper builds its fits on (section 4).
struct Local_fit_parameters
{
  std::size_t minimum_points = 15;   ///< N_min
  double support_factor = 0.75;      ///< alpha: radius of the support ball in cell diagonals
  double support_growth = 0.1;       ///< lambda: its growth while it holds too few points
};

/*!
  Which shape is fitted: many points whose normals turn by more than 90 degrees, a general quadric; many others, a
  bivariate one; few points, an edge or corner if their normals say so. A general quadric without a usable auxiliary
  point, for which the paper's source subdivides the cell, becomes a bivariate one, because every cell of every level
  needs a fit here. Empty data give an empty approximation.
*/
inline Local_approximation fit_local_approximation(const Fit_data& data,
                                                   const Local_fit_parameters& parameters = Local_fit_parameters())
{
  typedef Local_approximation::Kind Kind;
  if(data.size() == 0)
    return Local_approximation();
  if(data.size() < 6)
    return Local_approximation(Kind::plane, fit_bivariate_quadric(data));
  bool is_general = false;
  if(data.size() <= 2 * parameters.minimum_points)
  {
    const Local_approximation sharp = Sharp_fit::fit(data);
    if(!sharp.is_empty())
      return sharp;
  }
  const Vector n = data.mean_normal();
  for(std::size_t i = 0; i < data.size() && !is_general; ++i)
    is_general = data.normal(i).dot(n) < 0;
  Quadric q;
  if(is_general && fit_general_quadric(data, q))
    return Local_approximation(Kind::general, q);
  return Local_approximation(Kind::bivariate, fit_bivariate_quadric(data));
}

/// The paper's support: the points in the bare cell, equal weights (it names none).
template <typename IndexRange>
Fit_data bare_cell_support(const Surface_points& surface, const IndexRange& indices, const Vector& center, double edge)
{
  Fit_data data;
  data.surface = &surface;
  data.indices.assign(indices.begin(), indices.end());
  data.weights.assign(data.indices.size(), 1.);
  data.center = center;
  data.half_edge = 0.5 * edge;
  return data;
}

/*!
  The support ball of the multi-level partition of unity: radius 0.75 cell diagonals, grown by a tenth of that while
  it holds no more than N_min points, weighted by a quadratic B-spline of the distance.
  \param search over the positions of `surface`, with `in_ball()` as that of `Neighbor_search`
  \param side if not zero, points whose normals look the other way are left out, so that the far side of a thin part
         does not leak into the fit; they then do not count for N_min, either
*/
template <typename BallSearch>
Fit_data ball_support(const Surface_points& surface, const BallSearch& search, const Vector& center, double edge,
                      const Vector& side = Vector::Zero(),
                      const Local_fit_parameters& parameters = Local_fit_parameters())
{
  Fit_data data;
  data.surface = &surface;
  data.center = center;
  data.half_edge = 0.5 * edge;
  const double support = parameters.support_factor * std::sqrt(3.) * edge;
  double radius = support;
  std::vector<std::size_t> found;
  // a thousand steps are a hundred radii; a point set with fewer points of this side never has enough
  for(int step = 0; step < 1000; ++step, radius += parameters.support_growth * support)
  {
    search.in_ball(center, radius, found);
    data.indices.clear();
    for(std::size_t i : found)
      if(side.isZero() || is_same_side(side, surface.normal[i]))
        data.indices.push_back(i);
    if(data.size() > parameters.minimum_points || found.size() == surface.size() || !(support > 0))
      break;
  }
  std::vector<std::size_t> kept;
  for(std::size_t i : data.indices)
  {
    const double t = radius > 0 ? 1.5 * (surface.position[i] - center).norm() / radius : 0;
    const double w = t < 0.5 ? 0.75 - t * t : t < 1.5 ? 0.5 * (1.5 - t) * (1.5 - t) : 0;
    if(!(w > 1e-12))
      continue;
    kept.push_back(i);
    data.weights.push_back(w);
  }
  data.indices.swap(kept);
  return data;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_FIT_H
