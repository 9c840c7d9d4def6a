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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_FAKE_HOLE_STATISTICS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_FAKE_HOLE_STATISTICS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Error_extrapolation.h>
#include <CGAL/Context_completion_3/internal/Filling_plan.h>
#include <CGAL/Context_completion_3/internal/Place.h>

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
  How well source places match a hole and each other, and what is learnt from those among them that serve as fake holes:
  from which mismatch on a copy is to be believed, and which error a hole of another mismatch has.

  The hole itself is place `target`.
*/
class Fake_hole_statistics
{
public:
  static constexpr std::size_t target = static_cast<std::size_t>(-1);

  /*!
    \param places the source places
    \param coverage of each, the share of the hole in which the source has a surface
    \param mismatch of a place, or the hole, with another place around the hole
    \param radius places that are nearer to each other know each other's truth
    \param spacing of points
    \param may_fill of each place, whether the hole may be filled from it (empty: all may); the others are fake holes
           all the same
  */
  Fake_hole_statistics(const std::vector<Place>& places, const std::vector<double>& coverage,
                       const std::function<double(std::size_t, std::size_t)>& mismatch, double radius, double spacing,
                       const std::vector<char>& may_fill = std::vector<char>())
    : m_mismatch(Eigen::Index(places.size()) + 1, Eigen::Index(places.size())), m_spacing(spacing)
  {
    const std::size_t n = places.size();
    for(std::size_t k = 0; k <= n; ++k)
      for(std::size_t j = 0; j < n; ++j)
        m_mismatch(Eigen::Index(k), Eigen::Index(j)) =
          mismatch(k == n ? target : k, j) + 2 * (std::max)(0., 0.97 - coverage[j]);
    for(std::size_t i = 0; i <= n; ++i)
      m_ranking.push_back(rank(places, i == n ? target : i, radius));
    choose_judges(coverage);
    std::vector<std::size_t>& order = m_ranking.back();
    m_least_mismatch = order.empty() ? 0. : this->mismatch(target, order.front());
    order.erase(std::remove_if(order.begin(), order.end(), [&](std::size_t j)
      { return !may_fill.empty() && !may_fill[j]; }), order.end());
  }

  /// Places by their match to place `k`, without those that overlap it.
  const std::vector<std::size_t>& ranking(std::size_t k) const { return m_ranking[std::size_t(column(k))]; }

  /// Mismatch between the surroundings of two places, 0 perfect, at least 1 hopeless. A place that does not cover the
  /// hole matches worse.
  double mismatch(std::size_t k, std::size_t j) const { return m_mismatch(column(k), Eigen::Index(j)); }

  /// Mismatch of the hole with the best place of all, whether the hole may be filled from it or not.
  double least_mismatch() const { return m_least_mismatch; }

  /// Row of place `k` in matrices of all places and, last, the hole.
  Eigen::Index column(std::size_t k) const { return k == target ? m_mismatch.cols() : Eigen::Index(k); }

  /// The fake holes: the best matching places that are fully there.
  const std::vector<std::size_t>& judges() const { return m_judges; }

  /// Their weights, of sum 1. Worse matches count less.
  const std::vector<double>& weights() const { return m_weights; }

  /// Whether there are enough fake holes to learn from.
  bool is_sufficient() const { return m_judges.size() >= 3; }

  /// Harmonic mean of the mismatches of the best places of `k`.
  double joint_mismatch(std::size_t places, std::size_t k) const
  {
    const std::vector<std::size_t>& order = ranking(k);
    const std::size_t used = (std::min)(places, order.size());
    double inverse = 0;
    for(std::size_t r = 0; r < used; ++r)
      inverse += 1 / (1e-6 + mismatch(k, order[r]));
    return double(used) / inverse;
  }

