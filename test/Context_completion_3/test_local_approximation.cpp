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

#include <CGAL/Context_completion_3/internal/Local_fit.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace test_local_approximation {

using namespace CGAL::Context_completions_3::internal;

namespace {

typedef Local_approximation::Kind Kind;

Local_approximation fit(const Surface_points& surface, const Vector& center, double edge)
{
  std::vector<std::size_t> all(surface.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return fit_local_approximation(bare_cell_support(surface, all, center, edge));
}

// points on the pieces of a polyhedral corner: a piece is the plane through the origin across n, restricted by `keep`
void add_piece(Surface_points& surface, const Vector& n, std::size_t number, std::mt19937& random,
               const std::function<bool(const Vector&)>& keep)
{
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Vector u = any_orthogonal(n), v = n.cross(u);
  while(number > 0)
  {
    const Vector p = uniform(random) * u + uniform(random) * v;
    if(!keep(p))
      continue;
    surface.push_back(p, n);
    --number;
  }
}

void expect_finite(const Local_approximation& f)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for(int i = 0; i < 100 && !f.is_empty(); ++i)
  {
    const Vector p(normal(random), normal(random), normal(random));
    EXPECT_TRUE(std::isfinite(f.value(p)) && f.gradient(p).allFinite() && std::isfinite(f.distance(p)));
  }
}

} // namespace

TEST(Local_approximation, plane_is_reproduced)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Vector n = Vector(1, -2, 0.5).normalized(), o(10, 20, -30), u = any_orthogonal(n), v = n.cross(u);
  Surface_points surface;
  for(int i = 0; i < 60; ++i)
    surface.push_back(o + uniform(random) * u + uniform(random) * v, n);
  const Local_approximation f = fit(surface, o, 2);
  EXPECT_EQ(f.kind(), Kind::bivariate);
  for(int i = 0; i < 100; ++i)
  {
    const Vector p = o + Vector(uniform(random), uniform(random), uniform(random));
    EXPECT_NEAR(f.distance(p), n.dot(p - o), 1e-8); // signed: positive where the normal points
  }
}

TEST(Local_approximation, bivariate_quadratic_is_reproduced)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Surface_points surface;
  for(int i = -5; i <= 5; ++i) // symmetric in x and y: the mean normal is z
    for(int j = -5; j <= 5; ++j)
    {
      const double x = i * 0.2, y = j * 0.2;
      surface.push_back(Vector(x, y, 0.1 * x * x - 0.2 * y * y), Vector(-0.2 * x, 0.4 * y, 1).normalized());
    }
  const Local_approximation f = fit(surface, Vector::Zero(), 2);
  EXPECT_EQ(f.kind(), Kind::bivariate);
  for(int i = 0; i < 100; ++i)
  {
    const double x = uniform(random), y = uniform(random);
    EXPECT_NEAR(f.value(Vector(x, y, 0.1 * x * x - 0.2 * y * y)), 0, 1e-9);
    EXPECT_GT(f.value(Vector(x, y, 1)), 0);
  }
}

TEST(Local_approximation, sphere_and_cylinder_are_reproduced)
{
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  Surface_points sphere, cylinder;
  const Vector o(1, 2, 3);
  for(int i = 0; i < 400; ++i)
  {
    const Vector n = Vector(normal(random), normal(random), normal(random)).normalized();
    sphere.push_back(o + 0.8 * n, n);
    const double angle = i * 0.1;
    const Vector m(std::cos(angle), std::sin(angle), 0);
    cylinder.push_back(o + 0.6 * m + Vector(0, 0, -1 + 0.005 * i), m);
  }
  const Local_approximation f = fit(sphere, o, 2), g = fit(cylinder, o, 2);
  ASSERT_EQ(f.kind(), Kind::general);
  ASSERT_EQ(g.kind(), Kind::general);
  for(int i = 0; i < 100; ++i)
  {
    const Vector n = Vector(normal(random), normal(random), normal(random)).normalized();
    EXPECT_NEAR(f.distance(o + 0.8 * n), 0, 2e-4);
    EXPECT_NEAR(f.distance(o + 0.81 * n), 0.01, 1e-3);
    EXPECT_NEAR(f.gradient(o + 0.8 * n).normalized().dot(n), 1, 2e-4);
    const Vector m = Vector(normal(random), normal(random), 0).normalized();
    EXPECT_NEAR(g.distance(o + 0.6 * m + Vector(0, 0, 0.5)), 0, 1e-4);
    EXPECT_NEAR(g.distance(o + 0.59 * m), -0.01, 1e-3);
  }
}

