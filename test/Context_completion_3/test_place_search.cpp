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

// The search for source places: look-up of near points, alignment on the overlap, and the whole search against an
// exhaustive one.

#include "include/engine_samples.h"
#include "include/search_target.h"

#include <CGAL/Context_completion_3/internal/Hole_completion.h>
#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Nearest_point_grid.h>
#include <CGAL/Context_completion_3/internal/Overlap_alignment.h>
#include <CGAL/Context_completion_3/internal/Place_search.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace test_place_search {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;
typedef Surface_model<Tag> Model;
typedef Example_source<Tag> Source;

const double period = 12., bump = 1.5;

// relief that repeats, and of which no mirror image is a part: three waves without a common axis
double chiral(double x, double y)
{
  return 0.9 * std::sin(0.5 * x) + 0.7 * std::sin(0.6 * y + 0.25 * x + 1.) + 0.5 * std::sin(0.45 * (x + 1.3 * y) + 2.) +
         0.4 * std::sin(0.8 * x - 0.35 * y);
}

samples::Samples chiral_sheet(std::size_t rows, unsigned int seed)
{
  const double step = 1e-5;
  return samples::graph(rows, 1., chiral, [=](double x, double y) {
    return std::make_pair((chiral(x + step, y) - chiral(x - step, y)) / (2 * step),
                          (chiral(x, y + step) - chiral(x, y - step)) / (2 * step)); }, 0.15, seed);
}

samples::Samples mirrored(const samples::Samples& surface)
{
  samples::Samples result;
  for(const samples::Oriented_point& s : surface)
    result.emplace_back(samples::Point(-s.first.x(), s.first.y(), s.first.z()),
                        samples::Vector(-s.second.x(), s.second.y(), s.second.z()));
  return result;
}

Source source(const samples::Samples& surface, std::size_t set = 0)
{
  Source result;
  result.set = set;
  result.points = std::make_shared<Surface_points>(samples::engine_points(surface));
  result.model = std::make_shared<Model>(*result.points);
  return result;
}

double largest_difference(const Motion& a, const Motion& b, const std::vector<Vector>& points)
{
  double largest = 0;
  for(const Vector& p : points)
    largest = (std::max)(largest, (a(p) - b(p)).norm());
  return largest;
}

// Known surroundings of (24, 24), carried by `motion`.
std::vector<Match_probe> ring(const Surface_points& points, const Motion& motion, std::vector<Vector>& original)
{
  std::vector<Match_probe> probes;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const double r = std::hypot(points.position[i].x() - 24, points.position[i].y() - 24);
    if(r < 5 || r > 9)
      continue;
    Match_probe probe;
    probe.position = motion(points.position[i]);
    probe.normal = motion.normal(points.normal[i]);
    probes.push_back(probe);
    original.push_back(points.position[i]);
  }
  return probes;
}

} // namespace

TEST(Nearest_point_grid, Answers_within_a_voxel_diagonal)
{
  for(const samples::Samples& surface : { samples::bumpy_plane(30, 1., period, bump), samples::sphere(2000, 12.) })
  {
    const Surface_points points = samples::engine_points(surface);
    const Neighbor_search search(points.position);
    const int layers = 6;
    for(const double voxel : { 0.4, 0.7 })
    {
      const Nearest_point_grid grid(points, voxel, layers);
      ASSERT_EQ(grid.voxel(), voxel);
      samples::Random_offsets offset(3);
      std::size_t inside = 0;
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        const double x = offset(), y = offset(), z = offset();
        const Vector q = points.position[i] + 2. * Vector(x, y, z);
        const double nearest = search.nearest(q).second;
        const std::uint32_t found = grid(q);
        // the band is as many steps to the six neighbours wide
        if(nearest > (layers - 2) * voxel / std::sqrt(3.))
          continue;
        ++inside;
        ASSERT_NE(found, Nearest_point_grid::none);
        EXPECT_LE((points.position[found] - q).norm(), nearest + std::sqrt(3.) * voxel);
      }
      EXPECT_GT(inside, 100u);
      EXPECT_EQ(grid(Vector(0, 0, 1000)), std::uint32_t(Nearest_point_grid::none));
      EXPECT_EQ(grid(Vector(-1000, 0, 0)), std::uint32_t(Nearest_point_grid::none));
    }
  }
}

