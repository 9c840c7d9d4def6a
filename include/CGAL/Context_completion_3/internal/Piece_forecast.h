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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PIECE_FORECAST_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PIECE_FORECAST_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Fake_hole_statistics.h>
#include <CGAL/Context_completion_3/internal/Hole_piece.h>
#include <CGAL/Context_completion_3/internal/Matrix_operations.h>
#include <CGAL/Context_completion_3/internal/Polyharmonic_base.h>
#include <CGAL/Context_completion_3/internal/Rim_mismatch.h>

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
  Copies for a piece of a hole, and their forecasts on fake pieces: as `Copy_forecast`, but all that is known is a part
  of the rim and what has been filled before. On the fake pieces no more is known, so that the forecast is honest.
*/
template <typename ConcurrencyTag>
class Piece_forecast
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

public:
  static constexpr std::size_t target = Fake_hole_statistics::target;

  /*!
    \param heights of the hole, per sample of its base
    \param reliefs of the places, at least around the piece
    \param ingredients whether several places may be averaged and are warped
  */
  Piece_forecast(const Patch& patch, const Hole_piece& piece, const Piece_controls& controls,
                 const Eigen::VectorXd& heights, const std::vector<Place>& places,
                 const std::vector<Place_relief>& reliefs, const Ingredients& ingredients)
    : m_patch(patch), m_piece(piece), m_controls(controls), m_heights(heights), m_reliefs(reliefs),
      m_ingredients(ingredients), m_statistics(places, coverages(), mismatch(), piece.radius, patch.spacing())
  {
    prepare_membrane();
  }

  /// The places by how well they match around the piece.
  const std::vector<std::size_t>& ranking() const { return m_statistics.ranking(target); }

  /// The best plan that copies and is to be believed; its plan has no places if there is none.
  Plan_forecast best() const
  {
    Plan_forecast result;
    if(!m_statistics.is_sufficient())
      return result;
    for(std::size_t places : {1, 2, 4})
    {
      if(places > 1 && !m_ingredients.averaging)
        break;
      Plan_forecast forecast;
      forecast.plan.places = places;
      std::vector<double> errors;
      const Trust trust = m_statistics.learn_trust(
        places, [&](const Filling_plan& plan, std::size_t k) { return fake_error(plan, k); }, errors);
      forecast.plan.share = trust.share(m_statistics.joint_mismatch(places, target));
      m_statistics.extrapolate(errors, [&](std::size_t k) { return m_statistics.copy_predictor(places, k); },
                                forecast);
      if(forecast.belief() > 0 && (result.plan.places == 0 || forecast.error < result.error))
        result = forecast;
    }
    return result;
  }

  /// Heights that so many places give, parallel to the samples of the piece.
  Eigen::VectorXd copy(std::size_t places) const { return predict(Filling_plan(places, 1), target); }

  /// Displacement that fits place `j` to the controls, parallel to the samples of the piece.
  Eigen::VectorXd fitting(std::size_t j) const
  {
    return m_membrane.col(m_statistics.column(target)) - m_membrane.col(Eigen::Index(j));
  }

