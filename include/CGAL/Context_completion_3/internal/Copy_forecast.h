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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_COPY_FORECAST_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_COPY_FORECAST_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_family.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Filling_plan.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>

#include <CGAL/for_each.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Copy or smooth, and how: decided by fake holes. Each of the best matching source places is taken for a hole of the same
  outline; all plans fill it from the other places; the truth is known there. What fills the fake holes best fills the
  hole, and the error made there is the error to expect.

  How much of a copy to believe depends on how well its surroundings match: all of it at no mismatch, nothing of a bad
  match. Where the one turns into the other is learnt from the fake holes (`Trust`), so a hole whose twin was found is
  filled from the twin even if the fake holes have none.

  The hole itself is place `target`. All places are seen as heights over the one base of the hole, so a fake hole costs
  no more than a few sums.
*/
template <typename ConcurrencyTag>
class Copy_forecast
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

public:
  static constexpr std::size_t target = static_cast<std::size_t>(-1);

  Copy_forecast(const Patch& patch, const Base_family<ConcurrencyTag>& family, const std::vector<Place>& places,
                const std::vector<Place_relief>& reliefs, double radius, const Ingredients& ingredients)
    : m_patch(patch), m_places(places), m_reliefs(reliefs), m_radius(radius), m_ingredients(ingredients)
  {
    // the hole is the last column: nothing but the known surface
    const std::size_t n = places.size();
    Eigen::MatrixXd rim = Eigen::MatrixXd::Zero(4 * Eigen::Index(patch.centers().size()), Eigen::Index(n) + 1);
    for(std::size_t c = 0; c < n; ++c)
      rim.col(Eigen::Index(c)) = reliefs[c].rim;
    m_membrane = family.membrane(rim);
    if(!m_ingredients.warp)
      m_membrane.setZero();
    m_roughness = family.roughness(rim);
    m_mismatch = Eigen::MatrixXd::Zero(Eigen::Index(n) + 1, Eigen::Index(n));
    for(std::size_t k = 0; k <= n; ++k)
      for(std::size_t j = 0; j < n; ++j)
        m_mismatch(Eigen::Index(k), Eigen::Index(j)) = measure_mismatch(k == n ? target : k, j);
    for(std::size_t i = 0; i < n; ++i)
      m_ranking.push_back(rank(i));
    m_ranking.push_back(rank(target));
    choose_judges();
    combine_bases(family, rim);
  }

  /// The places by how well they match the hole around it.
  const std::vector<std::size_t>& ranking() const { return m_ranking.back(); }

  /// Mismatch between the surroundings of a place and of the hole, 0 perfect, at least 1 hopeless.
  double match(std::size_t place) const { return mismatch(target, place); }

  /// Heights over the samples of the base that a plan gives in the hole.
  Eigen::VectorXd heights(const Filling_plan& plan) const { return predict(plan, target); }

  /// Displacement that fits place `j` to the rim.
  Eigen::VectorXd fitting(std::size_t j) const { return -m_membrane.col(Eigen::Index(j)); }

  /// All plans with their forecasts, the smooth one first.
  std::vector<Plan_forecast> forecasts() const
  {
    std::vector<Plan_forecast> result(1);
    if(m_judges.size() < fewest_judges())
    {
      result[0].error = 1.3 * m_sector_error;
      result[0].upper = 2 * m_sector_error;
      return result;
    }
    if(!m_ingredients.fake_holes)
    {
      result[0].error = result[0].upper = m_sector_error;
      result.push_back(result[0]);
      result[1].plan = Filling_plan(1, 1);
      result[1].error = 0.5 * m_sector_error;
      return result;
    }
    std::vector<double> errors;
    for(std::size_t k : m_judges)
      errors.push_back(fake_error(Filling_plan(), k));
    extrapolate(errors, result[0]);
    for(std::size_t places : {1, 2, 4, 8})
    {
      if(places > 1 && !m_ingredients.averaging)
        break;
      Plan_forecast forecast;
      forecast.plan.places = places;
      const Trust trust = learn_trust(places, errors);
      forecast.plan.share = trust.share(joint_mismatch(places, target));
      if(forecast.plan.share < least_share())
        continue;
      extrapolate(errors, forecast);
      result.push_back(forecast);
    }
    contradict(result);
    return result;
  }

  /// What a plan misses on the fake holes: difference of the true heights from it, a column per fake hole.
  Eigen::MatrixXd misses(const Filling_plan& plan) const
  {
    Eigen::MatrixXd result(m_smooth.rows(), Eigen::Index(m_judges.size()));
    for(std::size_t i = 0; i < m_judges.size(); ++i)
      result.col(Eigen::Index(i)) = m_reliefs[m_judges[i]].height - predict(plan, m_judges[i]);
    return result;
  }

  /// Weights of the fake holes, of sum 1.
  const std::vector<double>& judge_weights() const { return m_judge_weights; }

