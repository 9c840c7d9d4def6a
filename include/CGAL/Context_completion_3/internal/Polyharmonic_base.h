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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_POLYHARMONIC_BASE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_POLYHARMONIC_BASE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Polyharmonic Hermite interpolation: a function with given values and gradients at scattered centres, kernel |x|^3 with
  a linear polynomial. Its zero set, for values 0 and gradients equal to the normals, is the smooth base over a hole, of
  any topology; with other right hand sides the same factorisation spreads displacements from the rim over the hole.
*/
class Polyharmonic_base
{
public:
  Polyharmonic_base() {}

  /*!
    \param centers positions, at least one
    \param scale a length of the size of the hole: the unit of the computation
    \param value_noise, gradient_noise variances of the data in units of `scale`, relative to the kernel's amplitude;
    0: interpolation
  */
  Polyharmonic_base(const std::vector<Vector>& centers, double scale, double value_noise = 0,
                    double gradient_noise = 0)
    : m_scale(scale), m_origin(centers.front())
  {
    for(const Vector& c : centers)
      m_centers.push_back((c - m_origin) / m_scale);
    const Eigen::Index n = Eigen::Index(m_centers.size()), p = terms, size = 4 * n + p;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      for(Eigen::Index j = 0; j < n; ++j)
      {
        double value; Vector gradient; Matrix hessian;
        derivatives(m_centers[i] - m_centers[j], value, gradient, hessian);
        a(4 * i, 4 * j) = value;
        for(Eigen::Index k = 0; k < 3; ++k)
        {
          a(4 * i, 4 * j + 1 + k) = -gradient[k];
          a(4 * i + 1 + k, 4 * j) = gradient[k];
          for(Eigen::Index l = 0; l < 3; ++l)
            a(4 * i + 1 + k, 4 * j + 1 + l) = -hessian(k, l);
        }
      }
      a(4 * i, 4 * i) += value_noise;
      for(Eigen::Index k = 1; k < 4; ++k)
        a(4 * i + k, 4 * i + k) += gradient_noise;
      double q[terms]; Vector g[terms];
      polynomial(m_centers[i], q, g);
      for(Eigen::Index k = 0; k < p; ++k)
      {
        a(4 * i, 4 * n + k) = a(4 * n + k, 4 * i) = q[k];
        for(Eigen::Index l = 0; l < 3; ++l)
          a(4 * i + 1 + l, 4 * n + k) = a(4 * n + k, 4 * i + 1 + l) = g[k][l];
      }
    }
    for(Eigen::Index k = 0; k < p; ++k)
      a(4 * n + k, 4 * n + k) = -1e-10;  // keeps coplanar centres, which do not fix all polynomials, solvable
    m_solver.compute(a);
  }

  std::size_t number_of_centers() const { return m_centers.size(); }

  /// Coefficients of the interpolants, one a column. \param data per centre the value and the gradient, a column each
  Eigen::MatrixXd solve(const Eigen::MatrixXd& data) const
  {
    const Eigen::Index n = Eigen::Index(m_centers.size());
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(4 * n + terms, data.cols());
    right.topRows(4 * n) = data;
    for(Eigen::Index c = 0; c < right.cols(); ++c)
      for(Eigen::Index i = 0; i < 4 * n; ++i)
        if(i % 4 > 0)
          right(i, c) *= m_scale;
    return m_solver.solve(right);
  }

  /*!
    What the data of a group of centres differ from their prediction by all other centres, per group 4 numbers a centre,
    a column for each of `data` (block cross-validation from one inverse).
  */
  std::vector<Eigen::MatrixXd> left_out(const std::vector<std::vector<std::size_t> >& groups,
                                        const Eigen::MatrixXd& data) const
  {
    const Eigen::Index n = Eigen::Index(m_centers.size());
    const Eigen::MatrixXd coefficients = solve(data).topRows(4 * n);
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(4 * n + terms, 4 * n + terms);
    const Eigen::MatrixXd inverse = m_solver.solve(identity);
    std::vector<Eigen::MatrixXd> result;
    for(const std::vector<std::size_t>& group : groups)
    {
      const Eigen::Index g = Eigen::Index(group.size());
      Eigen::MatrixXd block(4 * g, 4 * g);
      Eigen::MatrixXd right(4 * g, data.cols());
      for(Eigen::Index a = 0; a < g; ++a)
      {
        for(Eigen::Index c = 0; c < right.cols(); ++c)
          for(Eigen::Index k = 0; k < 4; ++k)
            right(4 * a + k, c) = coefficients(4 * Eigen::Index(group[std::size_t(a)]) + k, c);
        for(Eigen::Index b = 0; b < g; ++b)
          for(Eigen::Index l = 0; l < 4; ++l)
            for(Eigen::Index k = 0; k < 4; ++k)
              block(4 * a + k, 4 * b + l) =
                inverse(4 * Eigen::Index(group[std::size_t(a)]) + k, 4 * Eigen::Index(group[std::size_t(b)]) + l);
      }
      Eigen::MatrixXd residual = solve_linear_systems(block, right);
      for(Eigen::Index c = 0; c < residual.cols(); ++c)
        for(Eigen::Index i = 0; i < 4 * g; ++i)
          if(i % 4 > 0)
            residual(i, c) /= m_scale;
      result.push_back(residual);
    }
    return result;
  }

  /// Value of the function with coefficients `c` (a column of `solve()`).
  double value(const Vector& x, const Eigen::VectorXd& c) const
  {
    Vector gradient;
    return value(x, c, gradient);
  }

  /// The same, with its gradient.
  double value(const Vector& x, const Eigen::VectorXd& c, Vector& gradient) const
  {
    const Vector y = (x - m_origin) / m_scale;
    const Eigen::Index n = Eigen::Index(m_centers.size());
    double sum = 0;
    Vector slope = Vector::Zero();
    for(Eigen::Index j = 0; j < n; ++j)
    {
      // phi = r^3, its gradient 3 r d, its Hessian 3 r I + 3 / r d d^T
      const Vector d = y - m_centers[j];
      const double r2 = d.squaredNorm(), r = std::sqrt(r2);
      const double alpha = c[4 * j];
      const Vector beta(c[4 * j + 1], c[4 * j + 2], c[4 * j + 3]);
      const double db = d.dot(beta);
      sum += alpha * r2 * r - 3 * r * db;
      slope += (3 * r * alpha - (r > 0 ? 3 * db / r : 0.)) * d - 3 * r * beta;
    }
    double q[terms]; Vector g[terms];
    polynomial(y, q, g);
    for(int k = 0; k < terms; ++k)
    {
      sum += c[4 * n + k] * q[k];
      slope += c[4 * n + k] * g[k];
    }
    gradient = slope / m_scale;
    return sum;
  }

  /// Row of the values of all basis functions at `x`: many functions are evaluated by one matrix product.
  void basis(const Vector& x, Eigen::RowVectorXd& row) const
  {
    const Vector y = (x - m_origin) / m_scale;
    const Eigen::Index n = Eigen::Index(m_centers.size());
    row.resize(4 * n + terms);
    for(Eigen::Index j = 0; j < n; ++j)
    {
      const Vector d = y - m_centers[j];
      const double r2 = d.squaredNorm(), r = std::sqrt(r2);
      row[4 * j] = r2 * r;
      for(Eigen::Index k = 0; k < 3; ++k)
        row[4 * j + 1 + k] = -3 * r * d[k];
    }
    double q[terms]; Vector g[terms];
    polynomial(y, q, g);
    for(int k = 0; k < terms; ++k)
      row[4 * n + k] = q[k];
  }

