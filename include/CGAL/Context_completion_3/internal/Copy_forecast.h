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
#include <CGAL/Context_completion_3/internal/Fake_hole_statistics.h>
#include <CGAL/Context_completion_3/internal/Filling_plan.h>
#include <CGAL/Context_completion_3/internal/Learned_continuation.h>
#include <CGAL/Context_completion_3/internal/Matrix_operations.h>
#include <CGAL/Context_completion_3/internal/Place_facets.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Rim_membrane.h>
#include <CGAL/Context_completion_3/internal/Rim_mismatch.h>
#include <CGAL/Context_completion_3/internal/Rim_warps.h>
#include <CGAL/Context_completion_3/internal/Smooth_choice.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Copy or smooth, and how: decided by fake holes. Each of the best matching source places is taken for a hole of the
  same outline; all plans fill it from the other places; the truth is known there. What fills the fake holes best fills
  the hole, and the error made there is the error to expect.

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
  typedef Rim_warps<ConcurrencyTag> Warps;

public:
  static constexpr std::size_t target = Fake_hole_statistics::target;

  /// \param facets if sharp edges go into the hole, or null
  Copy_forecast(const Patch& patch, const Base_family<ConcurrencyTag>& family, const std::vector<Place>& places,
                const std::vector<Place_relief>& reliefs, double radius, const Ingredients& ingredients,
                const Place_facets<ConcurrencyTag>* facets = nullptr)
    : m_patch(patch), m_reliefs(reliefs), m_radius(radius), m_ingredients(ingredients),
      m_statistics(places, values<double>(reliefs, &Place_relief::coverage), mismatch(), radius, patch.spacing(),
                   values<char>(reliefs, &Place_relief::may_fill))
  {
    // the hole is the last column: nothing but the known surface
    const std::size_t n = places.size();
    Eigen::MatrixXd rim = Eigen::MatrixXd::Zero(4 * Eigen::Index(patch.centers().size()), Eigen::Index(n) + 1);
    Eigen::MatrixXd rim_by_normals = rim;
    for(std::size_t c = 0; c < n; ++c)
    {
      rim.col(Eigen::Index(c)) = reliefs[c].rim;
      rim_by_normals.col(Eigen::Index(c)) = reliefs[c].rim_by_normals;
    }
    rim_by_normals.col(Eigen::Index(n)) = family.known_by_normals();
    m_roughness = family.roughness(rim);
    const Smooth_choice<ConcurrencyTag> choice(family, rim, rim_by_normals, m_statistics, ingredients,
                                               smallest_error() * patch.spacing(), radius,
                                               [&](const Eigen::MatrixXd& heights) { return loss(heights); });
    m_smooth = choice.heights();
    m_sector_error = choice.sector_error();
    if(facets != nullptr)
      m_facet_points = facets->take_over(m_smooth, places, m_statistics, ingredients.fake_holes,
                                         [&](const Eigen::MatrixXd& heights) { return loss(heights); });
    choose_warps(family.membrane(), family.rim_values(rim));
  }

  /// Lets what many places teach take the place of the smooth continuation of the hole.
  void learn(const Learned_relief& learned)
  {
    m_learned = learned;
    m_smooth.col(m_statistics.column(target)) = learned.heights;
  }

  /// The places by how well they match the hole around it.
  const std::vector<std::size_t>& ranking() const { return m_statistics.ranking(target); }

  /// Mismatch between the surroundings of a place and of the hole, 0 perfect, at least 1 hopeless.
  double match(std::size_t place) const { return m_statistics.mismatch(target, place); }

  /// The least one over all places, also those that the hole is not to be filled from.
  double least_mismatch() const { return m_statistics.least_mismatch(); }

  /// Whether there are enough fake holes to learn from.
  bool has_fake_holes() const { return m_statistics.is_sufficient(); }

  /// Points on the facets that the smooth plan is made of; none if it is not.
  const Surface_points& facet_points() const { return m_facet_points; }

  /// Heights over the samples of the base that a plan gives in the hole.
  Eigen::VectorXd heights(const Filling_plan& plan) const { return predict(plan, target); }

  /// Displacement that fits the best place to the rim.
  Eigen::VectorXd fitting() const { return m_warps.of(m_statistics, target, ranking().front()); }

  /// All plans with their forecasts, the smooth one first.
  std::vector<Plan_forecast> forecasts() const
  {
    std::vector<Plan_forecast> result(1);
    if(!m_statistics.is_sufficient())
    {
      // A sector is close to what it is predicted from, a hole is not, and one that is like no other place of the shape
      // is where edges meet: generated cases miss 3 to 17 times as much.
      result[0].error = 1.3 * m_sector_error;
      result[0].upper = 10 * m_sector_error;
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
    if(is_learned(result[0].plan))
    {
      result[0].error = m_learned.error;
      result[0].upper = m_learned.upper;
    }
    else
    {
      for(std::size_t k : m_statistics.judges())
        errors.push_back(fake_error(Filling_plan(), k));
      extrapolate(errors, result[0]);
    }
    for(std::size_t places : {std::size_t(1), std::size_t(2), std::size_t(4), most_places})
    {
      if(places > 1 && !m_ingredients.averaging)
        break;
      Plan_forecast forecast;
      forecast.plan.places = places;
      const Trust trust = m_statistics.learn_trust(
        places, [&](const Filling_plan& plan, std::size_t k) { return fake_error(plan, k); }, errors);
      forecast.plan.share = trust.share(m_statistics.joint_mismatch(places, target));
      // a mean of two surfaces with sharp edges has them twice
      if(forecast.plan.share < least_share() || (m_facet_points.size() > 0 && !forecast.plan.is_whole()))
        continue;
      extrapolate(errors, forecast);
      result.push_back(forecast);
    }
    contradict(result);
    return result;
  }

  /// What a plan misses on fake holes: difference of the true heights from it, a column per fake hole.
  Eigen::MatrixXd misses(const Filling_plan& plan) const
  {
    if(is_learned(plan))
      return m_learned.misses;
    const std::vector<std::size_t>& judges = m_statistics.judges();
    Eigen::MatrixXd result(m_smooth.rows(), Eigen::Index(judges.size()));
    for(std::size_t i = 0; i < judges.size(); ++i)
      result.col(Eigen::Index(i)) = m_reliefs[judges[i]].height - predict(plan, judges[i]);
    return result;
  }

  /// The error of a plan, sample by sample: it varies as on the fake holes, its mean is that of the forecast.
  Eigen::VectorXd errors(const Plan_forecast& forecast) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(m_smooth.rows(), forecast.error);
    if(!m_statistics.is_sufficient())
      return result;
    const Eigen::MatrixXd missed = misses(forecast.plan).cwiseAbs();
    const std::vector<double> weights = weights_of_misses(forecast.plan);
    Eigen::VectorXd mean = Eigen::VectorXd::Constant(m_smooth.rows(), 1e-300);
    for(std::size_t i = 0; i < weights.size(); ++i)
      mean += weights[i] * missed.col(Eigen::Index(i)).cwiseMin(0.3 * m_radius);
    return mean * (forecast.error / mean.mean());
  }

  /// Weights of the fake holes that `misses()` tells of, of sum 1.
  std::vector<double> weights_of_misses(const Filling_plan& plan) const
  {
    if(!is_learned(plan))
      return m_statistics.weights();
    return std::vector<double>(std::size_t(m_learned.misses.cols()), 1 / double(m_learned.misses.cols()));
  }

  /// The same for the texture of the hole: less where the surroundings of a fake hole are smoother or rougher than those
  /// of the hole. The sum is below 1, and the smaller, the less the fake holes are like it.
  std::vector<double> weights_by_roughness(const Filling_plan& plan) const
  {
    std::vector<double> result = weights_of_misses(plan);
    for(std::size_t i = 0; i < result.size() && !is_learned(plan); ++i)
      result[i] *= std::exp(-0.5 * std::pow(std::log(relative_roughness(m_statistics.judges()[i])) / 0.4, 2));
    return result;
  }

