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

// Rims beside other rims and beside acute edges, rims that bend, and how rims turn.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Rim_cycles.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace test_rims {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;
typedef Detected_hole<Tag> Hole;

const double row_distance = std::sqrt(0.75);

std::vector<Hole> holes_of(const Surface_model<Tag>& model)
{
  std::vector<Hole> all, holes;
  EXPECT_TRUE(Hole_detection<Tag>(model).run(all, std::function<bool(double)>()));
  for(const Hole& hole : all)
    if(!hole.is_outer_border)
      holes.push_back(hole);
  return holes;
}

/// A sheet with a slot of five rows along its border, which some rows of points separate it from.
samples::Samples sheet_with_slot(std::size_t rows_between)
{
  samples::Samples sheet;
  const double lower = double(rows_between) * row_distance, upper = lower + 5 * row_distance;
  for(const samples::Oriented_point& s : samples::plane(30))
    if(!(s.first.y() > lower && s.first.y() < upper && s.first.x() > 8 && s.first.x() < 22))
      sheet.push_back(s);
  return sheet;
}

/*!
  Two faces of a solid, 20 by 30 spacings, that meet along the y axis at an acute angle. With points on the edge, as the
  vertices of a mesh, these have normals between those of the faces.
*/
samples::Samples wedge(double degrees, bool has_edge_points)
{
  const double angle = degrees * samples::pi / 180;
  samples::Random_offsets offset(5);
  samples::Samples result;
  const samples::Vector lower(0, 0, -1), upper(-std::sin(angle), 0, std::cos(angle));
  for(std::size_t j = 0; j < 30; ++j)
  {
    if(has_edge_points)
      result.emplace_back(samples::Point(0, double(j) + 0.1 * offset(), 0), samples::unit(lower + upper));
    for(std::size_t i = 0; i < 23; ++i)
      for(bool is_upper : { false, true })
      {
        const double x = row_distance * (double(i) + (has_edge_points ? 1 : 0.5) + 0.1 * offset());
        const double y = double(j) + 0.5 * double(i % 2) + 0.1 * offset();
        if(is_upper)
          result.emplace_back(samples::Point(x * std::cos(angle), y, x * std::sin(angle)), upper);
        else
          result.emplace_back(samples::Point(x, y, 0), lower);
      }
  }
  return result;
}

/// The ways along all rims of some points, of 8 points at least.
std::vector<Rim_cycle> cycles_of(const samples::Samples& surface)
{
  const Surface_points points = samples::engine_points(surface);
  const Surface_model<Tag> model(points);
  std::vector<Rim_cycle> result;
  for(const Rim_loop& loop : Rim_detection<Tag>(model).loops())
    for(const Rim_cycle& cycle : Rim_cycles<Tag>(model, loop).cycles())
      if(cycle.rim.points.size() >= 8)
        result.push_back(cycle);
  return result;
}

/// Whether the distance of a place from the z axis is that of an arc of three quarters of a circle, and so its direction.
bool is_on_arc(double x, double y, double inner, double outer)
{
  const double r = std::hypot(x, y);
  return r > inner && r < outer && std::abs(std::atan2(y, x)) < 0.75 * samples::pi;
}

samples::Samples centered_plane(std::size_t rows)
{
  samples::Samples result;
  const samples::Vector middle(0.5 * double(rows), 0.5 * double(rows) * row_distance, 0);
  for(const samples::Oriented_point& s : samples::plane(rows))
    result.emplace_back(s.first - middle, s.second);
  return result;
}

} // namespace

TEST(Rims, Turn_once_around_a_hole_in_a_plane_and_back_around_a_sheet)
{
  for(bool has_hole : { false, true })
  {
    samples::Samples sheet;
    for(const samples::Oriented_point& s : centered_plane(40))
      if(std::hypot(s.first.x(), s.first.y()) < 16 &&
         !(has_hole && is_on_arc(s.first.x(), s.first.y(), 6, 11)))
        sheet.push_back(s);
    const std::vector<Rim_cycle> cycles = cycles_of(sheet);
    ASSERT_EQ(cycles.size(), has_hole ? 2u : 1u);
    std::size_t holes = 0;
    for(const Rim_cycle& cycle : cycles)
    {
      // in a plane whole turns, whichever points the way passes
      EXPECT_NEAR(cycle.turns, cycle.bounds_hole() ? 1 : -1, 1e-9);
      holes += cycle.bounds_hole();
    }
    EXPECT_EQ(holes, has_hole ? 1u : 0u);
  }
}

