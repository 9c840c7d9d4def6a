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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEFAULT_COMPLETION_VISITOR_H
#define CGAL_CONTEXT_COMPLETION_3_DEFAULT_COMPLETION_VISITOR_H

#include <CGAL/license/Context_completion_3.h>

#include <cstddef>

namespace CGAL {
namespace Context_completions_3 {

/*!
  \ingroup PkgContextCompletion3Ref

  \brief is the visitor that does nothing.

  A visitor that is interested in some events only can derive from it.

  \cgalModels{CompletionVisitor}
*/
struct Default_completion_visitor
{
  /// \name Detection
  /// @{
  void on_detection_begin(std::size_t /* number_of_points */) {} ///< does nothing
  void on_detection_end(std::size_t /* number_of_holes */) {} ///< does nothing
  /// @}

  /// \name Completion
  /// @{
  void on_completion_begin(std::size_t /* number_of_chosen_holes */) {} ///< does nothing
  void on_hole_begin(std::size_t /* hole */) {} ///< does nothing
  void on_hole_end(std::size_t /* hole */, std::size_t /* number_of_new_points */) {} ///< does nothing
  void on_completion_end(std::size_t /* number_of_new_points */) {} ///< does nothing
  /// @}
};

} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_DEFAULT_COMPLETION_VISITOR_H
