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

// Rims beside acute edges, and around narrow slots.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

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

/*!
  Two faces of a solid, 20 by 30 spacings, that meet along the y axis at an acute angle, and points on the edge with
  normals between those of the faces, as the vertices of a mesh have.
*/
samples::Samples wedge(double degrees)
{
  const double angle = degrees * samples::pi / 180;
  samples::Random_offsets offset(5);
  samples::Samples result;
  const samples::Vector lower(0, 0, -1), upper(-std::sin(angle), 0, std::cos(angle));
  for(std::size_t j = 0; j < 30; ++j)
  {
    result.emplace_back(samples::Point(0, double(j) + 0.1 * offset(), 0), samples::unit(lower + upper));
    for(std::size_t i = 1; i < 23; ++i)
      for(bool is_upper : { false, true })
      {
        const double x = row_distance * (double(i) + 0.1 * offset()), y = double(j) + 0.5 * double(i % 2) + 0.1 * offset();
        if(is_upper)
          result.emplace_back(samples::Point(x * std::cos(angle), y, x * std::sin(angle)), upper);
        else
          result.emplace_back(samples::Point(x, y, 0), lower);
      }
  }
  return result;
}

bool is_below(const Vector& position) { return position.z() < 0.01; }

} // namespace

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

TEST(Rims, Of_a_whole_acute_edge_there_are_none)
{
  for(double degrees : { 20., 40., 60. })
  {
    const Surface_points points = samples::engine_points(wedge(degrees));
    const Surface_model<Tag> model(points);
    for(const Rim_loop& loop : Rim_detection<Tag>(model).loops())
      for(const Rim_point& p : loop.points)
      {
        const Vector& x = points.position[p.index];
        EXPECT_FALSE(x.x() < 3 && x.y() > 4 && x.y() < 26) << degrees << " degrees: " << x.transpose();
      }
  }
}

TEST(Rims, Of_a_hole_in_one_face_up_to_an_acute_edge_are_found)
{
  for(double degrees : { 40., 60. })
  {
    SCOPED_TRACE(std::to_string(degrees) + " degrees");
    // all of the lower face within six spacings of the edge, but not the edge
    samples::Samples rest;
    for(const samples::Oriented_point& s : wedge(degrees))
      if(!(s.first.z() < 0.01 && s.first.x() > 0.3 && s.first.x() < 6 && std::abs(s.first.y() - 15) < 6))
        rest.push_back(s);
    const Surface_points points = samples::engine_points(rest);
    const Surface_model<Tag> model(points);
    const std::vector<Hole> holes = holes_of(model);
    ASSERT_EQ(holes.size(), 1u);
    std::size_t inside = 0;
    for(const Base_sample& s : holes[0].patch->samples())
      inside += is_below(s.position) && s.position.x() > 0 && s.position.x() < 6.5 && std::abs(s.position.y() - 15) < 7;
    EXPECT_GT(inside, 50u);
    EXPECT_GE(double(inside), 0.8 * double(holes[0].patch->samples().size()));
  }
}

} // namespace test_rims
