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

// The class for step-by-step use agrees with the free function, and its steps can be repeated and resumed.

#include "include/surface_samples.h"

#include <CGAL/context_complete.h>
#include <CGAL/Context_completion_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_step_by_step {

using CGAL::Context_completions_3::Hole_state;
using CGAL::Context_completions_3::Invalid_input;
using CGAL::Context_completions_3::combine;
namespace parameters = CGAL::parameters;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Point_set_3<samples::Point> Point_set;
typedef CGAL::Context_completion_3<samples::Kernel> Completion;
typedef std::vector<Completion::New_point> New_points;

bool is_same(const Completion::New_point& a, const Completion::New_point& b)
{
  return a.point == b.point && a.normal == b.normal && a.source == b.source && a.source_set == b.source_set &&
         a.hole == b.hole && a.confidence == b.confidence;
}

bool is_same(const New_points& a, const New_points& b)
{
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const auto& p, const auto& q) { return is_same(p, q); });
}

std::vector<std::size_t> holes_to_fill(const Completion& completion)
{
  std::vector<std::size_t> result;
  for(const Completion::Hole& hole : completion.holes())
    if(hole.is_to_be_filled())
      result.push_back(hole.id);
  return result;
}

New_points complete(Completion& completion)
{
  New_points result;
  completion.complete(std::back_inserter(result));
  return result;
}

New_points all_at_once(const Point_set& points)
{
  Completion completion(points);
  completion.detect_holes();
  return complete(completion);
}

} // namespace

TEST(Step_by_step, Agrees_with_the_free_function)
{
  Point_set points = samples::point_set(samples::plane_with_two_holes());
  const std::size_t before = points.size();
  const New_points expected = all_at_once(points);
  const auto source = points.add_property_map<std::size_t>("source").first;
  const auto hole = points.add_property_map<std::size_t>("hole").first;
  const auto confidence = points.add_property_map<double>("confidence").first;
  ASSERT_EQ(CGAL::context_complete(points, combine(parameters::source_map(source), parameters::hole_map(hole),
                                                   parameters::confidence_map(confidence))), expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_EQ(points.point(before + i), expected[i].point);
    EXPECT_EQ(points.normal(before + i), expected[i].normal);
    EXPECT_EQ(source[before + i], expected[i].source);
    EXPECT_EQ(hole[before + i], expected[i].hole);
    EXPECT_EQ(confidence[before + i], expected[i].confidence);
  }
}

TEST(Step_by_step, Holes_are_described)
{
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  Completion completion(points);
  EXPECT_FALSE(completion.is_detected());
  EXPECT_TRUE(completion.holes().empty());
  EXPECT_NEAR(completion.spacing(), 0.9, 0.25);
  const std::vector<Completion::Hole>& holes = completion.detect_holes();
  EXPECT_TRUE(completion.is_detected());
  EXPECT_EQ(&holes, &completion.detect_holes());
  const std::vector<std::size_t> chosen = holes_to_fill(completion);
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(completion.chosen(), chosen);
  for(std::size_t i = 0; i < holes.size(); ++i)
    EXPECT_EQ(holes[i].id, i);
  std::set<int> found;
  for(std::size_t id : chosen)
  {
    const bool is_first = holes[id].center.x() < 21.;
    const samples::Point center = is_first ? samples::Point(14, 14, 0) : samples::Point(29, 30, 0);
    const double radius = is_first ? 4. : 5.5;
    found.insert(is_first);
    EXPECT_LT(std::sqrt(CGAL::squared_distance(holes[id].center, center)), 1.);
    EXPECT_NEAR(holes[id].diameter, 2. * radius, 2.5);
    EXPECT_NEAR(holes[id].spacing, 0.9, 0.25);
    ASSERT_FALSE(holes[id].loops.empty());
    for(const auto& loop : holes[id].loops)
      for(std::size_t index : loop)
      {
        ASSERT_LT(index, points.size());
        EXPECT_NEAR(std::sqrt(CGAL::squared_distance(points.point(index), center)), radius, 2.5);
      }
  }
  EXPECT_EQ(found.size(), 2u);
}

TEST(Step_by_step, The_outer_border_is_not_filled)
{
  Completion completion(samples::point_set(samples::plane(24)));
  completion.detect_holes();
  EXPECT_TRUE(completion.chosen().empty());
  EXPECT_TRUE(complete(completion).empty());
}

