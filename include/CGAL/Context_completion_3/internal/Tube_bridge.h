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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_TUBE_BRIDGE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_TUBE_BRIDGE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Rim_surroundings.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Rings between the two rims of a cut tube. Where the gap is longer than the tube is thick, the smoothest surface through
  the surroundings closes each end alone, as a soap film does. A base that is led through these rings goes on from one
  rim to the other.

  Both rims are read as curves over the angle around the line between their centres. From a place of the one to that of
  the same angle of the other leads the cubic that leaves both in the direction in which the surface is open.
*/
template <typename ConcurrencyTag>
class Tube_bridge
{
  typedef Surface_model<ConcurrencyTag> Model;

  struct Place
  {
    Vector position = Vector::Zero(), outward = Vector::Zero(), normal = Vector::Zero();
    double weight = 0;
  };

public:
  Tube_bridge(const Model& model, const Rim_loop& first, const Rim_loop& second)
    : m_model(model), m_axis((second.center - first.center).normalized()), m_u(m_axis.unitOrthogonal()),
      m_v(m_axis.cross(m_u))
  {
    const double spacing = (model.spacing(first.points.front().index) + model.spacing(second.points.front().index)) / 2;
    const double around = pi() * (std::min)(first.diameter, second.diameter);
    m_number = (std::max)(std::size_t(12), std::size_t(around / (2 * spacing)));
    m_places[0] = places(first);
    m_places[1] = places(second);
    const double gap = (second.center - first.center).norm();
    m_rings = 1 + std::size_t(gap / (std::min)(first.diameter, second.diameter));
  }

  /// Positions and normals of the rings.
  std::vector<Base_center> rings() const
  {
    std::vector<Base_center> result;
    for(std::size_t r = 1; r <= m_rings; ++r)
    {
      const double t = double(r) / double(m_rings + 1);
      for(std::size_t i = 0; i < m_number; ++i)
      {
        Vector along;
        Base_center center;
        center.position = position(i, t, along);
        Vector ignored;
        const Vector across = position((i + 1) % m_number, t, ignored) - position((i + m_number - 1) % m_number, t,
                                                                                  ignored);
        center.normal = along.cross(across).normalized();
        if(center.normal.dot((1 - t) * m_places[0][i].normal + t * m_places[1][i].normal) < 0)
          center.normal = -center.normal;
        center.distance = t < 0.5 ? (center.position - m_places[0][i].position).norm()
                                  : (center.position - m_places[1][i].position).norm();
        if(center.position.allFinite() && center.normal.allFinite())
          result.push_back(center);
      }
    }
    return result;
  }

private:
  static double pi() { return 3.14159265358979323846; }

  // Means over the rim points near each angle.
  std::vector<Place> places(const Rim_loop& loop) const
  {
    const double width = 2 * pi() / double(m_number);
    std::vector<Place> result(m_number);
    for(const Rim_point& p : loop.points)
    {
      const Vector x = m_model.position(p.index), d = x - loop.center;
      const double angle = std::atan2(d.dot(m_v), d.dot(m_u));
      for(std::size_t i = 0; i < m_number; ++i)
      {
        const double away = std::remainder(angle - double(i) * width, 2 * pi()) / width;
        const double weight = std::exp(-0.5 * away * away) + 1e-12;   // somewhere at least
        result[i].position += weight * x;
        result[i].outward += weight * p.outward;
        result[i].normal += weight * m_model.normal(p.index);
        result[i].weight += weight;
      }
    }
    for(Place& place : result)
    {
      place.position /= place.weight;
      place.outward.normalize();
      place.normal.normalize();
    }
    return result;
  }

  // The cubic between the i-th places, which are left along `outward`.
  Vector position(std::size_t i, double t, Vector& along) const
  {
    const Place &a = m_places[0][i], &b = m_places[1][i];
    const double length = (b.position - a.position).norm(), s = 1 - t;
    const Vector p = a.position + length / 3 * a.outward, q = b.position + length / 3 * b.outward;
    along = s * s * (p - a.position) + 2 * s * t * (q - p) + t * t * (b.position - q);
    return s * s * s * a.position + 3 * s * s * t * p + 3 * s * t * t * q + t * t * t * b.position;
  }

  const Model& m_model;
  Vector m_axis, m_u, m_v;
  std::size_t m_number = 0, m_rings = 0;
  std::vector<Place> m_places[2];
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_TUBE_BRIDGE_H
