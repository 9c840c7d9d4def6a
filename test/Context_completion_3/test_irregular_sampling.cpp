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

// Points at random and on scan lines, whose gaps are much wider than points are near to each other.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace test_irregular_sampling {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;
typedef Completion_engine<Tag> Engine;

const double width = 60;   // of all surfaces, in spacings
const double hole_radius = 7;

double height(double x, double y) { return 2 * std::sin(x / 7) * std::cos(y / 9); }

samples::Oriented_point on_hills(double x, double y)
{
  const samples::Vector normal(-2. / 7 * std::cos(x / 7) * std::cos(y / 9), 2. / 9 * std::sin(x / 7) * std::sin(y / 9), 1);
  return { samples::Point(x, y, height(x, y)), samples::unit(normal) };
}

/// One per unit of area, each anywhere.
samples::Samples points_at_random(unsigned int seed)
{
  samples::Random_offsets offset(seed);
  samples::Samples result;
  for(std::size_t i = 0; i < std::size_t(width * width); ++i)
  {
    const double x = (1 + offset()) / 2 * width, y = (1 + offset()) / 2 * width;
    result.push_back(on_hills(x, y));
  }
  return result;
}

/// Lines more than twice as far apart as two points of a line are; one point per unit of area.
samples::Samples scan_lines(unsigned int seed)
{
  samples::Random_offsets offset(seed);
  samples::Samples result;
  const double along = 0.65, across = 1 / along;
  for(double y = across / 2; y < width; y += across)
    for(double x = along / 2; x < width; x += along)
      result.push_back(on_hills(x + 0.1 * offset(), y + 0.1 * offset()));
  return result;
}

/// Two even samplings, one over the other, as of two scans.
samples::Samples two_scans(unsigned int seed)
{
  samples::Samples result;
  const double spacing = std::sqrt(2 / std::sqrt(0.75));
  for(unsigned int scan = 0; scan < 2; ++scan)
    for(const samples::Oriented_point& s : samples::plane(std::size_t(width / spacing), spacing, 0.15, 2 * seed + scan))
    {
      const double angle = scan == 0 ? 0. : 0.5;   // about the middle; corners that leave the sheet are cut off
      const double u = s.first.x() - width / 2, v = s.first.y() - width / 2;
      const double x = width / 2 + std::cos(angle) * u - std::sin(angle) * v;
      const double y = width / 2 + std::sin(angle) * u + std::cos(angle) * v;
      if(std::hypot(u, v) < width / 2)
        result.push_back(on_hills(x, y));
    }
  return result;
}

struct Sampling
{
  std::string name;
  samples::Samples (*points)(unsigned int seed);
};

class Irregular_sampling : public testing::TestWithParam<Sampling>
{
protected:
  samples::Point middle() const
  {
    const double x = 0.55 * width, y = 0.5 * width;
    return samples::Point(x, y, height(x, y));
  }
};

std::size_t number_of_holes(const Engine& engine)
{
  std::size_t result = 0;
  for(const Hole_data& hole : engine.holes())
    result += hole.state == Hole_state::hole;
  return result;
}

} // namespace

TEST(Surface_model, Gaps_of_even_samplings_are_as_wide_as_its_points_are_apart)
{
  // also where the spacing changes by a factor of four
  const samples::Samples thinning = samples::thinning_plane(20, [](double x, double) { return 0.25 * (1 + 3 * x / 20); });
  for(const samples::Samples& surface : { samples::plane(30), samples::plane(30, 1., 0.), thinning })
  {
    const Surface_points points = samples::engine_points(surface);
    const Surface_model<Tag> model(points);
    EXPECT_EQ(model.irregularity(), 1);
  }
}

TEST(Surface_model, Gaps_between_points_at_random_are_wider_than_by_their_number)
{
  const Surface_points points = samples::engine_points(points_at_random(1));
  const Surface_model<Tag> model(points);
  EXPECT_NEAR(model.area_spacing(), 1, 0.1);
  // as many points spread evenly have a nearest neighbour at 0.8, half of these within sqrt(log(2) / pi)
  EXPECT_NEAR(model.irregularity(), 0.8 / std::sqrt(std::log(2) / samples::pi), 0.1);
  EXPECT_NEAR(model.spacing(), 0.8, 0.08);
}

TEST_P(Irregular_sampling, Has_no_hole_but_the_one_that_was_cut)
{
  for(unsigned int seed = 1; seed <= 5; ++seed)
  {
    const samples::Samples whole = GetParam().points(seed);
    for(bool is_cut : { false, true })
    {
      const Surface_points points =
        samples::engine_points(is_cut ? samples::without_ball(whole, middle(), hole_radius) : whole);
      Engine engine(points, Engine_parameters());
      ASSERT_TRUE(engine.detect(Engine::Callback()));
      ASSERT_EQ(number_of_holes(engine), is_cut ? 1u : 0u) << "seed " << seed;
      EXPECT_EQ(engine.holes().size(), is_cut ? 2u : 1u) << "the border of the sheet is the only one, seed " << seed;
      for(const Hole_data& hole : engine.holes())
        if(hole.state == Hole_state::hole)
        {
          EXPECT_LT((hole.center - samples::engine_vector(middle())).norm(), 1.5);
          EXPECT_NEAR(hole.diameter, 2 * hole_radius, 3);
        }
    }
  }
}

TEST_P(Irregular_sampling, Gets_as_many_points_as_are_missing)
{
  samples::Samples removed;
  const samples::Samples rest = samples::without_ball(GetParam().points(7), middle(), hole_radius, &removed);
  const Surface_points points = samples::engine_points(rest);
  Engine engine(points, Engine_parameters());
  ASSERT_TRUE(engine.detect(Engine::Callback()));
  ASSERT_EQ(number_of_holes(engine), 1u);
  std::vector<std::size_t> chosen;
  for(std::size_t i = 0; i < engine.holes().size(); ++i)
    if(engine.holes()[i].state == Hole_state::hole)
      chosen.push_back(i);
  ASSERT_TRUE(engine.complete(chosen, Engine::Callback()));
  const double ratio = double(engine.added().size()) / double(removed.size());
  EXPECT_GT(ratio, 0.7);
  EXPECT_LT(ratio, 1.5);
  double sum = 0;
  for(const Added_point& p : engine.added())
    sum += std::abs(p.position.z() - height(p.position.x(), p.position.y()));
  EXPECT_LT(sum / double(engine.added().size()), 0.25);
  // nowhere is a gap left that is wider than those of the sampling
  std::vector<Vector> all = points.position;
  for(const Added_point& p : engine.added())
    all.push_back(p.position);
  for(const samples::Oriented_point& s : removed)
    EXPECT_LT(samples::nearest_distance(samples::engine_vector(s.first), all), 2.2);
}

INSTANTIATE_TEST_SUITE_P(Samplings, Irregular_sampling,
                         testing::Values(Sampling{"points_at_random", points_at_random},
                                         Sampling{"scan_lines", scan_lines}, Sampling{"two_scans", two_scans}),
                         [](const testing::TestParamInfo<Sampling>& info) { return info.param.name; });

} // namespace test_irregular_sampling