TEST(Rims, Turn_as_the_curvature_of_what_is_missing_lets_them)
{
  // of a sphere without a cap the turns are the cosine of its half angle
  for(double degrees : { 20., 45., 60., 90., 120., 150. })
  {
    samples::Samples rest;
    const double height = std::cos(degrees * samples::pi / 180);
    for(const samples::Oriented_point& s : samples::sphere(4000, 1))
      if(s.first.z() < height)
        rest.push_back(s);
    const std::vector<Rim_cycle> cycles = cycles_of(rest);
    ASSERT_EQ(cycles.size(), 1u) << degrees;
    EXPECT_NEAR(cycles[0].turns, height, 0.06) << degrees;
    EXPECT_NEAR(cycles[0].smooth_turns, height, 0.15) << degrees;
    EXPECT_EQ(cycles[0].bounds_hole(), degrees < 65) << degrees;
  }
  // the ends of a tube are none
  const std::vector<Rim_cycle> ends = cycles_of(samples::cylinder(40, 40, 6.));
  ASSERT_EQ(ends.size(), 2u);
  for(const Rim_cycle& end : ends)
    EXPECT_NEAR(end.turns, 0, 0.03);
}

TEST(Rims, At_the_end_of_a_tube_bound_no_hole_whatever_its_relief)
{
  // the flanks of ribs turn normals at its ends to and fro, and with them, by chance, the sum of all turns
  double most = 0;
  for(unsigned int seed = 1; seed <= 8; ++seed)
  {
    samples::Samples tube;
    for(const samples::Oriented_point& s : samples::cylinder(120, 60, 19., 0.15, seed))
    {
      const double angle = std::atan2(s.first.y(), s.first.x()), zigzag = 8 * angle / samples::pi;
      const bool is_rising = zigzag - 2 * std::floor(zigzag / 2) < 1;
      const double share = zigzag - std::floor(zigzag), phase = 0.9 * s.first.z() + 5 * (is_rising ? share : 1 - share) + seed;
      const double profile = std::tanh(4 * std::sin(phase)), slope = 4 * (1 - profile * profile) * std::cos(phase);
      const double r = 19 + 0.6 * profile, c = std::cos(angle), d = std::sin(angle);
      const double around = 0.6 * slope * (is_rising ? 5 : -5) * 8 / samples::pi / r, along = 0.6 * 0.9 * slope;
      tube.emplace_back(samples::Point(r * c, r * d, s.first.z()),
                        samples::unit({ c + around * d, d - around * c, -along }));
    }
    for(const Rim_cycle& end : cycles_of(tube))
    {
      most = (std::max)(most, end.turns);
      EXPECT_NEAR(end.smooth_turns, 0, 0.1) << "seed " << seed;
      EXPECT_FALSE(end.bounds_hole()) << "seed " << seed;
    }
  }
  EXPECT_GT(most, 0.375);   // otherwise this shows nothing
}

TEST(Rims, At_the_mouth_of_a_bore_without_points_bound_no_hole)
{
  // normals at its edge, where alone there are points, are between those of the plate and of the wall
  for(bool is_mouth : { false, true })
  {
    samples::Samples plate;
    for(const samples::Oriented_point& s : centered_plane(40))
      if(std::hypot(s.first.x(), s.first.y()) > 6.7)
        plate.push_back(s);
    for(std::size_t i = 0; i < 38; ++i)
    {
      const double angle = double(i) * 2 * samples::pi / 38, x = std::cos(angle), y = std::sin(angle);
      plate.emplace_back(samples::Point(6 * x, 6 * y, 0),
                         is_mouth ? samples::unit({ -x, -y, 1 }) : samples::Vector(0, 0, 1));
    }
    std::size_t around = 0;
    for(const Rim_cycle& cycle : cycles_of(plate))
      if(cycle.rim.diameter < 14)
      {
        ++around;
        EXPECT_GT(cycle.turns, 0.5);
        EXPECT_EQ(cycle.bounds_hole(), !is_mouth);
      }
    EXPECT_EQ(around, 1u);
  }
}

