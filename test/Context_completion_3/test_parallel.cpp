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

// The result does not depend on the number of threads, nor on the run.

#include "include/surface_samples.h"

#include <CGAL/context_complete.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <iterator>
#include <utility>
#include <vector>

namespace test_parallel {

namespace samples = Test_surfaces;

namespace {

typedef CGAL::Context_completions_3::New_point_3<samples::Kernel> New_point;

template <typename ConcurrencyTag>
std::vector<New_point> completed(const samples::Samples& surface)
{
  CGAL::Context_completion_3<samples::Kernel, ConcurrencyTag> completion(samples::point_set(surface));
  completion.detect_holes();
  std::vector<New_point> added;
  completion.complete(std::back_inserter(added));
  return added;
}

void expect_same(const std::vector<New_point>& a, const std::vector<New_point>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_EQ(a[i].point, b[i].point);
    EXPECT_EQ(a[i].normal, b[i].normal);
    EXPECT_EQ(a[i].source, b[i].source);
    EXPECT_EQ(a[i].hole, b[i].hole);
    EXPECT_EQ(a[i].confidence, b[i].confidence);
  }
}

class Parallel_completion : public ::testing::TestWithParam<samples::Samples> {};

} // namespace

TEST_P(Parallel_completion, Equals_the_sequential_one_bit_for_bit)
{
  const std::vector<New_point> sequential = completed<CGAL::Sequential_tag>(GetParam());
  EXPECT_FALSE(sequential.empty());
  expect_same(sequential, completed<CGAL::Parallel_if_available_tag>(GetParam()));
  expect_same(sequential, completed<CGAL::Sequential_tag>(GetParam()));
}

TEST_P(Parallel_completion, Of_a_range_equals_the_sequential_one_bit_for_bit)
{
  typedef std::pair<samples::Point, samples::Vector> Pair;
  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Pair>()).
                    normal_map(CGAL::Second_of_pair_property_map<Pair>());
  samples::Samples sequential, parallel;
  CGAL::context_complete<CGAL::Sequential_tag>(GetParam(), std::back_inserter(sequential), maps);
  CGAL::context_complete<CGAL::Parallel_if_available_tag>(GetParam(), std::back_inserter(parallel), maps);
  EXPECT_FALSE(sequential.empty());
  EXPECT_EQ(sequential, parallel);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Parallel_completion, ::testing::Values(
  samples::plane_with_two_holes(),
  samples::bumpy_plane_with_hole(),
  samples::four_patterns_with_hole(),
  samples::without_ball(samples::bumpy_sphere(1500, 10., 0.6, 6.), samples::Point(6, 5, 6), 2.8),
  samples::without_ball(samples::cylinder(40, 40, 6.), samples::Point(6, 0, 16), 3.)));

} // namespace test_parallel
