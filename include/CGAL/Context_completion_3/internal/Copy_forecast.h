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
#include <CGAL/Context_completion_3/internal/Place_relief.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A way to fill a hole: the smooth base, plus a share of what the best places have over it.
struct Filling_plan
{
  std::size_t places = 0;    ///< so many best places are averaged; 0: smooth
  double share = 0;          ///< of their relief that is added
};

/// A plan and its error on the fake holes.
struct Plan_forecast
{
  Filling_plan plan;
  double error = 0;          ///< expected mean distance to the true surface
  double upper = 0;          ///< one standard deviation above it
};

/*!
  Copy or smooth, and how: decided by fake holes. Each of the best matching source places is taken for a hole of the same
  outline; all plans fill it from the other places; the truth is known there. What fills the fake holes best fills the
  hole, and the error made there is the error to expect.

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
                const std::vector<Place_relief>& reliefs, double radius)
    : m_patch(patch), m_places(places), m_reliefs(reliefs), m_radius(radius), m_sector_error(family.sector_error())
  {
    // the hole is the last column: nothing but the known surface
    const std::size_t n = places.size();
    Eigen::MatrixXd rim = Eigen::MatrixXd::Zero(4 * Eigen::Index(patch.centers().size()), Eigen::Index(n) + 1);
    for(std::size_t c = 0; c < n; ++c)
      rim.col(Eigen::Index(c)) = reliefs[c].rim;
    m_smooth = family.smooth(rim);
    m_membrane = family.membrane(rim);
    m_roughness = family.roughness(rim);
    m_mismatch = Eigen::MatrixXd::Zero(Eigen::Index(n) + 1, Eigen::Index(n));
    for(std::size_t k = 0; k <= n; ++k)
      for(std::size_t j = 0; j < n; ++j)
        m_mismatch(Eigen::Index(k), Eigen::Index(j)) = measure_mismatch(k == n ? target : k, j);
    for(std::size_t i = 0; i < n; ++i)
      m_ranking.push_back(rank(i));
    m_ranking.push_back(rank(target));
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
    const std::vector<std::size_t> judges = fake_holes();
    std::vector<Plan_forecast> result;
    for(const Filling_plan& plan : plans())
    {
      Plan_forecast forecast;
      forecast.plan = plan;
      if(judges.size() >= 3)
        extrapolate(judges, plan, forecast);
      else if(plan.places > 0)
        continue;
      else
      {
        forecast.error = 1.3 * m_sector_error;
        forecast.upper = 2 * m_sector_error;
      }
      result.push_back(forecast);
    }
    return result;
  }

private:
  static std::vector<Filling_plan> plans()
  {
    std::vector<Filling_plan> all(1);
    for(std::size_t places : {1, 2, 4, 8})
      for(double share : {1., 0.7})
      {
        Filling_plan plan;
        plan.places = places;
        plan.share = share;
        all.push_back(plan);
      }
    return all;
  }

  // Places that serve as fake holes: the best matching ones that are fully there.
  std::vector<std::size_t> fake_holes() const
  {
    std::vector<std::size_t> result;
    for(std::size_t k : ranking())
      if(m_reliefs[k].coverage > 0.9 && !m_ranking[k].empty() && result.size() < 16)
        result.push_back(k);
    return result;
  }

  // Fake holes differ from the hole: another one may be rougher around, or have found better examples. The errors made
  // there are carried to the hole along a power law, errors of the smooth base with the roughness of the surroundings,
  // errors of a copy with the mismatch (see `predictor()`); its exponent is fitted, with 1 as the prior.
  void extrapolate(const std::vector<std::size_t>& judges, const Filling_plan& plan, Plan_forecast& forecast) const
  {
    const double floor = 0.01 * m_patch.spacing();
    std::vector<double> x, y, w;
    double total = 0, mean_x = 0, mean_y = 0;
    for(std::size_t k : judges)
    {
      x.push_back(predictor(plan, k));
      y.push_back(std::log(fake_error(plan, k) + floor));
      w.push_back(1 / (0.05 + match(k)));
      total += w.back();
      mean_x += w.back() * x.back();
      mean_y += w.back() * y.back();
    }
    mean_x /= total;
    mean_y /= total;
    double xx = 0, xy = 0;
    for(std::size_t i = 0; i < x.size(); ++i)
    {
      xx += w[i] / total * (x[i] - mean_x) * (x[i] - mean_x);
      xy += w[i] / total * (x[i] - mean_x) * (y[i] - mean_y);
    }
    const double prior = 1, strength = 0.1;
    const double slope = (std::max)(0., (std::min)(1., (xy + strength * prior) / (xx + strength)));
    const double step = (std::max)(-1.5, (std::min)(1.5, predictor(plan, target) - mean_x));
    double spread = 0;
    for(std::size_t i = 0; i < x.size(); ++i)
    {
      const double d = y[i] - mean_y - slope * (x[i] - mean_x);
      spread += w[i] / total * d * d;
    }
    const double center = mean_y + slope * step;
    forecast.error = std::exp(center) - floor;
    forecast.upper = std::exp(center + std::sqrt(spread + 0.04)) - floor;
  }

  double predictor(const Filling_plan& plan, std::size_t k) const
  {
    const double h = m_patch.spacing();
    if(plan.places == 0)
      return std::log(0.02 * h + m_roughness[column(k)]);
    return std::log(0.02 * h + h * std::sqrt(joint_mismatch(plan, k)));
  }

  double joint_mismatch(const Filling_plan& plan, std::size_t k) const
  {
    const std::vector<std::size_t>& order = m_ranking[std::size_t(column(k))];
    const std::size_t used = (std::min)(plan.places, order.size());
    double inverse = 0;
    for(std::size_t r = 0; r < used; ++r)
      inverse += 1 / (1e-6 + mismatch(k, order[r]));
    return double(used) / inverse;
  }

  double fake_error(const Filling_plan& plan, std::size_t k) const
  {
    const Eigen::VectorXd prediction = predict(plan, k);
    double sum = 0;
    std::size_t count = 0;
    for(Eigen::Index s = 0; s < prediction.size(); ++s)
      if(m_reliefs[k].is_covered[std::size_t(s)])
      {
        sum += (std::min)(std::abs(prediction[s] - m_reliefs[k].height[s]), 0.3 * m_radius);
        ++count;
      }
    return count > 0 ? sum / double(count) : 0.3 * m_radius;
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
      Eigen::Vector4d d = m_reliefs[j].rim.template segment<4>(4 * Eigen::Index(i));
      if(k != target)
        d -= m_reliefs[k].rim.template segment<4>(4 * Eigen::Index(i));
      const double w = std::exp(-m_patch.centers()[i].distance / (0.4 * m_radius));
      const double value = d[0] / tau, slope = d.template tail<3>().norm();
      sum += w * ((std::min)(1., value * value) + kappa * (std::min)(1., slope * slope / 2));
      total += w;
    }
    return sum / total + 2 * (std::max)(0., 0.97 - m_reliefs[j].coverage);
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
  double m_sector_error;
  Eigen::MatrixXd m_smooth, m_membrane;               // samples x places, the hole last
  Eigen::VectorXd m_roughness;                        // per place, the hole last
  Eigen::MatrixXd m_mismatch;                         // (places, the hole last) x places
  std::vector<std::vector<std::size_t> > m_ranking;   // per place, the hole last
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_COPY_FORECAST_H
