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

#ifndef CGAL_CONTEXT_COMPLETION_3_INVALID_INPUT_H
#define CGAL_CONTEXT_COMPLETION_3_INVALID_INPUT_H

#include <CGAL/license/Context_completion_3.h>

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Context_completions_3 {

/*!
  \ingroup PkgContextCompletion3Ref

  \brief is thrown when a point set or a parameter cannot be used.

  `what()` is a sentence that names the point, the set or the parameter, and the offending value.
  It is thrown before anything has been changed or written.
*/
class Invalid_input : public std::invalid_argument
{
public:
  /// \param sentence what is wrong, and with which value
  explicit Invalid_input(const std::string& sentence) : std::invalid_argument(sentence) {}
};

} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INVALID_INPUT_H
