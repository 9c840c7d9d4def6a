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

// Relief that no single place matches, but that many places teach to go on.

#include "include/engine_samples.h"
#include "include/random_relief.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Height_field.h>
#include <CGAL/Context_completion_3/internal/Learned_continuation.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace test_learned_relief {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Parallel_if_available_tag Tag;
typedef Surface_model<Tag> Model;
typedef Height_field<Tag> Field;

const double hole_radius = 9, center = 33;
const std::size_t rows = 66;

// Five waves that cross each other: their phases never come together again, but how they go on is the same everywhere.
samples::Random_relief crossing_waves(unsigned int seed = 5)
{
  samples::Random_relief relief(seed);
  relief.add(1., 11., 5);
  return relief;
}

samples::Samples sheet(const samples::Random_relief& relief, const std::function<bool(double, double)>& is_kept)
{
  const samples::Samples all = samples::graph(
    rows, 1., [&](double x, double y) { return relief.height(x, y); },
    [&](double x, double y) { return relief.gradient(x, y); });
  samples::Samples kept;
  for(const samples::Oriented_point& p : all)
    if(is_kept(p.first.x() - center, p.first.y() - center))
      kept.push_back(p);
  return kept;
}

bool is_around(double x, double y) { return std::hypot(x, y) > hole_radius; }

struct Completion
{
  std::vector<Added_point> added;
  Hole_outcome outcome;
  double error = 0;                      // mean distance to the relief
};

template <typename Engine_tag>
Completion completed(const samples::Random_relief& relief, bool is_learning)
{
  typedef Completion_engine<Engine_tag> Engine;
  const Surface_points points = samples::engine_points(sheet(relief, is_around));
  Engine_parameters parameters;
  parameters.ingredients.learning = is_learning;
  Engine engine(points, parameters);
  EXPECT_TRUE(engine.detect(typename Engine::Callback()));
  std::vector<std::size_t> chosen;
  for(std::size_t h = 0; h < engine.holes().size(); ++h)
    if(engine.holes()[h].state == Hole_state::hole)
      chosen.push_back(h);
  EXPECT_EQ(chosen.size(), 1u);
  EXPECT_TRUE(engine.complete(chosen, typename Engine::Callback()));
  Completion result;
  result.added = engine.added();
  result.outcome = engine.outcomes()[chosen.front()];
  for(const Added_point& p : result.added)
    result.error += relief.distance(p.position) / double(result.added.size());
  return result;
}

void expect_same_points(const std::vector<Added_point>& a, const std::vector<Added_point>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t i = 0; i < a.size(); ++i)
    EXPECT_EQ(a[i].position, b[i].position);
}

// The hole of a sheet with its base.
struct Hole_in_sheet
{
  explicit Hole_in_sheet(const samples::Samples& sheet) : points(samples::engine_points(sheet)), model(points)
  {
    std::vector<Detected_hole<Tag> > holes;
    EXPECT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
    for(const Detected_hole<Tag>& hole : holes)
      if(!hole.is_outer_border)
        patch = hole.patch;
    if(!patch)
      ADD_FAILURE() << "no hole";
  }

  Surface_points points;
  Model model;
  std::shared_ptr<const Smooth_patch<Tag> > patch;
};

std::size_t nearest_point(const Model& model, double x, double y, double z)
{
  return model.search().nearest(Vector(center + x, center + y, z)).first;
}

} // namespace

TEST(Learned_relief, CrossingWavesGoOnThroughTheHole)
{
  const samples::Random_relief relief = crossing_waves();
  const Completion learned = completed<Tag>(relief, true), other = completed<Tag>(relief, false);
  EXPECT_EQ(learned.outcome.filling, Filling::learned) << learned.outcome.reason;
  EXPECT_NE(learned.outcome.reason.find("learned from "), std::string::npos) << learned.outcome.reason;
  EXPECT_NE(other.outcome.filling, Filling::learned) << other.outcome.reason;
  EXPECT_LT(learned.error, 0.5 * other.error);
  EXPECT_LT(learned.error, learned.outcome.expected_error);
  EXPECT_LT(learned.outcome.expected_error, 5 * learned.error);
}

// Waves of forty directions are as good as none: the sheet is too small to teach them.
TEST(Learned_relief, ReliefThatIsRandomStaysAsItWas)
{
  samples::Random_relief relief(6);
  relief.add(1., 6., 40);
  const Completion learned = completed<Tag>(relief, true), other = completed<Tag>(relief, false);
  EXPECT_NE(learned.outcome.filling, Filling::learned) << learned.outcome.reason;
  expect_same_points(learned.added, other.added);
}

TEST(Learned_relief, OneThreadAndSeveralMakeTheSamePoints)
{
  const samples::Random_relief relief = crossing_waves();
  const Completion one = completed<CGAL::Sequential_tag>(relief, true), several = completed<Tag>(relief, true);
  EXPECT_EQ(one.outcome.filling, Filling::learned) << one.outcome.reason;
  expect_same_points(one.added, several.added);
}

TEST(Learned_relief, FakeHolesMissWhatTheHoleMisses)
{
  const samples::Random_relief relief = crossing_waves();
  const Hole_in_sheet hole(sheet(relief, is_around));
  ASSERT_TRUE(hole.patch);
  const Learned_relief learned =
    Learned_continuation<Tag>(hole.model, hole.model, *hole.patch, hole_radius, []() {}).result();
  ASSERT_GT(learned.places, 0u);
  double error = 0;
  for(std::size_t s = 0; s < hole.patch->samples().size(); ++s)
  {
    const Base_sample& sample = hole.patch->samples()[s];
    error += relief.distance(Vector(sample.position + learned.heights[Eigen::Index(s)] * sample.normal)) /
             double(hole.patch->samples().size());
  }
  // heights over a curved base are only first order: that is the rest
  EXPECT_LT(error, learned.error + 0.05);
  EXPECT_GT(error, learned.error / 2);
  EXPECT_LT(learned.error, learned.upper);
  EXPECT_EQ(learned.misses.rows(), Eigen::Index(hole.patch->samples().size()));
  EXPECT_LT(std::abs(std::log(learned.misses.cwiseAbs().mean() / learned.error)), std::log(2.));
}

