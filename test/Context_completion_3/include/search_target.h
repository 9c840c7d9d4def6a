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

#ifndef CGAL_CONTEXT_COMPLETION_3_TEST_SEARCH_TARGET_H
#define CGAL_CONTEXT_COMPLETION_3_TEST_SEARCH_TARGET_H

#include <CGAL/Context_completion_3/internal/Hole_completion.h>
#include <CGAL/Context_completion_3/internal/Hole_detection.h>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace Test_surfaces {

/// What a search looks for: the first hole of a surface.
template <typename Tag>
CGAL::Context_completions_3::internal::Match_target
target_of(const CGAL::Context_completions_3::internal::Surface_model<Tag>& model)
{
  using namespace CGAL::Context_completions_3::internal;
  std::vector<Detected_hole<Tag> > holes;
  EXPECT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
  for(const Detected_hole<Tag>& h : holes)
    if(!h.is_outer_border)
      return Hole_completion<Tag>::match_target(model, *h.patch);
  ADD_FAILURE() << "no hole";
  return Match_target();
}

} // namespace Test_surfaces

#endif // CGAL_CONTEXT_COMPLETION_3_TEST_SEARCH_TARGET_H
