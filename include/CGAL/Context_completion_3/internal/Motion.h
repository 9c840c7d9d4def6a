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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_MOTION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_MOTION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/Geometry>

#include <cmath>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A rigid motion, possibly with a reflection, that carries a source place into a hole.
struct Motion
{
  Matrix linear = Matrix::Identity();
  Vector translation = Vector::Zero();

  Vector operator()(const Vector& x) const { return linear * x + translation; }
  Vector inverse(const Vector& x) const { return linear.transpose() * (x - translation); }
  Vector normal(const Vector& n) const { return linear * n; }
  Vector inverse_normal(const Vector& n) const { return linear.transpose() * n; }

  /// The motion followed by a small rotation vector about `pivot` and a shift.
  Motion moved(const Vector& rotation, const Vector& shift, const Vector& pivot) const
  {
    const double angle = rotation.norm();
    Matrix turn = Matrix::Identity();
    if(angle > 0)
      turn = Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
    Motion result;
    result.linear = turn * linear;
    result.translation = turn * (translation - pivot) + pivot + shift;
    return result;
  }
};

/// The rotation by the least angle that takes the unit vector `from` to the unit vector `to`. \pre they are not opposite.
inline Matrix least_rotation(const Vector& from, const Vector& to)
{
  // Eigen's FromTwoVectors() has a decomposition for opposite vectors: a tenth of the time to parse this package.
  const Vector axis = from.cross(to);
  const double s = std::sqrt(2 * (1 + from.dot(to)));
  return Eigen::Quaterniond(0.5 * s, axis[0] / s, axis[1] / s, axis[2] / s).toRotationMatrix();
}

/// Origin, in-plane axis and normal of a place; the third axis is their cross product.
struct Surface_frame
{
  Vector origin = Vector::Zero();
  Vector axis = Vector::UnitX();
  Vector normal = Vector::UnitZ();

  /// The frame turned about its normal.
  Surface_frame turned(double angle) const
  {
    Surface_frame result = *this;
    result.axis = std::cos(angle) * axis + std::sin(angle) * normal.cross(axis);
    return result;
  }

  /// The motion that carries `source` onto this frame, reflected at the plane of axis and normal if `mirrored`.
  Motion motion_from(const Surface_frame& source, bool mirrored) const
  {
    const Vector across = normal.cross(axis), source_across = (mirrored ? -1. : 1.) * source.normal.cross(source.axis);
    Matrix to, from;
    for(int k = 0; k < 3; ++k)
    {
      to(k, 0) = axis[k]; to(k, 1) = across[k]; to(k, 2) = normal[k];
      from(k, 0) = source.axis[k]; from(k, 1) = source_across[k]; from(k, 2) = source.normal[k];
    }
    Motion result;
    result.linear = to * from.transpose();
    result.translation = origin - result.linear * source.origin;
    return result;
  }
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_MOTION_H
