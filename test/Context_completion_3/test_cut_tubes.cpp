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

// Holes with two rims: tubes that were cut through, limbs cut off where they rise, bores.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Rim_grouping.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace test_cut_tubes {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;
typedef Detected_hole<Tag> Detected;

const double plate_radius = 40, fillet = 4, limb_length = 40;

// A round limb that rises from a plate over a fillet and ends in a half ball: the profile turned around the z axis.
samples::Samples limb_on_plate(double limb_radius = 6)
{
  const double quarter = samples::pi / 2, foot = limb_radius + fillet;
  const double plate = plate_radius - foot, bend = fillet * quarter, tube = limb_length - fillet,
               cap = limb_radius * quarter;
  const double length = plate + bend + tube + cap;
  samples::Random_offsets offset(7);
  samples::Samples result;
  const std::size_t rings = std::size_t(length / std::sqrt(0.75));
  for(std::size_t k = 0; k < rings; ++k)
  {
    double s = (double(k) + 0.5) * length / double(rings), r, z, nr, nz;
    if(s < plate)
    {
      r = plate_radius - s; z = 0; nr = 0; nz = 1;
    }
    else if((s -= plate) < bend)
    {
      const double a = s / fillet;
      nr = std::sin(a); nz = std::cos(a);
      r = foot - fillet * nr; z = fillet - fillet * nz;
    }
    else if((s -= bend) < tube)
    {
      r = limb_radius; z = fillet + s; nr = 1; nz = 0;
    }
    else
    {
      const double a = (s - tube) / limb_radius;
      nr = std::cos(a); nz = std::sin(a);
      r = limb_radius * nr; z = limb_length + limb_radius * nz;
    }
    const std::size_t around = (std::max)(std::size_t(1), std::size_t(2 * samples::pi * r));
    for(std::size_t i = 0; i < around; ++i)
    {
      const double angle = (double(i) + (k % 2 == 0 ? 0. : 0.5) + 0.15 * offset()) * 2 * samples::pi / double(around);
      result.emplace_back(samples::Point(r * std::cos(angle), r * std::sin(angle), z),
                          samples::Vector(nr * std::cos(angle), nr * std::sin(angle), nz));
    }
  }
  return result;
}

samples::Samples turned_inside_out(samples::Samples surface)
{
  for(samples::Oriented_point& s : surface)
    s.second = -s.second;
  return surface;
}