TEST(Local_approximation, edges_of_crossing_planes_are_reproduced)
{
  std::mt19937 random(5);
  const Vector n1(1, 0, 0), n2(0, 0.6, 0.8);
  for(const double side : { -1., 1. }) // convex: each piece lies below the other's plane
  {
    Surface_points surface;
    add_piece(surface, n1, 14, random, [&](const Vector& p) { return side * n2.dot(p) < 0; });
    add_piece(surface, n2, 14, random, [&](const Vector& p) { return side * n1.dot(p) < 0; });
    const Local_approximation f = fit(surface, Vector::Zero(), 2);
    ASSERT_EQ(f.kind(), Kind::edge);
    EXPECT_EQ(f.members().size(), 2u);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for(int i = 0; i < 200; ++i)
    {
      const Vector p(uniform(random), uniform(random), uniform(random));
      const double expected = side > 0 ? (std::max)(n1.dot(p), n2.dot(p)) : (std::min)(n1.dot(p), n2.dot(p));
      EXPECT_NEAR(f.value(p), expected, 1e-6);
    }
  }
}

TEST(Local_approximation, corners_of_three_planes_are_reproduced)
{
  // every combination of convex and concave edges: f = op2(op1(x, y), z)
  typedef std::function<double(const Vector&)> Function;
  const Vector n[3] = { Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1) };
  const auto larger = [](double a, double b) { return (std::max)(a, b); };
  const auto smaller = [](double a, double b) { return (std::min)(a, b); };
  const Function functions[4] = {
    [&](const Vector& p) { return larger(larger(p.x(), p.y()), p.z()); },
    [&](const Vector& p) { return smaller(smaller(p.x(), p.y()), p.z()); },
    [&](const Vector& p) { return larger(smaller(p.x(), p.y()), p.z()); },
    [&](const Vector& p) { return smaller(larger(p.x(), p.y()), p.z()); } };
  std::mt19937 random(6);
  for(const Function& function : functions)
  {
    Surface_points surface;
    for(int k = 0; k < 3; ++k)
      add_piece(surface, n[k], 10, random, [&](const Vector& p) { return std::abs(function(p)) < 1e-12; });
    const Local_approximation f = fit(surface, Vector::Zero(), 2);
    ASSERT_EQ(f.kind(), Kind::corner);
    ASSERT_EQ(f.members().size(), 3u);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for(int i = 0; i < 200; ++i)
    {
      const Vector p(uniform(random), uniform(random), uniform(random));
      EXPECT_NEAR(f.value(p), function(p), 1e-6);
    }
  }
}

TEST(Local_approximation, apex_of_a_pyramid_has_degree_four)
{
  std::mt19937 random(7);
  std::vector<Vector> n;
  for(int k = 0; k < 4; ++k) // steep, so that opposite faces differ by more than neighbouring ones
    n.push_back(Vector(std::cos(k * CGAL_PI / 2 + 0.1), std::sin(k * CGAL_PI / 2 + 0.1), 0.35).normalized());
  const auto function = [&](const Vector& p)
    { return (std::max)((std::max)(n[0].dot(p), n[1].dot(p)), (std::max)(n[2].dot(p), n[3].dot(p))); };
  Surface_points surface;
  for(int k = 0; k < 4; ++k)
    add_piece(surface, n[std::size_t(k)], 7, random, [&](const Vector& p)
      { return std::abs(function(p)) < 1e-9 && p.z() > -1; });
  const Local_approximation f = fit(surface, Vector::Zero(), 2);
  ASSERT_EQ(f.kind(), Kind::corner);
  EXPECT_EQ(f.members().size(), 4u);
  for(std::size_t i = 0; i < surface.size(); ++i)
    EXPECT_NEAR(f.value(surface.position[i]), 0, 1e-6);
}