TEST(Overlap_alignment, Recovers_a_known_small_motion)
{
  const Surface_points points = samples::engine_points(chiral_sheet(48, 1));
  const Model model(points);
  const Vector pivot(24, 24, 0);
  const Nearest_point_grid grid(points, 0.5, 8);
  for(const Motion& expected : { Motion().moved(Vector(0.02, -0.03, 0.06), Vector(0.4, -0.3, 0.5), pivot),
                                 Motion().moved(Vector(0, 0, -0.08), Vector(-0.5, 0.2, -0.3), pivot), Motion() })
  {
    std::vector<Vector> original;
    const std::vector<Match_probe> probes = ring(points, expected, original);
    const Motion exact = Overlap_alignment<Tag>(model, nullptr).align(probes, Motion(), 3., 1.5, 40);
    EXPECT_LT(largest_difference(exact, expected, original), 1e-3);
    EXPECT_NEAR(std::abs(exact.linear.determinant()), 1., 1e-9);
    const Motion fast = Overlap_alignment<Tag>(model, &grid).align(probes, Motion(), 3., 1.5, 40);
    EXPECT_LT(largest_difference(fast, expected, original), 0.15);
    Match_weights weights;
    const Overlap_alignment<Tag> alignment(model, nullptr);
    EXPECT_LT(alignment.score(probes, exact, weights), 1e-4);
    EXPECT_LE(alignment.score(probes, exact, weights), alignment.score(probes, Motion(), weights) + 1e-12);
  }
}

TEST(Overlap_alignment, Recovers_a_motion_from_other_samples_of_the_surface)
{
  const Surface_points points = samples::engine_points(chiral_sheet(48, 1));
  const Surface_points others = samples::engine_points(chiral_sheet(48, 2));
  const Model model(points);
  const Motion expected = Motion().moved(Vector(0.02, -0.03, 0.06), Vector(0.4, -0.3, 0.5), Vector(24, 24, 0));
  std::vector<Vector> original;
  const std::vector<Match_probe> probes = ring(others, expected, original);
  const Motion found = Overlap_alignment<Tag>(model, nullptr).align(probes, Motion(), 3., 1.5, 40);
  EXPECT_LT(largest_difference(found, expected, original), 0.1);
}

// Tangent planes lie all on one side of a bulge, and would lift what is fitted to them.
TEST(Overlap_alignment, Points_between_those_of_a_bulge_do_not_lift_it)
{
  const auto height = [](double x, double y) { return -(x - 24) * (x - 24) / 20 - (y - 24) * (y - 24) / 12; };
  const auto slope = [](double x, double y) { return std::make_pair(-(x - 24) / 10, -(y - 24) / 6); };
  const Surface_points points = samples::engine_points(samples::graph(48, 1., height, slope, 0.3, 1));
  const Surface_points others = samples::engine_points(samples::graph(48, 1., height, slope, 0.3, 2));
  std::vector<Vector> original;
  const std::vector<Match_probe> probes = ring(others, Motion(), original);
  const Motion found = Overlap_alignment<Tag>(Model(points), nullptr).align(probes, Motion(), 3., 1.5, 20, 20);
  double lift = 0;
  for(const Vector& x : original)
    lift += (found(x) - x).z() / double(original.size());
  EXPECT_LT(std::abs(lift), 1e-4);
}