// Three quarters of the way around a torus, which leaves a gap that is longer than the tube is thick.
samples::Samples cut_ring(double radius, double tube, double gap, samples::Samples& removed)
{
  samples::Random_offsets offset(3);
  samples::Samples rest;
  const std::size_t rings = std::size_t(2 * samples::pi * radius / std::sqrt(0.75));
  const std::size_t around = std::size_t(2 * samples::pi * tube);
  for(std::size_t k = 0; k < rings; ++k)
    for(std::size_t i = 0; i < around; ++i)
    {
      const double u = (double(k) + 0.15 * offset()) * 2 * samples::pi / double(rings);
      const double v = (double(i) + (k % 2 == 0 ? 0. : 0.5) + 0.15 * offset()) * 2 * samples::pi / double(around);
      const samples::Vector n(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
      const samples::Point p = samples::Point(radius * std::cos(u), radius * std::sin(u), 0) + tube * n;
      (std::abs(u - samples::pi) < gap / radius / 2 ? removed : rest).emplace_back(p, n);
    }
  return rest;
}

// A beam along z whose cross section is a regular triangle: the edges are acute. The middle is missing.
samples::Samples cut_prism(double side, double length, double gap, samples::Samples& removed)
{
  samples::Random_offsets offset(5);
  samples::Samples rest;
  for(int face = 0; face < 3; ++face)
  {
    const double turn = 2 * samples::pi * face / 3, apothem = side / std::sqrt(12.);
    const samples::Vector n(std::cos(turn), std::sin(turn), 0), across(-n.y(), n.x(), 0), up(0, 0, 1);
    for(double z = 0; z < length; z += 1)
      for(double x = 0.5; x < side; x += 1)
      {
        const double height = z + 0.15 * offset();
        const samples::Point p =
          CGAL::ORIGIN + apothem * n + (x - side / 2 + 0.15 * offset()) * across + height * up;
        (std::abs(height - length / 2) < gap / 2 ? removed : rest).emplace_back(p, n);
      }
  }
  return rest;
}

// A straight tube with blocks on it, in rows around and along, whose grooves cut the rims into pieces. The middle is
// missing.
samples::Samples cut_tube_with_blocks(double height, double gap, samples::Samples& removed)
{
  const double radius = 10, length = 80, around = 7, along = 11;     // blocks around, period along
  const auto step = [](double x) { return 0.5 + 0.5 * std::tanh(6 * (std::cos(x) + 0.55)); };
  const auto r = [&](double angle, double z) {
    return radius + height * step(around * angle) * step(2 * samples::pi * z / along); };
  samples::Random_offsets offset(11);
  samples::Samples rest;
  Point_grid grid(1.);
  for(double z = 0; z < length; z += 0.21)
    for(double angle = 0; angle < 2 * samples::pi; angle += 0.21 / radius)
    {
      const double a = angle + 0.1 * offset() / radius, s = z + 0.1 * offset(), d = 1e-4, x = r(a, s);
      const double by_angle = (r(a + d, s) - r(a - d, s)) / (2 * d * x), by_z = (r(a, s + d) - r(a, s - d)) / (2 * d);
      const samples::Point p(x * std::cos(a), x * std::sin(a), s);
      bool is_free = true;
      grid.for_each_in_ball(samples::engine_vector(p), 0.82, [&](std::size_t, double) { return is_free = false; });
      if(!is_free)
        continue;
      grid.insert(samples::engine_vector(p));
      const samples::Vector n(std::cos(a) + by_angle * std::sin(a), std::sin(a) - by_angle * std::cos(a), -by_z);
      (std::abs(s - length / 2) < gap / 2 ? removed : rest).emplace_back(p, samples::unit(n));
    }
  return rest;
}

// The two borders of a cylinder, each in two pieces between which rim points are missing on either side.
struct Broken_rims
{
  Surface_points points;
  std::vector<Rim_loop> loops;

  Broken_rims() : points(samples::engine_points(samples::cylinder(40, 15, 40 / (2 * samples::pi))))
  {
    const Surface_model<Tag> model(points);
    for(const Rim_loop& whole : Rim_detection<Tag>(model).loops())
    {
      Rim_loop pieces[2];
      for(const Rim_point& p : whole.points)
        if(std::abs(points.position[p.index].y()) > 0.8)
          pieces[points.position[p.index].y() > 0].points.push_back(p);
      for(Rim_loop& piece : pieces)
      {
        piece.measure(points);
        loops.push_back(piece);
      }
    }
  }
};

struct Completed
{
  std::vector<Detected> holes;            // that are closed
  std::vector<Added_point> added;

  explicit Completed(const samples::Samples& surface)
  {
    const Surface_points points = samples::engine_points(surface);
    const Surface_model<Tag> model(points);
    std::vector<Detected> all;
    EXPECT_TRUE(Hole_detection<Tag>(model).run(all, std::function<bool(double)>()));
    for(const Detected& h : all)
      if(!h.is_outer_border)
        holes.push_back(h);
    Completion_engine<Tag> engine(points, Engine_parameters());
    EXPECT_TRUE(engine.detect(std::function<bool(double)>()));
    std::vector<std::size_t> fillable;
    for(std::size_t h = 0; h < engine.holes().size(); ++h)
      if(engine.holes()[h].state == Hole_state::hole)
        fillable.push_back(h);
    EXPECT_TRUE(engine.complete(fillable, std::function<bool(double)>()));
    added = engine.added();
  }

  // Both ways: largest distance of a new point from what was there, and of what was there from the new ones. The
  // fillet is not to be foreseen.
  void expect_that_restores(const samples::Samples& removed, double tolerance) const
  {
    std::vector<Vector> missing, restored;
    for(const samples::Oriented_point& s : removed)
      missing.push_back(samples::engine_vector(s.first));
    for(const Added_point& p : added)
      restored.push_back(p.position);
    ASSERT_FALSE(restored.empty());
    EXPECT_NEAR(double(restored.size()), double(missing.size()), 0.2 * double(missing.size()));
    for(const Vector& p : restored)
      EXPECT_LT(samples::nearest_distance(p, missing), tolerance) << p.transpose();
    for(const Vector& p : missing)
      EXPECT_LT(samples::nearest_distance(p, restored), tolerance) << p.transpose();
  }
};

} // namespace

