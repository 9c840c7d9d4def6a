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
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A way to fill a hole: a smooth base, plus the relief of the best places over their own base.
struct Filling_plan
{
  std::size_t base = 0;      ///< member of the family that continues base or displacement
  std::size_t places = 0;    ///< so many best places are averaged; 0: smooth
  double share = 1;          ///< of their relief that is added
};

/// A plan and its error on the fake holes.
struct Plan_forecast
{
  Filling_plan plan;
  double error = 0;          ///< mean distance, weighted mean over the fake holes
  double upper = 0;          ///< its upper quartile
};

/*!
  Copy or smooth, and how: decided by fake holes. Each of the best matching source places is taken for a hole of the same
  outline; all plans fill it from the other places; the truth is known there. What fills the fake holes best fills the
  hole, and the error made there is the error to expect.
*/
template <typename ConcurrencyTag>
class Copy_forecast
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

public:
  static constexpr std::size_t target = static_cast<std::size_t>(-1); ///< the hole itself among the places

  Copy_forecast(const Patch& patch, const Base_family<ConcurrencyTag>& family, const std::vector<Place>& places,
                const std::vector<Place_relief>& reliefs, double radius)
    : m_patch(patch), m_family(family), m_places(places), m_reliefs(reliefs), m_radius(radius)
  {
    const Eigen::Index k = Eigen::Index(places.size());
    if(k == 0)
      return;
    Eigen::MatrixXd rim(reliefs[0].rim.size(), k);
    for(Eigen::Index c = 0; c < k; ++c)
      rim.col(c) = reliefs[std::size_t(c)].rim;
    for(std::size_t m = 0; m < family.size(); ++m)
      m_spread.push_back(family.spread(m, rim));
    for(std::size_t i = 0; i < places.size(); ++i)
      m_ranking.push_back(ranking(i));
    m_target_ranking = ranking(target);
  }

  /// The places by how well they match the hole around it.
  const std::vector<std::size_t>& ranking() const { return m_target_ranking; }

  /// Mismatch between the surroundings of a place and of the hole, 0 perfect, at least 1 hopeless.
  double match(std::size_t place) const { return mismatch(target, place); }

  /// Heights over the samples of the base that a plan gives in the hole.
  Eigen::VectorXd heights(const Filling_plan& plan) const { return predict(plan, target); }

  /// Displacement that carries place `j` into the hole by member `m` of the family.
  Eigen::VectorXd warp(std::size_t m, std::size_t j) const { return -m_spread[m].col(Eigen::Index(j)); }

  /// All plans with their forecasts, the best first; none if there are too few places to judge by.
  std::vector<Plan_forecast> forecasts() const
  {
    const std::vector<std::size_t> judges = fake_holes();
    std::vector<Plan_forecast> result;
    if(judges.size() < 2)
      return result;
    for(const Filling_plan& plan : plans())
    {
      std::vector<double> errors;
      double sum = 0, total = 0;
      for(std::size_t k : judges)
      {
        const double e = fake_error(plan, k);
        const double w = 1 / (0.05 + mismatch(target, k));
        errors.push_back(e);
        sum += w * e;
        total += w;
      }
      std::sort(errors.begin(), errors.end());
      Plan_forecast forecast;
      forecast.plan = plan;
      forecast.error = sum / total;
      forecast.upper = errors[(3 * errors.size()) / 4];
      result.push_back(forecast);
    }
    std::stable_sort(result.begin(), result.end(), [](const Plan_forecast& a, const Plan_forecast& b)
      { return a.error < b.error; });
    return result;
  }

  std::string describe(const Filling_plan& plan) const
  {
    std::string text = m_family.name(plan.base);
    if(plan.places > 0)
      text += ", " + std::to_string(plan.places) + " places, share " + std::to_string(plan.share).substr(0, 4);
    return text;
  }