  /// Weights, of sum 1, of so many best places of the hole: of those that match it as well as the very best does.
  std::vector<double> twins(std::size_t most) const
  {
    const std::vector<std::size_t>& order = ranking(target);
    std::vector<double> weights;
    double total = 0;
    for(std::size_t r = 0; r < most && r < order.size(); ++r)
    {
      const double least = mismatch(target, order.front());
      weights.push_back(std::exp((least - mismatch(target, order[r])) / (0.001 + 0.1 * least)));
      total += weights.back();
    }
    for(double& w : weights)
      w /= total;
    return weights;
  }

  /// Mean of a field over so many best places of `k`; better matches count more.
  /// \param field of a place, a vector
  template <typename Field>
  Eigen::VectorXd mean_over_best(std::size_t places, std::size_t k, const Field& field) const
  {
    const std::vector<std::size_t>& order = ranking(k);
    Eigen::VectorXd sum;
    double total = 0;
    for(std::size_t r = 0; r < places && r < order.size(); ++r)
    {
      const double w = 1 / (0.02 + mismatch(k, order[r]));
      if(r == 0)
        sum = w * field(order[r]);
      else
        sum += w * field(order[r]);
      total += w;
    }
    return sum / total;
  }

  /*!
    The scale of mismatch at which copies of so many places are half believed: what fills the fake holes best, each by
    its own mismatch, relative to what can be had there.

    \param error what a plan misses on a fake hole
    \param errors receives what is reached on them
  */
  Trust learn_trust(std::size_t places, const std::function<double(const Filling_plan&, std::size_t)>& error,
                    std::vector<double>& errors) const
  {
    const double prior = 0.08, smallest = 0.004, largest = 1;
    const int steps = 24;
    std::vector<double> mismatches, ends;
    for(std::size_t k : m_judges)
    {
      mismatches.push_back(joint_mismatch(places, k));
      ends.push_back(0.02 * m_spacing);
      for(double share : {0., 1.})
        ends.back() += error(Filling_plan(places, share), k);
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
        made.push_back(error(Filling_plan(places, trust.share(mismatches[i])), m_judges[i]));
        loss += m_weights[i] * 2 * made.back() / ends[i];
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

  /// Carries errors on the fake holes over to the hole. \param predictor logarithm of what the error grows with, of a
  /// fake hole or the hole \param forecast receives the error to expect
  void extrapolate(const std::vector<double>& errors, const std::function<double(std::size_t)>& predictor,
                   Plan_forecast& forecast) const
  {
    std::vector<double> predictors;
    for(std::size_t k : m_judges)
      predictors.push_back(predictor(k));
    extrapolate_errors(errors, m_weights, predictors, predictor(target), 0.01 * m_spacing, forecast.error,
                       forecast.upper);
  }

  /// What the error of a copy grows with: the mismatch of the places it is made of.
  double copy_predictor(std::size_t places, std::size_t k) const
  {
    return std::log(0.02 * m_spacing + m_spacing * std::sqrt(joint_mismatch(places, k)));
  }

private:
  void choose_judges(const std::vector<double>& coverage)
  {
    for(std::size_t k : ranking(target))
      if(coverage[k] > 0.9 && !m_ranking[k].empty() && m_judges.size() < 16)
        m_judges.push_back(k);
    double total = 0;
    for(std::size_t k : m_judges)
    {
      m_weights.push_back(1 / (0.05 + mismatch(target, k)));
      total += m_weights.back();
    }
    for(double& w : m_weights)
      w /= total;
  }

  std::vector<std::size_t> rank(const std::vector<Place>& places, std::size_t k, double radius) const
  {
    std::vector<std::size_t> order;
    for(std::size_t j = 0; j < places.size(); ++j)
      if(k == target || places[j].source != places[k].source ||
         (places[j].origin - places[k].origin).norm() >= radius)
        order.push_back(j);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b)
      { return mismatch(k, a) < mismatch(k, b); });
    return order;
  }

  Eigen::MatrixXd m_mismatch;                         // (places, the hole last) x places
  double m_spacing;
  double m_least_mismatch = 0;
  std::vector<std::vector<std::size_t> > m_ranking;   // per place, the hole last
  std::vector<std::size_t> m_judges;
  std::vector<double> m_weights;                      // parallel to it
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_FAKE_HOLE_STATISTICS_H
