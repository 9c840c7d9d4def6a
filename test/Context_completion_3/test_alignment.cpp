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

#include <CGAL/Context_completion_3/internal/Quadratic_warp.h>
#include <CGAL/Context_completion_3/internal/Rigid_alignment.h>

#include <gtest/gtest.h>

#include <random>

namespace test_alignment {

using namespace CGAL::Context_completions_3::internal;

namespace {

std::vector<Vector> random_points(std::size_t number, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Vector> points;
  for(std::size_t i = 0; i < number; ++i)
    points.push_back(Vector(uniform(random), uniform(random), uniform(random)));
  return points;
}

Rigid_motion motion(double angle, const Vector& axis, const Vector& translation)
{
  Rigid_motion m;
  m.rotation = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  m.translation = translation;
  return m;
}

std::vector<Vector> moved(const Rigid_motion& m, const std::vector<Vector>& points)
{
  std::vector<Vector> result;
  for(const Vector& p : points)
    result.push_back(m(p));
  return result;
}

// a bumpy patch: no motion along it maps it to itself
std::vector<Vector> patch(int n)
{
  std::vector<Vector> points;
  for(int i = -n; i <= n; ++i)
    for(int j = -n; j <= n; ++j)
    {
      const double x = double(i) / n, y = double(j) / n;
      points.push_back(Vector(x, y, 0.3 * std::sin(3 * x) * std::cos(2 * y) + 0.2 * x * y));
    }
  return points;
}

} // namespace

TEST(Rigid_alignment, recovers_a_known_motion_from_correspondences)
{
  const std::vector<Vector> points = random_points(50, 1);
  for(const double angle : { 0., 0.3, 1.5, 3.1 })
  {
    const Rigid_motion expected = motion(angle, Vector(1, 2, -1), Vector(5, -3, 100));
    const Rigid_motion found = least_squares_rigid_motion(points, moved(expected, points));
    EXPECT_LT((found.rotation - expected.rotation).norm(), 1e-12);
    EXPECT_LT((found.translation - expected.translation).norm(), 1e-12 * 100);
    EXPECT_LT((found.inverse(found(points[0])) - points[0]).norm(), 1e-12 * 100);
  }
}

TEST(Rigid_alignment, is_never_a_reflection)
{
  std::vector<Vector> points = random_points(50, 2), mirrored = points, flat = points, line = points;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    mirrored[i].x() *= -1;
    flat[i].z() = 0;
    line[i] = Vector(points[i].x(), 0, 0);
  }
  for(const std::vector<Vector>& target : { mirrored, flat, line, std::vector<Vector>(50, Vector(1, 1, 1)) })
  {
    const Rigid_motion found = least_squares_rigid_motion(points, target);
    EXPECT_NEAR(found.rotation.determinant(), 1, 1e-9);
    EXPECT_TRUE((found.rotation * found.rotation.transpose()).isIdentity(1e-9));
  }
  const Rigid_motion turn = motion(0.5, Vector(0, 1, 1), Vector(1, 2, 3));
  for(const std::vector<Vector>& degenerate : { flat, line })
    for(const Vector& p : degenerate) // what is determined is right
      EXPECT_LT((least_squares_rigid_motion(degenerate, moved(turn, degenerate))(p) - turn(p)).norm(), 1e-9);
  EXPECT_TRUE(least_squares_rigid_motion(std::vector<Vector>(), std::vector<Vector>()).rotation.isIdentity());
}

TEST(Rigid_alignment, no_other_motion_is_better)
{
  const std::vector<Vector> from = random_points(40, 3), to = random_points(40, 4);
  const auto cost = [&](const Rigid_motion& m)
  {
    double sum = 0;
    for(std::size_t i = 0; i < from.size(); ++i)
      sum += (m(from[i]) - to[i]).squaredNorm();
    return sum;
  };
  const Rigid_motion best = least_squares_rigid_motion(from, to);
  const std::vector<Vector> random = random_points(1000, 5);
  for(std::size_t i = 0; i + 1 < random.size(); ++i)
  {
    Rigid_motion other = motion(random[i].x() * (i % 2 == 0 ? 3 : 0.05), random[i + 1], Vector::Zero());
    other.rotation = other.rotation * best.rotation;
    other.translation = best.translation + random[i] * 0.05;
    EXPECT_GE(cost(other), cost(best) - 1e-9);
  }
}

