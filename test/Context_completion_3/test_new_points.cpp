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

// Where the new points of a hole are put: how densely, and on which surface.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Base_darts.h>
#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Patch_transfer.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace test_new_points {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;

const double hole_radius = 8;
const Vector hole_center(16, 20, 0);

bool is_in_hole(const Vector& p) { return (p - hole_center).norm() < hole_radius; }

double median_nearest_distance(const std::vector<Vector>& points)
{
  std::vector<double> nearest(points.size(), 1e9);
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = 0; j < points.size(); ++j)
      if(i != j)
        nearest[i] = (std::min)(nearest[i], (points[i] - points[j]).norm());
  std::nth_element(nearest.begin(), nearest.begin() + nearest.size() / 2, nearest.end());
  return nearest[nearest.size() / 2];
}

/// A flat sheet whose points keep a distance that may vary, what was in its hole, and what is put there.
struct Filled_sheet
{
  explicit Filled_sheet(const std::function<double(double, double)>& distance)
  {
    Surface_points known;
    const Surface_points all = samples::engine_points(samples::thinning_plane(40, distance, 1, 60));
    for(std::size_t i = 0; i < all.size(); ++i)
      if(is_in_hole(all.position[i]))
        removed.push_back(all.position[i]);
      else
        known.push_back(all.position[i], all.normal[i]);
    Completion_engine<Tag> engine(known, Engine_parameters());
    EXPECT_TRUE(engine.detect(Completion_engine<Tag>::Callback()));
    std::vector<std::size_t> chosen;
    for(std::size_t h = 0; h < engine.holes().size(); ++h)
      if(engine.holes()[h].state == Hole_state::hole)
        chosen.push_back(h);
    EXPECT_TRUE(engine.complete(chosen, Completion_engine<Tag>::Callback()));
    for(const Added_point& p : engine.added())
      added.push_back(p.position);
  }

  std::vector<Vector> removed, added;
};

/// A sheet with a hole, and another part of it that comes to lie there.
struct Sheet_with_place
{
  explicit Sheet_with_place(const Surface_points& all)
    : sources(1), removed(0)
  {
    const auto known = std::make_shared<Surface_points>();
    for(std::size_t i = 0; i < all.size(); ++i)
      if(is_in_hole(all.position[i]))
        ++removed;
      else
        known->push_back(all.position[i], all.normal[i]);
    sources[0].points = known;
    sources[0].model = std::make_shared<Surface_model<Tag> >(*sources[0].points);
    std::vector<Detected_hole<Tag> > holes;
    EXPECT_TRUE(Hole_detection<Tag>(*sources[0].model).run(holes, std::function<bool(double)>()));
    for(const Detected_hole<Tag>& h : holes)
      if(!h.is_outer_border && (h.center() - hole_center).norm() < 4)
        patch = h.patch;
    if(patch)
      sampler = std::make_unique<Relief_sampler<Tag> >(*patch, sources);
  }

  /// What is 30 along x, moved here and raised, where nothing but the plane is planned.
  std::vector<Added_point> carried(double height, bool is_whole) const
  {
    const Eigen::Index number = Eigen::Index(patch->samples().size());
    Hole_relief relief;
    relief.heights = relief.errors = Eigen::VectorXd::Zero(number);
    relief.copy.assign(patch->samples().size(), 0);
    relief.copies.resize(1);
    relief.copies[0].place.motion.translation = Vector(-30, 0, 0);
    relief.copies[0].displacement = Eigen::VectorXd::Constant(number, height);
    relief.copies[0].set_surface(sampler->relief(relief.copies[0].place), relief.heights);
    relief.copies[0].is_whole = is_whole;
    relief.copies[0].tolerance = is_whole ? sampler->height_limit() : 1.5 * patch->spacing();
    return Patch_transfer<Tag>(*sources[0].model, *patch, *sampler, sources).points(relief);
  }

  std::vector<Example_source<Tag> > sources;
  std::shared_ptr<const Smooth_patch<Tag> > patch;
  std::unique_ptr<Relief_sampler<Tag> > sampler;
  std::size_t removed;
};

/// Both sides of a thin wall that stands on the plane, along y through `x`.
void add_fin(double x, double from, double to, Surface_points& points)
{
  for(double side : { -0.5, 0.5 })
    for(double y = from; y < to; y += 0.9)
      for(double z = 0.5; z < 7; z += 0.9)
        points.push_back(Vector(x + side, y, z), Vector(side > 0 ? 1. : -1., 0, 0));
  for(double y = from; y < to; y += 0.9)
    points.push_back(Vector(x, y, 7.2), Vector(0, 0, 1));
}

Surface_points sheet() { return samples::engine_points(samples::thinning_plane(62, [](double, double) { return 0.9; })); }

