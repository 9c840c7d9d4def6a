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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRIC_FIT_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRIC_FIT_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Quadric_3.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The points that a local approximation is fitted to: indices into a surface, one weight each, and the cell they
  stand for.
*/
struct Fit_data
{
  const Surface_points* surface = nullptr;
  std::vector<std::size_t> indices;
  std::vector<double> weights;          ///< positive, parallel to `indices`
  Vector center = Vector::Zero();       ///< of the cell
  double half_edge = 1;                 ///< of the cell

  std::size_t size() const { return indices.size(); }
  const Vector& position(std::size_t i) const { return surface->position[indices[i]]; }
  const Vector& normal(std::size_t i) const { return surface->normal[indices[i]]; }

  /// Weighted mean of the positions. \pre size() > 0
  Vector mean_position() const
  {
    Vector sum = Vector::Zero();
    double all = 0;
    for(std::size_t i = 0; i < size(); ++i)
    {
      sum += weights[i] * position(i);
      all += weights[i];
    }
    return sum / all;
  }

  /// Unit weighted mean of the normals; the first normal where they cancel. \pre size() > 0
  Vector mean_normal() const
  {
    Vector sum = Vector::Zero();
    double all = 0;
    for(std::size_t i = 0; i < size(); ++i)
    {
      sum += weights[i] * normal(i);
      all += weights[i];
    }
    return sum.norm() > 1e-6 * all ? Vector(sum.normalized()) : normal(0);
  }
};

/// A unit vector orthogonal to the unit vector `n`.
inline Vector any_orthogonal(const Vector& n)
{
  Eigen::Index smallest;
  n.cwiseAbs().minCoeff(&smallest);
  return n.cross(Vector(Vector::Unit(smallest))).normalized();
}

/*!
  Case (b) of the multi-level partition of unity: f = h - (c0 + c1 u + c2 v + c3 uu + c4 uv + c5 vv) in the frame of
  the mean point and normal. Fewer than six points, or `plane`, leave only the terms up to c2; fewer than three the
  plane through the mean point across the mean normal. \pre data.size() > 0
*/
inline Quadric fit_bivariate_quadric(const Fit_data& data, bool plane = false, double cut = 1e-5)
{
  const Vector o = data.mean_position(), n = data.mean_normal();
  if(data.size() < 3)
    return make_plane_quadric(o, n);
  const Vector u = any_orthogonal(n), v = n.cross(u);
  const std::size_t unknowns = plane || data.size() < 6 ? 3 : 6;
  const double s = data.half_edge > 0 ? data.half_edge : 1;
  Eigen::MatrixXd rows(data.size(), unknowns);
  Eigen::MatrixXd right(data.size(), 1);
  for(std::size_t i = 0; i < data.size(); ++i)
  {
    const Eigen::Index r = Eigen::Index(i);
    const Vector y = (data.position(i) - o) / s;
    const double x[2] = { y.dot(u), y.dot(v) }, w = std::sqrt(data.weights[i]);
    rows(r, 0) = w;
    rows(r, 1) = w * x[0];
    rows(r, 2) = w * x[1];
    if(unknowns == 6)
    {
      rows(r, 3) = w * x[0] * x[0];
      rows(r, 4) = w * x[0] * x[1];
      rows(r, 5) = w * x[1] * x[1];
    }
    right(r, 0) = w * y.dot(n);
  }
  const Eigen::MatrixXd c = least_squares_by_svd(rows, right, cut);
  Matrix a = Matrix::Zero();
  if(unknowns == 6)
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        a(i, j) = -(c(3, 0) * u[i] * u[j] + 0.5 * c(4, 0) * (u[i] * v[j] + v[i] * u[j]) + c(5, 0) * v[i] * v[j]);
  return make_quadric(a, n - c(1, 0) * u - c(2, 0) * v, -c(0, 0), o, s);
}

/*!
  Case (a): all ten coefficients. The points alone are fitted by f = 0, too; so the corners and the centre of the cell
  prescribe the distance to the tangent planes of their six nearest points, where these agree on the side.
  \param auxiliary_weight of all prescribed distances together, the points having 1. The source uses 1, too, and a
         whole sphere then is a tenth too large, because no quadric has the distances as its values. They have to
         settle scale and side only, and what the points leave open.
  \return whether any did; `false` leaves `q` as it was
*/
inline bool fit_general_quadric(const Fit_data& data, Quadric& q, double auxiliary_weight = 1e-4,
                                double cut = 1e-7)
{
  const double s = data.half_edge > 0 ? data.half_edge : 1;
  std::vector<std::pair<Vector, double> > auxiliary; // in the coordinates of the cell
  std::vector<std::pair<double, std::size_t> > nearest(data.size());
  for(int k = 0; k < 9; ++k)
  {
    const Vector y = k == 8 ? Vector(Vector::Zero()) : Vector(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    const Vector x = data.center + s * y;
    for(std::size_t i = 0; i < data.size(); ++i)
      nearest[i] = std::make_pair((data.position(i) - x).squaredNorm(), i);
    const std::size_t number = (std::min)(std::size_t(6), data.size());
    std::partial_sort(nearest.begin(), nearest.begin() + std::ptrdiff_t(number), nearest.end());
    double sum = 0;
    std::size_t positive = 0, negative = 0;
    for(std::size_t i = 0; i < number; ++i)
    {
      const double d = data.normal(nearest[i].second).dot(x - data.position(nearest[i].second));
      sum += d;
      positive += d > 0 ? 1 : 0;
      negative += d < 0 ? 1 : 0;
    }
    if(positive == number || negative == number)
      auxiliary.emplace_back(y, sum / double(number) / s);
  }
  if(auxiliary.empty())
    return false;

  double all = 0;
  for(double w : data.weights)
    all += w;
  const Eigen::Index number = Eigen::Index(data.size() + auxiliary.size());
  Eigen::MatrixXd rows(number, 10);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(number, 1);
  for(Eigen::Index r = 0; r < number; ++r)
  {
    const bool is_point = std::size_t(r) < data.size();
    const std::size_t i = is_point ? std::size_t(r) : std::size_t(r) - data.size();
    const Vector y = is_point ? Vector((data.position(i) - data.center) / s) : auxiliary[i].first;
    const double w = std::sqrt(is_point ? data.weights[i] / all : auxiliary_weight / double(auxiliary.size()));
    const double row[10] = { y.x() * y.x(), y.y() * y.y(), y.z() * y.z(), y.x() * y.y(), y.x() * y.z(), y.y() * y.z(),
                             y.x(), y.y(), y.z(), 1 };
    for(Eigen::Index k = 0; k < 10; ++k)
      rows(r, k) = w * row[k];
    if(!is_point)
      right(r, 0) = w * auxiliary[i].second;
  }
  const Eigen::MatrixXd c = least_squares_by_svd(rows, right, cut);
  Matrix a;
  a << c(0, 0), c(3, 0) / 2, c(4, 0) / 2, c(3, 0) / 2, c(1, 0), c(5, 0) / 2, c(4, 0) / 2, c(5, 0) / 2, c(2, 0);
  q = make_quadric(a, Vector(c(6, 0), c(7, 0), c(8, 0)), c(9, 0), data.center, s);
  return true;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRIC_FIT_H
