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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_MISSING_TEXTURE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_MISSING_TEXTURE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Copy_forecast.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Weighted_quantile.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The fine relief that a plan misses, taken from a place: what is finer than a few spacings may stay with carried points
  as their texture, as far as the plan misses such relief on the fake holes, sample by sample. It begins a few spacings
  from the rim, as it does not fit what is there.
*/
template <typename ConcurrencyTag>
class Missing_texture
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Relief_sampler<ConcurrencyTag> Sampler;

public:
  /// The texture of one place.
  struct Texture
  {
    Eigen::VectorXd field;               ///< height over the plan, per sample
    double amplitude = 0;                ///< root mean square of it
    double own = 0;                      ///< that of the place, before it was brought to what is missing
  };

  Missing_texture(const Surface_model<ConcurrencyTag>& known, const Patch& patch, const Sampler& sampler,
                  const Copy_forecast<ConcurrencyTag>& forecast, const Filling_plan& plan)
    : m_sampler(sampler), m_spacing(patch.spacing())
  {
    Eigen::MatrixXd missing = forecast.misses(plan);
    for(Eigen::Index k = 0; k < missing.cols(); ++k)
      missing.col(k) = low_pass(fine(missing.col(k)).cwiseAbs2());
    m_deviation = Eigen::VectorXd::Zero(missing.rows());
    if(missing.cols() == 0)
      return;
    std::vector<std::pair<double, double> > variances(std::size_t(missing.cols()));
    for(Eigen::Index s = 0; s < missing.rows(); ++s)
    {
      for(Eigen::Index k = 0; k < missing.cols(); ++k)
        variances[std::size_t(k)] = std::make_pair(missing(s, k), forecast.judge_weights()[std::size_t(k)]);
      const double distance = known.search().nearest(patch.samples()[std::size_t(s)].position).second / m_spacing;
      const double fade = (std::max)(0., (std::min)(1., (distance - 1) / 3));
      // above the median, because that of squares is below their mean; not the mean, for fake holes at sharp edges
      m_deviation[s] = fade * std::sqrt(weighted_quantile(variances, 0.65));
    }
  }

  /// \param difference of the plan from the place, per sample
  Texture of(const Eigen::VectorXd& difference) const
  {
    Texture texture;
    texture.field = fine(difference);
    texture.own = root_mean_square(texture.field);
    const Eigen::VectorXd variance = low_pass(texture.field.cwiseAbs2());
    for(Eigen::Index s = 0; s < variance.size(); ++s)
      texture.field[s] *= (std::min)(largest_gain(), m_deviation[s] / std::sqrt(variance[s] + 1e-300));
    texture.amplitude = root_mean_square(texture.field);
    return texture;
  }

  /// Finer relief than 0.05 spacings cannot be told from an uneven sampling; texture that is random against the true
  /// one adds to the error, by a fifth at most below 0.7 of it; and a place with much more of it has another texture.
  bool is_fitting(const Texture& texture, double error) const
  {
    return texture.amplitude > 0.05 * m_spacing && texture.amplitude < 0.7 * error &&
           texture.amplitude > 0.4 * texture.own;
  }

private:
  static double largest_gain() { return 1.25; }

  Eigen::VectorXd fine(const Eigen::VectorXd& field) const { return field - low_pass(field); }

  Eigen::VectorXd low_pass(Eigen::VectorXd field) const
  {
    for(int round = 0; round < 4; ++round)
    {
      Eigen::VectorXd next(field.size());
      for(Eigen::Index s = 0; s < field.size(); ++s)
      {
        double sum = 0;
        for(std::size_t t : m_sampler.neighbors(std::size_t(s)))
          sum += field[Eigen::Index(t)];
        next[s] = sum / double(m_sampler.neighbors(std::size_t(s)).size());
      }
      field.swap(next);
    }
    return field;
  }

  static double root_mean_square(const Eigen::VectorXd& v) { return std::sqrt(v.squaredNorm() / double(v.size())); }

  const Sampler& m_sampler;
  double m_spacing;
  Eigen::VectorXd m_deviation;           // fine relief that the plan misses, per sample
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_MISSING_TEXTURE_H
