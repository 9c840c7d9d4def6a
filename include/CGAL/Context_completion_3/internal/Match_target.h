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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_MATCH_TARGET_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_MATCH_TARGET_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Motion.h>
#include <CGAL/Context_completion_3/internal/Overlap_alignment.h>
#include <CGAL/Context_completion_3/internal/Place_descriptor.h>
#include <CGAL/Context_completion_3/internal/Place_index.h>
#include <CGAL/Context_completion_3/internal/Place_signature.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// What is searched for: the surroundings of a hole and its current base.
struct Match_target
{
  Surface_frame frame;                      ///< at the middle of the hole
  double radius = 0;
  double spacing = 0;
  std::vector<Match_probe> overlap;         ///< known surroundings
  std::vector<Match_probe> base;            ///< the current approximation inside, of less weight
  std::vector<Smoothed_place> around;       ///< known surroundings, smoothed: what the shortlist goes by
  Surface_points surface;                   ///< what signatures look at: the surroundings and what fills the hole now

  /// How far from the middle the signature looks.
  double reach() const { return Place_signatures::reach(radius); }

  /// Fills in the known part of what the shortlist and the signature go by. \pre frame, radius and overlap are set
  template <typename ConcurrencyTag>
  void describe_surroundings(const Surface_model<ConcurrencyTag>& known)
  {
    const double deviation = Place_index<ConcurrencyTag>::smoothing(radius);
    for(const Match_probe& p : overlap)
      around.push_back(smoothed_place(known, p.position, p.normal, deviation));
    std::vector<std::size_t> ball;
    known.search().in_ball(frame.origin, reach(), ball);
    for(std::size_t i : ball)
      surface.push_back(known.position(i), known.normal(i));
  }
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_MATCH_TARGET_H