TEST(Step_by_step, A_subset_of_the_holes)
{
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  const New_points expected = all_at_once(points);
  Completion completion(points);
  completion.detect_holes();
  const std::vector<std::size_t> ids = holes_to_fill(completion);
  ASSERT_EQ(ids.size(), 2u);

  completion.choose(std::vector<std::size_t>());
  EXPECT_TRUE(complete(completion).empty());

  completion.choose(std::vector<int>{ int(ids[0]), int(ids[0]) }); // twice is once
  EXPECT_EQ(completion.chosen(), std::vector<std::size_t>(1, ids[0]));
  New_points first = complete(completion);
  EXPECT_FALSE(first.empty());
  for(const auto& point : first)
    EXPECT_EQ(point.hole, ids[0]);
  EXPECT_EQ(completion.report()[ids[0]].number_of_points, first.size());
  EXPECT_EQ(completion.report()[ids[1]].number_of_points, 0u);

  EXPECT_TRUE(complete(completion).empty()); // it is completed already
  completion.choose_all();
  const New_points second = complete(completion);
  EXPECT_FALSE(second.empty());
  for(const auto& point : second)
    EXPECT_EQ(point.hole, ids[1]);
  first.insert(first.end(), second.begin(), second.end());
  EXPECT_TRUE(is_same(first, expected));
}

TEST(Step_by_step, A_predicate_chooses)
{
  Completion completion(samples::point_set(samples::plane_with_two_holes()));
  completion.detect_holes();
  completion.choose([](const Completion::Hole& hole) { return hole.is_to_be_filled() && hole.diameter > 10.5; });
  ASSERT_EQ(completion.chosen().size(), 1u);
  EXPECT_GT(completion.holes()[completion.chosen()[0]].center.x(), 20.);
  for(const auto& point : complete(completion))
    EXPECT_EQ(point.hole, completion.chosen()[0]);
}

TEST(Step_by_step, An_unknown_hole_leaves_the_choice)
{
  Completion completion(samples::point_set(samples::plane_with_two_holes()));
  completion.detect_holes();
  const std::vector<std::size_t> before = completion.chosen();
  EXPECT_THROW(completion.choose(std::vector<std::size_t>{ 0, completion.holes().size() }), Invalid_input);
  EXPECT_THROW(completion.choose(std::vector<int>(1, -1)), Invalid_input);
  EXPECT_EQ(completion.chosen(), before);
}

TEST(Step_by_step, Unknown_indices_of_the_constructor)
{
  const std::vector<int> indices = { 0, 77 };
  Completion completion(samples::point_set(samples::plane_with_two_holes()), parameters::hole_indices(indices));
  EXPECT_THROW(completion.detect_holes(), Invalid_input);
  EXPECT_TRUE(completion.is_detected());
  EXPECT_FALSE(completion.holes().empty());
  EXPECT_TRUE(completion.chosen().empty());
  EXPECT_TRUE(complete(completion).empty());
}

TEST(Step_by_step, A_visitor_that_throws_can_be_left_out)
{
  struct Visitor : CGAL::Context_completions_3::Default_completion_visitor
  {
    bool in_detection = true;
    void on_detection_end(std::size_t) { if(in_detection) throw std::runtime_error("not now"); }
    void on_hole_begin(std::size_t) { throw std::runtime_error("not now"); }
  } visitor;
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  const New_points expected = all_at_once(points);
  Completion completion(points);
  New_points added;
  EXPECT_THROW(completion.detect_holes(parameters::visitor(std::ref(visitor))), std::runtime_error);
  EXPECT_FALSE(completion.is_detected());
  visitor.in_detection = false;
  completion.detect_holes(parameters::visitor(std::ref(visitor)));
  EXPECT_THROW(completion.complete(std::back_inserter(added), parameters::visitor(std::ref(visitor))),
               std::runtime_error);
  EXPECT_TRUE(added.empty());
  EXPECT_TRUE(is_same(complete(completion), expected));
}

