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
#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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
  typedef std::array<double, 10> Monomials;            ///< x y z 1 xx yy zz xy xz yz
  typedef Eigen::Matrix<double, 10, 3> Coefficients;   ///< of the displacement

  /// The identity.
  Quadratic_warp() {}
  Quadratic_warp(const Coefficients& coefficients, const Vector& center, double scale)
    : m_coefficients(coefficients), m_center(center), m_scale(scale)
  {}

  static Monomials monomials(const Vector& x)
  {
    return {{x.x(), x.y(), x.z(), 1, x.x() * x.x(), x.y() * x.y(), x.z() * x.z(), x.x() * x.y(), x.x() * x.z(),
             x.y() * x.z()}};
  }

  const Coefficients& coefficients() const { return m_coefficients; }

  Vector operator()(const Vector& p) const
  {
    const Monomials m = monomials((p - m_center) / m_scale);
    Vector shift = Vector::Zero();
    for(int k = 0; k < 3; ++k)
      for(int l = 0; l < 10; ++l)
        shift[k] += m_coefficients(l, k) * m[std::size_t(l)];
    return p + m_scale * shift;
  }

  /// A normal at `p` is moved by the cofactor matrix of the derivative; where the map folds it is left as it was.
  Vector normal(const Vector& p, const Vector& n) const
  {
    const Vector x = (p - m_center) / m_scale;
    Vector j[3]; // the columns of the derivative
    for(int k = 0; k < 3; ++k)
    {
      const Coefficients& c = m_coefficients;
      j[0][k] = c(0, k) + 2 * c(4, k) * x[0] + c(7, k) * x[1] + c(8, k) * x[2];
      j[1][k] = c(1, k) + 2 * c(5, k) * x[1] + c(7, k) * x[0] + c(9, k) * x[2];
      j[2][k] = c(2, k) + 2 * c(6, k) * x[2] + c(8, k) * x[0] + c(9, k) * x[1];
    }
    for(int k = 0; k < 3; ++k)
      j[k][k] += 1;
    const Vector first = j[1].cross(j[2]), second = j[2].cross(j[0]), third = j[0].cross(j[1]);
    const Vector moved = n[0] * first + n[1] * second + n[2] * third;
    return j[0].dot(first) > 0 && moved.norm() > 1e-6 ? Vector(moved.normalized()) : n;
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
    const Quadratic_warp::Monomials m = Quadratic_warp::monomials((from[k] - center) / scale);
    for(Eigen::Index l = 0; l < 10; ++l)
      rows(i, l) = m[std::size_t(l)];
    const Vector step = (to[k] - from[k]) / scale;
    for(Eigen::Index l = 0; l < 3; ++l)
      right(i, l) = step[l];
  }
  for(Eigen::Index k = 0; k < 6; ++k)
    rows(n + k, 4 + k) = std::sqrt(regularisation * double(n));
  return Quadratic_warp(least_squares_by_svd(rows, right, 1e-6), center, scale);
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