TEST(Rigid_alignment, closest_points_recover_a_small_motion)
{
  const std::vector<Vector> fixed = patch(12);
  const Rigid_motion truth = motion(0.05, Vector(1, 1, 3), Vector(0.01, -0.02, 0.01));
  std::vector<Vector> moving;
  for(const Vector& p : fixed)
    moving.push_back(truth.inverse(p));
  double residual = 1;
  const Rigid_motion found = iterative_closest_point(moving, fixed, 0., 50, &residual);
  EXPECT_LT(residual, 1e-9);
  EXPECT_LT((found.rotation - truth.rotation).norm(), 1e-9);
  EXPECT_TRUE(iterative_closest_point(std::vector<Vector>(), fixed, 0.).rotation.isIdentity());
  EXPECT_TRUE(iterative_closest_point(fixed, std::vector<Vector>(), 0.).rotation.isIdentity());
}

TEST(Quadratic_warp, reproduces_a_known_quadratic_map)
{
  const std::vector<Vector> from = random_points(80, 6), far = random_points(20, 7);
  const Vector center(0.3, -0.2, 0.1);
  Quadratic_warp::Coefficients coefficients = Quadratic_warp::Coefficients::Random() * 0.2;
  const Quadratic_warp truth(coefficients, center, 0.7);
  std::vector<Vector> to;
  for(const Vector& p : from)
    to.push_back(truth(p));
  const Quadratic_warp found = least_squares_quadratic_warp(from, to, center, 0.7, 0.);
  EXPECT_LT((found.coefficients() - coefficients).norm(), 1e-9);
  for(const Vector& p : far)
    EXPECT_LT((found(p) - truth(p)).norm(), 1e-9);
}

TEST(Quadratic_warp, regularisation_bounds_the_quadratic_part)
{
  const std::vector<Vector> from = random_points(12, 8), noise = random_points(12, 9);
  std::vector<Vector> to;
  for(std::size_t i = 0; i < from.size(); ++i)
    to.push_back(from[i] + 0.5 * noise[i]);
  double previous = std::numeric_limits<double>::infinity();
  for(const double regularisation : { 0., 1e-3, 0.1, 10., 1e6 })
  {
    const double size = least_squares_quadratic_warp(from, to, Vector::Zero(), 1, regularisation)
                          .coefficients().bottomRows<6>().norm();
    EXPECT_LT(size, previous);
    previous = size;
  }
  EXPECT_LT(previous, 1e-5); // nothing but the affine part is left
}

TEST(Quadratic_warp, what_flat_points_leave_open_stays_put)
{
  std::vector<Vector> from = random_points(60, 10), to;
  for(Vector& p : from)
    p.z() = 0;
  for(const Vector& p : from)
    to.push_back(p + Vector(0, 0, 0.1 * p.x() * p.x()));
  const Quadratic_warp warp = least_squares_quadratic_warp(from, to, Vector::Zero(), 1, 0.);
  EXPECT_LT((warp(Vector(0.5, 0.2, 1)) - Vector(0.5, 0.2, 1.025)).norm(), 1e-9);
  EXPECT_LT((least_squares_quadratic_warp(std::vector<Vector>(), to, Vector::Zero(), 1, 0.1)(to[0]) - to[0]).norm(),
            1e-12);
}

TEST(Quadratic_warp, normals_follow_the_surface)
{
  Quadratic_warp::Coefficients c = Quadratic_warp::Coefficients::Zero();
  c(4, 2) = 0.5; // z += x x / 2
  const Quadratic_warp warp(c, Vector::Zero(), 1);
  for(const double x : { -0.5, 0., 0.3, 0.9 })
    EXPECT_LT((warp.normal(Vector(x, 0.1, 0), Vector(0, 0, 1)) - Vector(-x, 0, 1).normalized()).norm(), 1e-12);
}

TEST(Quadratic_warp, iteration_bends_a_patch_onto_a_surface)
{
  std::vector<Vector> fixed, moving, normals;
  for(int i = -20; i <= 20; ++i)
    for(int j = -20; j <= 20; ++j)
    {
      const double x = i * 0.05, y = j * 0.05;
      fixed.push_back(Vector(x, y, 0.1 * x * x - 0.05 * y * y + 0.02));
      moving.push_back(Vector(x, y, 0));
      normals.push_back(Vector(0, 0, 1));
    }
  Warp_parameters parameters;
  parameters.regularisation = 1e-6;
  parameters.iterations = 8;
  EXPECT_LT(warp_to_closest_points(moving, normals, fixed, Vector::Zero(), 2, parameters), 2e-3);
  for(std::size_t i = 0; i < moving.size(); ++i)
  {
    const Vector& p = moving[i];
    EXPECT_NEAR(p.z(), 0.1 * p.x() * p.x() - 0.05 * p.y() * p.y() + 0.02, 2e-3);
    EXPECT_GT(normals[i].dot(Vector(-0.2 * p.x(), 0.1 * p.y(), 1).normalized()), 0.999);
  }
}

} // namespace test_alignment
