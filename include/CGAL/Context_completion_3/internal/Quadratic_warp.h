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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRATIC_WARP_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRATIC_WARP_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Closest_point_search.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The elastic warp of eq. 6. As printed, the quadratic coefficients f_ij are shared by all three coordinates of the
  result, and a translation is missing; meant must be the full quadratic map, each coordinate with its own symmetric
  form. With the rotation applied before (r_ij = identity) it reads y = x + C x + t + (x^T F_i x)_i in the
  coordinates of the cell, x = (p - center) / scale.
*/
class Quadratic_warp
{
public:
  typedef Eigen::Matrix<double, 10, 1> Monomials;      ///< x y z 1 xx yy zz xy xz yz
  typedef Eigen::Matrix<double, 10, 3> Coefficients;   ///< of the displacement

  /// The identity.
  Quadratic_warp() {}
  Quadratic_warp(const Coefficients& coefficients, const Vector& center, double scale)
    : m_coefficients(coefficients), m_center(center), m_scale(scale)
  {}

  static Monomials monomials(const Vector& x)
  {
    Monomials m;
    m << x.x(), x.y(), x.z(), 1, x.x() * x.x(), x.y() * x.y(), x.z() * x.z(), x.x() * x.y(), x.x() * x.z(),
         x.y() * x.z();
    return m;
  }

  const Coefficients& coefficients() const { return m_coefficients; }

  Vector operator()(const Vector& p) const
  {
    return p + m_scale * (m_coefficients.transpose() * monomials((p - m_center) / m_scale));
  }

  /// A normal at `p` is moved by the cofactor matrix of the derivative; where the map folds it is left as it was.
  Vector normal(const Vector& p, const Vector& n) const
  {
    const Vector x = (p - m_center) / m_scale;
    Eigen::Matrix<double, 10, 3> d = Eigen::Matrix<double, 10, 3>::Zero(); // derivatives of the monomials
    d.topRows<3>().setIdentity();
    for(int k = 0; k < 3; ++k)
      d(4 + k, k) = 2 * x[k];
    d(7, 0) = x.y(); d(7, 1) = x.x();
    d(8, 0) = x.z(); d(8, 2) = x.x();
    d(9, 1) = x.z(); d(9, 2) = x.y();
    const Matrix j = Matrix::Identity() + m_coefficients.transpose() * d;
    Matrix cofactors;
    cofactors << j.col(1).cross(j.col(2)), j.col(2).cross(j.col(0)), j.col(0).cross(j.col(1));
    const Vector moved = cofactors * n;
    return j.col(0).dot(cofactors.col(0)) > 0 && moved.norm() > 1e-6 ? Vector(moved.normalized()) : n;
  }

private:
  Coefficients m_coefficients = Coefficients::Zero();
  Vector m_center = Vector::Zero();
  double m_scale = 1;
};

/*!
  The warp that minimises the mean squared distance of warped and target points plus `regularisation` times the sum
  of the squared quadratic coefficients, by additional equations f_ij = 0, solved by a singular value decomposition.
  What the points leave open (points in a plane) is zero, the decomposition giving the smallest solution.
  \pre from.size() == to.size()
*/
inline Quadratic_warp least_squares_quadratic_warp(const std::vector<Vector>& from, const std::vector<Vector>& to,
                                                   const Vector& center, double scale, double regularisation)
{
  if(from.empty() || !(scale > 0))
    return Quadratic_warp();
  const Eigen::Index n = Eigen::Index(from.size());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n + 6, 10);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n + 6, 3);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    const std::size_t k = std::size_t(i);
    rows.row(i) = Quadratic_warp::monomials((from[k] - center) / scale).transpose();
    right.row(i) = ((to[k] - from[k]) / scale).transpose();
  }
  for(Eigen::Index k = 0; k < 6; ++k)
    rows(n + k, 4 + k) = std::sqrt(regularisation * double(n));
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(1e-6);
  return Quadratic_warp(Quadratic_warp::Coefficients(svd.solve(right)), center, scale);
}

/// How the warp is iterated.
struct Warp_parameters
{
  double regularisation = 0.1;
  std::size_t iterations = 4;     ///< correspondences are established anew for each
};

/// The second step of section 7.1: closest points of the moving set to each fixed point, warp, and again from where
/// the points are now. \param normals parallel to `moving`, moved along
/// \return the root of the mean squared distance of eq. 4 in the end
inline double warp_to_closest_points(std::vector<Vector>& moving, std::vector<Vector>& normals,
                                     const std::vector<Vector>& fixed, const Vector& center, double scale,
                                     const Warp_parameters& parameters = Warp_parameters())
{
  if(moving.empty() || fixed.empty())
    return 0;
  std::vector<Vector> from(fixed.size());
  for(std::size_t iteration = 0; ; ++iteration)
  {
    const Closest_point_search search(moving);
    double sum = 0;
    for(std::size_t i = 0; i < fixed.size(); ++i)
    {
      const Neighbor_search::Neighbor found = search.nearest(fixed[i]);
      from[i] = moving[found.first];
      sum += found.second * found.second;
    }
    if(iteration == parameters.iterations)
      return std::sqrt(sum / double(fixed.size()));
    const Quadratic_warp warp = least_squares_quadratic_warp(from, fixed, center, scale, parameters.regularisation);
    for(std::size_t i = 0; i < moving.size(); ++i)
    {
      normals[i] = warp.normal(moving[i], normals[i]);
      moving[i] = warp(moving[i]);
    }
  }
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRATIC_WARP_H
