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

// Ends of tubes: borders of the surface, or limbs that were cut off, which examples tell.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace test_open_ends {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;
typedef std::vector<std::pair<double, double> > Profile;   // distance from the axis, height; fine steps, downwards

const std::function<bool(double)> no_callback;

// rings of about one spacing, turned around the z axis
samples::Samples turned(const Profile& profile, unsigned int seed = 3)
{
  samples::Random_offsets offset(seed);
  samples::Samples result;
  const double step = std::sqrt(0.75);
  double behind = 0.5 * step;
  for(std::size_t k = 1; k < profile.size(); ++k)
  {
    const double dr = profile[k].first - profile[k - 1].first, dz = profile[k].second - profile[k - 1].second;
    behind += std::hypot(dr, dz);
    if(behind < step)
      continue;
    behind -= step;
    const double r = profile[k].first, z = profile[k].second;
    const std::size_t number = (std::max)(std::size_t(1), std::size_t(2 * samples::pi * r + 0.5));
    const double start = samples::pi * offset();
    for(std::size_t i = 0; i < number; ++i)
    {
      const double angle = start + 2 * samples::pi * (double(i) + 0.15 * offset()) / double(number);
      const samples::Vector out(std::cos(angle), std::sin(angle), 0), normal = -dz * out + samples::Vector(0, 0, dr);
      result.emplace_back(CGAL::ORIGIN + (r * out + samples::Vector(0, 0, z)), samples::unit(normal));
    }
  }
  return result;
}

// Half of a rod with a groove, which ends in a flat cap with a knob: a smooth continuation would miss it.
Profile upper_half(double length)
{
  Profile profile;
  const double radius = 5, fine = 0.01;
  for(double angle = samples::pi / 2; angle > 0; angle -= fine)
  {
    const double r = radius * std::cos(angle);
    profile.emplace_back(r, length + 2.5 * std::sin(angle) + 1.2 * std::exp(-r * r / 2));
  }
  for(double z = length; z > 0; z -= fine)
    profile.emplace_back(radius - 1.2 * std::exp(-(z - length + 8) * (z - length + 8) / 4), z);
  return profile;
}

samples::Samples rod(double length)
{
  Profile profile = upper_half(length);
  for(std::size_t k = profile.size(); k-- > 0; )
    profile.emplace_back(profile[k].first, -profile[k].second);
  return turned(profile);
}

// A ball with a neck.
samples::Samples bust()
{
  Profile profile;
  for(double z = 24; z > 11; z -= 0.01)
    profile.emplace_back(5, z);
  for(double angle = std::asin(5 / 12.); angle < samples::pi; angle += 0.001)
    profile.emplace_back(12 * std::sin(samples::pi - angle), 12 * std::sin(samples::pi / 2 - angle));
  return turned(profile);
}

samples::Samples cut(const samples::Samples& surface, double low, double high, samples::Samples* removed = nullptr)
{
  samples::Samples rest;
  for(const samples::Oriented_point& s : surface)
    if(s.first.z() > low && s.first.z() < high)
      rest.push_back(s);
    else if(removed != nullptr)
      removed->push_back(s);
  return rest;
}

struct Detected
{
  Surface_points points;
  Completion_engine<Tag> engine;

  explicit Detected(const samples::Samples& surface, const Engine_parameters& parameters = Engine_parameters())
    : points(samples::engine_points(surface)), engine(points, parameters)
  {
    EXPECT_TRUE(engine.detect(no_callback));
  }

  std::vector<std::size_t> with_state(Hole_state state) const
  {
    std::vector<std::size_t> result;
    for(std::size_t h = 0; h < engine.holes().size(); ++h)
      if(engine.holes()[h].state == state)
        result.push_back(h);
    return result;
  }
};

const double rod_length = 24, cut_height = 22.5;

} // namespace

TEST(Open_ends, An_end_that_was_cut_off_is_restored_from_the_other_one)
{
  samples::Samples removed;
  const samples::Samples rest = cut(rod(rod_length), -100, cut_height, &removed);
  ASSERT_GT(removed.size(), 80u);
  Detected detected(rest);
  const std::vector<std::size_t> holes = detected.with_state(Hole_state::hole);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_TRUE(detected.with_state(Hole_state::outer_border).empty());
  ASSERT_TRUE(detected.engine.complete(holes, no_callback));
  EXPECT_EQ(detected.engine.outcomes()[holes[0]].filling, Filling::copied);
  std::vector<Vector> missing, added;
  for(const samples::Oriented_point& s : removed)
    missing.push_back(samples::engine_vector(s.first));
  for(const Added_point& p : detected.engine.added())
    added.push_back(p.position);
  EXPECT_NEAR(double(added.size()), double(missing.size()), 0.15 * double(missing.size()));
  // the points lie elsewhere on the same surface: 0.8 spacings are the room between them
  for(const Vector& p : missing)
    EXPECT_LT(samples::nearest_distance(p, added), 1.3) << p.transpose();
  const Profile profile = upper_half(rod_length);
  for(const Vector& p : added)
  {
    double distance = 100;
    for(const auto& q : profile)
      distance = (std::min)(distance, std::hypot(std::hypot(p.x(), p.y()) - q.first, p.z() - q.second));
    EXPECT_LT(distance, 0.15) << p.transpose();
  }
}

