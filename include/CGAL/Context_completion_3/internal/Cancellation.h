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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CANCELLATION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CANCELLATION_H

#include <CGAL/license/Context_completion_3.h>

#include <functional>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Thrown by a poll when the user's callback says so, and caught where the callback was given; users never see it.
struct Cancelled {};

/// What long steps call now and then, from the thread that called them.
typedef std::function<void()> Poll;

/// Asks a callback, which may be empty, with the same fraction each time: what is done in one piece has no parts.
inline Poll make_poll(const std::function<bool(double)>& callback, double fraction)
{
  return [&callback, fraction]()
  {
    if(callback && !callback(fraction))
      throw Cancelled();
  };
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CANCELLATION_H
