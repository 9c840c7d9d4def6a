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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Motion.h>

#include <cstddef>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A source place carried into a hole.
struct Place
{
  std::size_t source = 0;            ///< which example source
  Motion motion;                     ///< source to hole
  Vector origin = Vector::Zero();    ///< where the centre of the hole lies on the source
  double score = 0;                  ///< match score, 0 perfect
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_H
