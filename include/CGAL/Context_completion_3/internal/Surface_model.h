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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_MODEL_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_MODEL_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Normal_equations.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/for_each.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A point of the denoised surface and its unit normal.
struct Surface_element
{
  Vector position = Vector::Zero();
  Vector normal = Vector::Zero();

  /// Height of the tangent plane over `foot` along `axis`, which it faces, and the gradient of that height.
  std::array<double, 4> height_over(const Vector& foot, const Vector& axis) const
  {
    const double facing = normal.dot(axis);
    const Vector gradient = axis - normal / facing;
    return {{normal.dot(position - foot) / facing, gradient[0], gradient[1], gradient[2]}};
  }
};

/*!
  A point set together with what all stages ask of it: neighbours, local spacing, local quadratic fits.

  Three measures of spacing serve three ends. `area_spacing(i)` is the square root of the area per point. `gap_spacing(i)` is
  that of an even sampling whose gaps are as wide: of points at random, on scan lines or in several scans, one over the other,
  gaps are much wider than by their number, and no holes. `spacing(i)` is the distance that new points keep; in an even
  sampling that is the one to the nearest neighbour, otherwise that of an even sampling of as many points.
*/
template <typename ConcurrencyTag>
class Surface_model
{
public:
  explicit Surface_model(const Surface_points& points)
    : m_points(points), m_search(points.position)
  {
    compute_spacing();
  }

  std::size_t size() const { return m_points.size(); }
  const Surface_points& points() const { return m_points; }
  const Vector& position(std::size_t i) const { return m_points.position[i]; }
  const Vector& normal(std::size_t i) const { return m_points.normal[i]; }
  const Neighbor_search& search() const { return m_search; }

  double spacing() const { return m_median_spacing; }
  double area_spacing() const { return m_median_area_spacing; }
  double area_spacing(std::size_t i) const { return m_area_spacing[i]; }
  double spacing(std::size_t i) const { return m_area_spacing[i] * m_median_spacing / m_median_area_spacing; }
  double gap_spacing(std::size_t i) const { return m_area_spacing[i] * m_irregularity; }

  /// How many times as wide as in an even sampling of as many points the gaps between points are, from 1 to 3.
  double irregularity() const { return m_irregularity; }

  /// Distance, in area spacings, over which the surface goes on from a point.
  static constexpr double link() { return 1.8; }

  /// Points that the surface goes on to from point `i`, itself included: those within a link on the same side, so that
  /// paths over them do not reach the far side of a thin part. By increasing index.
  void linked_points(std::size_t i, std::vector<std::size_t>& found) const
  {
    linked_points(i, link() * m_area_spacing[i], found);
  }

  /// The same with links of another length.
  void linked_points(std::size_t i, double length, std::vector<std::size_t>& found) const
  {
    m_search.in_ball(m_points.position[i], length, found);
    found.erase(std::remove_if(found.begin(), found.end(), [&](std::size_t j)
      { return !is_same_side(m_points.normal[i], m_points.normal[j]); }), found.end());
  }

  /*!
    The surface near `q`, by a quadratic height field over the plane with normal `axis`, weighted by a Gaussian on the
    neighbours of agreeing normal; values at the line through `q` along `axis`.
    \param left_out indices of points that must not be used
    \return whether the neighbours suffice; fewer than 10 give a plane, none fails.
  */
  bool quadratic_fit(const Vector& q, const Vector& axis, double radius, Surface_element& result,
                     std::vector<std::size_t>& buffer,
                     const std::unordered_set<std::size_t>& left_out = std::unordered_set<std::size_t>()) const
  {
    return fit(q, axis, radius, result, nullptr, buffer, left_out);
  }

  /*!
    The same by positions alone and, in a second fit, by positions and the slopes that the normals of the points tell.
    At a rim, where points are on one side only, slopes steady the fit, if the normals are right.
  */
  bool quadratic_fits(const Vector& q, const Vector& axis, double radius, Surface_element& by_positions,
                      Surface_element& by_normals, std::vector<std::size_t>& buffer,
                      const std::unordered_set<std::size_t>& left_out = std::unordered_set<std::size_t>()) const
  {
    return fit(q, axis, radius, by_positions, &by_normals, buffer, left_out);
  }

private:
  typedef Normal_equations<6> Equations;

  // Of a slope, a height having 1, with the radius for unit of length. A third to three times as much hardly differs.
  static double slope_weight() { return 0.3; }

