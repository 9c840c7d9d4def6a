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

// Signatures in the frames of places (sections 6.1 and 6.2), and the first round of a search, which goes by them.

#include "include/engine_samples.h"
#include "include/search_target.h"

#include <CGAL/Context_completion_3/internal/Hole_completion.h>
#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Place_ranking.h>
#include <CGAL/Context_completion_3/internal/Place_search.h>
#include <CGAL/Context_completion_3/internal/Place_signature.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace test_place_signature {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;
typedef Surface_model<Tag> Model;

const double radius = 5.;

// a relief without symmetry
Surface_points hilly(std::size_t rows)
{
  const auto height = [](double x, double y) {
    return 0.9 * std::sin(0.3 * x) + 0.7 * std::sin(0.35 * y + 0.2 * x + 1.) +
           1.5 * std::exp(-0.02 * (x * x + y * y)); };
  const double e = 1e-5;
  return samples::engine_points(samples::graph(rows, 1., height, [=](double x, double y) {
    return std::make_pair((height(x + e, y) - height(x - e, y)) / (2 * e),
                          (height(x, y + e) - height(x, y - e)) / (2 * e)); }));
}

Surface_points moved(const Surface_points& points, const Motion& motion)
{
  Surface_points result;
  for(std::size_t i = 0; i < points.size(); ++i)
    result.push_back(motion(points.position[i]), motion.normal(points.normal[i]));
  return result;
}

Surface_frame frame_at(const Surface_points& points, std::size_t i, double angle)
{
  Surface_frame frame;
  frame.origin = points.position[i];
  frame.normal = points.normal[i];
  frame.axis = frame.normal.unitOrthogonal();
  return frame.turned(angle);
}

/// Signatures with all points for the coarse ones, too.
struct All_signatures
{
  All_signatures(const Surface_points& points, double radius, double spacing)
    : search(points.position), signatures(points, search, points, radius, spacing)
  {}

  std::vector<Cell_signature> operator()(const std::vector<Surface_frame>& frames)
  {
    return signatures.signatures<Tag>(frames);
  }

  Neighbor_search search;
  Place_signatures signatures;
};

Cell_signature signature(const Surface_points& points, const Surface_frame& frame)
{
  return All_signatures(points, radius, 1.)({ frame }).front();
}

double largest_difference(const Cell_signature& a, const Cell_signature& b)
{
  return double((a.vector - b.vector).lpNorm<Eigen::Infinity>());
}

std::size_t middle_of(const Surface_points& points)
{
  Vector mean = Vector::Zero();
  for(const Vector& p : points.position)
    mean += p / double(points.size());
  return Neighbor_search(points.position).nearest(mean).first;
}

} // namespace

TEST(Place_signature, Of_a_plane_is_known)
{
  const Surface_points plane = samples::engine_points(samples::plane(60));
  const std::size_t middle = middle_of(plane);
  const Cell_signature found = signature(plane, frame_at(plane, middle, 0.7));
  for(std::size_t i = 0; i < 27; ++i)
  {
    const int k = int(i);
    const Cell_offset offset = cell_offset(i);
    EXPECT_NEAR(found.vector[Cell_signature::inner_distance + k], 0.5 * offset[2], 1e-5) << i;
    EXPECT_NEAR(found.vector[Cell_signature::outer_distance + k], offset[2], 1e-5) << i;
    for(const int direction : { Cell_signature::inner_direction, Cell_signature::outer_direction })
      EXPECT_LT((found.vector.segment<3>(direction + 3 * k) - Eigen::Vector3f(0, 0, 1)).norm(), 1e-5f) << i;
    // the plane passes the eight cells beside this one, and is exact there
    const bool is_beside = offset[2] == 0 && i != own_offset;
    EXPECT_EQ(found.vector[Cell_signature::detail + k], is_beside ? 0.f : Cell_signature::undefined_detail) << i;
  }
}

TEST(Place_signature, Of_a_sphere_has_its_distances)
{
  // a general quadric is a sphere exactly, and so is its distance along the normal to first order
  const double large = 24.;
  const Surface_points sphere = samples::engine_points(samples::sphere(7000, large));
  const Cell_signature found = signature(sphere, frame_at(sphere, 3500, 0.));
  for(std::size_t i = 0; i < 27; ++i)
  {
    const Cell_offset offset = cell_offset(i);
    const Vector p = Vector(0, 0, large) + radius * Vector(offset[0], offset[1], offset[2]);
    const double distance = (p.norm() - large) / (2 * radius);
    EXPECT_NEAR(found.vector[Cell_signature::inner_distance + int(i)], distance, 0.06) << i;
    EXPECT_LT((found.vector.segment<3>(Cell_signature::inner_direction + 3 * int(i)).cast<double>() -
               p.normalized()).norm(), 0.15) << i;
  }
}

