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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_SAMPLE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_SAMPLE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A sample of the smooth base.
struct Base_sample
{
  Vector position = Vector::Zero();
  Vector normal = Vector::Zero();
  bool is_uncovered = false;   ///< no known point is near, or none near a place next to it: evidence of a hole
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_SAMPLE_H
