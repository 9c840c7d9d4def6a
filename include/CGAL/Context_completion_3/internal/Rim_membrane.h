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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_MEMBRANE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_MEMBRANE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Matrix_operations.h>
#include <CGAL/Context_completion_3/internal/Polyharmonic_base.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Spreads what a copy misses at the rim over the hole: as a membrane, stiffer where the values at the rim are noise.

  Of several stiffnesses, and a membrane that stays where it is, the one is taken that predicts the value at each place
  of the rim best from those beyond the reach of the local fits. On an exact counterpart all that is missed is the noise of
  these fits, which would do nothing but bend the copy; a counterpart that fits loosely misses by and by.
*/
class Rim_membrane
{
  // With a noise of the values of some variance.
  struct Stiffness
  {
    Eigen::MatrixXd spread;      // samples x rim
    Eigen::MatrixXd left_out;    // rim x rim: value minus what the others predict
  };

public:
  Rim_membrane() {}

  /*!
    \param rim positions of the values
    \param samples where they are spread to
    \param spacing of the rim
    \param reach of the local fits that the values come from
  */
  Rim_membrane(const std::vector<Vector>& rim, const std::vector<Vector>& samples, double spacing, double reach)
  {
    const Eigen::Index n = Eigen::Index(rim.size()), j = Eigen::Index(samples.size());
    Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(n, n), kernel(j, n + 1);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      for(Eigen::Index k = 0; k < n; ++k)
        distances(i, k) = (rim[std::size_t(i)] - rim[std::size_t(k)]).norm();
      for(Eigen::Index s = 0; s < j; ++s)
        kernel(s, i) = -(samples[std::size_t(s)] - rim[std::size_t(i)]).norm() / spacing;
    }
    kernel.col(n).setOnes();
    // variances of the noise over half the mean square difference of values that are a spacing apart
    for(double nugget : {0., 1., 4., 16., 64.})
    {
      if(nugget > 0 && n < least_number())
        break;
      Eigen::MatrixXd a = Eigen::MatrixXd::Ones(n + 1, n + 1);
      for(Eigen::Index k = 0; k < n; ++k)
        for(Eigen::Index i = 0; i < n; ++i)
          a(i, k) = -distances(i, k) / spacing;
      add_to_diagonal(a, n, nugget);
      a(n, n) = 0;
      const Eigen::MatrixXd inverse = inverse_matrix(a);
      m_stiffnesses.emplace_back();
      m_stiffnesses.back().spread = matrix_product(kernel, inverse.leftCols(n));
      m_stiffnesses.back().left_out = left_out(inverse.topLeftCorner(n, n), distances, reach);
    }
  }

  /// Takes all values at the rim for granted.
  Eigen::VectorXd interpolated(const Eigen::VectorXd& values) const
  {
    return m_stiffnesses.empty() ? Eigen::VectorXd() : matrix_vector_product(m_stiffnesses.front().spread, values);
  }

  /// Values at the samples from those at the rim, as stiff as these predict each other best; a rim of few centres cannot
  /// tell.
  Eigen::VectorXd smoothed(const Eigen::VectorXd& values) const
  {
    if(m_stiffnesses.size() < 2)
      return interpolated(values);
    const Stiffness* best = nullptr;
    double least = mean_absolute_value(values);
    for(const Stiffness& stiffness : m_stiffnesses)
    {
      const double error = mean_absolute_value(matrix_vector_product(stiffness.left_out, values));
      if(error < least)
      {
        least = error;
        best = &stiffness;
      }
    }
    if(best == nullptr)
      return Eigen::VectorXd::Zero(m_stiffnesses.front().spread.rows());
    return matrix_vector_product(best->spread, values);
  }

private:
  static Eigen::Index least_number() { return 12; }

  // Each row leaves out all centres within `reach` of one and predicts that one.
  static Eigen::MatrixXd left_out(const Eigen::MatrixXd& inverse, const Eigen::MatrixXd& distances, double reach)
  {
    const Eigen::Index n = inverse.rows();
    Eigen::MatrixXd result(n, n);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      std::vector<Eigen::Index> block(1, i);
      for(Eigen::Index k = 0; k < n; ++k)
        if(k != i && distances(i, k) < reach)
          block.push_back(k);
      const Eigen::Index b = Eigen::Index(block.size());
      Eigen::MatrixXd own(b, b), rows(b, n);
      for(Eigen::Index p = 0; p < b; ++p)
      {
        rows.row(p) = inverse.row(block[std::size_t(p)]);
        for(Eigen::Index q = 0; q < b; ++q)
          own(p, q) = inverse(block[std::size_t(p)], block[std::size_t(q)]);
      }
      result.row(i) = solve_linear_systems(own, rows).row(0);
    }
    return result;
  }

  std::vector<Stiffness> m_stiffnesses;    // softest first
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_MEMBRANE_H