TEST(Place_signature, Moves_with_the_surface)
{
  const Surface_points surface = hilly(60);
  const std::size_t middle = middle_of(surface);
  const Motion motion = Motion().moved(Vector(0.4, -1.1, 0.8), Vector(100, -20, 7), Vector(3, 2, 1));
  const Surface_points other = moved(surface, motion);
  for(const double angle : { 0., 1.3 })
  {
    const Surface_frame frame = frame_at(surface, middle, angle);
    Surface_frame image;
    image.origin = motion(frame.origin);
    image.axis = motion.normal(frame.axis);
    image.normal = motion.normal(frame.normal);
    EXPECT_LT(largest_difference(signature(surface, frame), signature(other, image)), 1e-4);
    // which would be no feat if it were always the same
    EXPECT_GT(largest_difference(signature(surface, frame), signature(surface, frame.turned(0.8))), 0.05);
  }
}

TEST(Place_signature, Of_a_mirror_image_is_the_mirrored_one)
{
  const Surface_points surface = hilly(60);
  const Surface_frame frame = frame_at(surface, middle_of(surface), 0.4);
  // the reflection at the plane through axis and normal
  const Vector across = frame.normal.cross(frame.axis);
  Motion mirror;
  mirror.linear = Matrix::Identity() - 2 * across * across.transpose();
  mirror.translation = frame.origin - mirror.linear * frame.origin;
  const Cell_signature original = signature(surface, frame), image = signature(moved(surface, mirror), frame);
  EXPECT_LT(largest_difference(original.transformed(Place_signatures::mirror()), image), 1e-4);
  EXPECT_GT(largest_difference(original, image), 0.02);
}

TEST(Place_signature, Tells_places_of_a_repeat_from_others)
{
  const double period = 30.;
  const Surface_points surface = samples::engine_points(samples::bumpy_plane(130, 1., period, 4.));
  const Neighbor_search search(surface.position);
  const std::size_t here = search.nearest(Vector(52, 46, 0)).first;
  All_signatures signatures(surface, radius, 1.);
  const auto distance = [&](const Vector& there)
  {
    Surface_frame a, b;
    a.origin = surface.position[here];
    b.origin = surface.position[search.nearest(there).first];
    const std::vector<Cell_signature> both = signatures({ a, b });
    return signature_distance(both[0], both[1], Signature_weights());
  };
  const Vector p = surface.position[here];
  const double twin = distance(p + Vector(period, 0, 0)), other = distance(p + Vector(period / 4, 0, 0));
  EXPECT_LT(3 * twin, other);
}

TEST(Place_signature, Counts_the_levels_that_detail_needs)
{
  // waves too short for a fit of the cell's size, and none
  const Surface_points wavy = samples::engine_points(samples::bumpy_plane(120, 0.5, 6., 1.)),
                       flat = samples::engine_points(samples::plane(120, 0.5));
  const auto deepest = [](const Surface_points& points)
  {
    const Cell_signature found = All_signatures(points, radius, 0.5)(
      { frame_at(points, middle_of(points), 0.) }).front();
    return found.vector.segment<27>(Cell_signature::detail).maxCoeff();
  };
  EXPECT_EQ(deepest(flat), 0.f);
  EXPECT_GE(deepest(wavy), 1.f);
}

TEST(Place_signature, Does_not_depend_on_what_was_asked_before)
{
  const Surface_points surface = hilly(50);
  std::vector<Surface_frame> frames;
  for(std::size_t i = 5; i < surface.size(); i += 97)
    frames.push_back(frame_at(surface, i, 0.1 * double(i)));
  All_signatures together(surface, radius, 1.);
  const std::vector<Cell_signature> all = together(frames);
  for(std::size_t i = 0; i < frames.size(); ++i)
  {
    EXPECT_EQ(largest_difference(all[i], signature(surface, frames[i])), 0.) << i;
    EXPECT_EQ(largest_difference(all[i], together({ frames[i] }).front()), 0.) << i;
  }
}

