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

// Sharp edges that go into a hole: facets, how the surroundings divide into them, and where they meet.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Facet.h>
#include <CGAL/Context_completion_3/internal/Facet_continuation.h>
#include <CGAL/Context_completion_3/internal/Facet_sampling.h>
#include <CGAL/Context_completion_3/internal/Facet_segmentation.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test_sharp_edges {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef std::function<double(const Vector&)> Solid;   // negative inside; its zero set is known in closed form

// A part of the boundary of a solid around the origin: points, what is missing of them, and the truth.
struct Edged_surface
{
  std::string name;
  Solid distance;             // to the boundary, near it
  Surface_points known, removed;
};

// Of length 1 but at edges, where it is a mean.
Vector numeric_gradient(const Solid& f, const Vector& p)
{
  const double step = 1e-5;
  return Vector(f(p + step * Vector::UnitX()) - f(p - step * Vector::UnitX()),
                f(p + step * Vector::UnitY()) - f(p - step * Vector::UnitY()),
                f(p + step * Vector::UnitZ()) - f(p - step * Vector::UnitZ())) / (2 * step);
}

Vector numeric_normal(const Solid& f, const Vector& p) { return numeric_gradient(f, p).normalized(); }

// Points of the boundary within [-size, size]^3, no two closer than 1, without those within `radius` of the origin.
Edged_surface cut(const std::string& name, const Solid& f, double size, double radius, double noise = 0)
{
  Edged_surface result = { name, f, {}, {} };
  samples::Random_offsets offset(7);
  Point_grid grid(1.);
  const std::size_t darts = std::size_t(200 * size * size);
  for(std::size_t dart = 0; dart < darts; ++dart)
  {
    const double x = offset(), y = offset(), z = offset();
    Vector p = size * Vector(x, y, z);
    if(std::abs(f(p)) > 1)
      continue;
    for(int step = 0; step < 3; ++step)
      p -= f(p) * numeric_normal(f, p);
    const Vector n = numeric_normal(f, p);
    if(std::abs(f(p)) > 1e-6 || p.cwiseAbs().maxCoeff() > size)
      continue;
    bool is_free = true;
    grid.for_each_in_ball(p, 1., [&](std::size_t, double) { return is_free = false; });
    if(!is_free)
      continue;
    grid.insert(p);
    const Vector moved = p + noise * offset() * n;
    (p.norm() < radius ? result.removed : result.known).push_back(moved, n);
  }
  return result;
}

// One convex and one concave edge.
double stairs(const Vector& p)
{
  const double step = (std::max)(p.z() - 3, p.x() + 3), floor = p.z() + 3;
  return (std::min)(step, floor);
}

double box_corner(const Vector& p) { return (std::max)({ p.x(), p.y(), p.z() }); }

double room_corner(const Vector& p) { return (std::min)({ p.x(), p.y(), p.z() }); }

// Convex and concave edges meet in one point.
double notch(const Vector& p) { return (std::max)(p.z(), (std::min)(p.x(), p.y())); }

// A cylinder that rises from a plane.
double boss(const Vector& p)
{
  return (std::min)(p.z(), (std::max)(std::hypot(p.x() - 12, p.y()) - 12, p.z() - 30));
}

std::vector<Edged_surface> edged_surfaces()
{
  return { cut("stairs", stairs, 22, 8), cut("box_corner", box_corner, 22, 7), cut("room_corner", room_corner, 22, 7),
           cut("notch", notch, 22, 7), cut("boss", boss, 22, 7) };
}

std::vector<double> distances_to_rim(const Edged_surface& surface, double radius)
{
  std::vector<double> result;
  for(const Vector& p : surface.known.position)
    result.push_back((std::max)(0., p.norm() - radius));
  return result;
}