private:
  std::vector<Filling_plan> plans() const
  {
    std::vector<Filling_plan> all;
    for(std::size_t m = 0; m < m_family.size(); ++m)
    {
      if(m_family.is_base(m))
        all.push_back(plan(m, 0, 1));
      for(std::size_t n : {1, 2, 4, 8})
      {
        all.push_back(plan(m, n, 1));
        if(m_family.is_base(m))
          all.push_back(plan(m, n, 0.6));
      }
    }
    return all;
  }

  static Filling_plan plan(std::size_t base, std::size_t places, double share)
  {
    Filling_plan p;
    p.base = base;
    p.places = places;
    p.share = share;
    return p;
  }

  // Places that serve as fake holes: the best matching ones that are fully there.
  std::vector<std::size_t> fake_holes() const
  {
    std::vector<std::size_t> result;
    for(std::size_t k : m_target_ranking)
      if(m_reliefs[k].coverage > 0.9 && !m_ranking[k].empty() && result.size() < 10)
        result.push_back(k);
    return result;
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
    const std::vector<std::size_t>& order = k == target ? m_target_ranking : m_ranking[k];
    const Eigen::MatrixXd& spread = m_spread[plan.base];
    const Eigen::Index n = spread.rows();
    Eigen::VectorXd own = Eigen::VectorXd::Zero(n);      // what the rim of the hole itself continues to
    if(k != target)
      own = spread.col(Eigen::Index(k));
    Eigen::VectorXd relief = Eigen::VectorXd::Zero(n);
    const std::size_t used = (std::min)(plan.places, order.size());
    double total = 0;
    for(std::size_t r = 0; r < used; ++r)
    {
      const std::size_t j = order[r];
      const double w = 1 / (0.02 + mismatch(k, j));
      relief += w * (m_reliefs[j].height - spread.col(Eigen::Index(j)));
      total += w;
    }
    if(used > 0)
      relief /= total;
    if(!m_family.is_base(plan.base))
      return own + relief;
    const Eigen::VectorXd& offset = m_family.offset(plan.base);
    if(used == 0)
      return own + offset;
    return own + offset + plan.share * (relief - offset);
  }

  double mismatch(std::size_t k, std::size_t j) const
  {
    const double tau = 2 * m_patch.spacing(), kappa = 0.5;
    double sum = 0, total = 0;
    for(std::size_t i = 0; i < m_patch.centers().size(); ++i)
    {
      Eigen::Vector4d d = m_reliefs[j].rim.segment<4>(4 * Eigen::Index(i));
      if(k != target)
        d -= m_reliefs[k].rim.segment<4>(4 * Eigen::Index(i));
      const double w = std::exp(-m_patch.centers()[i].distance / (0.4 * m_radius));
      const double value = d[0] / tau, slope = d.tail<3>().norm();
      sum += w * ((std::min)(1., value * value) + kappa * (std::min)(1., slope * slope / 2));
      total += w;
    }
    return sum / total + 2 * (std::max)(0., 0.97 - m_reliefs[j].coverage);
  }

  // Other places by their match to place `k`; a place that overlaps it would know the truth.
  std::vector<std::size_t> ranking(std::size_t k) const
  {
    std::vector<std::size_t> order;
    std::vector<double> value(m_places.size(), 0.);
    for(std::size_t j = 0; j < m_places.size(); ++j)
    {
      if(k != target && m_places[j].source == m_places[k].source &&
         (m_places[j].origin - m_places[k].origin).norm() < m_radius)
        continue;
      value[j] = mismatch(k, j);
      order.push_back(j);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value[a] < value[b]; });
    return order;
  }

  const Patch& m_patch;
  const Base_family<ConcurrencyTag>& m_family;
  const std::vector<Place>& m_places;
  const std::vector<Place_relief>& m_reliefs;
  double m_radius;
  std::vector<Eigen::MatrixXd> m_spread;                // per member: samples x places
  std::vector<std::vector<std::size_t> > m_ranking;
  std::vector<std::size_t> m_target_ranking;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_COPY_FORECAST_H
