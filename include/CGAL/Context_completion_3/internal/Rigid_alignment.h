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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIGID_ALIGNMENT_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIGID_ALIGNMENT_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Closest_point_search.h>
#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// x -> R x + t with a proper rotation R.
struct Rigid_motion
{
  Matrix rotation = Matrix::Identity();
  Vector translation = Vector::Zero();

  Vector operator()(const Vector& p) const { return rotation * p + translation; }
  Vector inverse(const Vector& p) const { return rotation.transpose() * (p - translation); }
};

/// The rigid motion that minimises the sum of squared distances between moved and target points (eq. 5): the centroids
/// give the translation, a singular value decomposition the rotation. Without points it is the identity.
/// \pre from.size() == to.size()
inline Rigid_motion least_squares_rigid_motion(const std::vector<Vector>& from, const std::vector<Vector>& to)
{
  Rigid_motion motion;
  if(from.empty())
    return motion;
  Vector from_center = Vector::Zero(), to_center = Vector::Zero();
  for(std::size_t i = 0; i < from.size(); ++i)
  {
    from_center += from[i];
    to_center += to[i];
  }
  from_center /= double(from.size());
  to_center /= double(from.size());
  Matrix covariance = Matrix::Zero();
  for(std::size_t i = 0; i < from.size(); ++i)
    covariance += (to[i] - to_center) * (from[i] - from_center).transpose();
  motion.rotation = nearest_rotation(covariance);
  motion.translation = to_center - motion.rotation * from_center;
  return motion;
}

/*!
  The first step of section 7.1: the closest point to each fixed point is sought among the moving ones (eq. 4), the
  motion that brings them there is found (eq. 5), and again, until nothing moves.
  \param smallest_change mean change of distance that counts as none
  \param residual if not null, receives the root of the mean squared distance of eq. 4
*/
inline Rigid_motion iterative_closest_point(const std::vector<Vector>& moving, const std::vector<Vector>& fixed,
                                            double smallest_change, std::size_t maximum_iterations = 20,
                                            double* residual = nullptr)
{
  Rigid_motion motion;
  if(moving.empty() || fixed.empty())
    return motion;
  const Closest_point_search search(moving);
  std::vector<Vector> from(fixed.size());
  double previous = (std::numeric_limits<double>::max)();
  for(std::size_t iteration = 0; ; ++iteration)
  {
    double sum = 0;
    for(std::size_t i = 0; i < fixed.size(); ++i)
    {
      const Neighbor_search::Neighbor found = search.nearest(motion.inverse(fixed[i]));
      from[i] = moving[found.first];
      sum += found.second * found.second;
    }
    const double rms = std::sqrt(sum / double(fixed.size()));
    if(residual != nullptr)
      *residual = rms;
    if(iteration == maximum_iterations || previous - rms < smallest_change)
      return motion;
    previous = rms;
    motion = least_squares_rigid_motion(from, fixed);
  }
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIGID_ALIGNMENT_H