TEST(Step_by_step, Cancelling_can_be_resumed)
{
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  const New_points expected = all_at_once(points);
  Completion completion(points);
  const std::function<bool(double)> never = [](double) { return false; };
  EXPECT_TRUE(completion.detect_holes(parameters::callback(never)).empty());
  EXPECT_TRUE(completion.is_cancelled());
  EXPECT_FALSE(completion.is_detected());
  completion.detect_holes();
  EXPECT_FALSE(completion.is_cancelled());

  // the first call of the callback, the second one, ...: at the beginning, within and at the end of holes
  New_points added;
  std::size_t number_of_cancellations = 0;
  for(std::size_t allowed = 0; added.empty() && allowed < 1000; ++allowed)
  {
    std::size_t calls = 0;
    const std::function<bool(double)> callback = [&](double) { return calls++ < allowed; };
    completion.complete(std::back_inserter(added), parameters::callback(callback));
    number_of_cancellations += completion.is_cancelled();
    EXPECT_EQ(added.empty(), completion.is_cancelled());
  }
  EXPECT_GE(number_of_cancellations, 8u) << "the search of one hole is asked, too";
  EXPECT_FALSE(completion.is_cancelled());
  EXPECT_TRUE(is_same(added, expected));
}

TEST(Step_by_step, Detection_by_the_paper_policy_can_be_cancelled_at_every_stage)
{
  const Point_set points = samples::point_set(samples::plane_with_hole());
  Completion whole(points, parameters::use_paper_policies(true));
  std::size_t number_of_calls = 0;
  const std::function<bool(double)> counting = [&](double fraction)
  {
    EXPECT_GE(fraction, 0.);
    EXPECT_LE(fraction, 1.);
    ++number_of_calls;
    return true;
  };
  const std::size_t number_of_holes = whole.detect_holes(parameters::callback(counting)).size();
  ASSERT_GT(number_of_holes, 0u);
  ASSERT_GE(number_of_calls, 7u) << "trees, three rotated copies, detection";
  for(std::size_t allowed = 0; allowed < number_of_calls; ++allowed)
  {
    Completion completion(points, parameters::use_paper_policies(true));
    std::size_t calls = 0;
    const std::function<bool(double)> callback = [&](double) { return calls++ < allowed; };
    EXPECT_TRUE(completion.detect_holes(parameters::callback(callback)).empty()) << allowed;
    EXPECT_TRUE(completion.is_cancelled()) << allowed;
    EXPECT_EQ(completion.detect_holes().size(), number_of_holes) << allowed;
  }
}

// By the paper's policy no hole is done before all are, and a later call goes on from the cells that were filled.
TEST(Step_by_step, Cancelling_the_paper_policy_can_be_resumed)
{
  const Point_set points =
    samples::point_set(samples::without_ball(samples::plane(80), samples::Point(41, 36, 0), 12.));
  Completion whole(points, parameters::use_paper_policies(true));
  whole.detect_holes();
  std::size_t number_of_calls = 0;
  const std::function<bool(double)> counting = [&](double) { ++number_of_calls; return true; };
  New_points all;
  whole.complete(std::back_inserter(all), parameters::callback(counting));
  const std::size_t expected = all.size();
  ASSERT_GT(expected, 0u);
  ASSERT_GT(number_of_calls, 5u);
  for(std::size_t allowed : { std::size_t(0), number_of_calls / 3, 2 * number_of_calls / 3, number_of_calls - 1 })
  {
    Completion completion(points, parameters::use_paper_policies(true));
    completion.detect_holes();
    std::size_t calls = 0;
    const std::function<bool(double)> callback = [&](double) { return calls++ < allowed; };
    New_points added;
    completion.complete(std::back_inserter(added), parameters::callback(callback));
    ASSERT_TRUE(completion.is_cancelled());
    EXPECT_TRUE(added.empty());
    completion.complete(std::back_inserter(added));
    EXPECT_FALSE(completion.is_cancelled());
    EXPECT_NEAR(double(added.size()), double(expected), 0.05 * double(expected));
    std::size_t reported = 0;
    for(const Completion::Hole_report& report : completion.report())
      reported += report.number_of_points;
    EXPECT_EQ(reported, added.size());
    completion.complete(std::back_inserter(added));
    EXPECT_EQ(reported, added.size()) << "points are written once";
  }
}

TEST(Step_by_step, Named_borders_stay_open_and_named_holes_are_filled_whatever_their_state)
{
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  Completion completion(points, parameters::minimum_hole_diameter(10.5));
  completion.detect_holes();
  std::vector<std::size_t> borders, small;
  for(const Completion::Hole& hole : completion.holes())
    if(hole.state == Hole_state::outer_border)
      borders.push_back(hole.id);
    else if(hole.state == Hole_state::too_small)
      small.push_back(hole.id);
  ASSERT_FALSE(borders.empty());
  ASSERT_EQ(small.size(), 1u);
  completion.choose(borders);
  EXPECT_TRUE(complete(completion).empty());
  EXPECT_NE(completion.report()[borders[0]].reason.find("opens outwards"), std::string::npos);
  completion.choose(small);
  EXPECT_FALSE(complete(completion).empty());
  EXPECT_GT(completion.report()[small[0]].number_of_points, 0u);
}