TEST(Local_approximation, degenerate_data_give_finite_answers)
{
  EXPECT_TRUE(fit(Surface_points(), Vector::Zero(), 1).is_empty());
  const Vector z(0, 0, 1);
  for(std::size_t number : { 1, 2, 3, 5, 6, 20, 100 })
  {
    Surface_points same, line, opposite, cancelling;
    for(std::size_t i = 0; i < number; ++i)
    {
      same.push_back(Vector(1, 1, 1), z);
      line.push_back(Vector(double(i), 0, 0), z);
      opposite.push_back(Vector(double(i % 10), double(i / 10), i % 2 == 0 ? 0.5 : -0.5), i % 2 == 0 ? z : Vector(-z));
      cancelling.push_back(Vector(0, 0, 0), i % 2 == 0 ? z : Vector(-z));
    }
    for(const Surface_points& surface : { same, line, opposite, cancelling })
      for(double edge : { 0., 1., 1e-9 })
      {
        const Local_approximation f = fit(surface, Vector(0.5, 0.5, 0.5), edge);
        ASSERT_FALSE(f.is_empty());
        expect_finite(f);
        double slope = 0;
        for(double c : f.members()[0].c)
          slope = (std::max)(slope, std::abs(c));
        EXPECT_GT(slope, 0); // never the zero polynomial, whose zero set is everything
      }
  }
  // one point defines the plane through it
  Surface_points one;
  one.push_back(Vector(1, 2, 3), z);
  EXPECT_EQ(fit(one, Vector::Zero(), 1).distance(Vector(7, 7, 5)), 2);
}

TEST(Local_approximation, taubin_distance_stays_finite_at_critical_points)
{
  Quadric sphere;
  sphere.c = {{ 1, 1, 1, 0, 0, 0, 0, 0, 0, -1 }};
  EXPECT_TRUE(std::isfinite(taubin_distance(sphere, Vector(0, 0, 0))));
  EXPECT_LT(taubin_distance(sphere, Vector(0, 0, 0)), -1e300);
  EXPECT_EQ(taubin_distance(sphere, Vector(1, 0, 0)), 0);
  EXPECT_NEAR(taubin_distance(sphere, Vector(1.01, 0, 0)), 0.01, 1e-3);
}

TEST(Local_approximation, support_ball_grows_and_keeps_to_one_side)
{
  Surface_points plate; // two sheets, a tenth apart
  for(int i = 0; i < 40; ++i)
    for(int j = 0; j < 40; ++j)
    {
      plate.push_back(Vector(i * 0.1, j * 0.1, 0.05), Vector(0, 0, 1));
      plate.push_back(Vector(i * 0.1, j * 0.1, -0.05), Vector(0, 0, -1));
    }
  const Neighbor_search search(plate.position);
  const Fit_data tiny = ball_support(plate, search, Vector(2, 2, 0), 1e-3);
  EXPECT_GT(tiny.size(), 0u);
  const Fit_data sided = ball_support(plate, search, Vector(2, 2, 0), 0.3, Vector(0, 0, 1));
  ASSERT_GT(sided.size(), 15u);
  for(std::size_t i = 0; i < sided.size(); ++i)
  {
    EXPECT_EQ(sided.normal(i).z(), 1);
    EXPECT_GT(sided.weights[i], 0);
  }
  EXPECT_NEAR(fit_local_approximation(sided).distance(Vector(2, 2, 0)), -0.05, 1e-6);
}

} // namespace test_local_approximation