Facet facet_of(const Surface_points& points, double noise = 0)
{
  std::vector<std::size_t> all(points.size());
  for(std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  Facet_precision precision;
  precision.position = (std::max)(noise, 0.03);
  precision.normal = 0.05;
  precision.scale = 8;
  return Facet(points, all, precision);
}

// a patch of a surface of revolution about the z axis: a strip that spans the given angle
Surface_points strip(double radius, double angle, double height)
{
  Surface_points points;
  for(double t = -angle / 2; t <= angle / 2; t += 1 / radius)
    for(double z = 0; z < height; ++z)
    {
      const Vector n(std::cos(t), std::sin(t), 0);
      points.push_back(radius * n + z * Vector::UnitZ(), n);
    }
  return points;
}

} // namespace

TEST(Sharp_edges, a_facet_of_a_cylinder_goes_on_as_that_cylinder)
{
  const double radius = 20;
  const Facet facet = facet_of(strip(radius, 1, 5));
  for(double t : {0.6, 0.8, 1.})
    for(double z : {-6., 2., 10.})
      for(double r : {19.5, 20., 20.5})
      {
        const Vector p(r * std::cos(t), r * std::sin(t), z);
        EXPECT_NEAR(r - radius, facet.distance(p), 0.03) << t << ' ' << z;
        EXPECT_GT(facet.normal(p).dot(Vector(std::cos(t), std::sin(t), 0)), std::cos(0.02));
      }
}

TEST(Sharp_edges, a_facet_of_noisy_points_on_a_plane_is_a_plane)
{
  samples::Random_offsets offset(3);
  Surface_points points;
  for(int x = 0; x < 20; ++x)
    for(int y = 0; y < 6; ++y)
    {
      const double dx = offset(), dy = offset(), dz = offset();
      points.push_back(Vector(x, y, 0.2 * dz), Vector(0.1 * dx, 0.1 * dy, 1).normalized());
    }
  const Facet facet = facet_of(points, 0.12);
  for(double x : {-8., 10., 28.})
    for(double y : {-6., 12.})
    {
      // the value is linear: as at the ends, so in the middle
      const Vector p(x, y, 0), q(10, 3, 0);
      EXPECT_NEAR((facet.distance(p) + facet.distance(q)) / 2, facet.distance((p + q) / 2), 1e-9);
      EXPECT_NEAR(0, facet.distance(p), 0.15);
    }
}

