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

// Holes in the middle of which a part of the surface was sampled, and what only seems to be one.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3.h>
#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Island_search.h>
#include <CGAL/Context_completion_3/internal/Named_holes.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace test_islands {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;
typedef Detected_hole<Tag> Hole;
typedef Smooth_patch<Tag> Patch;

const double middle = 20;

double distance_to_middle(const samples::Oriented_point& s)
{
  return std::hypot(s.first.x() - middle, s.first.y() - middle);
}

double dome_height(double x, double y)
{
  return 5 * std::exp(-(std::pow(x - middle, 2) + std::pow(y - middle, 2)) / 50);
}

/// A dome in a plane, of which a ring is missing.
samples::Samples dome(double inner, double outer)
{
  const samples::Samples whole = samples::graph(46, 0.9, dome_height, [](double x, double y)
    { return std::make_pair(-(x - middle) / 25 * dome_height(x, y), -(y - middle) / 25 * dome_height(x, y)); });
  samples::Samples rest;
  for(const samples::Oriented_point& s : whole)
    if(distance_to_middle(s) < inner || distance_to_middle(s) > outer)
      rest.push_back(s);
  return rest;
}

/// A plane with a hole of radius 8, and a disc of points above or below it.
samples::Samples plane_with_disc(double radius, double height, bool is_turned)
{
  samples::Samples rest;
  for(const samples::Oriented_point& s : samples::plane(40))
    if(distance_to_middle(s) < radius)
      rest.emplace_back(s.first + samples::Vector(0, 0, height), is_turned ? -s.second : s.second);
    else if(distance_to_middle(s) > 8)
      rest.push_back(s);
  return rest;
}

/// What is found near the middle.
std::vector<Hole> found_in(const Surface_model<Tag>& model)
{
  std::vector<Hole> all, near;
  EXPECT_TRUE(Hole_detection<Tag>(model).run(all, std::function<bool(double)>()));
  for(const Hole& hole : all)
    if(hole.loops.front().diameter < 25)
      near.push_back(hole);
  return near;
}

double mean_distance_from_dome(const Patch& patch)
{
  double sum = 0;
  for(const Base_sample& s : patch.samples())
    sum += std::abs(s.position.z() - dome_height(s.position.x(), s.position.y()));
  return sum / double(patch.samples().size());
}

} // namespace

TEST(Islands, Are_rims_of_the_hole_around_them_and_guide_its_base)
{
  const Surface_points points = samples::engine_points(dome(3.5, 9));
  const Surface_model<Tag> model(points);
  const std::vector<Hole> found = found_in(model);
  ASSERT_EQ(found.size(), 1u);   // and not the border of the island, too
  ASSERT_FALSE(found[0].is_outer_border);
  ASSERT_EQ(found[0].loops.size(), 2u);
  for(const Rim_point& p : found[0].loops[1].points)
  {
    EXPECT_LT(std::hypot(points.position[p.index].x() - middle, points.position[p.index].y() - middle), 3.5);
    EXPECT_GT(p.outward.dot(points.position[p.index] - found[0].loops[1].center), 0);
  }
  EXPECT_GE(found[0].loops[1].points.size(), 12u);

  const Patch alone(std::make_shared<const Rim_surroundings<Tag> >(model, std::vector<Rim_loop>(1, found[0].loops[0])));
  ASSERT_TRUE(alone.is_closed());
  EXPECT_TRUE(found[0].patch->joins_rims());
  EXPECT_LT(mean_distance_from_dome(*found[0].patch), 0.2);
  EXPECT_GT(mean_distance_from_dome(alone), 0.6);
}

TEST(Islands, Get_no_points_and_the_ring_around_them_is_filled)
{
  const samples::Samples known = dome(3.5, 9);
  CGAL::Context_completion_3<samples::Kernel> completion(samples::point_set(known));
  completion.detect_holes();
  std::vector<CGAL::Context_completion_3<samples::Kernel>::New_point> added;
  completion.complete(std::back_inserter(added));
  const double missing = samples::pi * (9 * 9 - 3.5 * 3.5) / (0.9 * 0.9 * std::sqrt(0.75));   // by area, of a plane
  EXPECT_NEAR(double(added.size()), missing, 0.15 * missing);
  for(const auto& p : added)
  {
    const double r = std::hypot(p.point.x() - middle, p.point.y() - middle);
    EXPECT_GT(r, 2.9);
    EXPECT_LT(r, 9.6);
    EXPECT_NEAR(p.point.z(), dome_height(p.point.x(), p.point.y()), 0.5);
  }
}

