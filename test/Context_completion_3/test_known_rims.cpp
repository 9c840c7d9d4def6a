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

// Holes whose rims the caller knows, found by the points alone or not.

#include "include/surface_samples.h"

#include <CGAL/Context_completion_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace test_known_rims {

using CGAL::Context_completions_3::Hole_state;
using CGAL::Context_completions_3::Invalid_input;
using CGAL::Context_completions_3::combine;
namespace parameters = CGAL::parameters;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Point_set_3<samples::Point> Point_set;
typedef CGAL::Context_completion_3<samples::Kernel> Completion;
typedef std::vector<std::size_t> Rim;
typedef std::vector<Rim> Rims;

const double slot_left = 8, slot_right = 32, slot_lower = 0.8, slot_upper = 6.8;

bool is_in_slot(double x, double y, double margin)
{
  return x > slot_left - margin && x < slot_right + margin && y > slot_lower - margin && y < slot_upper + margin;
}

/// A sheet with a slot so near to its border that only two rows of points are between them.
Point_set sheet_with_slot()
{
  samples::Samples sheet;
  for(const samples::Oriented_point& sample : samples::plane(40))
    if(!is_in_slot(sample.first.x(), sample.first.y(), 0))
      sheet.push_back(sample);
  return samples::point_set(sheet);
}

/// The points next to the slot, around it.
Rim rim_of_slot(const Point_set& points)
{
  std::vector<std::pair<double, std::size_t> > found;
  const double x = (slot_left + slot_right) / 2, y = (slot_lower + slot_upper) / 2;
  for(std::size_t i : points)
    if(is_in_slot(points.point(i).x(), points.point(i).y(), 0.9))
      found.emplace_back(std::atan2(points.point(i).y() - y, points.point(i).x() - x), i);
  std::sort(found.begin(), found.end());
  Rim rim;
  for(const auto& f : found)
    rim.push_back(f.second);
  return rim;
}

std::vector<Completion::New_point> complete(Completion& completion)
{
  std::vector<Completion::New_point> result;
  completion.complete(std::back_inserter(result));
  return result;
}

std::string refusal_of(const Rims& rims)
{
  try
  {
    Completion completion(samples::point_set(samples::plane(12)), parameters::known_rims(rims));
  }
  catch(const Invalid_input& error)
  {
    return error.what();
  }
  return std::string();
}

} // namespace

TEST(Known_rims, A_slot_beside_a_border_is_filled_by_its_rim)
{
  const Point_set points = sheet_with_slot();
  Completion plain(points);
  plain.detect_holes();
  EXPECT_TRUE(plain.chosen().empty()) << "the points alone do not tell the slot from the border";

  Rim rim = rim_of_slot(points);
  for(bool is_reversed : { false, true })
  {
    if(is_reversed)
      std::reverse(rim.begin(), rim.end());
    Completion completion(points, parameters::known_rims(Rims(1, rim)));
    completion.detect_holes();
    ASSERT_EQ(completion.chosen().size(), 1u);
    EXPECT_EQ(completion.holes()[completion.chosen()[0]].loops, Rims(1, rim));
    const std::vector<Completion::New_point> added = complete(completion);
    const double area = (slot_right - slot_left) * (slot_upper - slot_lower);
    // beside two borders points seem to be farther apart than they are
    EXPECT_NEAR(double(added.size()), area / std::sqrt(0.75), 0.3 * area);
    for(const Completion::New_point& p : added)
    {
      EXPECT_LT(std::abs(p.point.z()), 0.05);
      EXPECT_TRUE(is_in_slot(p.point.x(), p.point.y(), 0.3)) << p.point;
    }
  }
}

