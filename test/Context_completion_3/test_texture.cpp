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

// True in texture or nearest in distance: the parameter `keep_texture`, on relief that does not repeat.

#include "include/engine_samples.h"
#include "include/random_relief.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Patch_transfer.h>

#include <CGAL/tags.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace test_texture {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef Completion_engine<CGAL::Parallel_if_available_tag> Engine;

typedef samples::Random_relief Random_relief;

const double hole_radius = 8, center = 24;

double from_center(const Vector& p) { return std::hypot(p.x() - center, p.y() - center); }

// Hills that no rim tells of, and on them a roughness of a few spacings. Most of the error is due to the hills, so that
// the roughness is small against it.
Random_relief rough_hills(unsigned int seed)
{
  Random_relief relief(seed);
  relief.add(1.1, 14., 40);
  relief.add(0.2, 4., 60);
  return relief;
}

struct Completion
{
  std::vector<Added_point> added;
  Hole_outcome outcome;
};

Completion completed(const Surface_points& points, bool keep_texture)
{
  Engine_parameters parameters;
  parameters.keep_texture = keep_texture;
  Engine engine(points, parameters);
  EXPECT_TRUE(engine.detect(Engine::Callback()));
  std::vector<std::size_t> chosen;
  for(std::size_t h = 0; h < engine.holes().size(); ++h)
    if(engine.holes()[h].state == Hole_state::hole)
      chosen.push_back(h);
  EXPECT_EQ(chosen.size(), 1u);
  EXPECT_TRUE(engine.complete(chosen, Engine::Callback()));
  Completion result;
  result.added = engine.added();
  if(!chosen.empty())
    result.outcome = engine.outcomes()[chosen.front()];
  return result;
}

// Root mean square residual of the points around each of `centers` to the quadric that fits them best.
double roughness(const std::vector<Vector>& centers, const std::vector<Vector>& points)
{
  double sum = 0;
  for(const Vector& c : centers)
  {
    std::vector<Vector> near;
    for(const Vector& p : points)
      if((p - c).norm() < 4)
        near.push_back(p - c);
    Eigen::MatrixXd terms(near.size(), 6);
    Eigen::VectorXd height(near.size());
    for(std::size_t i = 0; i < near.size(); ++i)
    {
      const double x = near[i].x(), y = near[i].y();
      terms.row(Eigen::Index(i)) << 1, x, y, x * x, x * y, y * y;
      height[Eigen::Index(i)] = near[i].z();
    }
    const Eigen::VectorXd rest = height - terms * terms.colPivHouseholderQr().solve(height);
    sum += rest.squaredNorm() / double(near.size());
  }
  return std::sqrt(sum / double(centers.size()));
}

struct Scores
{
  double roughness = 0;       // where the texture has begun
  double error = 0;           // mean distance to the true surface
};

Scores scores(const Completion& completion, const Surface_points& known, const Random_relief& relief)
{
  Scores result;
  std::vector<Vector> points = known.position, inner;
  for(const Added_point& p : completion.added)
  {
    points.push_back(p.position);
    result.error += relief.distance(p.position) / double(completion.added.size());
    if(from_center(p.position) < hole_radius - 4)
      inner.push_back(p.position);
  }
  EXPECT_GT(inner.size(), 40u);
  result.roughness = roughness(inner, points);
  return result;
}

} // namespace

TEST(Keep_texture, Roughness_goes_on_if_asked_for_and_costs_distance)
{
  // one surface says little: a plan may be a copy with some texture anyway, and distances depend on chance
  const unsigned int number = 5;
  Scores around, with, without;
  for(unsigned int seed = 1; seed <= number; ++seed)
  {
    SCOPED_TRACE(seed);
    const Random_relief relief = rough_hills(seed);
    const samples::Samples sheet = samples::graph(48, 1.,
      [&](double x, double y) { return relief.height(x, y); },
      [&](double x, double y) { return relief.gradient(x, y); });
    const samples::Point middle(center, center, relief.height(center, center));
    const Surface_points known = samples::engine_points(samples::without_ball(sheet, middle, hole_radius));
    std::vector<Vector> ring;
    for(const Vector& p : known.position)
      if(from_center(p) > hole_radius + 4 && from_center(p) < hole_radius + 12)
        ring.push_back(p);
    around.roughness += roughness(ring, known.position) / number;

    const Completion rough = completed(known, true), smooth = completed(known, false);
    ASSERT_FALSE(rough.added.empty());
    ASSERT_FALSE(smooth.added.empty());
    EXPECT_EQ(rough.outcome.filling, smooth.outcome.filling);
    const Scores with_here = scores(rough, known, relief), without_here = scores(smooth, known, relief);
    EXPECT_GE(with_here.roughness, without_here.roughness);
    with.roughness += with_here.roughness / number;
    with.error += with_here.error / number;
    without.roughness += without_here.roughness / number;
    without.error += without_here.error / number;
  }
  RecordProperty("roughness_around", std::to_string(around.roughness));
  RecordProperty("roughness_with_texture", std::to_string(with.roughness));
  RecordProperty("roughness_without", std::to_string(without.roughness));
  RecordProperty("error_with_texture", std::to_string(with.error));
  RecordProperty("error_without", std::to_string(without.error));
  EXPECT_NEAR(with.roughness, around.roughness, 0.2 * around.roughness);
  EXPECT_LT(without.roughness, 0.75 * around.roughness);
  EXPECT_LT(without.error, 1.02 * with.error);
}