TEST(Learned_relief, TooSmallASheetTeachesNothing)
{
  const samples::Random_relief relief = crossing_waves();
  const Hole_in_sheet hole(sheet(relief, [](double x, double y) {
    return is_around(x, y) && std::hypot(x, y) < 2 * hole_radius; }));
  ASSERT_TRUE(hole.patch);
  const Learned_relief learned =
    Learned_continuation<Tag>(hole.model, hole.model, *hole.patch, hole_radius, []() {}).result();
  EXPECT_EQ(learned.places, 0u);
}

TEST(Learned_relief, PollIsAskedWhileLearning)
{
  const Hole_in_sheet hole(sheet(crossing_waves(), is_around));
  ASSERT_TRUE(hole.patch);
  std::size_t asked = 0;
  Learned_continuation<Tag>(hole.model, hole.model, *hole.patch, hole_radius, [&]() { ++asked; });
  EXPECT_GT(asked, 5u);
}

TEST(Height_field, PlacesAreSeenFromTheirMeanPlane)
{
  const samples::Random_relief relief = crossing_waves();
  const Hole_in_sheet hole(sheet(relief, is_around));
  ASSERT_TRUE(hole.patch);
  const Field field(hole.model, *hole.patch, hole_radius);
  ASSERT_TRUE(field.is_valid());
  const Field::Heights own = field.of_hole(hole.model);
  EXPECT_EQ(own.around_share, 1.);
  EXPECT_LT(own.inside_share, 0.2);
  // a place as far from the hole as there is room for: a sheet that is the same but for a shift has the same heights
  const samples::Samples all = sheet(relief, [](double, double) { return true; });
  const Surface_points points = samples::engine_points(all);
  const Model whole(points);
  Vector origin;
  const auto place = field.of_place(whole, nearest_point(whole, 0, 0, relief.height(center, center)), origin);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->inside_share, 1.);
  // up to the tilt of the mean plane, and the shift from the middle of the hole to the nearest point
  Eigen::MatrixXd terms(own.around.size(), 3);
  for(Eigen::Index i = 0; i < terms.rows(); ++i)
    terms.row(i) << 1, field.around()[std::size_t(i)].transpose();
  const Eigen::VectorXd difference = place->around - own.around;
  const Eigen::VectorXd tilt = terms.colPivHouseholderQr().solve(difference);
  const double shift = (origin - field.middle()).norm();
  EXPECT_LT((difference - terms * tilt).cwiseAbs().mean(), 0.05 + 0.6 * shift);
}

TEST(Height_field, PointsInsideTellNothingAboutHeightsAround)
{
  const samples::Random_relief relief = crossing_waves();
  const Hole_in_sheet hole(sheet(relief, is_around));
  ASSERT_TRUE(hole.patch);
  const Field field(hole.model, *hole.patch, hole_radius);
  samples::Samples all = sheet(relief, [](double, double) { return true; }), moved;
  for(const samples::Oriented_point& p : all)
  {
    const bool is_inside = std::hypot(p.first.x() - center, p.first.y() - center) < hole_radius - 1;
    moved.emplace_back(is_inside ? p.first + samples::Vector(0, 0, 0.7) : p.first, p.second);
  }
  // the mean plane of the place must not move, so the points of the hole are compared
  const Surface_points before = samples::engine_points(all), after = samples::engine_points(moved);
  const Model whole(before), changed(after);
  const Field::Heights one = field.of_hole(whole), other = field.of_hole(changed);
  EXPECT_EQ(one.inside_share, 1.);
  EXPECT_EQ(one.around, other.around);
  EXPECT_GT((other.inside - one.inside).mean(), 0.4);
}

TEST(Height_field, HeightsOverThePlaneBecomeThoseOverTheBase)
{
  const samples::Random_relief relief = crossing_waves();
  const Hole_in_sheet hole(sheet(relief, is_around));
  ASSERT_TRUE(hole.patch);
  const Field field(hole.model, *hole.patch, hole_radius);
  const Surface_points points = samples::engine_points(sheet(relief, [](double, double) { return true; }));
  const Model whole(points);
  const Eigen::VectorXd heights = field.over_base(field.of_hole(whole).inside);
  double error = 0;
  for(std::size_t s = 0; s < hole.patch->samples().size(); ++s)
  {
    const Base_sample& sample = hole.patch->samples()[s];
    error += relief.distance(Vector(sample.position + heights[Eigen::Index(s)] * sample.normal)) /
             double(hole.patch->samples().size());
  }
  EXPECT_LT(error, 0.1);
}

// The hole takes a third of the ball, so much of what is around it faces aside and away.
TEST(Height_field, AHoleThatIsLargeAgainstABallIsNoHeightField)
{
  const double radius = 10;
  const Hole_in_sheet hole(samples::without_ball(samples::sphere(1200, radius), samples::Point(0, 0, radius), 11));
  ASSERT_TRUE(hole.patch);
  EXPECT_FALSE(Field(hole.model, *hole.patch, radius).is_valid());
  const Learned_relief learned =
    Learned_continuation<Tag>(hole.model, hole.model, *hole.patch, radius, []() {}).result();
  EXPECT_EQ(learned.places, 0u);
}

} // namespace test_learned_relief
