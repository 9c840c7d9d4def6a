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

// The decompositions of the engine, judged by others of Eigen.

#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Normal_equations.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>

namespace test_linear_systems {

using namespace CGAL::Context_completions_3::internal;

namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixXd result(rows, columns);
  for(Eigen::Index k = 0; k < columns; ++k)
    for(Eigen::Index i = 0; i < rows; ++i)
      result(i, k) = uniform(random);
  return result;
}

} // namespace

TEST(Linear_systems, Least_squares_are_those_of_a_complete_orthogonal_decomposition)
{
  std::mt19937 random(1);
  struct Shape { Eigen::Index rows, unknowns, rank; };
  // more equations than unknowns, as many, fewer, and some of them dependent
  for(const Shape& shape : { Shape{40, 10, 10}, Shape{10, 10, 10}, Shape{6, 10, 6}, Shape{40, 10, 7}, Shape{10, 10, 1} })
  {
    SCOPED_TRACE(shape.rows);
    SCOPED_TRACE(shape.rank);
    const Eigen::MatrixXd rows = random_matrix(shape.rows, shape.rank, random)
                                 * random_matrix(shape.rank, shape.unknowns, random);
    const Eigen::MatrixXd right = random_matrix(shape.rows, 3, random);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> judge;
    judge.setThreshold(1e-8);
    judge.compute(rows);
    ASSERT_EQ(judge.rank(), shape.rank);
    const Eigen::MatrixXd expected = judge.solve(right), result = least_squares_by_svd(rows, right, 1e-8);
    EXPECT_LT((result - expected).norm(), 1e-8 * expected.norm());
  }
}

TEST(Linear_systems, Singular_values_below_the_cut_count_as_none)
{
  // the second unknown has a singular value of 1e-3
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3, 2), right = Eigen::MatrixXd::Ones(3, 1);
  rows(0, 0) = 2;
  rows(1, 1) = 1e-3;
  const Eigen::MatrixXd all = least_squares_by_svd(rows, right, 1e-4), cut = least_squares_by_svd(rows, right, 1e-2);
  EXPECT_NEAR(all(0, 0), 0.5, 1e-12);
  EXPECT_NEAR(all(1, 0), 1e3, 1e-6);
  EXPECT_NEAR(cut(0, 0), 0.5, 1e-12);
  EXPECT_EQ(cut(1, 0), 0);
  EXPECT_EQ(least_squares_by_svd(Eigen::MatrixXd::Zero(3, 2), right, 1e-4), Eigen::MatrixXd(Eigen::MatrixXd::Zero(2, 1)));
}

TEST(Linear_systems, The_nearest_rotation_is_one_and_none_is_nearer)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for(int round = 0; round < 50; ++round)
  {
    Matrix matrix = random_matrix(3, 3, random);
    if(round % 5 == 0)
      matrix.col(2) = matrix.col(0) + matrix.col(1); // points on a plane
    const Matrix rotation = nearest_rotation(matrix);
    EXPECT_LT((rotation * rotation.transpose() - Matrix::Identity()).norm(), 1e-12);
    EXPECT_GT(rotation.determinant(), 0);
    for(int other = 0; other < 200; ++other)
    {
      Eigen::Vector4d q;
      for(int k = 0; k < 4; ++k)
        q[k] = uniform(random);
      // near by, and anywhere
      const Eigen::Quaterniond turn = other % 2 == 0 ? Eigen::Quaterniond(1, 0.01 * q[0], 0.01 * q[1], 0.01 * q[2])
                                                     : Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
      const Matrix candidate = turn.normalized().toRotationMatrix() * rotation;
      EXPECT_GE((candidate - matrix).norm(), (rotation - matrix).norm() - 1e-12);
    }
  }
}

TEST(Linear_systems, Damped_systems_are_solved)
{
  std::mt19937 random(3);
  for(int round = 0; round < 50; ++round)
  {
    const Vector direction = random_matrix(3, 1, random), right = random_matrix(3, 1, random);
    // of rank 1 but for the damping
    const Matrix a = direction * direction.transpose() + 1e-3 * Matrix::Identity();
    const Vector x = solve_damped_system(a, right);
    EXPECT_LT((a * x - right).norm(), 1e-10 * (1 + x.norm()));
  }
}

TEST(Normal_equations, Weighted_least_squares_of_all_and_of_the_first_unknowns)
{
  std::mt19937 random(4);
  const Eigen::MatrixXd rows = random_matrix(30, 6, random), right = random_matrix(30, 1, random);
  Normal_equations<6> equations, first_half, second_half;
  Eigen::MatrixXd weighted = rows, weighted_right = right;
  double square = 0;
  for(Eigen::Index i = 0; i < 30; ++i)
  {
    const double weight = 0.1 + double(i % 4);
    Normal_equations<6>::Row row;
    for(Eigen::Index k = 0; k < 6; ++k)
      row[std::size_t(k)] = rows(i, k);
    equations.add(row, right(i, 0), weight);
    (i < 15 ? first_half : second_half).add(row, right(i, 0), weight / (i < 15 ? 1. : 2.));
    weighted.row(i) *= std::sqrt(weight);
    weighted_right.row(i) *= std::sqrt(weight);
    square += weight * right(i, 0) * right(i, 0);
  }
  first_half.add(second_half, 2.);
  for(std::size_t used : { 1, 3, 6 })
  {
    const Eigen::MatrixXd part = weighted.leftCols(Eigen::Index(used));
    const Eigen::MatrixXd expected = part.colPivHouseholderQr().solve(weighted_right);
    const Normal_equations<6>::Row x = equations.solve(used, 0.), joined = first_half.solve(used, 0.);
    for(std::size_t k = 0; k < 6; ++k)
    {
      EXPECT_NEAR(x[k], k < used ? expected(Eigen::Index(k), 0) : 0., 1e-10);
      EXPECT_NEAR(joined[k], x[k], 1e-10);
    }
    EXPECT_NEAR(square + equations.change_of_loss(x), (part * expected - weighted_right).squaredNorm(), 1e-10);
  }
}

} // namespace test_linear_systems
