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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_SPACING_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_SPACING_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_sample.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  How densely a hole is to be sampled, at each sample of its base: the spacing of the surroundings behind the rim goes on
  into it, its logarithm as a linear function in space.
*/
template <typename ConcurrencyTag>
class Local_spacing
{
public:
  explicit Local_spacing(const Smooth_patch<ConcurrencyTag>& patch)
  {
    const Rim_surroundings<ConcurrencyTag>& surroundings = *patch.surroundings();
    const Surface_model<ConcurrencyTag>& model = surroundings.model();
    m_per_area = model.spacing() / model.area_spacing();
    m_is_lattice = model.area_spacing() * model.irregularity() < 1.2 * model.spacing();
    std::vector<std::size_t> behind;
    for(const Band_point& b : surroundings.band())
      if(surroundings.is_behind(b))
        behind.push_back(b.index);
    m_area_spacing.assign(patch.samples().size(), surroundings.area_spacing_behind());
    if(behind.empty())
      return;
    // by area, since there are more points where they are dense
    Vector middle = Vector::Zero();
    double mean = 0, total = 0, least = std::log(model.area_spacing(behind[0])), most = least;
    for(std::size_t i : behind)
    {
      const double weight = model.area_spacing(i) * model.area_spacing(i), value = std::log(model.area_spacing(i));
      middle += weight * model.position(i);
      mean += weight * value;
      total += weight;
      least = (std::min)(least, value);
      most = (std::max)(most, value);
    }
    middle /= total;
    mean /= total;
    Matrix covariance = Matrix::Zero();
    Vector right = Vector::Zero();
    for(std::size_t i : behind)
    {
      const double weight = model.area_spacing(i) * model.area_spacing(i) / total;
      const Vector d = model.position(i) - middle;
      covariance.noalias() += weight * d * d.transpose();
      right += weight * (std::log(model.area_spacing(i)) - mean) * d;
    }
    // across a flat rim nothing is known
    const double damping = 0.02 * covariance.trace();
    covariance.diagonal().array() += damping;
    const Vector slope = damping > 0 ? solve_damped_system(covariance, right) : Vector(Vector::Zero());
    for(std::size_t s = 0; s < m_area_spacing.size(); ++s)
    {
      const double value = mean + slope.dot(patch.samples()[s].position - middle);
      m_area_spacing[s] = std::exp((std::max)(least, (std::min)(most, value)));
    }
  }

  /// Square root of the area per point.
  double area_spacing(std::size_t sample) const { return m_area_spacing[sample]; }

  /// Distance that new points keep, see `Surface_model`.
  double spacing(std::size_t sample) const { return m_per_area * m_area_spacing[sample]; }

  /// Distance for darts: they are about as many as wanted then, and the nearest ones about as far apart. A lattice has more
  /// points than blue noise with the same distance between them.
  double dart_spacing(std::size_t sample) const
  {
    return (std::min)(0.96 * m_per_area, 0.8) * m_area_spacing[sample];
  }

  /// Whether the surroundings are sampled nearly as evenly as can be, with one spacing: as the base is.
  bool is_lattice() const
  {
    const auto range = std::minmax_element(m_area_spacing.begin(), m_area_spacing.end());
    return m_is_lattice && *range.second < 1.2 * *range.first;
  }

private:
  double m_per_area = 1;
  bool m_is_lattice = false;
  std::vector<double> m_area_spacing;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_SPACING_H
