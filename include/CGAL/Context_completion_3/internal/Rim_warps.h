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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_WARPS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_WARPS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Fake_hole_statistics.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Matrix_operations.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Displacements that fit the best places of the hole, and of each fake hole, to its rim.
template <typename ConcurrencyTag>
class Rim_warps
{
public:
  /// Spreads what is missed at the rim over the samples of the base.
  typedef std::function<Eigen::VectorXd(const Eigen::VectorXd&)> Spread;

  Rim_warps() {}

  /*!
    \param statistics which places are the best ones, and which serve as fake holes
    \param rim values at the rim, a column per place, that of the hole last
    \param number of best places that are fitted
  */
  Rim_warps(const Fake_hole_statistics& statistics, const Eigen::MatrixXd& rim, std::size_t number, const Spread& spread)
    : m_warps(std::size_t(rim.cols()))
  {
    std::vector<std::size_t> holes = statistics.judges();
    holes.push_back(Fake_hole_statistics::target);
    for_each_index<ConcurrencyTag>(holes.size(), [&](std::size_t i)
    {
      const Eigen::Index k = statistics.column(holes[i]);
      const std::vector<std::size_t>& order = statistics.ranking(holes[i]);
      for(std::size_t r = 0; r < order.size() && r < number; ++r)
        m_warps[std::size_t(k)].push_back(spread(rim.col(k) - rim.col(Eigen::Index(order[r]))));
    });
  }

  /// Those by one of several spreads; of two that are as good, by the first.
  /// \param loss what copies lose with some warps
  static Rim_warps of_least_loss(const Fake_hole_statistics& statistics, const Eigen::MatrixXd& rim, std::size_t number,
                                 const std::vector<Spread>& spreads, const std::function<double(const Rim_warps&)>& loss)
  {
    Rim_warps best(statistics, rim, number, spreads.front());
    if(spreads.size() == 1)
      return best;
    double least = loss(best);
    for(std::size_t i = 1; i < spreads.size(); ++i)
    {
      Rim_warps other(statistics, rim, number, spreads[i]);
      const double other_loss = loss(other);
      if(other_loss < least)
      {
        least = other_loss;
        best = std::move(other);
      }
    }
    return best;
  }

  /// Of place `j`, which is among the best ones of `k`, there.
  const Eigen::VectorXd& of(const Fake_hole_statistics& statistics, std::size_t k, std::size_t j) const
  {
    const std::vector<std::size_t>& order = statistics.ranking(k);
    return m_warps[std::size_t(statistics.column(k))]
                  [std::size_t(std::find(order.begin(), order.end(), j) - order.begin())];
  }

  /// Whether the best place misses at the rim of the hole what best places miss at those of the fake holes. If it misses
  /// more, the fake holes have counterparts and the hole has not: what is noise there is misfit here.
  /// \param floor values below are alike
  static bool is_missed_alike(const Fake_hole_statistics& statistics, const Eigen::MatrixXd& rim, double floor)
  {
    const auto missed = [&](std::size_t k)
    {
      const Eigen::Index best = Eigen::Index(statistics.ranking(k).front());
      return std::log(mean_absolute_value(rim.col(statistics.column(k)) - rim.col(best)) + floor);
    };
    if(!statistics.is_sufficient())
      return false;
    double usual = 0;
    for(std::size_t i = 0; i < statistics.judges().size(); ++i)
      usual += statistics.weights()[i] * missed(statistics.judges()[i]);
    return missed(Fake_hole_statistics::target) < usual + std::log(2.);
  }

private:
  std::vector<std::vector<Eigen::VectorXd> > m_warps; // per place, the hole last: parallel to its ranking
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_WARPS_H
