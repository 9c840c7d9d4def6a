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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_LINEAR_SYSTEMS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_LINEAR_SYSTEMS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/determinant.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

// The decompositions of the engine, all on matrices of few types. To compile a decomposition of one more type, or for
// one more type of the right hand side, takes seconds: expressions and small matrices are copied before.

typedef Eigen::PartialPivLU<Eigen::MatrixXd> Linear_solver;

/// Solutions for each column of `right`. Symmetric systems come here, too: those of the engine are regular.
inline Eigen::MatrixXd solve_linear_systems(const Eigen::MatrixXd& a, const Eigen::MatrixXd& right)
{
  return Linear_solver(a).solve(right);
}

/// The same for one column.
inline Eigen::VectorXd solve_linear_system(const Eigen::MatrixXd& a, const Eigen::VectorXd& right)
{
  return Linear_solver(a).solve(right);
}

inline Eigen::MatrixXd inverse_matrix(const Eigen::MatrixXd& a)
{
  return solve_linear_systems(a, Eigen::MatrixXd::Identity(a.rows(), a.rows()));
}

/// By Cramer's rule, which is good enough for damped systems: their condition is that of the damping.
inline Vector solve_damped_system(const Matrix& a, const Vector& b)
{
  const auto minor = [&a](int k, const Vector& c) {
    return CGAL::determinant(k == 0 ? c[0] : a(0, 0), k == 1 ? c[0] : a(0, 1), k == 2 ? c[0] : a(0, 2),
                             k == 0 ? c[1] : a(1, 0), k == 1 ? c[1] : a(1, 1), k == 2 ? c[1] : a(1, 2),
                             k == 0 ? c[2] : a(2, 0), k == 1 ? c[2] : a(2, 1), k == 2 ? c[2] : a(2, 2)); };
  const double all = minor(-1, b);
  return Vector(minor(0, b) / all, minor(1, b) / all, minor(2, b) / all);
}

/*!
  Least squares by a singular value decomposition: singular values below `cut` times the largest count as none, and what
  they leave open is zero (the smallest solution).
  \param rows one an equation \param right a column for each solution
*/
inline Eigen::MatrixXd least_squares_by_svd(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& right, double cut)
{
  // Rotations bring the equations to a triangle first, one by one. It has the same singular values, and Eigen's own
  // step to a square matrix takes six times as long to compile as the rest.
  const Eigen::Index n = rows.cols(), m = right.cols();
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(n, n), rotated = Eigen::MatrixXd::Zero(n, m);
  std::vector<double> row(std::size_t(n + m));
  Eigen::JacobiRotation<double> rotation;
  for(Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    for(Eigen::Index k = 0; k < n; ++k)
      row[std::size_t(k)] = rows(i, k);
    for(Eigen::Index k = 0; k < m; ++k)
      row[std::size_t(n + k)] = right(i, k);
    for(Eigen::Index k = 0; k < n; ++k)
    {
      if(row[std::size_t(k)] == 0)
        continue;
      rotation.makeGivens(triangle(k, k), row[std::size_t(k)]);
      for(Eigen::Index l = k; l < n + m; ++l)
      {
        double& x = l < n ? triangle(k, l) : rotated(k, l - n);
        double& y = row[std::size_t(l)];
        const double turned = rotation.c() * x - rotation.s() * y;
        y = rotation.s() * x + rotation.c() * y;
        x = turned;
      }
    }
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(triangle,
                                                                         Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, m);
  for(Eigen::Index s = 0; s < n; ++s)
  {
    const double value = svd.singularValues()[s];
    if(!(value > 0) || value < cut * svd.singularValues()[0])
      break; // they decrease
    for(Eigen::Index c = 0; c < m; ++c)
    {
      double share = 0;
      for(Eigen::Index k = 0; k < n; ++k)
        share += svd.matrixU()(k, s) * rotated(k, c);
      for(Eigen::Index k = 0; k < n; ++k)
        result(k, c) += share / value * svd.matrixV()(k, s);
    }
  }
  return result;
}

/// The rotation next to a matrix: the least singular direction is flipped where the nearest orthogonal matrix is a
/// reflection.
inline Matrix nearest_rotation(const Matrix& matrix)
{
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(Eigen::MatrixXd(matrix),
                                                                         Eigen::ComputeFullU | Eigen::ComputeFullV);
  const auto product = [&svd](double sign)
  {
    Matrix result;
    for(int r = 0; r < 3; ++r)
      for(int c = 0; c < 3; ++c)
        result(r, c) = svd.matrixU()(r, 0) * svd.matrixV()(c, 0) + svd.matrixU()(r, 1) * svd.matrixV()(c, 1)
                       + sign * svd.matrixU()(r, 2) * svd.matrixV()(c, 2);
    return result;
  };
  const Matrix result = product(1);
  const double sign = CGAL::determinant(result(0, 0), result(0, 1), result(0, 2), result(1, 0), result(1, 1),
                                        result(1, 2), result(2, 0), result(2, 1), result(2, 2));
  return sign < 0 ? product(-1) : result;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_LINEAR_SYSTEMS_H