TEST(Open_ends, The_neck_of_a_bust_stays_open_and_whoever_names_it_gets_it_closed)
{
  Detected detected(cut(bust(), -100, 20));
  EXPECT_TRUE(detected.with_state(Hole_state::hole).empty());
  const std::vector<std::size_t> borders = detected.with_state(Hole_state::outer_border);
  ASSERT_EQ(borders.size(), 1u);
  ASSERT_TRUE(detected.engine.complete(borders, no_callback));
  EXPECT_NE(detected.engine.outcomes()[borders[0]].filling, Filling::none);
  ASSERT_GT(detected.engine.added().size(), 40u);
  for(const Added_point& p : detected.engine.added())
    EXPECT_GT(p.position.z(), 18) << p.position.transpose();
}

TEST(Open_ends, A_pipe_stays_open_on_both_sides)
{
  for(double length : { 18., 42. })
  {
    Profile profile;
    for(double z = length; z > -length; z -= 0.01)
      profile.emplace_back(5 - 0.5 * std::cos(samples::pi * z / 6), z);
    Detected pipe(turned(profile));
    EXPECT_TRUE(pipe.with_state(Hole_state::hole).empty()) << length;
    EXPECT_EQ(pipe.with_state(Hole_state::outer_border).size(), 2u) << length;
  }
}

TEST(Open_ends, A_named_end_of_a_pipe_is_closed_and_not_continued)
{
  Profile profile;
  for(double z = 42; z > -42; z -= 0.01)
    profile.emplace_back(5 - 0.5 * std::cos(samples::pi * z / 6), z);
  Detected pipe(turned(profile));
  const std::vector<std::size_t> borders = pipe.with_state(Hole_state::outer_border);
  ASSERT_EQ(borders.size(), 2u);
  ASSERT_TRUE(pipe.engine.complete(borders, no_callback));
  EXPECT_EQ(pipe.engine.outcomes()[borders[0]].filling, Filling::smooth);
  EXPECT_EQ(pipe.engine.outcomes()[borders[1]].filling, Filling::smooth);
  // from both ends towards the axis
  std::size_t near_axis[2] = { 0, 0 };
  for(const Added_point& p : pipe.engine.added())
    near_axis[p.position.z() > 0] += std::hypot(p.position.x(), p.position.y()) < 2;
  EXPECT_GT(near_axis[0], 4u);
  EXPECT_GT(near_axis[1], 4u);
}

TEST(Open_ends, Two_ends_that_were_cut_off_alike_are_no_examples_for_each_other)
{
  Detected detected(cut(rod(rod_length), -cut_height, cut_height));
  EXPECT_TRUE(detected.with_state(Hole_state::hole).empty());
  EXPECT_EQ(detected.with_state(Hole_state::outer_border).size(), 2u);
}

TEST(Open_ends, Only_ends_that_would_be_filled_are_searched_for)
{
  const samples::Samples rest = cut(rod(rod_length), -100, cut_height);
  Engine_parameters small;
  small.maximum_hole_diameter = 5;
  Engine_parameters elsewhere;
  elsewhere.excluded_regions.push_back(CGAL::Bbox_3(-10, -10, 10, 10, 10, 40));
  Engine_parameters without;
  without.ingredients.open_ends = false;
  for(const Engine_parameters& parameters : { small, elsewhere, without })
  {
    Detected detected(rest, parameters);
    EXPECT_TRUE(detected.with_state(Hole_state::hole).empty());
    EXPECT_EQ(detected.with_state(Hole_state::outer_border).size(), 1u);
  }
}

TEST(Open_ends, An_end_that_the_user_bounds_is_one_hole)
{
  Engine_parameters parameters;
  parameters.user_holes.push_back(CGAL::Bbox_3(-8, -8, 20, 8, 8, 30));
  Detected detected(cut(rod(rod_length), -100, cut_height), parameters);
  const std::vector<std::size_t> holes = detected.with_state(Hole_state::hole);
  ASSERT_EQ(holes.size(), 1u);
  ASSERT_TRUE(detected.engine.complete(holes, no_callback));
  EXPECT_GT(detected.engine.added().size(), 50u);
}

TEST(Open_ends, A_cancelled_search_leaves_nothing_and_can_be_repeated)
{
  const Surface_points points = samples::engine_points(cut(rod(rod_length), -100, cut_height));
  Completion_engine<Tag> engine(points, Engine_parameters());
  bool is_late = false;
  EXPECT_FALSE(engine.detect([&](double fraction) { is_late = fraction >= 0.9; return !is_late; }));
  EXPECT_TRUE(is_late);
  EXPECT_TRUE(engine.holes().empty());
  double last = 0;
  ASSERT_TRUE(engine.detect([&](double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    return true; }));
  ASSERT_EQ(engine.holes().size(), 1u);
  EXPECT_EQ(engine.holes()[0].state, Hole_state::hole);
}

} // namespace test_open_ends
