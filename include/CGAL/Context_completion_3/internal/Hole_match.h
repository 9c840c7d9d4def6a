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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_MATCH_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_MATCH_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Copy_forecast.h>
#include <CGAL/Context_completion_3/internal/Filling_plan.h>
#include <CGAL/Context_completion_3/internal/Place.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// What was found for a hole, and which plan the forecasts chose.
template <typename ConcurrencyTag>
struct Hole_match
{
  std::shared_ptr<const Smooth_patch<ConcurrencyTag> > patch;   ///< the base that all is seen from
  std::shared_ptr<const Relief_sampler<ConcurrencyTag> > sampler;
  std::vector<Place> places;               ///< source places, best score first
  std::vector<Place_relief> reliefs;       ///< parallel to places
  std::shared_ptr<const Copy_forecast<ConcurrencyTag> > forecast;
  Plan_forecast smooth, chosen;
  double best = 0;                         ///< mismatch of the best place
  bool has_fake_holes = false;             ///< whether the forecasts are learnt
  bool continues_edges = false;            ///< whether the smooth plan is made of facets
  std::size_t teachers = 0;                ///< places that the smooth plan was learnt from, 0: it is smooth

  /// Whether the hole is to be filled by facets that go on until they meet.
  bool is_faceted() const { return chosen.plan.places == 0 && continues_edges; }

  /// Forgets what only `Hole_completion::relief()` needs.
  void shrink()
  {
    reliefs.clear();
    reliefs.shrink_to_fit();
    forecast.reset();
  }
};

/*!
  Whether what was found over a stiff base is better than what was found over another. Where that bulges, places lie badly
  on it, and the fake holes, which are seen from it too, bulge alike: so a copy over the stiff base that is to be believed
  wins over all but another such copy and facets. Facets need a base for their forecast alone, and win by that; but where
  too few places resemble the hole, that the stiff base finds some is no promise. A smooth surface that no place resembles
  gives way to one that some do. Where the other base is no larger, a copy has to promise clearly less.
  \param bulges whether the other base does
*/
template <typename ConcurrencyTag>
bool is_better_over_stiff_base(const Hole_match<ConcurrencyTag>& stiff, const Hole_match<ConcurrencyTag>& other, bool bulges)
{
  const bool is_surer = stiff.chosen.error < other.chosen.error;
  if(!bulges)
    return stiff.chosen.belief() > 0 && (!other.has_fake_holes || stiff.chosen.error < 0.5 * other.chosen.error);
  if(stiff.chosen.belief() > 0)
    return is_surer || (other.chosen.belief() == 0 && !other.is_faceted());
  if(stiff.is_faceted())
    return other.has_fake_holes && is_surer;
  return stiff.has_fake_holes && !other.has_fake_holes && !other.is_faceted();
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_MATCH_H