TEST(Overlap_alignment, Pairs_across_edges_do_not_move_a_pyramid)
{
  const auto height = [](double x, double y) { return -0.4 * (std::max)(std::abs(x - 24), std::abs(y - 24)); };
  const auto slope = [](double x, double y) {
    return std::abs(x - 24) > std::abs(y - 24) ? std::make_pair(x < 24 ? 0.4 : -0.4, 0.)
                                               : std::make_pair(0., y < 24 ? 0.4 : -0.4); };
  const Surface_points points = samples::engine_points(samples::graph(48, 1., height, slope, 0.3, 1));
  const Surface_points others = samples::engine_points(samples::graph(48, 1., height, slope, 0.3, 2));
  const Motion expected = Motion().moved(Vector(0.01, -0.02, 0.03), Vector(0.2, -0.1, 0.2), Vector(24, 24, 0));
  std::vector<Vector> original;
  const std::vector<Match_probe> probes = ring(others, expected, original);
  const Motion found = Overlap_alignment<Tag>(Model(points), nullptr).align(probes, Motion(), 3., 1.5, 20, 20);
  EXPECT_LT(largest_difference(found, expected, original), 1e-6);
}

TEST(Overlap_alignment, Nothing_near_scores_worst_and_stays)
{
  const Surface_points points = samples::engine_points(samples::plane(20));
  const Model model(points);
  Match_probe probe;
  probe.position = Vector(10, 10, 100);
  probe.normal = Vector::UnitZ();
  const std::vector<Match_probe> probes(5, probe);
  const Overlap_alignment<Tag> alignment(model, nullptr);
  Match_weights weights;
  EXPECT_EQ(alignment.score(probes, Motion(), weights), 1 + weights.kappa);
  EXPECT_EQ(alignment.score(std::vector<Match_probe>(), Motion(), weights), 1 + weights.kappa);
  const Motion found = alignment.align(probes, Motion(), 3., 1., 5);
  EXPECT_TRUE(found.linear == Matrix::Identity());
  EXPECT_TRUE(found.translation == Vector::Zero());
}

TEST(Place_search, Is_as_good_as_an_exhaustive_search)
{
  const std::vector<Source> sources(1, source(
    samples::without_ball(samples::bumpy_plane(60, 1., period, bump), samples::Point(29, 31, 0), 4.)));
  const Model& model = *sources.front().model;
  const Match_target target = samples::target_of(model);
  const std::vector<Place> found = Place_search<Tag>(sources, Search_settings()).search(target);
  ASSERT_FALSE(found.empty());
  const Overlap_alignment<Tag> alignment(model, nullptr);

  // all places of a period, turned in steps of 15 degrees, and mirrored
  double best = std::numeric_limits<double>::infinity();
  const double w = 2 * samples::pi / period;
  for(double x = 12; x < 12 + period; x += 1.5)
    for(double y = 12; y < 12 + period; y += 1.5)
    {
      Surface_frame frame;
      frame.origin = Vector(x, y, bump * std::sin(w * x) * std::sin(w * y));
      for(int turn = 0; turn < 24; ++turn)
        for(const bool is_mirrored : { false, true })
        {
          const Motion start = target.frame.turned(2 * samples::pi * turn / 24.).motion_from(frame, is_mirrored);
          const Motion motion = alignment.align(target.overlap, start, 4 * target.spacing, 1.5 * target.spacing, 8);
          best = (std::min)(best, Place_search<Tag>::exact_score(model, target, motion));
        }
    }
  EXPECT_LE(found.front().score, best + 0.01);

  // the relief repeats, so a perfect place exists up to the sampling
  EXPECT_LT(found.front().score, 0.1);
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].score, Place_search<Tag>::exact_score(model, target, found[i].motion));
    EXPECT_LT((found[i].motion(found[i].origin) - target.frame.origin).norm(), 1e-9);
    EXPECT_LT((found[i].motion.linear * found[i].motion.linear.transpose() - Matrix::Identity()).norm(), 1e-9);
    if(i > 0)
    {
      EXPECT_LE(found[i - 1].score, found[i].score);
    }
    for(std::size_t j = 0; j < i; ++j)
      EXPECT_GE((found[i].origin - found[j].origin).norm(), 0.5 * target.radius);
  }
}