private:
  static constexpr std::size_t most_places = 8;        // of a plan

  static double least_share() { return 0.15; }

  bool is_learned(const Filling_plan& plan) const { return plan.places == 0 && m_learned.places > 0; }

  // In spacings: errors below are alike.
  static double smallest_error() { return 0.005; }

  template <typename Value, typename Member>
  static std::vector<Value> values(const std::vector<Place_relief>& reliefs, Member Place_relief::* member)
  {
    std::vector<Value> result;
    for(const Place_relief& relief : reliefs)
      result.push_back(relief.*member);
    return result;
  }

  // Whether what a copy misses at the rim goes on into the hole, is partly noise of the local fits there, or nothing but
  // that, the fake holes tell.
  void choose_warps(const Rim_membrane& membrane, const Eigen::MatrixXd& rim)
  {
    std::vector<typename Warps::Spread> spreads;
    if(m_ingredients.warp)
      spreads.push_back([&](const Eigen::VectorXd& missed) { return membrane.interpolated(missed); });
    if(m_ingredients.warp && m_ingredients.fake_holes
       && Warps::is_missed_alike(m_statistics, rim, smallest_error() * m_patch.spacing()))
      spreads.push_back([&](const Eigen::VectorXd& missed) { return membrane.smoothed(missed); });
    if(spreads.size() != 1)
      spreads.push_back([&](const Eigen::VectorXd&) -> Eigen::VectorXd { return Eigen::VectorXd::Zero(m_smooth.rows()); });
    m_warps = Warps::of_least_loss(m_statistics, rim, most_places, spreads, [&](const Warps& warps)
    {
      m_warps = warps;
      return loss_of_whole_copies();
    });
  }

  // Mean logarithm over the fake holes of an error there: one that is quite different must not decide.
  double mean_log(const std::function<double(std::size_t)>& error_of) const
  {
    double loss = 0;
    for(std::size_t i = 0; i < m_statistics.judges().size(); ++i)
      loss += m_statistics.weights()[i] * std::log(error_of(m_statistics.judges()[i]) + smallest_error() * m_patch.spacing());
    return loss;
  }

  // of what the best place of each fake hole makes of it
  double loss_of_whole_copies() const
  {
    return mean_log([&](std::size_t k) { return fake_error(Filling_plan(1, 1), k); });
  }

  // of heights, a column per place
  double loss(const Eigen::MatrixXd& heights) const
  {
    return mean_log([&](std::size_t k) { return error(heights.col(m_statistics.column(k)), k); });
  }

  // the heights of place `j`, which is among the best ones of `k`, there
  Eigen::VectorXd carried(std::size_t k, std::size_t j) const { return m_reliefs[j].height + m_warps.of(m_statistics, k, j); }

  // A copy that is to be believed and the smooth base cannot both be right where they differ. A feature that the rim
  // does not show is known from its twin alone; the smooth base did well on fake holes without one. And twins that
  // differ from each other by more than they forecast cannot all be right: a plane matches planes with and without a
  // feature alike. Which of them the hole is like is open then, for copies and for the smooth base.
  void contradict(std::vector<Plan_forecast>& forecasts) const
  {
    std::size_t best = 0;
    for(std::size_t i = 1; i < forecasts.size(); ++i)
      if(best == 0 || forecasts[i].error < forecasts[best].error)
        best = i;
    const double belief = forecasts[best].belief();
    if(belief == 0)
      return;
    const Eigen::VectorXd smooth = m_smooth.col(m_statistics.column(target));
    double difference = mean_absolute_value(predict(forecasts[best].plan, target) - smooth);
    if(distance_from_twins(forecasts[best].plan) > 2 * forecasts[best].error + 0.05 * m_patch.spacing())
    {
      difference = distance_from_twins(Filling_plan());
      for(Plan_forecast& forecast : forecasts)
        if(forecast.belief() > 0)
          raise(forecast, (std::max)(forecast.error, forecast.belief() * distance_from_twins(forecast.plan)));
    }
    raise(forecasts[0], std::hypot(forecasts[0].error, belief * difference));
  }

  static void raise(Plan_forecast& forecast, double error)
  {
    forecast.error = error;
    forecast.upper = (std::max)(forecast.upper, error);
  }

  // Of a plan, taken for whole: mean over the places that match the hole as well as the best one.
  double distance_from_twins(const Filling_plan& plan) const
  {
    const Eigen::VectorXd heights = predict(Filling_plan(plan.places, 1), target);
    const std::vector<double> weights = m_statistics.twins(most_places);
    double sum = 0;
    for(std::size_t r = 0; r < weights.size(); ++r)
      sum += weights[r] * mean_absolute_value(heights - carried(target, ranking()[r]));
    return sum;
  }

  // Errors of the smooth base grow with the roughness of the surroundings, those of a copy with the mismatch.
  void extrapolate(const std::vector<double>& errors, Plan_forecast& forecast) const
  {
    const std::size_t places = forecast.plan.places;
    m_statistics.extrapolate(errors, [&](std::size_t k) {
      return places > 0 ? m_statistics.copy_predictor(places, k)
                        : std::log(0.02 * m_patch.spacing() + m_roughness[m_statistics.column(k)]); }, forecast);
  }

  // of the surroundings of place `k`, to those of the hole
  double relative_roughness(std::size_t k) const
  {
    const double smallest = smallest_error() * m_patch.spacing();
    return (m_roughness[m_statistics.column(k)] + smallest) / (m_roughness[m_statistics.column(target)] + smallest);
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
    const Eigen::VectorXd smooth = m_smooth.col(m_statistics.column(k));
    if(plan.places == 0 || m_statistics.ranking(k).empty())
      return smooth;
    const Eigen::VectorXd copy = m_statistics.mean_over_best(plan.places, k, [&](std::size_t j) -> Eigen::VectorXd
      { return carried(k, j); });
    return smooth + plan.share * (copy - smooth);
  }

  std::function<double(std::size_t, std::size_t)> mismatch() const
  {
    std::vector<double> weights;
    for(const Base_center& c : m_patch.centers())
      weights.push_back(std::exp(-c.distance / (0.4 * m_radius)));
    return [=](std::size_t k, std::size_t j)
    {
      Rim_mismatch result(m_patch.spacing());
      result.add_centers(k == target ? nullptr : &m_reliefs[k], m_reliefs[j], weights);
      return result.mean();
    };
  }

  const Patch& m_patch;
  std::vector<Place_relief> m_reliefs;
  double m_radius;
  Ingredients m_ingredients;
  double m_sector_error = 0;
  Fake_hole_statistics m_statistics;
  Surface_points m_facet_points;                      // if the smooth base is made of facets
  Eigen::MatrixXd m_smooth;                           // samples x places, the hole last
  Warps m_warps;
  Learned_relief m_learned;
  Eigen::VectorXd m_roughness;                        // per place, the hole last
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_COPY_FORECAST_H