/// How high the points in the hole reach if the place has a fin, and the surroundings the same one or none.
double highest_carried_fin(double from, double to, bool is_known)
{
  Surface_points points = sheet();
  add_fin(46, from, to, points);
  if(is_known)
    add_fin(16, from, to, points);
  const Sheet_with_place scene(points);
  EXPECT_TRUE(scene.patch);
  double result = 0;
  if(scene.patch)
    for(const Added_point& p : scene.carried(0, true))
      result = (std::max)(result, p.position.z());
  return result;
}

} // namespace

TEST(New_points, Are_as_many_and_as_far_apart_as_those_that_are_missing)
{
  const Filled_sheet sheet([](double, double) { return 0.9; });
  ASSERT_FALSE(sheet.added.empty());
  EXPECT_NEAR(double(sheet.added.size()) / double(sheet.removed.size()), 1., 0.15);
  EXPECT_NEAR(median_nearest_distance(sheet.added) / median_nearest_distance(sheet.removed), 1., 0.1);
}

TEST(New_points, Leave_no_gap)
{
  const Filled_sheet sheet([](double, double) { return 0.9; });
  for(const Vector& p : sheet.removed)
    if((p - hole_center).norm() < hole_radius - 2)
    {
      EXPECT_LT(samples::nearest_distance(p, sheet.added), 1.3);
    }
}

TEST(New_points, Follow_a_spacing_that_changes_across_the_hole)
{
  const Filled_sheet sheet([](double x, double) { return 0.3 + 0.045 * x; });
  const auto ratio = [](const std::vector<Vector>& points)
  {
    const double left = double(std::count_if(points.begin(), points.end(), [](const Vector& p) {
      return p.x() < hole_center.x(); }));
    return left / (double(points.size()) - left);
  };
  ASSERT_GT(ratio(sheet.removed), 1.4);
  EXPECT_NEAR(ratio(sheet.added) / ratio(sheet.removed), 1., 0.2);
  EXPECT_NEAR(double(sheet.added.size()) / double(sheet.removed.size()), 1., 0.2);
}

TEST(New_points, Between_those_of_a_sparser_place_lie_on_the_same_surface)
{
  Sheet_with_place sheet(samples::engine_points(samples::thinning_plane(62, [](double x, double) {
    return x < 31 ? 0.9 : 1.4; })));
  ASSERT_TRUE(sheet.patch);
  const std::vector<Added_point> points = sheet.carried(0.4, false);
  EXPECT_GT(double(points.size()), 0.85 * double(sheet.removed));
  std::size_t inside = 0;
  for(const Added_point& p : points)
    if((p.position - hole_center).norm() < hole_radius - 2)
    {
      EXPECT_NEAR(p.position.z(), 0.4, 0.01);
      ++inside;
    }
  EXPECT_GT(inside, 50u);
}

TEST(Walls_of_a_place, Are_carried_where_they_go_on_beside_the_hole)
{
  EXPECT_GT(highest_carried_fin(2, 38, true), 4);
}

TEST(Walls_of_a_place, Are_left_out_where_they_would_end_in_the_air)
{
  EXPECT_LT(highest_carried_fin(2, 38, false), 2.5);
}

TEST(Walls_of_a_place, Are_carried_where_they_end_within_the_hole)
{
  EXPECT_GT(highest_carried_fin(17, 23, false), 4);
}

TEST(Base_darts, Are_all_over_the_base_beside_their_samples)
{
  Sheet_with_place sheet(samples::engine_points(samples::bumpy_plane(62, 1., 25., 2.)));
  ASSERT_TRUE(sheet.patch);
  const std::vector<char> is_wanted(sheet.patch->samples().size(), 1);
  const Base_darts<Tag> one(*sheet.patch, *sheet.sampler, is_wanted);
  ASSERT_GT(one.darts().size(), 8 * is_wanted.size());
  for(const Base_dart& dart : one.darts())
  {
    Vector x = dart.position, normal;
    ASSERT_TRUE(sheet.patch->project(x, normal));
    EXPECT_LT((x - dart.position).norm(), 0.01 * sheet.patch->spacing());
    for(std::size_t s = 0; s < is_wanted.size(); ++s)
      ASSERT_GE((sheet.patch->samples()[s].position - dart.position).norm(),
                (sheet.patch->samples()[dart.sample].position - dart.position).norm());
  }
}

TEST(Base_darts, Are_not_where_none_are_wanted)
{
  Sheet_with_place sheet(test_new_points::sheet());
  ASSERT_TRUE(sheet.patch);
  std::vector<char> is_wanted(sheet.patch->samples().size(), 0);
  is_wanted[is_wanted.size() / 2] = 1;
  const Base_darts<Tag> darts(*sheet.patch, *sheet.sampler, is_wanted);
  ASSERT_FALSE(darts.darts().empty());
  for(const Base_dart& dart : darts.darts())
    EXPECT_LT((dart.position - sheet.patch->samples()[is_wanted.size() / 2].position).norm(), sheet.patch->spacing());
}

} // namespace test_new_points