TEST(Known_rims, A_hole_that_is_found_is_not_doubled)
{
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  Completion plain(points);
  plain.detect_holes();
  ASSERT_EQ(plain.chosen().size(), 2u);
  Rims rims;
  for(std::size_t h : plain.chosen())
    rims.push_back(plain.holes()[h].loops[0]);
  Completion completion(points, parameters::known_rims(rims));
  completion.detect_holes();
  ASSERT_EQ(completion.holes().size(), plain.holes().size());
  EXPECT_EQ(completion.chosen(), plain.chosen());
  for(std::size_t h = 0; h < plain.holes().size(); ++h)
    EXPECT_EQ(completion.holes()[h].loops, plain.holes()[h].loops);

  // of two rims of one hole the first counts
  const Point_set slot = sheet_with_slot();
  Completion twice(slot, parameters::known_rims(Rims(2, rim_of_slot(slot))));
  twice.detect_holes();
  EXPECT_EQ(twice.chosen().size(), 1u);
}

TEST(Known_rims, Bounds_and_regions_leave_them_open)
{
  const Point_set points = sheet_with_slot();
  const Rims rims(1, rim_of_slot(points));
  const auto state_with = [&](const auto& np)
  {
    Completion completion(points, combine(np, parameters::known_rims(rims)));
    completion.detect_holes();
    EXPECT_TRUE(completion.chosen().empty());
    const auto hole = std::find_if(completion.holes().begin(), completion.holes().end(),
                                   [&](const Completion::Hole& h) { return h.loops == rims; });
    return hole == completion.holes().end() ? Hole_state::hole : hole->state;
  };
  EXPECT_EQ(state_with(parameters::maximum_hole_diameter(10)), Hole_state::too_large);
  EXPECT_EQ(state_with(parameters::minimum_hole_diameter(50)), Hole_state::too_small);
  EXPECT_EQ(state_with(parameters::excluded_regions(std::vector<CGAL::Bbox_3>(1, CGAL::Bbox_3(0, 0, -1, 40, 20, 1)))),
            Hole_state::excluded);
}

TEST(Known_rims, Around_nothing_there_is_no_hole)
{
  const Point_set points = samples::point_set(samples::plane(30));
  std::vector<std::pair<double, std::size_t> > around;
  for(std::size_t i : points)
    if(std::abs((points.point(i) - samples::Point(15, 15, 0)).squared_length() - 20) < 6)
      around.emplace_back(std::atan2(points.point(i).y() - 15, points.point(i).x() - 15), i);
  std::sort(around.begin(), around.end());
  Rim rim;
  for(const auto& a : around)
    rim.push_back(a.second);
  ASSERT_GT(rim.size(), 20u);
  Completion plain(points), completion(points, parameters::known_rims(Rims(1, rim)));
  plain.detect_holes();
  completion.detect_holes();
  EXPECT_EQ(completion.holes().size(), plain.holes().size());
  EXPECT_TRUE(completion.chosen().empty());
}

TEST(Known_rims, Name_points_as_the_point_set_does)
{
  Point_set points = sheet_with_slot();
  points.insert(samples::Point(100, 100, 100), samples::Vector(0, 0, 1));
  const std::size_t removed = *(points.end() - 1);
  for(int i = 0; i < 3; ++i)
    points.remove(points.begin());
  points.remove(removed);
  ASSERT_TRUE(points.has_garbage());
  const Rim rim = rim_of_slot(points);
  Completion completion(points, parameters::known_rims(Rims(1, rim)));
  completion.detect_holes();
  ASSERT_EQ(completion.chosen().size(), 1u);
  EXPECT_EQ(completion.holes()[completion.chosen()[0]].loops, Rims(1, rim));
  EXPECT_THROW(Completion(points, parameters::known_rims(Rims(1, Rim{ rim[0], rim[1], removed }))), Invalid_input);
}

TEST(Known_rims, Rims_that_are_none_are_named)
{
  EXPECT_EQ(refusal_of({}), "");
  EXPECT_EQ(refusal_of({ { 0, 1, 2, 3 }, { 4, 5, 1000000 } }),
            "Rim 1 of the parameter known_rims names point 1000000; there is no such point.");
  EXPECT_EQ(refusal_of({ { 4, 5, 6, 5 } }), "Rim 0 of the parameter known_rims names point 5 twice.");
  EXPECT_EQ(refusal_of({ { 4, 5 } }),
            "Rim 0 of the parameter known_rims has 2 points; at least 3 are needed to go around a hole.");
}

} // namespace test_known_rims