TEST(Step_by_step, What_the_user_bounds_is_filled_though_it_is_no_hole)
{
  // a sheet with a notch in its border
  samples::Samples sheet;
  for(const samples::Oriented_point& sample : samples::plane(40))
    if(!(sample.first.x() > 30 && std::abs(sample.first.y() - 20) < 5))
      sheet.push_back(sample);
  const Point_set points = samples::point_set(sheet);
  Completion plain(points);
  plain.detect_holes();
  EXPECT_TRUE(plain.chosen().empty());

  const std::vector<CGAL::Bbox_3> notch(1, CGAL::Bbox_3(27, 13, -3, 38, 27, 3));
  Completion completion(points, parameters::user_holes(notch));
  completion.detect_holes();
  ASSERT_EQ(completion.chosen().size(), 1u);
  const std::vector<Completion::New_point> added = complete(completion);
  EXPECT_NEAR(double(added.size()), 8 * 10 / std::sqrt(0.75), 15.);
  for(const Completion::New_point& p : added)
  {
    EXPECT_LT(std::abs(p.point.z()), 0.05);
    EXPECT_GT(p.point.x(), 29.);
    EXPECT_LT(p.point.x(), 39.);
    EXPECT_LT(std::abs(p.point.y() - 20), 6.);
  }
}

TEST(Step_by_step, A_hole_that_the_user_bounds_is_that_hole)
{
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  Completion plain(points);
  plain.detect_holes();
  ASSERT_EQ(plain.chosen().size(), 2u);
  const Completion::Hole hole = plain.holes()[plain.chosen()[0]];
  const double x = hole.center.x(), y = hole.center.y(), r = hole.diameter;
  const std::vector<CGAL::Bbox_3> box(1, CGAL::Bbox_3(x - r, y - r, -r, x + r, y + r, r));
  Completion completion(points, combine(parameters::user_holes(box), parameters::minimum_hole_diameter(100)));
  completion.detect_holes();
  ASSERT_EQ(completion.chosen().size(), 1u);
  EXPECT_EQ(completion.holes().size(), plain.holes().size());
  EXPECT_EQ(completion.holes()[completion.chosen()[0]].loops, hole.loops);

  // twice the same box is the same hole
  for(bool is_paper : { false, true })
  {
    const std::vector<CGAL::Bbox_3> boxes(2, box[0]);
    Completion twice(points, combine(parameters::user_holes(boxes), parameters::minimum_hole_diameter(100),
                                     parameters::use_paper_policies(is_paper)));
    twice.detect_holes();
    EXPECT_EQ(twice.chosen().size(), 1u);
  }

  const std::vector<CGAL::Bbox_3> nothing(1, CGAL::Bbox_3(-100, -100, -1, -90, -90, 1));
  for(bool is_paper : { false, true })
  {
    Completion bad(points, combine(parameters::user_holes(nothing), parameters::use_paper_policies(is_paper)));
    try
    {
      bad.detect_holes();
      ADD_FAILURE() << "an empty box is taken";
    }
    catch(const Invalid_input& error)
    {
      EXPECT_NE(std::string(error.what()).find("Box 0 of the parameter user_holes"), std::string::npos) << error.what();
    }
    EXPECT_FALSE(bad.is_detected());
  }

  // by the paper the cells in the box are one hole, whatever else they would be joined with
  Completion paper(points, combine(parameters::user_holes(box), parameters::use_paper_policies(true),
                                   parameters::minimum_hole_diameter(100)));
  paper.detect_holes();
  ASSERT_EQ(paper.chosen().size(), 1u);
  for(const CGAL::Bbox_3& cell : paper.holes()[paper.chosen()[0]].cells)
    EXPECT_TRUE(CGAL::do_overlap(cell, box[0]));
  EXPECT_FALSE(complete(paper).empty());
}

