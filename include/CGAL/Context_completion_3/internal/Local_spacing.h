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
#include <CGAL/Context_completion_3/internal/For_each_index.h>
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
  How densely a hole is to be sampled, at each sample of its base: the spacing of the surroundings goes on into it, as the
  geometric mean of what is known behind the rim, with weights that fall with the fourth power of the distance.
*/
template <typename ConcurrencyTag>
class Local_spacing
{
public:
  explicit Local_spacing(const Smooth_patch<ConcurrencyTag>& patch)
  {
    const Rim_surroundings<ConcurrencyTag>& surroundings = *patch.surroundings();
    const Surface_model<ConcurrencyTag>& model = surroundings.model();
    // a lattice has more points than blue noise with the same distance between them
    m_per_area = (std::min)(0.92, model.spacing() / model.area_spacing());
    const std::size_t most = 400;
    std::vector<std::size_t> behind;
    for(const Band_point& b : surroundings.band())
      if(surroundings.is_behind(b))
        behind.push_back(b.index);
    const std::size_t step = behind.size() / most + 1;
    m_area_spacing.assign(patch.samples().size(), surroundings.area_spacing_behind());
    if(behind.empty())
      return;
    const double softening = surroundings.area_spacing() * surroundings.area_spacing();
    for_each_index<ConcurrencyTag>(m_area_spacing.size(), [&](std::size_t s)
    {
      double sum = 0, total = 0;
      for(std::size_t k = 0; k < behind.size(); k += step)
      {
        const double square = (patch.samples()[s].position - model.position(behind[k])).squaredNorm() + softening;
        const double weight = 1 / (square * square);
        sum += weight * std::log(model.area_spacing(behind[k]));
        total += weight;
      }
      m_area_spacing[s] = std::exp(sum / total);
    });
  }

  /// Square root of the area per point.
  double area_spacing(std::size_t sample) const { return m_area_spacing[sample]; }

  /// Distance that new points keep, see `Surface_model`.
  double spacing(std::size_t sample) const { return m_per_area * m_area_spacing[sample]; }

private:
  double m_per_area = 1;
  std::vector<double> m_area_spacing;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_SPACING_H