private:
  static constexpr int terms = 4;   // of the polynomial

  void derivatives(const Vector& d, double& value, Vector& gradient, Matrix& hessian) const
  {
    const double r = d.norm();
    value = r * r * r;
    gradient = 3 * r * d;
    hessian = 3 * r * Matrix::Identity();
    if(r > 0)
      hessian += (3 / r) * d * d.transpose();
  }

  void polynomial(const Vector& y, double* q, Vector* g) const
  {
    q[0] = 1; g[0] = Vector::Zero();
    for(int k = 0; k < 3; ++k)
    {
      q[1 + k] = y[k];
      g[1 + k] = Vector::Unit(k);
    }
  }

  double m_scale = 1;
  Vector m_origin = Vector::Zero();
  std::vector<Vector> m_centers;
  Linear_solver m_solver;
};

/// Values at scattered centres spread as by a membrane: kernel |x| with a constant, minimal oscillation.
class Membrane
{
public:
  Membrane() {}

  Membrane(const std::vector<Vector>& centers, double scale)
    : m_centers(centers), m_scale(scale)
  {
    const Eigen::Index n = Eigen::Index(centers.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 1, n + 1);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      for(Eigen::Index j = 0; j < n; ++j)
        a(i, j) = -(centers[i] - centers[j]).norm() / scale;
      a(i, n) = a(n, i) = 1;
    }
    m_solver.compute(a);
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& values) const
  {
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(values.rows() + 1, values.cols());
    right.topRows(values.rows()) = values;
    return m_solver.solve(right);
  }

  void basis(const Vector& x, Eigen::RowVectorXd& row) const
  {
    const Eigen::Index n = Eigen::Index(m_centers.size());
    row.resize(n + 1);
    for(Eigen::Index i = 0; i < n; ++i)
      row[i] = -(x - m_centers[i]).norm() / m_scale;
    row[n] = 1;
  }

private:
  std::vector<Vector> m_centers;
  double m_scale = 1;
  Linear_solver m_solver;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_POLYHARMONIC_BASE_H
