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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_LEARNED_CONTINUATION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_LEARNED_CONTINUATION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cancellation.h>
#include <CGAL/Context_completion_3/internal/Error_extrapolation.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Height_field.h>
#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Matrix_operations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// What places that are all the same way up teach about a hole.
struct Learned_relief
{
  std::size_t places = 0;                ///< number of them, 0: nothing was learnt
  Eigen::VectorXd heights;               ///< over the base, per sample
  Eigen::MatrixXd misses;                ///< truth minus prediction on fake holes, a column each
  double error = 0;                      ///< expected mean distance to the true surface
  double upper = 0;                      ///< one standard deviation above it
};

/*!
  Continues relief as it goes on elsewhere, where no single place matches: waves of several directions cross each other
  in ever other phases. How the heights inside follow from those around is learnt from hundreds of places of the surface
  itself by ridge regression, so that the hole gets a sum of copies, each with a weight, which may be negative: what is
  common to all places, as directions and lengths of waves, goes on; what is not averages out.

  What is learnt is the difference from a thin plate through the heights around. Some places serve as fake holes: each
  is predicted from those that know nothing of it, as are those of `Copy_forecast`. They choose how strongly the weights
  are damped, and tell the error.
*/
template <typename ConcurrencyTag>
class Learned_continuation
{
  typedef Height_field<ConcurrencyTag> Field;
  typedef typename Field::Heights Heights;
  typedef typename Field::Point_2 Point_2;
  typedef Surface_model<ConcurrencyTag> Model;

public:
  /// \param source the surface to learn from \param radius of the hole \param poll called between stages
  Learned_continuation(const Model& known, const Model& source, const Smooth_patch<ConcurrencyTag>& patch,
                       double radius, const Poll& poll)
    : m_spacing(patch.spacing()), m_radius(radius), m_poll(poll), m_field(known, patch, radius)
  {
    if(!m_field.is_valid() || m_field.around().size() < least_probes)
      return;
    const Heights hole = m_field.of_hole(known);
    if(hole.around_share < least_share())
      return;
    find_places(source);
    if(m_places.size() < least_places)
      return;
    prepare(hole);
    learn();
  }

  const Learned_relief& result() const { return m_result; }

private:
  static constexpr std::size_t least_probes = 12, least_places = 40, most_places = 1000, most_fake_holes = 48,
                               most_points = 20000000;

  static double least_share() { return 0.95; }

  // Distance, in radii, at which two places know nothing of each other's inside.
  static double reach_of_truth() { return 2; }

  struct Example
  {
    Vector origin;
    Heights heights;
  };

  // The nearest places, as many as the probes around call for: as far apart as they may be, because near ones teach
  // alike.
  void find_places(const Model& source)
  {
    const std::size_t wanted = (std::min)(std::size_t(most_places), 4 * m_field.around().size());
    const double nearest = (std::max)(1.5 * m_spacing, 0.1 * m_radius);
    double distance = (std::max)(nearest, 0.3 * m_radius);
    for(int round = 0; round < 3; ++round)
    {
      double share = 0;
      std::vector<Example> found = find_places(source, distance, wanted, share);
      // among nearer ones, of which as many are tried, there may be fewer
      if(found.size() <= m_places.size())
        return;
      m_places.swap(found);
      if(m_places.size() >= wanted || m_places.size() < least_places || share < 0.2 || distance == nearest)
        return;
      distance = (std::max)(nearest, distance * std::sqrt(0.9 * double(m_places.size()) / double(wanted)));
    }
  }

  // \param share receives that of the tried places which can be seen as heights
  std::vector<Example> find_places(const Model& source, double distance, std::size_t wanted, double& share) const
  {
    std::vector<std::pair<double, std::size_t> > order;
    for(std::size_t i : thinned_points(source.points(), distance))
      order.emplace_back((source.position(i) - m_field.middle()).norm(), i);
    std::sort(order.begin(), order.end());
    // nearer ones lack what the hole lacks
    const std::pair<double, std::size_t> first(reach_of_truth() * m_radius, 0);
    order.erase(order.begin(), std::lower_bound(order.begin(), order.end(), first));
    std::vector<Example> result;
    std::size_t tried = 0;
    // holes of a hundred spacings and more learn from fewer, rather than for minutes
    const std::size_t batch = 256, most_tried = (std::min)(3 * most_places, most_points / m_field.size());
    while(tried < order.size() && tried < most_tried && result.size() < wanted)
    {
      m_poll();
      const std::size_t number = (std::min)(batch, (std::min)(order.size(), most_tried) - tried);
      std::vector<Example> examples(number);
      std::vector<char> is_seen(number, 0);
      for_each_index<ConcurrencyTag>(number, [&](std::size_t k)
      {
        std::optional<Heights> heights = m_field.of_place(source, order[tried + k].second, examples[k].origin);
        if(!heights || heights->inside_share < least_share() || heights->around_share < least_share())
          return;
        examples[k].heights = std::move(*heights);
        is_seen[k] = 1;
      });
      for(std::size_t k = 0; k < number && result.size() < wanted; ++k)
        if(is_seen[k])
          result.push_back(std::move(examples[k]));
      tried += number;
      // where the surface bends away from the plane everywhere, most of it would be tried in vain
      if(tried >= 2 * batch && double(result.size()) < 0.05 * double(tried))
        break;
    }
    share = double(result.size()) / double((std::max)(tried, std::size_t(1)));
    return result;
  }