TEST(Cut_tubes, A_limb_that_is_cut_off_where_it_rises_is_joined_to_its_body)
{
  samples::Samples removed;
  const Completed result(samples::without_ball(limb_on_plate(), samples::Point(0, 0, 4), 14., &removed));
  ASSERT_EQ(result.holes.size(), 1u);
  EXPECT_EQ(result.holes.front().loops.size(), 2u);
  result.expect_that_restores(removed, 3.);
}

TEST(Cut_tubes, A_limb_is_joined_to_a_hole_that_is_far_wider)
{
  const Surface_points points = samples::engine_points(
    samples::without_ball(limb_on_plate(), samples::Point(0, 0, 4), 24.));
  const Surface_model<Tag> model(points);
  std::vector<Detected> holes;
  ASSERT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
  const auto hole = std::find_if(holes.begin(), holes.end(), [](const Detected& h) { return !h.is_outer_border; });
  ASSERT_TRUE(hole != holes.end());
  ASSERT_EQ(hole->loops.size(), 2u);
  EXPECT_LT(hole->loops[1].diameter, 0.3 * hole->loops[0].diameter);
}

TEST(Cut_tubes, A_limb_is_joined_to_a_hole_that_is_not_centred_at_it)
{
  // it goes on in the plate, beside the limb, which is 12 thick
  for(double aside : { 15., 18., 20. })
  {
    const Surface_points points = samples::engine_points(
      samples::without_ball(samples::without_ball(limb_on_plate(), samples::Point(0, 0, 4), 13.),
                            samples::Point(aside, 0, 0), 10.));
    const Surface_model<Tag> model(points);
    std::vector<Detected> holes;
    ASSERT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
    const auto hole = std::find_if(holes.begin(), holes.end(), [](const Detected& h) { return !h.is_outer_border; });
    ASSERT_TRUE(hole != holes.end()) << aside;
    EXPECT_EQ(hole->loops.size(), 2u) << aside;
  }
}

TEST(Cut_tubes, A_bore_is_joined_to_the_wall_into_which_it_leads)
{
  samples::Samples removed;
  const Completed result(samples::without_ball(turned_inside_out(limb_on_plate()), samples::Point(0, 0, 4), 14.,
                                               &removed));
  ASSERT_EQ(result.holes.size(), 1u);
  EXPECT_EQ(result.holes.front().loops.size(), 2u);
  result.expect_that_restores(removed, 3.);
}

TEST(Cut_tubes, An_end_and_a_rim_that_bound_different_sides_are_not_joined)
{
  samples::Samples surface = samples::without_ball(limb_on_plate(), samples::Point(0, 0, 4), 14.);
  for(samples::Oriented_point& s : surface)
    if(s.first.z() > 1)                   // the limb, not the plate
      s.second = -s.second;
  const Surface_points points = samples::engine_points(surface);
  const Surface_model<Tag> model(points);
  std::vector<Detected> holes;
  ASSERT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
  for(const Detected& h : holes)
    EXPECT_EQ(h.loops.size(), 1u);
}

TEST(Cut_tubes, The_ends_of_a_bent_tube_are_joined_over_a_gap_longer_than_it_is_thick)
{
  samples::Samples removed;
  const Completed result(cut_ring(40., 6., 24., removed));
  ASSERT_EQ(result.holes.size(), 1u);
  EXPECT_EQ(result.holes.front().loops.size(), 2u);
  result.expect_that_restores(removed, 3.);
}