TEST(Place_descriptor, Does_not_change_with_turns_mirrors_shifts_and_motions)
{
  const Surface_points points = samples::engine_points(chiral_sheet(40, 1));
  const Model model(points);
  const double radius = 7;
  std::vector<Smoothed_place> places;
  for(std::size_t i = 0; i < points.size(); i += 5)
    places.push_back(smoothed_place(model, points.position[i], points.normal[i], 0.25 * radius));
  const Surface_frame frame = smoothed_place(model, Vector(20, 20, chiral(20, 20)), Vector::UnitZ(), 2.).frame;
  const auto describe = [&](const Surface_frame& at, const std::vector<Smoothed_place>& of)
  {
    std::vector<const Smoothed_place*> around;
    for(const Smoothed_place& p : of)
      around.push_back(&p);
    return Place_descriptor(at, around, radius).values();
  };
  const Place_descriptor::Values expected = describe(frame, places);
  for(const double v : expected)
    EXPECT_TRUE(std::isfinite(v));

  Surface_frame shifted = frame.turned(1.);
  shifted.origin += 0.3 * frame.normal;
  const Place_descriptor::Values turned = describe(shifted, places);
  Motion motion;
  motion.linear = Eigen::AngleAxisd(0.7, Vector(1, 2, 3).normalized()).toRotationMatrix() *
                  Eigen::DiagonalMatrix<double, 3>(-1, 1, 1);
  motion.translation = Vector(3, -5, 8);
  std::vector<Smoothed_place> moved = places;
  for(Smoothed_place& p : moved)
  {
    p.frame.origin = motion(p.frame.origin);
    p.frame.normal = motion.normal(p.frame.normal);
  }
  Surface_frame moved_frame = frame;
  moved_frame.origin = motion(frame.origin);
  moved_frame.normal = motion.normal(frame.normal);
  moved_frame.axis = motion.normal(frame.axis);
  const Place_descriptor::Values mirrored = describe(moved_frame, moved);
  for(std::size_t k = 0; k < Place_descriptor::size; ++k)
  {
    EXPECT_NEAR(mirrored[k], expected[k], 1e-9) << k;
    EXPECT_NEAR(turned[k], expected[k], 2e-3) << k;   // the fit prefers small coefficients, which a shift changes
  }
  // another place of the sheet has other values
  double difference = 0;
  Surface_frame other = frame;
  other.origin = Vector(14, 27, chiral(14, 27));
  const Place_descriptor::Values elsewhere = describe(other, places);
  for(std::size_t k = 0; k < Place_descriptor::size; ++k)
    difference = (std::max)(difference, std::abs(elsewhere[k] - expected[k]));
  EXPECT_GT(difference, 0.02);
}