TEST(Step_by_step, An_object_can_be_moved)
{
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  const New_points expected = all_at_once(points);
  Completion first(points);
  first.detect_holes();
  Completion second(std::move(first));
  std::vector<Completion> list;
  list.push_back(std::move(second));
  EXPECT_TRUE(is_same(complete(list.back()), expected));
}

TEST(Step_by_step, Reports_agree_with_the_points)
{
  Completion completion(samples::point_set(samples::plane_with_two_holes()));
  completion.detect_holes();
  EXPECT_TRUE(completion.report().empty());
  const New_points added = complete(completion);
  ASSERT_EQ(completion.report().size(), completion.holes().size());
  for(const Completion::Hole_report& report : completion.report())
  {
    const Completion::Hole& hole = completion.holes()[report.hole];
    EXPECT_EQ(report.state, hole.state);
    EXPECT_EQ(report.diameter, hole.diameter);
    EXPECT_EQ(report.loops, hole.loops);
    EXPECT_EQ(report.number_of_points, std::size_t(std::count_if(added.begin(), added.end(),
      [&](const Completion::New_point& point) { return point.hole == report.hole; })));
    EXPECT_EQ(report.filling != CGAL::Context_completions_3::Filling::none, report.number_of_points > 0);
    if(report.number_of_points > 0)
    {
      EXPECT_FALSE(report.reason.empty());
      EXPECT_GE(report.expected_error, 0.);
      EXPECT_TRUE(std::isfinite(report.expected_error));
    }
  }
}

TEST(Step_by_step, Diameters_and_regions_restrict_the_holes)
{
  const Point_set points = samples::point_set(samples::plane_with_two_holes());
  const auto states = [&](const auto& np)
  {
    Completion completion(points, np);
    completion.detect_holes();
    std::pair<Hole_state, Hole_state> result(Hole_state::outer_border, Hole_state::outer_border);
    for(const Completion::Hole& hole : completion.holes())
      if(hole.state != Hole_state::outer_border)
        (hole.center.x() < 21. ? result.first : result.second) = hole.state;
    return result;
  };
  typedef std::pair<Hole_state, Hole_state> States;
  typedef std::vector<samples::Kernel::Iso_cuboid_3> Boxes;
  const Boxes first(1, samples::Kernel::Iso_cuboid_3(4, 4, -5, 24, 24, 5));
  EXPECT_EQ(states(parameters::default_values()), States(Hole_state::hole, Hole_state::hole));
  EXPECT_EQ(states(parameters::minimum_hole_diameter(10.5)), States(Hole_state::too_small, Hole_state::hole));
  EXPECT_EQ(states(parameters::maximum_hole_diameter(10.5)), States(Hole_state::hole, Hole_state::too_large));
  EXPECT_EQ(states(parameters::regions(first)), States(Hole_state::hole, Hole_state::excluded));
  EXPECT_EQ(states(parameters::excluded_regions(first)), States(Hole_state::excluded, Hole_state::hole));
}

TEST(Step_by_step, A_visitor_hears_of_each_hole)
{
  struct Visitor : CGAL::Context_completions_3::Default_completion_visitor
  {
    std::vector<std::string> events;
    std::size_t sum = 0, total = 0;

    void on_detection_begin(std::size_t) { events.push_back("detect"); }
    void on_detection_end(std::size_t) { events.push_back("detected"); }
    void on_completion_begin(std::size_t n) { events.push_back("complete " + std::to_string(n)); }
    void on_hole_begin(std::size_t hole) { events.push_back("begin " + std::to_string(hole)); }
    void on_hole_end(std::size_t hole, std::size_t n) { events.push_back("end " + std::to_string(hole)); sum += n; }
    void on_completion_end(std::size_t n) { events.push_back("completed"); total = n; }
  };
  Point_set points = samples::point_set(samples::plane_with_two_holes());
  Completion completion(points);
  completion.detect_holes();
  std::vector<std::string> expected = { "detect", "detected", "complete 2" };
  for(std::size_t id : holes_to_fill(completion))
  {
    expected.push_back("begin " + std::to_string(id));
    expected.push_back("end " + std::to_string(id));
  }
  expected.push_back("completed");

  Visitor visitor;
  const std::size_t added = CGAL::context_complete(points, parameters::visitor(std::ref(visitor)));
  EXPECT_EQ(visitor.events, expected);
  EXPECT_EQ(visitor.sum, added);
  EXPECT_EQ(visitor.total, added);
}

} // namespace test_step_by_step