TEST(Sharp_edges, lines_meet_a_facet_where_its_sign_changes)
{
  samples::Random_offsets offset(11);
  const Facet facets[] = { facet_of(strip(20, 1, 5)), facet_of(strip(6, 2, 12)) };
  std::size_t meetings = 0;
  for(const Facet& facet : facets)
    for(int line = 0; line < 200; ++line)
    {
      const double x = offset(), y = offset(), z = offset(), u = offset(), v = offset(), w = offset();
      const Vector p(20 + 6 * x, 6 * y, 6 * z), d = Vector(u, v, w).normalized();
      std::vector<double> found = facet.intersections(p, d), expected;
      const double step = 0.01;
      for(double t = -10; t < 10; t += step)
        if((facet.distance(p + t * d) > 0) != (facet.distance(p + (t + step) * d) > 0))
          expected.push_back(t + step / 2);
      found.erase(std::remove_if(found.begin(), found.end(), [](double t) { return std::abs(t) > 10; }), found.end());
      std::sort(found.begin(), found.end());
      // a line that touches meets twice within one step
      if(found.size() == expected.size() + 2)
        continue;
      ASSERT_EQ(expected.size(), found.size());
      for(std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(expected[i], found[i], step);
      meetings += found.size();
    }
  EXPECT_GT(meetings, 100u);
}

TEST(Sharp_edges, surroundings_divide_into_their_facets)
{
  const Edged_surface surface = cut("stairs", stairs, 22, 8);
  const Facet_segmentation segmentation(surface.known, 1.1, 8);
  // tread, riser and floor: what the hole parts is one again
  ASSERT_EQ(3u, segmentation.facets().size());
  std::size_t divided = 0;
  std::vector<Vector> normals(3, Vector::Zero());
  for(std::size_t i = 0; i < surface.known.size(); ++i)
  {
    const std::size_t f = segmentation.facet_of(i);
    if(f == Facet_segmentation::none)
      continue;
    ++divided;
    if(normals[f].isZero())
      normals[f] = surface.known.normal[i];
    EXPECT_GT(normals[f].dot(surface.known.normal[i]), 0.99);
  }
  EXPECT_GT(divided, 95 * surface.known.size() / 100);
}

TEST(Sharp_edges, facets_meet_in_the_hole_where_those_of_the_solid_do)
{
  for(const Edged_surface& surface : edged_surfaces())
  {
    SCOPED_TRACE(surface.name);
    const double radius = surface.name == "stairs" ? 8 : 7;
    const Facet_continuation facets(surface.known, distances_to_rim(surface, radius), 1.1, radius);
    ASSERT_TRUE(facets.is_sharp());
    std::size_t missed = 0, turned = 0, tried = 0;
    for(std::size_t i = 0; i < surface.removed.size(); ++i)
    {
      // along the normal from beside the true place: there and nowhere nearer is the surface
      if(numeric_gradient(surface.distance, surface.removed.position[i]).norm() < 0.99)
        continue;
      ++tried;
      const Vector& n = surface.removed.normal[i];
      const Vector p = surface.removed.position[i] - 0.7 * n;
      double height = 0;
      Vector normal;
      if(!facets.find(p, n, 0, 5, height, normal) || std::abs(surface.distance(p + height * n)) > 0.05)
        ++missed;
      else
        turned += normal.dot(numeric_normal(surface.distance, p + height * n)) < 0.99;
    }
    EXPECT_GT(tried, 40u);
    EXPECT_LE(missed, tried / 20);      // beside an edge another facet may be nearer
    EXPECT_LE(turned, tried / 20);
  }
}

TEST(Sharp_edges, points_on_facets_fill_the_hole_and_end_at_its_rim)
{
  for(const Edged_surface& surface : edged_surfaces())
  {
    SCOPED_TRACE(surface.name);
    const double radius = surface.name == "stairs" ? 8 : 7;
    const Facet_continuation facets(surface.known, distances_to_rim(surface, radius), 1.1, radius);
    std::vector<Vector> seeds;
    for(std::size_t i = 0; i < surface.known.size(); ++i)
      if(surface.known.position[i].norm() < radius + 0.5)
        seeds.push_back(surface.known.position[i] - 1.7 * surface.known.position[i].normalized());
    const Surface_points points = sample_facets(facets, surface.known, seeds, 1.1, 1000);
    for(const Vector& p : surface.removed.position)
      EXPECT_LT((std::min)(samples::nearest_distance(p, points.position),
                           samples::nearest_distance(p, surface.known.position)), 1.6);
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_LT(points.position[i].norm(), radius + 1.5);
      EXPECT_LT(std::abs(surface.distance(points.position[i])), 0.05);
    }
    EXPECT_LT(points.size(), 2 * surface.removed.size());
  }
}

TEST(Sharp_edges, facets_that_run_off_give_no_points)
{
  // the far half of the surroundings is not known: nothing stops the facets there
  const Edged_surface surface = cut("stairs", stairs, 22, 8);
  Surface_points half;
  std::vector<double> distance;
  std::vector<Vector> seeds;
  for(std::size_t i = 0; i < surface.known.size(); ++i)
    if(surface.known.position[i].y() < 0)
    {
      half.push_back(surface.known.position[i], surface.known.normal[i]);
      distance.push_back((std::max)(0., surface.known.position[i].norm() - 8));
      if(distance.back() < 0.5)
        seeds.push_back(surface.known.position[i] - 1.7 * surface.known.position[i].normalized());
    }
  const Facet_continuation facets(half, distance, 1.1, 8);
  ASSERT_TRUE(facets.is_sharp());
  EXPECT_EQ(0u, sample_facets(facets, half, seeds, 1.1, 1000).size());
}

TEST(Sharp_edges, noise_hides_no_edge)
{
  const Edged_surface surface = cut("stairs", stairs, 22, 8, 0.4);
  const Facet_continuation facets(surface.known, distances_to_rim(surface, 8), 1.1, 8);
  ASSERT_TRUE(facets.is_sharp());
  double sum = 0;
  for(std::size_t i = 0; i < surface.removed.size(); ++i)
  {
    double height = 1;
    Vector normal;
    facets.find(surface.removed.position[i], surface.removed.normal[i], 0, 5, height, normal);
    sum += (std::min)(1., std::abs(surface.distance(surface.removed.position[i] + height * surface.removed.normal[i])));
  }
  EXPECT_LT(sum / double(surface.removed.size()), 0.12);
}