TEST(Place_shortlist, Is_the_same_as_an_exhaustive_search)
{
  const Surface_points points = samples::engine_points(chiral_sheet(40, 1));
  const Model model(points);
  const double radius = 5;
  std::vector<Smoothed_place> places;
  std::vector<const Smoothed_place*> around;
  for(std::size_t i = 0; i < points.size(); i += 4)
    places.push_back(smoothed_place(model, points.position[i], points.normal[i], 0.25 * radius));
  for(const Smoothed_place& p : places)
    around.push_back(&p);
  std::vector<Place_descriptor> descriptors;
  for(const Smoothed_place& p : places)
    descriptors.push_back(Place_descriptor(p.frame, around, radius));
  std::vector<double> deviation(Place_descriptor::size, 0.);
  for(std::size_t k = 0; k < Place_descriptor::size; ++k)
  {
    double mean = 0;
    for(const Place_descriptor& d : descriptors)
      mean += d.values()[k] / double(descriptors.size());
    for(const Place_descriptor& d : descriptors)
      deviation[k] += (d.values()[k] - mean) * (d.values()[k] - mean) / double(descriptors.size());
  }
  const Place_shortlist shortlist(descriptors);
  for(const std::size_t target : { std::size_t(0), descriptors.size() / 2, descriptors.size() - 1 })
  {
    std::vector<std::pair<double, std::size_t> > order;
    for(std::size_t i = 0; i < descriptors.size(); ++i)
    {
      double d = 0;
      for(std::size_t k = 0; k < Place_descriptor::size; ++k)
        d += std::pow((descriptors[i].values()[k] - descriptors[target].values()[k]) /
                      (std::sqrt(deviation[k]) + Place_shortlist::uncertainty()), 2);
      order.emplace_back(d, i);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> expected;
    for(std::size_t i = 0; i < 25; ++i)
      expected.push_back(order[i].second);
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(shortlist.nearest(descriptors[target], 25), expected);
  }
  EXPECT_EQ(shortlist.nearest(descriptors[0], 1), std::vector<std::size_t>(1, 0));
  EXPECT_EQ(shortlist.nearest(descriptors[0], 2 * descriptors.size()).size(), descriptors.size());
  EXPECT_TRUE(Place_shortlist(std::vector<Place_descriptor>()).nearest(descriptors[0], 5).empty());
}

TEST(Place_search, Shortlist_keeps_the_only_twin_on_a_surface_that_is_large_against_the_hole)
{
  // two craters with a peak in a wide, gently waved sheet; the hole takes the peak of one
  const samples::Point twin(113, 84, 0);
  const auto height = [&](double x, double y)
  {
    double z = 0.4 * std::sin(0.11 * x + 0.3) * std::cos(0.07 * y);
    for(const samples::Point& c : { samples::Point(35, 40, 0), twin })
    {
      const double r2 = (x - c.x()) * (x - c.x()) + (y - c.y()) * (y - c.y());
      z += 3 * std::exp(-r2 / 10) - 3 * std::exp(-r2 / 60);
    }
    return z;
  };
  const double step = 1e-5;
  const samples::Samples sheet = samples::graph(150, 1., height, [&](double x, double y) {
    return std::make_pair((height(x + step, y) - height(x - step, y)) / (2 * step),
                          (height(x, y + step) - height(x, y - step)) / (2 * step)); });
  const std::vector<Source> sources(1, source(samples::without_ball(sheet, samples::Point(35, 40, 1), 6.)));
  const Match_target target = samples::target_of(*sources.front().model);
  Search_settings settings;
  settings.number_of_places = 60;    // spread evenly they are three hole radii apart
  const std::vector<Place> found = Place_search<Tag>(sources, settings).search(target);
  ASSERT_FALSE(found.empty());
  EXPECT_LT(found.front().score, 0.06);   // the base knows nothing of the peak
  EXPECT_LT((found.front().origin.head<2>() - Eigen::Vector2d(twin.x(), twin.y())).norm(), 1.5);
}

TEST(Place_search, Mirrors_only_when_allowed)
{
  const Source holed = source(samples::without_ball(chiral_sheet(48, 1), samples::Point(24, 24, 0), 5.));
  const Match_target target = samples::target_of(*holed.model);
  const std::vector<Source> sources(1, source(mirrored(chiral_sheet(48, 5)), 1));
  Search_settings settings;
  const std::vector<Place> with = Place_search<Tag>(sources, settings).search(target);
  settings.mirror = false;
  const std::vector<Place> without = Place_search<Tag>(sources, settings).search(target);
  ASSERT_FALSE(with.empty());
  ASSERT_FALSE(without.empty());
  EXPECT_LT(with.front().motion.linear.determinant(), 0.);
  EXPECT_LT((with.front().origin - Vector(-target.frame.origin.x(), target.frame.origin.y(),
                                          target.frame.origin.z())).norm(), 1.);
  EXPECT_LT(with.front().score, 0.1);
  for(const Place& p : without)
    EXPECT_GT(p.motion.linear.determinant(), 0.);
  EXPECT_GT(without.front().score, 1.5 * with.front().score);
}

TEST(Place_search, Finds_the_place_in_the_right_source)
{
  const Source holed = source(samples::without_ball(chiral_sheet(48, 1), samples::Point(24, 24, 0), 5.));
  const Match_target target = samples::target_of(*holed.model);
  const std::vector<Source> sources = { source(samples::plane(40), 1), source(chiral_sheet(48, 5), 2),
                                        source(samples::Samples(), 3) };
  const std::vector<Place> found = Place_search<Tag>(sources, Search_settings()).search(target);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().source, 1u);
  EXPECT_LT((found.front().origin - target.frame.origin).norm(), 1.);
}

} // namespace test_place_search
