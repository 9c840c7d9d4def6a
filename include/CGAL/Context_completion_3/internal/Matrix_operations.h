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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_MATRIX_OPERATIONS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_MATRIX_OPERATIONS_H

#include <CGAL/license/Context_completion_3.h>

#include <Eigen/Core>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

// Operations on large matrices that are plain on purpose: each further type of an operand, such as a part of a matrix or
// a transposed one, makes Eigen instantiate a product of dozens of classes. To copy a part first takes no time that
// counts.

inline Eigen::MatrixXd matrix_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a * b;
}

inline Eigen::VectorXd matrix_vector_product(const Eigen::MatrixXd& a, const Eigen::VectorXd& v)
{
  return a * v;
}

/// To the first `rows` entries.
inline void add_to_diagonal(Eigen::MatrixXd& a, Eigen::Index rows, double value)
{
  for(Eigen::Index i = 0; i < rows; ++i)
    a(i, i) += value;
}

/// The same vector to each column.
inline void add_to_columns(Eigen::MatrixXd& a, const Eigen::VectorXd& v)
{
  for(Eigen::Index k = 0; k < a.cols(); ++k)
    for(Eigen::Index i = 0; i < a.rows(); ++i)
      a(i, k) += v[i];
}

inline double mean_absolute_value(const Eigen::VectorXd& v)
{
  return v.cwiseAbs().mean();
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_MATRIX_OPERATIONS_H