TEST(Sharp_edges, smooth_surroundings_have_none)
{
  const samples::Samples sphere = samples::sphere(3000, 15.5);
  Surface_points points;
  std::vector<double> distance;
  for(const samples::Oriented_point& s : sphere)
    if(s.first.x() > 6 && s.first.x() < 13)
    {
      points.push_back(samples::engine_vector(s.first), samples::engine_vector(s.second));
      distance.push_back(13 - s.first.x());
    }
  ASSERT_GT(points.size(), 200u);
  EXPECT_FALSE(Facet_continuation(points, distance, 1., 8).is_sharp());
}

TEST(Sharp_edges, folds_of_a_free_form_are_no_edges)
{
  // gathers towards the hole: as sharp as edges, but nothing between them goes on as it is
  const Solid folds = [](const Vector& p)
  {
    const double r = std::hypot(p.x(), p.y()), fold = std::abs(std::sin(4 * std::atan2(p.y(), p.x())));
    return (p.z() - 0.25 * r * fold * std::sin(0.5 * r)) / 1.5;
  };
  const Edged_surface surface = cut("folds", folds, 22, 8);
  EXPECT_FALSE(Facet_continuation(surface.known, distances_to_rim(surface, 8), 1.1, 8).is_sharp());
}

// Two slopes that meet at a ridge, which is rounded over some width.
bool has_sharp_ridge(double slope, double width)
{
  const samples::Samples roof = samples::graph(48, 1.,
    [=](double x, double) { return -slope * std::hypot(width, x - 24); },
    [=](double x, double) { return std::make_pair(-slope * (x - 24) / std::hypot(width, x - 24, 1e-6), 0.); });
  const Vector middle(24, 24, -slope * width);
  const Surface_points known = samples::engine_points(samples::without_ball(roof, samples::Point(24, 24, middle.z()), 8.));
  std::vector<double> distance;
  for(const Vector& p : known.position)
    distance.push_back((std::max)(0., (p - middle).norm() - 8));
  return Facet_continuation(known, distance, 1.1, 8).is_sharp();
}

TEST(Sharp_edges, a_ridge_that_is_rounded_over_a_spacing_is_a_fold)
{
  for(double slope : { 0.5, 1.2 })
  {
    SCOPED_TRACE(slope);
    EXPECT_TRUE(has_sharp_ridge(slope, 0));
    EXPECT_TRUE(has_sharp_ridge(slope, 0.3));
    EXPECT_FALSE(has_sharp_ridge(slope, 1));
  }
}

// How far the default is from the truth: mean distance, and share of normals that lean by more than 14 degrees.
struct Deviation
{
  std::size_t added = 0;
  double distance = 0, turned = 0;
  std::string reasons;
};

Deviation completed(const Edged_surface& surface, bool with_facets)
{
  typedef Completion_engine<CGAL::Sequential_tag> Engine;
  Engine_parameters parameters;
  parameters.ingredients.facets = with_facets;
  Engine engine(surface.known, parameters);
  EXPECT_TRUE(engine.detect(Engine::Callback()));
  std::vector<std::size_t> chosen;
  for(std::size_t h = 0; h < engine.holes().size(); ++h)
    if(engine.holes()[h].state == Hole_state::hole)
      chosen.push_back(h);
  EXPECT_TRUE(engine.complete(chosen, Engine::Callback()));
  Deviation result;
  result.added = engine.added().size();
  for(std::size_t h : chosen)
    result.reasons += engine.outcomes()[h].reason + "\n";
  for(const Added_point& p : engine.added())
  {
    result.distance += std::abs(surface.distance(p.position)) / double(result.added);
    result.turned += (p.normal.dot(numeric_normal(surface.distance, p.position)) < 0.97) / double(result.added);
  }
  return result;
}

