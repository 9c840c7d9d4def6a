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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_LOCAL_STATISTICS_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_LOCAL_STATISTICS_H

#include "Random_source.h"

#include <CGAL/Context_completion_3/internal/Neighbor_search.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Completion_benchmark {

typedef CGAL::Context_completions_3::internal::Neighbor_search Neighbor_search;
using CGAL::Context_completions_3::internal::is_same_side;

inline double mean(const std::vector<double>& values)
{
  double sum = 0;
  for(double v : values)
    sum += v;
  return sum / double(values.size());
}

/// Quantile with linear interpolation between the order statistics; `values` is not empty.
inline double quantile(std::vector<double> values, double q)
{
  std::sort(values.begin(), values.end());
  const double place = q * double(values.size() - 1);
  const std::size_t low = std::size_t(place), high = (std::min)(low + 1, values.size() - 1);
  return values[low] + (place - double(low)) * (values[high] - values[low]);
}

/// First Wasserstein distance of two distributions, from 200 quantiles.
inline double wasserstein_distance(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for(int i = 0; i < 200; ++i)
    sum += std::abs(quantile(a, (i + 0.5) / 200) - quantile(b, (i + 0.5) / 200));
  return sum / 200;
}

/// Distance of p to the plane at its nearest point q, at most their distance, and just this beyond 2 h.
inline double plane_distance(const Vector& p, const Vector& q, const Vector& normal, double distance, double h)
{
  return distance > 2 * h ? distance : (std::min)(distance, std::abs((p - q).dot(normal)));
}

/// Distance of each point to its nearest neighbour; at least two points.
inline std::vector<double> neighbor_distances(const std::vector<Vector>& positions)
{
  const Neighbor_search search(positions);
  std::vector<Neighbor_search::Neighbor> found;
  std::vector<double> distances;
  for(const Vector& p : positions)
  {
    search.k_nearest(p, 2, found);
    distances.push_back(found.back().second);
  }
  return distances;
}

/// Normal of the plane through the k nearest neighbours of q.
inline Vector normal_of_neighbors(const std::vector<Vector>& positions, const Neighbor_search& search, const Vector& q,
                                  std::size_t k)
{
  std::vector<Neighbor_search::Neighbor> found;
  search.k_nearest(q, k, found);
  Vector center = Vector::Zero();
  for(const Neighbor_search::Neighbor& n : found)
    center += positions[n.first] / double(found.size());
  Matrix scatter = Matrix::Zero();
  for(const Neighbor_search::Neighbor& n : found)
    scatter += (positions[n.first] - center) * (positions[n.first] - center).transpose();
  return Eigen::SelfAdjointEigenSolver<Matrix>(scatter).eigenvectors().col(0);
}

/// Positions, relative to the centre and in units of the radius, of the neighbours on the same side of the surface.
inline std::vector<Vector> neighborhood(const Surface_points& points, const Neighbor_search& search,
                                        const Vector& center, const Vector& normal, double radius)
{
  std::vector<std::size_t> found;
  search.in_ball(center, radius, found);
  std::vector<Vector> result;
  for(std::size_t i : found)
    if(is_same_side(points.normal[i], normal))
      result.push_back((points.position[i] - center) / radius);
  return result;
}

/// Subtracts the mean. \return the scatter matrix.
inline Matrix centered(std::vector<Vector>& points)
{
  Vector mean = Vector::Zero();
  for(const Vector& p : points)
    mean += p / double(points.size());
  Matrix scatter = Matrix::Zero();
  for(Vector& p : points)
  {
    p -= mean;
    scatter += p * p.transpose();
  }
  return scatter;
}

/// Root mean square distance of the neighbours to their plane; NaN for fewer than 5.
inline double plane_residual(const Surface_points& points, const Neighbor_search& search, const Vector& center,
                             const Vector& normal, double radius)
{
  std::vector<Vector> near = neighborhood(points, search, center, normal, radius);
  if(near.size() < 5)
    return std::numeric_limits<double>::quiet_NaN();
  const Matrix covariance = centered(near) / double(near.size());
  const double least = Eigen::SelfAdjointEigenSolver<Matrix>(covariance, Eigen::EigenvaluesOnly).eigenvalues()[0];
  return std::sqrt((std::max)(0., least)) * radius;
}

struct Roughness { double residual; std::size_t number_of_neighbors; };

/// Root mean square residual of a quadratic height field over the neighbours' plane; NaN for fewer than 12 or `needed`.
inline Roughness roughness(const Surface_points& points, const Neighbor_search& search, const Vector& center,
                           const Vector& normal, double radius, double needed)
{
  std::vector<Vector> near = neighborhood(points, search, center, normal, radius);
  Roughness result = { std::numeric_limits<double>::quiet_NaN(), near.size() };
  if(near.size() < 12 || double(near.size()) < needed)
    return result;
  const Matrix axes = Eigen::SelfAdjointEigenSolver<Matrix>(centered(near)).eigenvectors();
  Eigen::MatrixXd terms(near.size(), 6);
  Eigen::VectorXd height(near.size());
  for(std::size_t i = 0; i < near.size(); ++i)
  {
    const Vector local = axes.transpose() * near[i];
    const double u = local.y(), v = local.z();
    terms.row(Eigen::Index(i)) << 1, u, v, u * u, u * v, v * v;
    height[Eigen::Index(i)] = local.x();
  }
  const Eigen::VectorXd rest = height - terms * terms.colPivHouseholderQr().solve(height);
  result.residual = std::sqrt(rest.squaredNorm() / double(near.size())) * radius;
  return result;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_LOCAL_STATISTICS_H
