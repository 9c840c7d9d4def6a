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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SECOND_BASE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SECOND_BASE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_evidence.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <CGAL/number_utils.h>

#include <memory>
#include <optional>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Whether one base is, by the number of its samples, clearly larger than another.
template <typename ConcurrencyTag>
bool is_bulge(const Smooth_patch<ConcurrencyTag>& patch, const Smooth_patch<ConcurrencyTag>& other)
{
  return double(patch.samples().size()) > 1.15 * double(other.samples().size());
}

/// Whether a base is a spacing and more from another (root mean square over its samples): relief that the rim cuts leads one
/// of them up or down.
template <typename ConcurrencyTag>
bool lies_elsewhere(const Smooth_patch<ConcurrencyTag>& patch, const Smooth_patch<ConcurrencyTag>& other)
{
  double sum = 0;
  for(const Base_sample& s : patch.samples())
  {
    Vector x = s.position, normal;
    if(!other.project(x, normal))
      return true;
    sum += (x - s.position).squaredNorm();
  }
  return sum >= CGAL::square(patch.spacing()) * double(patch.samples().size());
}

/*!
  A stiff base where another one bulges, or lies elsewhere.
  \param left_alone the largest share of rim points that it may leave alone; one that leaves more is no answer
  \return none where both are much the same
*/
template <typename ConcurrencyTag>
std::shared_ptr<const Smooth_patch<ConcurrencyTag> >
second_base(const Smooth_patch<ConcurrencyTag>& patch, double left_alone)
{
  const auto stiff =
    std::make_shared<const Smooth_patch<ConcurrencyTag> >(patch.surroundings(), true, std::nullopt, patch.guides());
  const bool is_torn = stiff->joined_share() < patch.joined_share() - left_alone;
  if(!stiff->is_closed() || is_torn || !is_evident(*stiff))
    return nullptr;
  return is_bulge(patch, *stiff) || lies_elsewhere(patch, *stiff) ? stiff : nullptr;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SECOND_BASE_H
