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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_MESSAGE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_MESSAGE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/Invalid_input.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <sstream>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// The parts of a sentence, written one after the other.
template <typename... Parts>
std::string message(const Parts&... parts)
{
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

inline std::string coordinates(const Vector& v)
{
  return message('(', v.x(), ", ", v.y(), ", ", v.z(), ')');
}

template <typename... Parts>
void require(bool condition, const Parts&... parts)
{
  if(!condition)
    throw Invalid_input(message(parts...));
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_MESSAGE_H
