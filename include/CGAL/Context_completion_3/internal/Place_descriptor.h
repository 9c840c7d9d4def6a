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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_DESCRIPTOR_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_DESCRIPTOR_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Motion.h>
#include <CGAL/Context_completion_3/internal/Normal_equations.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A place on the smoothed surface, and how far the points around it are from the plane there.
struct Smoothed_place
{
  Surface_frame frame;
  double roughness = 0;     ///< root mean square
};

/// Position and normal are means with a Gaussian of deviation `sigma` over the points on the side of `normal`.
template <typename ConcurrencyTag>
Smoothed_place smoothed_place(const Surface_model<ConcurrencyTag>& model, const Vector& at, const Vector& normal,
                              double sigma)
{
  std::vector<std::size_t> ball;
  model.search().in_ball(at, 1.6 * sigma, ball);
  Vector position = Vector::Zero(), mean = Vector::Zero();
  std::vector<double> weight(ball.size(), 0.);
  double total = 0;
  for(std::size_t b = 0; b < ball.size(); ++b)
    if(is_same_side(normal, model.normal(ball[b])))
    {
      weight[b] = std::exp(-(model.position(ball[b]) - at).squaredNorm() / (2 * sigma * sigma));
      position += weight[b] * model.position(ball[b]);
      mean += weight[b] * model.normal(ball[b]);
      total += weight[b];
    }
  Smoothed_place place;
  place.frame.origin = total > 0 ? Vector(position / total) : at;
  place.frame.normal = total > 0 && mean.norm() > 1e-6 * total ? mean.normalized() : normal;
  place.frame.axis = place.frame.normal.unitOrthogonal();
  double sum = 0;
  for(std::size_t b = 0; b < ball.size(); ++b)
  {
    const double d = place.frame.normal.dot(model.position(ball[b]) - place.frame.origin);
    sum += weight[b] * d * d;
  }
  place.roughness = total > 0 ? std::sqrt(sum / total) : 0.;
  return place;
}

/*!
  A short form of the signature (paper, section 6.1) in the frame of a place, for the shortlist of section 6.3: what
  does not change when the place is turned, mirrored, shifted along its normal or tilted a little, and needs no complete
  ring.

  The smoothed surface between 0.8 and 1.65 radii from the place is fitted by a quadratic height field. The descriptor
  holds its two curvatures, and in three rings what the fit misses (mean and deviation), the roughness, and how far the
  normals lean; then how uneven the roughness is. Lengths are in radii.
*/
class Place_descriptor
{
public:
  static constexpr std::size_t size = 15;
  typedef std::array<double, size> Values;

  static constexpr double reach() { return 1.65; }

  /// \param around smoothed places near the frame; those out of reach or on another side are ignored
  Place_descriptor(const Surface_frame& frame, const std::vector<const Smoothed_place*>& around, double radius)
  {
    const Vector u = frame.axis, v = frame.normal.cross(u);
    std::vector<Sample> samples;
    Normal_equations<6> equations;
    for(const Smoothed_place* place : around)
    {
      const Vector d = (place->frame.origin - frame.origin) / radius;
      const double x = d.dot(u), y = d.dot(v), distance = std::hypot(x, y);
      if(distance < nearest() || distance >= reach() || !is_same_side(frame.normal, place->frame.normal))
        continue;
      Sample sample;
      sample.row = {{1, x, y, x * x, x * y, y * y}};
      sample.height = d.dot(frame.normal);
      sample.normal = place->frame.normal;
      sample.roughness = place->roughness / radius;
      sample.ring = (std::min)(rings - 1, std::size_t(double(rings) * (distance - nearest()) / (reach() - nearest())));
      equations.add(sample.row, sample.height, 1);
      samples.push_back(sample);
    }
    m_values.fill(0.);
    if(samples.empty())
      return;
    const Row c = equations.solve(6, 1e-3 * double(samples.size()));
    m_values[0] = c[3] + c[5];
    m_values[1] = std::hypot(c[3] - c[5], c[4]);
    const Vector plane = (frame.normal - c[1] * u - c[2] * v).normalized();
    double sum = 0, squares = 0;
    for(std::size_t ring = 0; ring < rings; ++ring)
    {
      double mean[4] = {0, 0, 0, 0};
      double number = 0;
      for(const Sample& s : samples)
        if(s.ring == ring)
        {
          const double missed = s.height - std::inner_product(c.begin(), c.end(), s.row.begin(), 0.);
          mean[0] += missed;
          mean[1] += missed * missed;
          mean[2] += s.roughness;
          mean[3] += plane.dot(s.normal);
          ++number;
        }
      if(number > 0)
        for(double& m : mean)
          m /= number;
      m_values[2 + ring] = mean[0];
      m_values[5 + ring] = std::sqrt((std::max)(0., mean[1] - mean[0] * mean[0]));
      m_values[8 + ring] = mean[2];
      m_values[11 + ring] = mean[3];
    }
    for(const Sample& s : samples)
    {
      sum += s.roughness;
      squares += s.roughness * s.roughness;
    }
    const double mean = sum / double(samples.size());
    m_values[14] = std::sqrt((std::max)(0., squares / double(samples.size()) - mean * mean));
  }

  const Values& values() const { return m_values; }

private:
  typedef Normal_equations<6>::Row Row;

  static constexpr std::size_t rings = 3;
  static constexpr double nearest() { return 0.8; }

  struct Sample
  {
    Row row;
    double height = 0, roughness = 0;
    Vector normal = Vector::Zero();
    std::size_t ring = 0;
  };

  Values m_values;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_DESCRIPTOR_H