private:
  static std::size_t fewest_judges() { return 3; }
  static double least_share() { return 0.15; }

  // Places that serve as fake holes: the best matching ones that are fully there. Worse matches count less.
  void choose_judges()
  {
    for(std::size_t k : ranking())
      if(m_reliefs[k].coverage > 0.9 && !m_ranking[k].empty() && m_judges.size() < 16)
        m_judges.push_back(k);
    double total = 0;
    for(std::size_t k : m_judges)
    {
      m_judge_weights.push_back(1 / (0.05 + match(k)));
      total += m_judge_weights.back();
    }
    for(double& w : m_judge_weights)
      w /= total;
  }

  // The smooth base of the hole and of all fake holes.
  void combine_bases(const Base_family<ConcurrencyTag>& family, const Eigen::MatrixXd& rim)
  {
    const double floor = 0.005 * m_patch.spacing();
    std::vector<Eigen::MatrixXd> heights(family.size());
    std::vector<double> errors(family.size(), 0.);
    std::vector<std::size_t> indices;
    for(std::size_t m = 0; m < family.size(); ++m)
      indices.push_back(m);
    CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t m) -> bool
    {
      heights[m] = family.heights(m, rim);
      for(std::size_t i = 0; i < m_judges.size(); ++i)
        errors[m] += m_judge_weights[i] * std::log(error(heights[m].col(column(m_judges[i])), m_judges[i]) + floor);
      errors[m] = std::exp(errors[m]);
      return true;
    });
    std::vector<double> sector_errors = family.sector_errors();
    for(std::size_t m = 0; m < family.size(); ++m)
      if(family.is_kriging(m) && !m_ingredients.kriging)
        errors[m] = sector_errors[m] = 1e3 * m_radius;
    // the geometric mean over the fake holes: one that is quite different must not decide
    const std::vector<double> weights = m_judges.size() < fewest_judges() || !m_ingredients.fake_holes
      ? family.weights(sector_errors, floor, 4) : family.weights(errors, floor, 8);
    m_smooth = family.combine(heights, weights);
    m_sector_error = 0;
    for(std::size_t m = 0; m < weights.size(); ++m)
      m_sector_error += weights[m] * sector_errors[m];
  }

  // The scale of mismatch at which copies of so many places are half believed: what fills the fake holes best, each by
  // its own mismatch,
  // relative to what can be had there. `errors` receives what is reached on them.
  Trust learn_trust(std::size_t places, std::vector<double>& errors) const
  {
    const double prior = 0.08, smallest = 0.004, largest = 1;
    const int steps = 24;
    std::vector<double> mismatches, ends;
    for(std::size_t k : m_judges)
    {
      mismatches.push_back(joint_mismatch(places, k));
      ends.push_back(0.02 * m_patch.spacing());
      for(double share : {0., 1.})
        ends.back() += fake_error(Filling_plan(places, share), k);
    }
    Trust best;
    double least = 0;
    for(int step = 0; step < steps; ++step)
    {
      Trust trust;
      trust.scale = smallest * std::pow(largest / smallest, step / double(steps - 1));
      const double from_prior = std::log(trust.scale / prior);
      double loss = 0.01 * from_prior * from_prior;
      std::vector<double> made;
      for(std::size_t i = 0; i < m_judges.size(); ++i)
      {
        made.push_back(fake_error(Filling_plan(places, trust.share(mismatches[i])), m_judges[i]));
        loss += m_judge_weights[i] * 2 * made.back() / ends[i];
      }
      if(step == 0 || loss < least)
      {
        least = loss;
        best = trust;
        errors = made;
      }
    }
    return best;
  }

  // A copy that is to be believed and the smooth base cannot both be right where they differ. A feature that the rim does
  // not show is known from its twin alone; the smooth base did well on fake holes without one.
  void contradict(std::vector<Plan_forecast>& forecasts) const
  {
    std::size_t best = 0;
    for(std::size_t i = 1; i < forecasts.size(); ++i)
      if(best == 0 || forecasts[i].error < forecasts[best].error)
        best = i;
    const double belief = forecasts[best].belief();
    if(belief == 0)
      return;
    const Eigen::VectorXd difference = predict(forecasts[best].plan, target) - m_smooth.col(column(target));
    forecasts[0].error = std::hypot(forecasts[0].error, belief * difference.cwiseAbs().mean());
    forecasts[0].upper = (std::max)(forecasts[0].upper, forecasts[0].error);
  }

  // Fake holes differ from the hole: another one may be rougher around, or have found better examples. The errors made
  // there are carried to the hole along a power law, errors of the smooth base with the roughness of the surroundings,
  // errors of a copy with the mismatch (see `predictor()`); its exponent is fitted, with 1 as the prior.
  void extrapolate(const std::vector<double>& errors, Plan_forecast& forecast) const
  {
    const double floor = 0.01 * m_patch.spacing();
    const std::vector<double>& w = m_judge_weights;
    std::vector<double> x, y;
    double mean_x = 0, mean_y = 0;
    for(std::size_t i = 0; i < m_judges.size(); ++i)
    {
      x.push_back(predictor(forecast.plan, m_judges[i]));
      y.push_back(std::log(errors[i] + floor));
      mean_x += w[i] * x.back();
      mean_y += w[i] * y.back();
    }
    double xx = 0, xy = 0;
    for(std::size_t i = 0; i < x.size(); ++i)
    {
      xx += w[i] * (x[i] - mean_x) * (x[i] - mean_x);
      xy += w[i] * (x[i] - mean_x) * (y[i] - mean_y);
    }
    const double prior = 1, strength = 0.1;
    const double slope = (std::max)(0., (std::min)(1., (xy + strength * prior) / (xx + strength)));
    const double step = (std::max)(-1.5, (std::min)(1.5, predictor(forecast.plan, target) - mean_x));
    double spread = 0;
    for(std::size_t i = 0; i < x.size(); ++i)
    {
      const double d = y[i] - mean_y - slope * (x[i] - mean_x);
      spread += w[i] * d * d;
    }
    const double center = mean_y + slope * step;
    forecast.error = (std::max)(0., std::exp(center) - floor);
    // a standard deviation, and a quarter for what fake holes cannot show, by generated cases of known truth
    forecast.upper = 1.25 * std::exp(center + std::sqrt(spread + 0.06)) - floor;
  }

  double predictor(const Filling_plan& plan, std::size_t k) const
  {
    const double h = m_patch.spacing();
    if(plan.places == 0)
      return std::log(0.02 * h + m_roughness[column(k)]);
    return std::log(0.02 * h + h * std::sqrt(joint_mismatch(plan.places, k)));
  }

  double joint_mismatch(std::size_t places, std::size_t k) const
  {
    const std::vector<std::size_t>& order = m_ranking[std::size_t(column(k))];
    const std::size_t used = (std::min)(places, order.size());
    double inverse = 0;
    for(std::size_t r = 0; r < used; ++r)
      inverse += 1 / (1e-6 + mismatch(k, order[r]));
    return double(used) / inverse;
  }

  double fake_error(const Filling_plan& plan, std::size_t k) const { return error(predict(plan, k), k); }

  // mean distance of predicted heights from place `k`
  double error(const Eigen::VectorXd& prediction, std::size_t k) const
  {
    const double limit = 0.3 * m_radius;
    double sum = 0;
    std::size_t count = 0;
    for(Eigen::Index s = 0; s < prediction.size(); ++s)
      if(m_reliefs[k].is_covered[std::size_t(s)])
      {
        sum += (std::min)(std::abs(prediction[s] - m_reliefs[k].height[s]), limit);
        ++count;
      }
    return count > 0 ? sum / double(count) : limit;
  }

  Eigen::VectorXd predict(const Filling_plan& plan, std::size_t k) const
  {
    const std::vector<std::size_t>& order = m_ranking[std::size_t(column(k))];
    const std::size_t used = (std::min)(plan.places, order.size());
    const Eigen::VectorXd smooth = m_smooth.col(column(k));
    if(used == 0)
      return smooth;
    Eigen::VectorXd copy = Eigen::VectorXd::Zero(smooth.size());
    double total = 0;
    for(std::size_t r = 0; r < used; ++r)
    {
      const std::size_t j = order[r];
      const double w = 1 / (0.02 + mismatch(k, j));
      copy += w * (m_reliefs[j].height - m_membrane.col(Eigen::Index(j)));
      total += w;
    }
    copy = copy / total + m_membrane.col(column(k));
    return smooth + plan.share * (copy - smooth);
  }

  Eigen::Index column(std::size_t k) const { return Eigen::Index(k == target ? m_places.size() : k); }

  double mismatch(std::size_t k, std::size_t j) const { return m_mismatch(column(k), Eigen::Index(j)); }

  double measure_mismatch(std::size_t k, std::size_t j) const
  {
    const double tau = 2 * m_patch.spacing(), kappa = 0.5;
    double sum = 0, total = 0;
    for(std::size_t i = 0; i < m_patch.centers().size(); ++i)
    {
      const double w = std::exp(-m_patch.centers()[i].distance / (0.4 * m_radius));
      const bool is_found = m_reliefs[j].is_found[i] != 0, is_expected = k == target || m_reliefs[k].is_found[i] != 0;
      if(is_found != is_expected) // a wall that only one of them has is as bad as can be
      {
        sum += (1 + kappa) * w;
        total += w;
      }
      if(!is_found || !is_expected)
        continue;
      Eigen::Vector4d d = m_reliefs[j].rim.template segment<4>(4 * Eigen::Index(i));
      if(k != target)
        d -= m_reliefs[k].rim.template segment<4>(4 * Eigen::Index(i));
      const double value = d[0] / tau, slope = d.template tail<3>().norm();
      sum += w * ((std::min)(1., value * value) + kappa * (std::min)(1., slope * slope / 2));
      total += w;
    }
    return (total > 0 ? sum / total : 1 + kappa) + 2 * (std::max)(0., 0.97 - m_reliefs[j].coverage);
  }

  // Other places by their match to place `k`; a place that overlaps it would know the truth.
  std::vector<std::size_t> rank(std::size_t k) const
  {
    std::vector<std::size_t> order;
    for(std::size_t j = 0; j < m_places.size(); ++j)
      if(k == target || m_places[j].source != m_places[k].source ||
         (m_places[j].origin - m_places[k].origin).norm() >= m_radius)
        order.push_back(j);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b)
      { return mismatch(k, a) < mismatch(k, b); });
    return order;
  }

  const Patch& m_patch;
  std::vector<Place> m_places;
  std::vector<Place_relief> m_reliefs;
  double m_radius;
  Ingredients m_ingredients;
  double m_sector_error = 0;
  std::vector<std::size_t> m_judges;                  // fake holes
  std::vector<double> m_judge_weights;                // parallel to it, of sum 1
  Eigen::MatrixXd m_smooth, m_membrane;               // samples x places, the hole last
  Eigen::VectorXd m_roughness;                        // per place, the hole last
  Eigen::MatrixXd m_mismatch;                         // (places, the hole last) x places
  std::vector<std::vector<std::size_t> > m_ranking;   // per place, the hole last
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_COPY_FORECAST_H