// A stiff base that bulges less is a second opinion; over a thin limb it may close both ends, and is smaller therefore.
TEST(Cut_tubes, No_base_closes_the_ends_of_a_thin_limb_that_another_joins)
{
  const double radii[][2] = { { 3, 14 }, { 3.5, 14 }, { 3.5, 16 }, { 4, 18 } };   // of the limb, of the ball cut out
  for(const double* r : radii)
  {
    const Surface_points points = samples::engine_points(
      samples::without_ball(limb_on_plate(r[0]), samples::Point(0, 0, 4), r[1]));
    const Surface_model<Tag> model(points);
    std::vector<Detected> holes;
    ASSERT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
    const auto hole = std::find_if(holes.begin(), holes.end(), [](const Detected& h) { return !h.is_outer_border; });
    ASSERT_TRUE(hole != holes.end());
    EXPECT_EQ(hole->loops.size(), 2u) << "limb " << r[0] << ", hole " << r[1];
    EXPECT_TRUE(hole->patch->joins_rims()) << "limb " << r[0] << ", hole " << r[1];
    EXPECT_TRUE(!hole->stiff || hole->stiff->joins_rims()) << "limb " << r[0] << ", hole " << r[1];
  }
}

TEST(Cut_tubes, Rims_in_pieces_are_joined)
{
  samples::Samples removed;
  const Completed result(cut_prism(14., 60., 10., removed));
  ASSERT_EQ(result.holes.size(), 1u);
  result.expect_that_restores(removed, 1.5);
}

// All around, the rim on the flank of the blocks leads away from the other end rather than towards it.
TEST(Cut_tubes, Ends_on_the_flank_of_a_relief_are_joined)
{
  samples::Samples removed;
  const Completed result(cut_tube_with_blocks(2.5, 14., removed));
  ASSERT_EQ(result.holes.size(), 1u);
  EXPECT_EQ(result.holes.front().loops.size(), 2u);
  result.expect_that_restores(removed, 1.5);
}

TEST(Cut_tubes, A_base_knows_which_share_of_the_rims_it_joins)
{
  const Surface_points points = samples::engine_points(
    samples::without_ball(limb_on_plate(3.), samples::Point(0, 0, 4), 14.));
  const Surface_model<Tag> model(points);
  std::vector<Detected> holes;
  ASSERT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
  const auto hole = std::find_if(holes.begin(), holes.end(), [](const Detected& h) { return !h.is_outer_border; });
  ASSERT_TRUE(hole != holes.end());
  ASSERT_EQ(hole->loops.size(), 2u);
  EXPECT_EQ(hole->patch->joined_share(), 1.);
  // stiff, it closes the body and the limb each for itself
  const Smooth_patch<Tag> torn(hole->patch->surroundings(), true);
  const std::size_t body = hole->loops[0].points.size(), limb = hole->loops[1].points.size();
  EXPECT_FALSE(torn.joins_rims());
  EXPECT_EQ(torn.joined_share(), double((std::max)(body, limb)) / double(body + limb));
}

TEST(Cut_tubes, Pieces_that_follow_each_other_are_one_rim)
{
  const Broken_rims broken;
  ASSERT_EQ(broken.loops.size(), 4u);
  const Surface_model<Tag> model(broken.points);
  const Rim_grouping<Tag> grouping(model, broken.loops);
  const std::vector<std::size_t> first = { 0, 1 }, second = { 2, 3 };
  EXPECT_EQ(grouping.pieces_of_rim(0), first);
  EXPECT_EQ(grouping.pieces_of_rim(3), second);
  EXPECT_EQ(grouping.joined(first).points.size(), broken.loops[0].points.size() + broken.loops[1].points.size());
  // the ends of the tube turn away from each other, and each opens to one side
  EXPECT_TRUE(grouping.facing_rims(first).empty());
  EXPECT_FALSE(grouping.surrounds_hole(first));
}

} // namespace test_cut_tubes