TEST(Sharp_edges, the_default_continues_edges_that_have_no_counterpart)
{
  for(const Edged_surface& surface : edged_surfaces())
  {
    if(surface.name == "stairs" || surface.name == "boss")   // a copy from farther along the edge is as good
      continue;
    SCOPED_TRACE(surface.name);
    const Deviation without = completed(surface, false), with = completed(surface, true);
    ASSERT_GT((std::min)(with.added, without.added), surface.removed.size() / 2);
    EXPECT_LT(with.distance, 0.06);
    EXPECT_LT(with.turned, 0.1);
    EXPECT_LT(with.distance, 0.7 * without.distance);
  }
}

// A plate whose corner is at (3, 3), and a ball that takes it off.
Edged_surface plate(double half_thickness, double radius)
{
  return cut("plate", [=](const Vector& p)
    { return (std::max)({ std::abs(p.z()) - half_thickness, p.x() - 3, p.y() - 3 }); }, 26, radius);
}

TEST(Sharp_edges, finer_levels_leave_facets_as_they_are)
{
  // Pieces are promised by fake ones, which know nothing of facets: some were put in the place of exact ones here.
  for(const Edged_surface& surface : { plate(3, 10), plate(4, 12) })
  {
    const Deviation made = completed(surface, true);
    EXPECT_NE(made.reasons.find("sharp edges go on"), std::string::npos);
    EXPECT_EQ(made.reasons.find("finer levels"), std::string::npos);
    EXPECT_LT(made.distance, 1e-6);
  }
}

TEST(Sharp_edges, where_the_corner_of_a_plate_is_cut_off_its_sides_go_on_until_they_meet)
{
  // The rim goes around the plate. Over the thin one an interpolating base bulges, and part of a copy is promised to be
  // better than edges there; over the next two a stiff base closes each side; the others are the ends of tubes.
  const std::pair<double, double> plates[] = { { 3, 7 }, { 4, 10 }, { 5, 10 }, { 4, 9 }, { 4, 12 } };
  for(const std::pair<double, double>& p : plates)
  {
    SCOPED_TRACE(testing::Message() << "half as thick as " << p.first << ", radius " << p.second);
    const Edged_surface surface = plate(p.first, p.second);
    const Deviation made = completed(surface, true);
    EXPECT_GT(made.added, surface.removed.size());
    EXPECT_LT(made.distance, 0.01);
    EXPECT_LT(made.turned, 0.08);   // on the edges normals of both sides are right
  }
}

TEST(Sharp_edges, facets_that_meet_far_off_make_no_spike)
{
  // The end of a beam whose sides taper: they would meet 24 above the middle of the hole, the end is at 2. These are holes
  // whose base goes across; where it leads up itself, facets follow it.
  for(double radius : { 5., 6., 10., 12. })
  {
    const Edged_surface surface = cut("beam", [](const Vector& p)
      { return (std::max)((std::max)(std::abs(p.x()), std::abs(p.y())) + 0.25 * p.z() - 6, p.z() - 2) / 1.03; }, 22, radius);
    typedef Completion_engine<CGAL::Sequential_tag> Engine;
    Engine engine(surface.known, Engine_parameters());
    ASSERT_TRUE(engine.detect(Engine::Callback()));
    ASSERT_EQ(engine.holes().size(), 2u);   // one is the other end, where the sampling stops
    ASSERT_TRUE(engine.complete({ 0, 1 }, Engine::Callback()));
    for(const Added_point& p : engine.added())
      EXPECT_LT(p.position.z(), 10);
  }
}

TEST(Sharp_edges, the_end_of_a_beam_whose_sides_never_meet_stays_open)
{
  typedef Completion_engine<CGAL::Sequential_tag> Engine;
  const Edged_surface beam = cut("beam", [](const Vector& p)
    { return (std::max)(std::abs(p.x()), std::abs(p.y())) - 8; }, 26, 0);
  Engine engine(beam.known, Engine_parameters());
  ASSERT_TRUE(engine.detect(Engine::Callback()));
  ASSERT_FALSE(engine.holes().empty());
  for(const auto& hole : engine.holes())
    EXPECT_EQ(hole.state, Hole_state::outer_border);
}

} // namespace test_sharp_edges
