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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_EVIDENCE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_EVIDENCE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Rim_surroundings.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// The least number of points of a rim.
inline std::size_t fewest_rim_points() { return 8; }

/*!
  Whether a base is evidence of a hole: it has room for some points between its rims, and these go around it, at least
  half of its circumference is found. Irregular samplings have groups of rim points that face each other over a covered
  place.
*/
template <typename ConcurrencyTag>
bool is_evident(const Smooth_patch<ConcurrencyTag>& patch)
{
  return patch.number_of_uncovered() >= Smooth_patch<ConcurrencyTag>::fewest_uncovered() &&
         patch.rim().size() >= fewest_rim_points() &&
         double(patch.rim().size()) * patch.surroundings()->gap_spacing() >= patch.diameter();
}

/*!
  Whether the base continues the surface at the rim, on the whole; the end of a tube would have to be capped across.
  \param least mean cosine between the normals at the rim and the mean one of the base
*/
template <typename ConcurrencyTag>
bool is_faced(const Smooth_patch<ConcurrencyTag>& patch, double least)
{
  Vector mean = Vector::Zero();
  for(const Base_sample& s : patch.samples())
    mean += s.normal;
  double sum = 0;
  for(std::size_t i : patch.rim())
    sum += patch.surroundings()->model().normal(i).dot(mean.normalized());
  return sum >= least * double(patch.rim().size());
}

/*!
  Whether the points thin out, and what the base finds uncovered is near points that are much farther from each other
  than those of the rim, as on the flat parts of an adaptive mesh. The spacing of a point is a median around it: stray
  points in a hole have that of its rim, and the few of a small island seem far apart but for the nearest of each.
*/
template <typename ConcurrencyTag>
bool is_sparse(const Smooth_patch<ConcurrencyTag>& patch)
{
  const double sparse = 1.75 * patch.spacing(), near = 2;   // spacings of the rim, of the point
  const Surface_model<ConcurrencyTag>& model = patch.surroundings()->model();
  std::size_t bare = 0, uncovered = 0;
  std::vector<Neighbor_search::Neighbor> found;
  std::vector<std::size_t> ball;
  const auto is_lone = [&](std::size_t i)
  {
    model.search().in_ball(model.position(i), sparse, ball);
    return std::count_if(ball.begin(), ball.end(), [&](std::size_t j)
      { return j != i && is_same_side(model.normal(i), model.normal(j)); }) < 2;
  };
  for(const Base_sample& s : patch.samples())
  {
    if(!s.is_uncovered)
      continue;
    ++uncovered;
    model.search().k_nearest(s.position, 12, found);
    bare += std::none_of(found.begin(), found.end(), [&](const Neighbor_search::Neighbor& n)
    {
      const double spacing = model.spacing(n.first);
      return spacing > sparse && n.second < near * spacing && is_same_side(s.normal, model.normal(n.first)) &&
             is_lone(n.first);
    });
  }
  return 2 * bare < uncovered;
}

/*!
  Whether a rim is whole: a closed curve is at least two diameters long, of which a tenth may be missing, and at most pi if
  it is convex. Both rims of a narrow strip are longer.
  \param further number of points at which the base ends, too, one after the other
*/
template <typename ConcurrencyTag>
bool goes_around_once(const Rim_surroundings<ConcurrencyTag>& surroundings, std::size_t further)
{
  const double length = double(surroundings.rim().size() + further) * surroundings.gap_spacing();
  return length >= 1.8 * surroundings.diameter() && length <= 4 * surroundings.diameter();
}

/// Share of the points of a rim that fragments have at most, which a base may leave alone.
inline double largest_fragment() { return 0.2; }

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_EVIDENCE_H