TEST(Islands, Are_taken_in_where_the_rim_around_them_is_known)
{
  const samples::Samples sheet = dome(3.5, 9);
  std::vector<std::pair<double, std::size_t> > around;
  for(std::size_t i = 0; i < sheet.size(); ++i)
    if(distance_to_middle(sheet[i]) > 9 && distance_to_middle(sheet[i]) < 9.8)
      around.emplace_back(std::atan2(sheet[i].first.y() - middle, sheet[i].first.x() - middle), i);
  std::sort(around.begin(), around.end());
  std::vector<std::size_t> rim;
  for(const auto& a : around)
    rim.push_back(a.second);
  const Surface_points points = samples::engine_points(sheet);
  const Surface_model<Tag> model(points);
  std::vector<Hole> holes(1);   // as if nothing but the border of the island had been found
  holes[0].is_outer_border = true;
  Rim_loop border;
  for(std::size_t i = 0; i < sheet.size(); ++i)
    if(distance_to_middle(sheet[i]) < 3.5 && distance_to_middle(sheet[i]) > 2.7)
    {
      border.points.emplace_back();
      border.points.back().index = i;
    }
  holes[0].loops.push_back(border);
  Named_holes<Tag>(model, std::vector<Rim_loop>()).add_rims({ rim }, holes);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_FALSE(holes[0].is_outer_border);
  ASSERT_EQ(holes[0].loops.size(), 2u);
  EXPECT_LT(mean_distance_from_dome(*holes[0].patch), 0.2);
}

TEST(Islands, Of_a_few_points_are_taken_in_and_do_not_hide_the_hole)
{
  // spacings of so few points are measured over the gap around them
  const Surface_points points = samples::engine_points(dome(1.6, 6));
  const Surface_model<Tag> model(points);
  const std::vector<Hole> found = found_in(model);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_FALSE(found[0].is_outer_border);
  ASSERT_EQ(found[0].loops.size(), 2u);
  EXPECT_LE(found[0].loops[1].points.size(), 12u);
  EXPECT_LT(mean_distance_from_dome(*found[0].patch), 0.2);
}

TEST(Islands, Are_not_what_lies_far_above_or_faces_the_other_way)
{
  for(const auto& height_and_turn : { std::make_pair(0.8, false), std::make_pair(8., false), std::make_pair(-0.8, true) })
  {
    const Surface_points points =
      samples::engine_points(plane_with_disc(3, height_and_turn.first, height_and_turn.second));
    const Surface_model<Tag> model(points);
    std::size_t holes = 0;
    for(const Hole& hole : found_in(model))
      if(!hole.is_outer_border)
      {
        ++holes;
        EXPECT_EQ(hole.loops.size(), height_and_turn.first == 0.8 ? 2u : 1u) << height_and_turn.first;
      }
    EXPECT_EQ(holes, 1u) << height_and_turn.first;
  }
}

TEST(Islands, Are_not_linked_to_the_surroundings_nor_single_points)
{
  for(bool is_linked : { false, true })
  {
    samples::Samples surface;
    std::size_t stray = 0;
    for(const samples::Oriented_point& s : samples::plane(40))
    {
      const double r = distance_to_middle(s);
      const bool is_strip = is_linked && s.first.x() > middle && std::abs(s.first.y() - middle) < 2;
      if(r > 9 || (is_linked && r < 3.5) || is_strip || (!is_linked && r < 1.2 && stray++ < 3))
        surface.push_back(s);
    }
    const Surface_points points = samples::engine_points(surface);
    const Surface_model<Tag> model(points);
    std::size_t holes = 0;
    for(const Hole& hole : found_in(model))
      if(!hole.is_outer_border)
      {
        ++holes;
        EXPECT_EQ(hole.loops.size(), 1u) << is_linked;
        EXPECT_TRUE(Island_search<Tag>(*hole.patch).rims().empty()) << is_linked;
      }
    EXPECT_EQ(holes, 1u) << is_linked;
  }
}

} // namespace test_islands
