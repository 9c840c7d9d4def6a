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

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The fine relief that a plan misses, taken from a place: what is finer than some six spacings may stay with carried
  points as their texture. Where it is missing, sample by sample, and how rough the hole is to be in the end, is learnt
  from the fake holes. It begins a few spacings from the rim, as it does not fit what is there.
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
    Eigen::VectorXd field;               ///< height of the plan over it, per sample
    double amplitude = 0;                ///< root mean square of it
    double own = 0;                      ///< that of the place, before it was brought to what is missing
  };

  Missing_texture(const Surface_model<ConcurrencyTag>& known, const Patch& patch, const Sampler& sampler,
                  const Copy_forecast<ConcurrencyTag>& forecast, const Filling_plan& plan)
    : m_sampler(sampler), m_spacing(patch.spacing()), m_smooth(forecast.heights(Filling_plan()))
  {
    m_deviation = Eigen::VectorXd::Zero(m_smooth.size());
    const std::vector<double> weights = forecast.weights_by_roughness(plan);
    // around nearly all of them it is rougher or smoother than around the hole: they do not tell its texture
    if(std::accumulate(weights.begin(), weights.end(), 0.) < least_weight())
      return;
    const Eigen::MatrixXd missing = fine_variances(forecast.misses(plan)),
                          relief = fine_variances(forecast.misses(Filling_plan()));
    const std::vector<std::pair<double, double> > judged = weighted(weights);
    std::vector<std::pair<double, double> > variances;
    for(Eigen::Index s = 0; s < missing.rows(); ++s)
    {
      variances = judged;
      for(std::size_t k = 0; k < judged.size(); ++k)
        variances[k].first = missing(s, Eigen::Index(k));
      const double distance = known.search().nearest(patch.samples()[std::size_t(s)].position).second / m_spacing;
      const double fade = (std::max)(0., (std::min)(1., (distance - 1) / 3));
      // above the median, because that of squares is below their mean; not the mean, for fake holes at sharp edges
      m_deviation[s] = fade * std::sqrt(weighted_quantile(variances, 0.65));
      if(fade == 1)
        m_inner.push_back(s);
    }
    std::vector<std::pair<double, double> > roughnesses = weighted(forecast.weights_by_roughness(Filling_plan()));
    for(std::size_t k = 0; k < roughnesses.size(); ++k)
      roughnesses[k].first = roughness(relief.col(Eigen::Index(k)));
    m_roughness = weighted_quantile(roughnesses, 0.5);
  }

  /// Whether there are fake holes that tell of a texture.
  bool is_known() const { return m_roughness > 0; }

  /*!
    The texture of a place, so strong that the hole gets the roughness of the fake holes.

    \param heights of the plan, per sample
    \param place heights of the place
    \param error of the plan that is to be expected
  */
  Texture of(const Eigen::VectorXd& heights, const Eigen::VectorXd& place, double error) const
  {
    const Eigen::VectorXd field = fine(heights - place), plan = fine(heights - m_smooth);
    const Eigen::VectorXd deviation = low_pass(field.cwiseAbs2()).cwiseSqrt();
    const Eigen::VectorXd missing = m_deviation.cwiseQuotient((deviation.array() + 1e-300).matrix());
    Texture texture;
    texture.own = root_mean_square(field);
    double low = 0, high = largest_gain();
    for(int round = 0; round < 12; ++round)
    {
      const double gain = (low + high) / 2;
      texture.field = field.cwiseProduct((gain * missing).cwiseMin(largest_gain()));
      // fine once more: what the low pass lets through in part was taken from the field already
      const Eigen::VectorXd result = plan - fine(texture.field);
      (roughness(low_pass(result.cwiseAbs2())) < m_roughness ? low : high) = gain;
    }
    texture.amplitude = root_mean_square(texture.field);
    limit(error, texture);
    return texture;
  }

  /// Relief of less than a tenth of a spacing cannot be seen but adds to the error, and a place with much more of it
  /// than is missing has another texture.
  bool is_fitting(const Texture& texture) const
  {
    return texture.amplitude > 0.1 * m_spacing && texture.amplitude > 0.4 * texture.own;
  }

private:
  // values, which are yet to be set, with weights of sum 1
  static std::vector<std::pair<double, double> > weighted(const std::vector<double>& weights)
  {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
    std::vector<std::pair<double, double> > result;
    for(double w : weights)
      result.emplace_back(0., w / sum);
    return result;
  }

  static double least_weight() { return 0.3; }

  static double largest_gain() { return 1.75; }

  // Texture cannot be stronger than all that is missing; fake holes that ask for far more are rougher than the hole.
  static void limit(double error, Texture& texture)
  {
    const double largest = 0.9 * error, absurd = 1.4 * error;
    if(texture.amplitude <= largest)
      return;
    const double scale = texture.amplitude < absurd ? largest / texture.amplitude : 0.;
    texture.field *= scale;
    texture.amplitude *= scale;
  }

  // Median over the samples that texture reaches unfaded.
  double roughness(const Eigen::VectorXd& variance) const
  {
    std::vector<std::pair<double, double> > values;
    for(Eigen::Index s : m_inner)
      values.emplace_back(variance[s], 1 / double(m_inner.size()));
    return values.empty() ? 0. : std::sqrt(weighted_quantile(values, 0.5));
  }

  // Local variance of the fine part of each column.
  Eigen::MatrixXd fine_variances(Eigen::MatrixXd fields) const
  {
    for(Eigen::Index k = 0; k < fields.cols(); ++k)
      fields.col(k) = low_pass(fine(fields.col(k)).cwiseAbs2());
    return fields;
  }

  Eigen::VectorXd fine(const Eigen::VectorXd& field) const { return field - low_pass(field); }

  Eigen::VectorXd low_pass(Eigen::VectorXd field) const
  {
    for(int round = 0; round < 6; ++round)
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
  Eigen::VectorXd m_smooth;              // heights of the smooth plan, per sample
  Eigen::VectorXd m_deviation;           // fine relief that the plan misses, per sample
  std::vector<Eigen::Index> m_inner;     // samples that are not near the rim
  double m_roughness = 0;                // fine relief of the fake holes
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_MISSING_TEXTURE_H