  // The heights without a plane through those around, which is none of the relief.
  void prepare(const Heights& hole)
  {
    const Eigen::Index n = Eigen::Index(m_places.size()), around = hole.around.size(), inside = hole.inside.size();
    m_around.resize(around, n + 1);
    m_inside.resize(inside, n);
    for(Eigen::Index k = 0; k < n; ++k)
    {
      m_around.col(k) = m_places[std::size_t(k)].heights.around;
      m_inside.col(k) = m_places[std::size_t(k)].heights.inside;
    }
    m_around.col(n) = hole.around;
    for(Example& place : m_places)
      place.heights = Heights();
    m_weights.resize(around);
    for(Eigen::Index i = 0; i < around; ++i)
      m_weights[i] = std::exp(-m_field.distance()[std::size_t(i)] / 0.4);
    const Eigen::MatrixXd outer = linear_terms(m_field.around());
    m_linear = linear_terms(m_field.inside());
    Eigen::MatrixXd weighted = outer.transpose();
    for(Eigen::Index i = 0; i < around; ++i)
      for(Eigen::Index k = 0; k < 3; ++k)
        weighted(k, i) *= m_weights[i];
    Eigen::MatrixXd normal = matrix_product(weighted, outer);
    add_to_diagonal(normal, 3, 1e-12 * normal.trace()); // all may be on a line
    m_planes = solve_linear_systems(normal, matrix_product(weighted, m_around));
    m_around -= matrix_product(outer, m_planes);
    m_inside -= matrix_product(m_linear, m_planes.leftCols(n));
  }

  static Eigen::MatrixXd linear_terms(const std::vector<Point_2>& positions)
  {
    Eigen::MatrixXd result(Eigen::Index(positions.size()), 3);
    for(std::size_t i = 0; i < positions.size(); ++i)
    {
      result(Eigen::Index(i), 0) = 1;
      result(Eigen::Index(i), 1) = positions[i].x();
      result(Eigen::Index(i), 2) = positions[i].y();
    }
    return result;
  }

  void learn()
  {
    const Eigen::Index n = m_inside.cols();
    Eigen::MatrixXd seen = m_around;
    const double all_weights = m_weights.norm();
    for(Eigen::Index k = 0; k < seen.cols(); ++k)
      for(Eigen::Index i = 0; i < seen.rows(); ++i)
        seen(i, k) = m_weights[i] * seen(i, k) / all_weights;
    const Eigen::MatrixXd products = matrix_product(seen.transpose(), seen);
    // places of more relief do not weigh more
    Eigen::VectorXd scale(n), relief(n + 1), likeness_to_hole(n);
    for(Eigen::Index k = 0; k <= n; ++k)
      relief[k] = std::sqrt(products(k, k));
    for(Eigen::Index k = 0; k < n; ++k)
      scale[k] = 1 / std::sqrt(products(k, k) + 1e-4 * m_spacing * m_spacing);
    Eigen::MatrixXd likeness(n, n);
    for(Eigen::Index k = 0; k < n; ++k)
    {
      for(Eigen::Index i = 0; i < n; ++i)
        likeness(i, k) = scale[i] * products(i, k) * scale[k];
      likeness_to_hole[k] = scale[k] * products(k, n);
    }
    std::vector<Eigen::Index> fake_holes;
    for(Eigen::Index i = 0; i < Eigen::Index(most_fake_holes); ++i)
      if(fake_holes.empty() || fake_holes.back() < i * n / Eigen::Index(most_fake_holes))
        fake_holes.push_back(i * n / Eigen::Index(most_fake_holes));
    std::vector<Eigen::MatrixXd> plates, differences;
    for(const Eigen::MatrixXd& plate : thin_plates({1e-4, 1e-2}))
    {
      plates.push_back(matrix_product(plate, m_around));
      differences.push_back(m_inside);
      for(Eigen::Index k = 0; k < n; ++k)
        for(Eigen::Index i = 0; i < m_inside.rows(); ++i)
          differences.back()(i, k) = (m_inside(i, k) - plates.back()(i, k)) * scale[k];
    }
    double least = 0;
    Eigen::VectorXd errors;
    for(double damping : {1e-4, 1e-3, 1e-2, 1e-1, 1., 10.})
    {
      m_poll();
      Eigen::MatrixXd inverse = likeness;
      add_to_diagonal(inverse, n, damping);
      inverse = inverse_matrix(inverse);
      Eigen::MatrixXd weights(n, Eigen::Index(fake_holes.size()));
      for_each_index<ConcurrencyTag>(fake_holes.size(), [&](std::size_t i)
        { weights.col(Eigen::Index(i)) = left_out(inverse, fake_holes[i]) / scale[fake_holes[i]]; });
      for(std::size_t p = 0; p < plates.size(); ++p)
      {
        const Eigen::MatrixXd misses = matrix_product(differences[p], weights);
        Eigen::VectorXd made(misses.cols());
        double loss = 0;
        for(Eigen::Index k = 0; k < made.size(); ++k)
        {
          made[k] = mean_absolute_value(misses.col(k));
          loss += std::log(made[k] + floor()) / double(made.size());
        }
        if(m_result.places > 0 && loss >= least)
          continue;
        least = loss;
        errors = made;
        m_result.places = std::size_t(n);
        m_result.misses = misses;
        m_result.heights = plates[p].col(n);
        m_result.heights += matrix_vector_product(differences[p], matrix_vector_product(inverse, likeness_to_hole));
        m_result.heights += matrix_vector_product(m_linear, m_planes.col(n));
      }
    }
    m_result.heights = m_field.over_base(m_result.heights);
    forecast(errors, fake_holes, relief);
  }