TEST(Place_index, Weights_of_signatures_rise_towards_the_finest_level)
{
  const Surface_points points = samples::engine_points(samples::plane(80));
  const Model model(points);
  double last = 0.3;
  for(const double hole : { 20., 10., 5., 3. })
  {
    const Signature_weights weights = Place_index<Tag>(model, hole, 1., 100).weights();
    EXPECT_GT(weights.inner, last) << hole;
    last = weights.inner;
  }
  EXPECT_LT(last, 0.7);
  EXPECT_EQ(Place_index<Tag>(model, 1., 1., 100).weights().inner, 0.7) << "cells of less than four spacings";
  EXPECT_EQ(Place_index<Tag>(model, 100., 1., 100).weights().inner, 0.3) << "cells larger than the surface";
}

TEST(Place_ranking, By_signature_equals_exhaustive_comparison)
{
  const Surface_points points = samples::engine_points(
    samples::without_ball(samples::bumpy_plane(48, 1., 12., 1.5), samples::Point(24, 24, 0), 5.));
  const Model model(points);
  const Match_target target = samples::target_of(model);
  const std::size_t turns = 6;
  Place_index<Tag> index(model, target.radius, target.spacing, 2000);
  const std::vector<Place_hypothesis> ranking = Place_ranking<Tag>(model, index, target, turns, true).by_signature();
  const std::vector<std::size_t> candidates = index.candidates(target.frame, target.around);
  ASSERT_EQ(ranking.size(), 3 * candidates.size());
  ASSERT_GT(candidates.size(), 100u);
  All_signatures around(target.surface, target.radius, target.spacing);
  Place_signatures source(points, model.search(), index.coarse(), target.radius, target.spacing);
  for(std::size_t c = 0; c < candidates.size(); c += 7)
  {
    const Surface_frame& place = index.frame(candidates[c]);
    double best = std::numeric_limits<double>::infinity();
    Motion motion;
    for(int mirrored = 0; mirrored < 2; ++mirrored)
      for(std::size_t t = 0; t < turns; ++t)
      {
        const Surface_frame turned = target.frame.turned(2 * samples::pi * double(t) / double(turns));
        Cell_signature there = source.signatures<Tag>({ place }).front();
        if(mirrored == 1)
          there = there.transformed(Place_signatures::mirror());
        const double distance = signature_distance(around({ turned }).front(), there,
                                                   index.weights());
        if(distance < best - 1e-9)
        {
          best = distance;
          motion = turned.motion_from(place, mirrored == 1);
        }
      }
    EXPECT_NEAR(ranking[3 * c].score, best, 1e-5) << c;
    EXPECT_LE(ranking[3 * c].score, ranking[3 * c + 1].score) << c;
    EXPECT_LT((motion(place.origin) - target.frame.origin).norm(), 1e-9) << c;
  }
}

TEST(Place_search, Finds_a_twin_by_each_judge_alone)
{
  const double period = 12., bump = 1.5, k = 2 * samples::pi / period;
  const auto height = [&](const Vector& p) { return bump * std::sin(k * p.x()) * std::sin(k * p.y()); };
  std::vector<Example_source<Tag> > sources(1);
  sources[0].points = std::make_shared<Surface_points>(samples::engine_points(
    samples::without_ball(samples::bumpy_plane(70, 1., period, bump), samples::Point(35, 35, 0), 6.)));
  sources[0].model = std::make_shared<Model>(*sources[0].points);
  const Match_target target = samples::target_of(*sources[0].model);
  for(const bool by_signature : { false, true })
  {
    Search_settings settings;
    settings.signature = by_signature;
    settings.probes = !by_signature;
    const std::vector<Place> found = Place_search<Tag>(sources, settings).search(target);
    ASSERT_FALSE(found.empty());
    EXPECT_LT(found.front().score, 0.05) << by_signature;
    // Elsewhere, and there the same: a period away along x, y or both, or that turned or mirrored.
    const Place& twin = found.front();
    EXPECT_GT((twin.origin - target.frame.origin).norm(), 0.4 * period) << by_signature;
    double largest = 0;
    for(double x = -8; x <= 8; x += 1)
      for(double y = -8; y <= 8; y += 1)
      {
        const Vector here = target.frame.origin + Vector(x, y, 0);
        const Vector there = twin.motion.inverse(Vector(here.x(), here.y(), height(here)));
        largest = (std::max)(largest, std::abs(there.z() - height(there)));
      }
    EXPECT_LT(largest, 0.05) << by_signature;
  }
}

} // namespace test_place_signature