  // `by_normals` may be null
  bool fit(const Vector& q, const Vector& axis, double radius, Surface_element& by_positions, Surface_element* by_normals,
           std::vector<std::size_t>& buffer, const std::unordered_set<std::size_t>& left_out) const
  {
    m_search.in_ball(q, radius, buffer);
    Vector u = axis.unitOrthogonal(), v = axis.cross(u);
    Equations equations, slopes;
    std::size_t count = 0;
    double total = 0;
    for(std::size_t i : buffer)
    {
      const double facing = m_points.normal[i].dot(axis);
      if(facing < 0.3 || left_out.count(i) > 0)
        continue;
      const Vector d = (m_points.position[i] - q) / radius;
      const double x = d.dot(u), y = d.dot(v), z = d.dot(axis);
      const double weight = std::exp(-3. * d.squaredNorm());
      equations.add({{1, x, y, x * x, x * y, y * y}}, z, weight);
      total += weight;
      ++count;
      if(by_normals == nullptr)
        continue;
      slopes.add({{0, 1, 0, 2 * x, y, 0}}, -m_points.normal[i].dot(u) / facing, weight);
      slopes.add({{0, 0, 1, 0, x, 2 * y}}, -m_points.normal[i].dot(v) / facing, weight);
    }
    if(count == 0 || total <= 0)
      return false;
    const std::size_t terms = count >= 10 ? 6 : (count >= 5 ? 3 : 1);
    const auto solve = [&](Surface_element& result)
    {
      const Equations::Row c = equations.solve(terms, 1e-9 * total);
      if(std::abs(c[0]) > 1. || !std::all_of(c.begin(), c.end(), [](double x) { return std::isfinite(x); }))
        return false;
      result.position = q + radius * c[0] * axis;
      result.normal = (axis - c[1] * u - c[2] * v).normalized();
      return true;
    };
    if(!solve(by_positions))
      return false;
    if(by_normals != nullptr)
    {
      equations.add(slopes, slope_weight());
      if(!solve(*by_normals))
        *by_normals = by_positions;
    }
    return true;
  }

  void compute_spacing()
  {
    const std::size_t n = size();
    m_area_spacing.assign(n, 0.);
    std::vector<double> nearest(n, 0.);
    std::vector<std::size_t> indices(n);
    for(std::size_t i = 0; i < n; ++i)
      indices[i] = i;
    const std::size_t k = (std::min)(std::size_t(neighbors), n > 0 ? n - 1 : 0);
    CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t i) -> bool
    {
      std::vector<Neighbor_search::Neighbor> found;
      m_search.k_nearest(m_points.position[i], k + 1, found);
      // The far side of a thin part is no neighbour on the surface; duplicates have no distance.
      std::size_t same = 0;
      double last = 0;
      for(const Neighbor_search::Neighbor& f : found)
      {
        if(f.first == i || f.second == 0 || !is_same_side(m_points.normal[i], m_points.normal[f.first]))
          continue;
        ++same;
        last = f.second;
        if(same == 1)
          nearest[i] = f.second;
      }
      if(same > 0)
        m_area_spacing[i] = last * std::sqrt(pi() / (double(same) + 0.5));
      return true;
    });
    m_median_spacing = median_of_positive(nearest);
    m_median_area_spacing = median_of_positive(m_area_spacing);
    // point by point, since the spacing may vary
    std::vector<double> ratios;
    for(std::size_t i = 0; i < n; ++i)
      if(nearest[i] > 0)
        ratios.push_back(m_area_spacing[i] / nearest[i]);
    m_irregularity = irregularity_of(median_of_positive(ratios));
    m_median_spacing *= m_irregularity;
    // One round of averaging: a single odd neighbourhood must not decide.
    std::vector<double> smoothed(n, m_median_area_spacing);
    CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t i) -> bool
    {
      std::vector<Neighbor_search::Neighbor> found;
      m_search.k_nearest(m_points.position[i], k + 1, found);
      std::vector<double> values;
      for(const Neighbor_search::Neighbor& f : found)
        if(m_area_spacing[f.first] > 0 && is_same_side(m_points.normal[i], m_points.normal[f.first]))
          values.push_back(m_area_spacing[f.first]);
      if(!values.empty())
      {
        std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
        smoothed[i] = values[values.size() / 2];
      }
      return true;
    });
    m_area_spacing.swap(smoothed);
  }

  static double median_of_positive(const std::vector<double>& values)
  {
    std::vector<double> v;
    for(double x : values)
      if(x > 0)
        v.push_back(x);
    if(v.empty())
      return 0;
    std::nth_element(v.begin(), v.begin() + v.size() / 2, v.end());
    return v[v.size() / 2];
  }

  // From the ratio of the area spacing to the nearest distance. It is 1 in a square grid, 1.25 in blue noise and up to 1.4 in
  // other even samplings; of points at random it is 2.1, and an even sampling has gaps as rare if it is 1.7 times as wide.
  // Scan lines at a distance d, whose points are s apart, have the area spacing sqrt(s d), and d is that times the ratio.
  static double irregularity_of(double ratio) { return (std::max)(1., (std::min)(3., ratio - 0.4)); }

  static double pi() { return 3.14159265358979323846; }

  static const int neighbors = 12;

  const Surface_points& m_points;
  Neighbor_search m_search;
  std::vector<double> m_area_spacing;
  double m_median_spacing = 0;
  double m_median_area_spacing = 0;
  double m_irregularity = 1;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_MODEL_H
