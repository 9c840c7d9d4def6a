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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_EXAMPLE_SOURCE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_EXAMPLE_SOURCE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Nearest_point_grid.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A point set from which may be copied: the completed set, as far as its mask allows, or a further example set.
template <typename ConcurrencyTag>
struct Example_source
{
  std::size_t set = 0;                                       ///< 0: the completed set
  std::shared_ptr<const Surface_points> points;
  std::shared_ptr<const Surface_model<ConcurrencyTag> > model;
  std::vector<std::size_t> original;                         ///< indices in the caller's set; empty: the same

  std::size_t original_index(std::size_t i) const { return original.empty() ? i : original[i]; }
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_EXAMPLE_SOURCE_H