private:
  // share of the piece in which each place has a surface
  std::vector<double> coverages() const
  {
    std::vector<double> result;
    for(const Place_relief& relief : m_reliefs)
    {
      double covered = 0, total = 0;
      for(std::size_t i = 0; i < m_piece.samples.size(); ++i)
      {
        covered += relief.is_covered[m_piece.samples[i]] ? m_piece.weights[i] : 0;
        total += m_piece.weights[i];
      }
      result.push_back(covered / total);
    }
    return result;
  }

  std::function<double(std::size_t, std::size_t)> mismatch() const
  {
    return [this](std::size_t k, std::size_t j)
    {
      Rim_mismatch result(m_patch.spacing());
      result.add_centers(k == target ? nullptr : &m_reliefs[k], m_reliefs[j], m_controls.centers);
      for(std::size_t s : m_controls.settled)
      {
        const Eigen::Index i = Eigen::Index(s);
        result.add_height((k == target ? m_heights : m_reliefs[k].height)[i] - m_reliefs[j].height[i], 0.5);
      }
      return result.mean();
    };
  }

  // Continues the values at the controls, of the places and of the hole, over the piece.
  void prepare_membrane()
  {
    m_membrane = Eigen::MatrixXd::Zero(Eigen::Index(m_piece.samples.size()), Eigen::Index(m_reliefs.size()) + 1);
    if(!m_ingredients.warp)
      return;
    const Eigen::Index n = Eigen::Index(m_reliefs.size()), rim = Eigen::Index(m_controls.rim.size());
    std::vector<Vector> positions;
    for(std::size_t i : m_controls.rim)
      positions.push_back(m_patch.centers()[i].position);
    for(std::size_t s : m_controls.settled)
      positions.push_back(m_patch.samples()[s].position);
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(Eigen::Index(positions.size()), n + 1);
    for(Eigen::Index k = 0; k <= n; ++k)
    {
      for(Eigen::Index i = 0; k < n && i < rim; ++i)
        values(i, k) = m_reliefs[std::size_t(k)].rim[4 * Eigen::Index(m_controls.rim[std::size_t(i)])];
      for(Eigen::Index i = rim; i < values.rows(); ++i)
        values(i, k) = (k == n ? m_heights : m_reliefs[std::size_t(k)].height)
          [Eigen::Index(m_controls.settled[std::size_t(i - rim)])];
    }
    const Membrane membrane(positions, m_piece.radius);
    Eigen::MatrixXd basis(Eigen::Index(m_piece.samples.size()), Eigen::Index(positions.size()) + 1);
    Eigen::RowVectorXd row;
    for(std::size_t i = 0; i < m_piece.samples.size(); ++i)
    {
      membrane.basis(m_patch.samples()[m_piece.samples[i]].position, row);
      basis.row(Eigen::Index(i)) = row;
    }
    m_membrane = matrix_product(basis, membrane.solve(values));
  }

  double fake_error(const Filling_plan& plan, std::size_t k) const
  {
    const Eigen::VectorXd prediction = predict(plan, k);
    const double limit = 0.3 * m_piece.radius;
    double sum = 0, total = 0;
    for(std::size_t i = 0; i < m_piece.samples.size(); ++i)
      if(m_reliefs[k].is_covered[m_piece.samples[i]])
      {
        const double miss = prediction[Eigen::Index(i)] - m_reliefs[k].height[Eigen::Index(m_piece.samples[i])];
        sum += m_piece.weights[i] * (std::min)(std::abs(miss), limit);
        total += m_piece.weights[i];
      }
    return total > 0 ? sum / total : limit;
  }

  // parallel to the samples of the piece
  Eigen::VectorXd predict(const Filling_plan& plan, std::size_t k) const
  {
    const Eigen::VectorXd smooth = m_membrane.col(m_statistics.column(k));
    if(m_statistics.ranking(k).empty())
      return smooth;
    return smooth + plan.share * m_statistics.mean_over_best(plan.places, k, [&](std::size_t j)
    {
      Eigen::VectorXd relief = -m_membrane.col(Eigen::Index(j));
      for(std::size_t i = 0; i < m_piece.samples.size(); ++i)
        relief[Eigen::Index(i)] += m_reliefs[j].height[Eigen::Index(m_piece.samples[i])];
      return relief;
    });
  }

  const Patch& m_patch;
  Hole_piece m_piece;
  Piece_controls m_controls;
  Eigen::VectorXd m_heights;
  std::vector<Place_relief> m_reliefs;
  Ingredients m_ingredients;
  Fake_hole_statistics m_statistics;
  Eigen::MatrixXd m_membrane;            // samples of the piece x places, the hole last
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PIECE_FORECAST_H
