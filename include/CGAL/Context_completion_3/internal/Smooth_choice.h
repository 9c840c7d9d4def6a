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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SMOOTH_CHOICE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SMOOTH_CHOICE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_family.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Fake_hole_statistics.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>

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
  The smooth base of a hole and of all fake holes, as a mixture of the members of a family, which are weighted by what
  they reach on the fake holes or, where there are too few of those, on sectors of the surroundings.
*/
template <typename ConcurrencyTag>
class Smooth_choice
{
  typedef Base_family<ConcurrencyTag> Family;

public:
  /*!
    \param rim, rim_by_normals data of the known surface, a column per place, that of the hole last: by fits to
      positions, and by fits that use normals, too
    \param floor errors below are alike
    \param radius of the hole
    \param loss mean logarithm, over the fake holes, of the error of heights, a column per place
  */
  Smooth_choice(const Family& family, const Eigen::MatrixXd& rim, const Eigen::MatrixXd& rim_by_normals,
                const Fake_hole_statistics& statistics, const Ingredients& ingredients, double floor, double radius,
                const std::function<double(const Eigen::MatrixXd&)>& loss)
  {
    const bool has_fake_holes = statistics.is_sufficient() && ingredients.fake_holes;
    std::vector<Eigen::MatrixXd> heights(family.size());
    std::vector<double> errors(family.size(), 0.);
    for_each_index<ConcurrencyTag>(family.size(), [&](std::size_t m)
    {
      heights[m] = family.heights(m, family.uses_normals(m) ? rim_by_normals : rim);
      errors[m] = std::exp(loss(heights[m]));
    });
    const double doubt = doubt_of_normals(family.inclination(rim, rim_by_normals), statistics);
    std::vector<double> sector_errors = family.sector_errors();
    for(std::size_t m = 0; m < family.size(); ++m)
    {
      if(family.uses_normals(m))
        errors[m] *= doubt;
      if(family.is_kriging(m) && !ingredients.kriging)
        errors[m] = sector_errors[m] = 1e3 * radius;
    }
    const std::vector<double> weights = has_fake_holes ? family.weights(errors, floor, 8)
                                                       : family.weights(sector_errors, floor, 4);
    m_heights = family.combine(heights, weights);
    for(std::size_t m = 0; m < weights.size(); ++m)
      m_sector_error += weights[m] * sector_errors[m];
  }

  /// A column per place, that of the hole last.
  const Eigen::MatrixXd& heights() const { return m_heights; }

  /// What the chosen members miss of sectors of the surroundings.
  double sector_error() const { return m_sector_error; }

private:
  // At least 1. Normals that were estimated around the hole, or are those of a mesh with that hole, lean at its rim. The
  // fake holes had none when their normals were made, and praise normals without knowing. But there fits with and without
  // normals differ less, and what normals tell is as much worse here as they differ more.
  static double doubt_of_normals(const Eigen::VectorXd& inclination, const Fake_hole_statistics& statistics)
  {
    const double least = 0.001;
    double usual = 0;
    for(std::size_t i = 0; i < statistics.judges().size(); ++i)
      usual += statistics.weights()[i] * std::log(inclination[statistics.column(statistics.judges()[i])] + least);
    return (std::max)(1., (inclination[statistics.column(Fake_hole_statistics::target)] + least) / std::exp(usual));
  }

  Eigen::MatrixXd m_heights;
  double m_sector_error = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SMOOTH_CHOICE_H
