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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_FOR_EACH_INDEX_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_FOR_EACH_INDEX_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/for_each.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Calls `function` with 0, 1, ..., `number` - 1, in parallel if the tag says so.
template <typename ConcurrencyTag, typename Function>
void for_each_index(std::size_t number, const Function& function)
{
  std::vector<std::size_t> indices;
  for(std::size_t i = 0; i < number; ++i)
    indices.push_back(i);
  CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t i) -> bool
  {
    function(i);
    return true;
  });
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_FOR_EACH_INDEX_H