  // The weights, of all places, that give what a fake hole differs from its prediction by the places that know nothing
  // of it (block cross-validation from one inverse).
  Eigen::VectorXd left_out(const Eigen::MatrixXd& inverse, Eigen::Index fake_hole) const
  {
    std::vector<Eigen::Index> block;
    Eigen::Index own = 0;
    const Vector origin = m_places[std::size_t(fake_hole)].origin;
    for(Eigen::Index k = 0; k < inverse.rows(); ++k)
      if((m_places[std::size_t(k)].origin - origin).norm() < reach_of_truth() * m_radius)
      {
        if(k == fake_hole)
          own = Eigen::Index(block.size());
        block.push_back(k);
      }
    const Eigen::Index size = Eigen::Index(block.size());
    Eigen::MatrixXd columns(inverse.rows(), size), inner(size, size);
    for(Eigen::Index a = 0; a < size; ++a)
    {
      columns.col(a) = inverse.col(block[std::size_t(a)]);
      for(Eigen::Index b = 0; b < size; ++b)
        inner(a, b) = inverse(block[std::size_t(a)], block[std::size_t(b)]);
    }
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(size);
    unit[own] = 1;
    return matrix_vector_product(columns, solve_linear_system(inner, unit));
  }

  // Cubic radial functions through the heights around, which have some noise: operators from those to the heights
  // inside.
  std::vector<Eigen::MatrixXd> thin_plates(const std::vector<double>& noises) const
  {
    const std::vector<Point_2>& centers = m_field.around();
    const Eigen::Index n = Eigen::Index(centers.size());
    const auto kernel = [](const Point_2& p, const Point_2& q) {
      const double r = (p - q).norm();
      return r * r * r; };
    const auto basis = [&](const std::vector<Point_2>& positions)
    {
      Eigen::MatrixXd result(Eigen::Index(positions.size()), n + 3);
      for(Eigen::Index i = 0; i < result.rows(); ++i)
        for(Eigen::Index k = 0; k < n; ++k)
          result(i, k) = kernel(positions[std::size_t(i)], centers[std::size_t(k)]);
      result.rightCols(3) = linear_terms(positions);
      return result;
    };
    Eigen::MatrixXd exact = Eigen::MatrixXd::Zero(n + 3, n + 3);
    exact.topRows(n) = basis(centers);
    for(Eigen::Index k = 0; k < n; ++k)
      for(Eigen::Index l = n; l < n + 3; ++l)
        exact(l, k) = exact(k, l);
    const Eigen::MatrixXd inside = basis(m_field.inside()).transpose();
    std::vector<Eigen::MatrixXd> result;
    for(double noise : noises)
    {
      Eigen::MatrixXd system = exact;
      add_to_diagonal(system, n, noise);
      const Eigen::MatrixXd weights = solve_linear_systems(system, inside).transpose();
      result.push_back(weights.leftCols(n));
    }
    return result;
  }

  // errors grow with the relief around
  void forecast(const Eigen::VectorXd& errors, const std::vector<Eigen::Index>& fake_holes,
                const Eigen::VectorXd& relief)
  {
    std::vector<double> made, predictors;
    for(Eigen::Index i = 0; i < errors.size(); ++i)
    {
      made.push_back(errors[i]);
      predictors.push_back(std::log(relief[fake_holes[std::size_t(i)]] + floor()));
    }
    extrapolate_errors(made, std::vector<double>(made.size(), 1 / double(made.size())), predictors,
                       std::log(relief[relief.size() - 1] + floor()), floor(), m_result.error, m_result.upper);
  }

  double floor() const { return 0.01 * m_spacing; }

  double m_spacing, m_radius;
  Poll m_poll;
  Field m_field;
  std::vector<Example> m_places;
  Eigen::MatrixXd m_around;              // heights at probes, a column per place, and the hole
  Eigen::MatrixXd m_inside;              // heights at samples, a column per place
  Eigen::VectorXd m_weights;             // of probes
  Eigen::MatrixXd m_linear, m_planes;    // terms of a plane at samples, and their coefficients for places and hole
  Learned_relief m_result;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_LEARNED_CONTINUATION_H
