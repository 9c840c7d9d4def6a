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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_NORMAL_EQUATIONS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_NORMAL_EQUATIONS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Linear_systems.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Weighted least squares of at most `size` unknowns, by an equation at a time.
template <std::size_t size>
class Normal_equations
{
public:
  typedef std::array<double, size> Row;

  Normal_equations()
  {
    m_matrix.fill(Row{});
    m_right.fill(0.);
  }

  void add(const Row& row, double value, double weight)
  {
    const double weighted_value = weight * value;
    for(std::size_t i = 0; i < size; ++i)
    {
      // the lower triangle, the matrix being symmetric
      const double weighted = weight * row[i];
      for(std::size_t j = 0; j <= i; ++j)
        m_matrix[i][j] += weighted * row[j];
      m_right[i] += weighted_value * row[i];
    }
  }

  /// Adds all equations of others.
  void add(const Normal_equations& others, double weight)
  {
    for(std::size_t i = 0; i < size; ++i)
    {
      for(std::size_t j = 0; j <= i; ++j)
        m_matrix[i][j] += weight * others.m_matrix[i][j];
      m_right[i] += weight * others.m_right[i];
    }
  }

  double& diagonal(std::size_t i) { return m_matrix[i][i]; }
  double diagonal(std::size_t i) const { return m_matrix[i][i]; }

  /// The first unknowns, the others being 0. \param damping is added to the diagonal
  Row solve(std::size_t used, double damping) const
  {
    const Eigen::Index n = Eigen::Index(used);
    Eigen::MatrixXd a(n, n);
    Eigen::VectorXd right(n);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      for(Eigen::Index j = 0; j <= i; ++j)
        a(i, j) = a(j, i) = m_matrix[std::size_t(i)][std::size_t(j)];
      a(i, i) += damping;
      right[i] = m_right[std::size_t(i)];
    }
    const Eigen::VectorXd solution = solve_linear_system(a, right);
    Row result{};
    for(Eigen::Index i = 0; i < n; ++i)
      result[std::size_t(i)] = solution[i];
    return result;
  }

  /// What `x` adds to the weighted sum of the squared right hand sides.
  double change_of_loss(const Row& x) const
  {
    double result = 0;
    for(std::size_t i = 0; i < size; ++i)
    {
      double product = 0;
      for(std::size_t j = 0; j < size; ++j)
        product += m_matrix[(std::max)(i, j)][(std::min)(i, j)] * x[j];
      result += x[i] * (product - 2 * m_right[i]);
    }
    return result;
  }

private:
  std::array<Row, size> m_matrix;
  Row m_right;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_NORMAL_EQUATIONS_H
