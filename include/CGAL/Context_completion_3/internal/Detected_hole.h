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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_DETECTED_HOLE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_DETECTED_HOLE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Second_base.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// An under-sampled place, with the base over it.
template <typename ConcurrencyTag>
struct Detected_hole
{
  std::vector<Rim_loop> loops;
  std::shared_ptr<const Smooth_patch<ConcurrencyTag> > patch;   ///< none where no base closes the rim
  std::shared_ptr<const Smooth_patch<ConcurrencyTag> > stiff;   ///< another, where that bulges or lies elsewhere
  bool is_outer_border = false;
  bool is_end = false;          ///< of a tube: a hole if a place that closes matches it, an outer border otherwise
  bool is_named = false;        ///< by the user

  /// Mean of the rim points.
  Vector center() const
  {
    Vector sum = Vector::Zero();
    std::size_t number = 0;
    for(const Rim_loop& loop : loops)
    {
      sum += double(loop.points.size()) * loop.center;
      number += loop.points.size();
    }
    return sum / double(number);
  }
};

/// A hole that a base fills. \param left_alone the largest share of rim points that a stiff base may leave alone
template <typename ConcurrencyTag>
Detected_hole<ConcurrencyTag> hole_of(const std::shared_ptr<const Smooth_patch<ConcurrencyTag> >& patch, double left_alone)
{
  Detected_hole<ConcurrencyTag> hole;
  hole.loops = patch->loops();
  hole.patch = patch;
  hole.stiff = second_base(*patch, left_alone);
  return hole;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_DETECTED_HOLE_H
