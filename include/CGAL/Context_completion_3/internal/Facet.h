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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Normal_equations.h>
#include <CGAL/Context_completion_3/internal/Quadric_3.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// What a fit of a facet expects of its points; lengths in model units.
struct Facet_precision
{
  double position = 0;     ///< standard deviation of positions from the surface
  double normal = 0;       ///< of normals, in radians
  double scale = 1;        ///< the surface is expected to bend by about a radian over this length at most
};

/*!
  A smooth piece of a surface that goes on beyond its points: a quadric whose value is 0 at the positions and whose
  gradient there is the normal, in least squares. Planes, spheres and cylinders are met exactly, and since the gradient
  has length 1, the value is close to a distance. It is a plane unless to bend is worth it, and how much it bends is
  judged by what is expected beforehand, so that narrow strips go on straight across.
*/
class Facet
{
public:
  Facet() {}

  /// \param members indices into `points`, at least one
  Facet(const Surface_points& points, const std::vector<std::size_t>& members, const Facet_precision& precision)
  {
    Vector origin = Vector::Zero();
    for(std::size_t i : members)
      origin += points.position[i];
    origin /= double(members.size());
    Normal_equations<terms> equations;
    std::size_t number = 0;
    double square = 0;
    const double position_weight = std::pow(precision.scale / precision.position, 2);
    const double normal_weight = std::pow(1 / precision.normal, 2);
    const auto add = [&](const Row& row, double value, double weight)
    {
      equations.add(row, value, weight);
      square += weight * value * value;
      ++number;
    };
    for(std::size_t i : members)
    {
      // linear terms first: a plane needs no others
      const Vector d = (points.position[i] - origin) / precision.scale;
      const double x = d.x(), y = d.y(), z = d.z();
      add({{1, x, y, z, x * x, y * y, z * z, x * y, x * z, y * z}}, 0, position_weight);
      add({{0, 1, 0, 0, 2 * x, 0, 0, y, z, 0}}, points.normal[i].x(), normal_weight);
      add({{0, 0, 1, 0, 0, 2 * y, 0, x, 0, z}}, points.normal[i].y(), normal_weight);
      add({{0, 0, 0, 1, 0, 0, 2 * z, 0, x, y}}, points.normal[i].z(), normal_weight);
    }
    for(std::size_t term = linear_terms; term < terms; ++term)
      equations.diagonal(term) += 4;
    const auto solution = [&](std::size_t used)
    {
      double largest = 0;
      for(std::size_t term = 0; term < used; ++term)
        largest = (std::max)(largest, equations.diagonal(term));
      return equations.solve(used, 1e-9 * largest);
    };
    const auto loss = [&](const Row& c) { return (std::max)(0., square + equations.change_of_loss(c)); };
    const Row plane = solution(linear_terms), bent = solution(terms);
    // the Bayesian information criterion, with a floor for the loss, since no surface is a plane to the last digit
    const double n = double(number), floor = 0.03 * n;
    const bool is_plane = n * std::log((loss(plane) + floor) / (loss(bent) + floor))
                          < double(terms - linear_terms) * std::log(n);
    const Row& c = is_plane ? plane : bent;
    m_loss = loss(c) + floor;
    Matrix a;
    a << c[4], c[7] / 2, c[8] / 2, c[7] / 2, c[5], c[9] / 2, c[8] / 2, c[9] / 2, c[6];
    m_quadric = make_quadric(a, Vector(c[1], c[2], c[3]), c[0], origin, precision.scale);
  }

  /// Sum of the squares of what it misses of positions and normals, over their expected deviations.
  double loss() const { return m_loss; }

  /// Signed distance, to first order.
  double distance(const Vector& x) const { return taubin_distance(m_quadric, x); }

  /// The point near `x` to which the gradient leads.
  Vector projection(Vector x) const
  {
    for(int step = 0; step < 3; ++step)
    {
      const Vector g = gradient(m_quadric, x);
      const double square = g.squaredNorm();
      if(square > 0)
        x -= value(m_quadric, x) / square * g;
    }
    return x;
  }

  Vector normal(const Vector& x) const { return gradient(m_quadric, x).normalized(); }

  /// Where the line from `x` along `direction` meets the facet.
  std::vector<double> intersections(const Vector& x, const Vector& direction) const
  {
    // by Taylor expansion, which is exact
    const double e0 = value(m_quadric, x), e1 = gradient(m_quadric, x).dot(direction);
    const double e2 = value(m_quadric, x + direction) - e0 - e1;
    std::vector<double> result;
    const double discriminant = e1 * e1 - 4 * e2 * e0;
    if(discriminant < 0 || (e1 == 0 && e2 == 0))
      return result;
    // without cancellation, and for e2 = 0
    const double root = -0.5 * (e1 + std::copysign(std::sqrt(discriminant), e1));
    if(root != 0)
      result.push_back(e0 / root);
    if(e2 != 0)
      result.push_back(root / e2);
    return result;
  }

private:
  static constexpr std::size_t linear_terms = 4, terms = 10;

  typedef Normal_equations<terms>::Row Row;

  Quadric m_quadric;
  double m_loss = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_H