TEST(Keep_texture, Is_the_same_where_there_is_none)
{
  const samples::Samples sphere = samples::without_ball(samples::sphere(3000, 15.5), samples::Point(15.5, 0, 0), 4.);
  const Surface_points known = samples::engine_points(sphere);
  const Completion with = completed(known, true), without = completed(known, false);
  ASSERT_FALSE(with.added.empty());
  ASSERT_EQ(with.added.size(), without.added.size());
  for(std::size_t i = 0; i < with.added.size(); ++i)
  {
    EXPECT_TRUE(with.added[i].position == without.added[i].position);
    EXPECT_EQ(with.added[i].source, without.added[i].source);
  }
}

// A rough sheet with a hole, from which another part of it, with a ledge, is carried there; nothing is planned but the
// plane. \return the largest height of a carried point
double highest_carried(bool is_whole)
{
  typedef CGAL::Sequential_tag Tag;
  Random_relief relief(3);
  relief.add(0.05, 4, 30);
  samples::Samples sheet = samples::graph(60, 1., [&](double x, double y)
    { return relief.height(x, y) + (x > 40 && x < 43 && y > 18 && y < 30 ? 1.3 : 0.); },
    [&](double x, double y) { return relief.gradient(x, y); });
  std::vector<Example_source<Tag> > sources(1);
  sources[0].points =
    std::make_shared<Surface_points>(samples::engine_points(samples::without_ball(sheet, samples::Point(16, 24, 0), 6.)));
  sources[0].model = std::make_shared<Surface_model<Tag> >(*sources[0].points);
  std::vector<Detected_hole<Tag> > holes;
  EXPECT_TRUE(Hole_detection<Tag>(*sources[0].model).run(holes, std::function<bool(double)>()));
  std::shared_ptr<const Smooth_patch<Tag> > patch;
  for(const Detected_hole<Tag>& h : holes)
    if(!h.is_outer_border && (h.center() - Vector(16, 24, 0)).norm() < 2)
      patch = h.patch;
  if(!patch)
    return -1;
  const Relief_sampler<Tag> sampler(*patch, sources);
  const Eigen::Index number = Eigen::Index(patch->samples().size());
  Hole_relief planned;
  planned.heights = planned.errors = Eigen::VectorXd::Zero(number);
  planned.copy.assign(patch->samples().size(), 0);
  planned.copies.resize(1);
  planned.copies[0].place.motion.translation = Vector(-25, 0, 0);
  planned.copies[0].place.origin = Vector(41, 24, 0);
  planned.copies[0].displacement = Eigen::VectorXd::Zero(number);
  planned.copies[0].surface = Eigen::VectorXd::Zero(number);
  planned.copies[0].is_whole = is_whole;
  planned.copies[0].tolerance = is_whole ? sampler.height_limit() : 1.5 * patch->spacing();
  double highest = -1;
  const Patch_transfer<Tag> transfer(*sources[0].model, *patch, sampler, sources);
  for(const Added_point& p : transfer.points(planned))
    highest = (std::max)(highest, p.position.z());
  return highest;
}

TEST(Keep_texture, A_ledge_of_the_place_is_no_texture)
{
  const double texture = highest_carried(false);
  EXPECT_GT(texture, 0.05);
  EXPECT_LT(texture, 0.6);
  EXPECT_GT(highest_carried(true), 1.2);
}

} // namespace test_texture