TEST(Rims, Of_a_slot_that_bends_back_bound_a_hole)
{
  // its centre is beside it, and its rims lead to all sides
  for(double width : { 4., 5., 6. })
    for(bool is_wave : { false, true })
    {
      SCOPED_TRACE(std::to_string(width) + " spacings wide, wave: " + std::to_string(is_wave));
      samples::Samples rest;
      std::size_t removed = 0;
      for(samples::Oriented_point s : centered_plane(50))
      {
        if(is_on_arc(s.first.x(), s.first.y(), 10 - width / 2, 10 + width / 2))
        {
          ++removed;
          continue;
        }
        if(is_wave)   // over a ridge
        {
          const double a = s.first.x() / 8;
          s = { samples::Point(s.first.x(), s.first.y(), 8 * std::cos(a)), samples::unit({ std::sin(a), 0, 1 }) };
        }
        rest.push_back(s);
      }
      const Surface_points points = samples::engine_points(rest);
      const Surface_model<Tag> model(points);
      const std::vector<Hole> holes = holes_of(model);
      ASSERT_EQ(holes.size(), 1u);
      std::size_t inside = 0;
      for(const Base_sample& s : holes[0].patch->samples())
        inside += is_on_arc(s.position.x(), s.position.y(), 8.5 - width / 2, 11.5 + width / 2);
      EXPECT_GE(double(inside), 0.9 * double(holes[0].patch->samples().size()));
      EXPECT_GE(double(inside), 0.75 * double(removed));
    }
}

TEST(Rims, Of_a_hole_and_of_the_border_beside_it_are_two)
{
  for(std::size_t rows : { 3, 4 })
  {
    SCOPED_TRACE(std::to_string(rows) + " rows of points between them");
    const Surface_points points = samples::engine_points(sheet_with_slot(rows));
    const Surface_model<Tag> model(points);
    const std::vector<Hole> holes = holes_of(model);
    ASSERT_EQ(holes.size(), 1u);
    for(const Rim_loop& loop : holes[0].loops)
      for(const Rim_point& p : loop.points)
      {
        const Vector& x = points.position[p.index];
        EXPECT_TRUE(x.x() > 6.5 && x.x() < 23.5 && x.y() > row_distance && x.y() < double(rows + 7) * row_distance)
          << x.transpose();
      }
    for(const Base_sample& s : holes[0].patch->samples())
      EXPECT_TRUE(s.position.x() > 7 && s.position.x() < 23 && s.position.y() > double(rows - 1) * row_distance &&
                  s.position.y() < double(rows + 6) * row_distance) << s.position.transpose();
  }
}

TEST(Rims, Across_a_narrow_slot_are_one)
{
  samples::Samples sheet;
  for(const samples::Oriented_point& s : samples::plane(30))
    if(!(std::abs(s.first.y() - 13) < row_distance && s.first.x() > 6 && s.first.x() < 24))
      sheet.push_back(s);
  const Surface_points points = samples::engine_points(sheet);
  const Surface_model<Tag> model(points);
  const std::vector<Hole> holes = holes_of(model);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_EQ(holes[0].loops.size(), 1u);
}

TEST(Rims, Of_a_hole_in_one_face_up_to_an_acute_edge_are_found)
{
  for(bool has_edge_points : { false, true })
    for(double degrees : { 30., 45., 60. })
    {
      SCOPED_TRACE(std::to_string(degrees) + " degrees, points on the edge: " + std::to_string(has_edge_points));
      // all of the lower face within six spacings of the edge, but not the edge
      samples::Samples rest;
      for(const samples::Oriented_point& s : wedge(degrees, has_edge_points))
        if(!(s.first.z() < 0.01 && s.first.x() > 0.3 && s.first.x() < 6 && std::abs(s.first.y() - 15) < 6))
          rest.push_back(s);
      const Surface_points points = samples::engine_points(rest);
      const Surface_model<Tag> model(points);
      const std::vector<Hole> holes = holes_of(model);
      ASSERT_EQ(holes.size(), 1u);
      // points on the edge have normals between those of the faces, towards which the base bends
      const double height = has_edge_points ? 2 : 0.3;
      std::size_t inside = 0;
      for(const Base_sample& s : holes[0].patch->samples())
        inside += std::abs(s.position.z()) < height && s.position.x() > -0.5 && s.position.x() < 6.5 &&
                  std::abs(s.position.y() - 15) < 7;
      EXPECT_GT(inside, 30u);   // of about 80 that are missing
      EXPECT_GE(double(inside), 0.75 * double(holes[0].patch->samples().size()));
    }
}

TEST(Rims, Of_a_whole_acute_edge_bound_no_hole)
{
  for(bool has_edge_points : { false, true })
    for(double degrees : { 20., 30., 45., 60. })
    {
      const Surface_points points = samples::engine_points(wedge(degrees, has_edge_points));
      const Surface_model<Tag> model(points);
      EXPECT_TRUE(holes_of(model).empty()) << degrees << " degrees, points on the edge: " << has_edge_points;
    }
}

} // namespace test_rims
