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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_DARTS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_DARTS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_sample.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A place on the base where a point may be put.
struct Base_dart
{
  Vector position = Vector::Zero();
  std::size_t sample = no_index;       ///< the nearest one, `no_index`: off the base
};

/*!
  Places all over the base of a hole in random order, which is always the same, some for each of its samples. Taken one by
  one where there is room, they give blue noise, as most samplings are, of any spacing; the samples themselves are a
  lattice with the spacing of the rim.
*/
template <typename ConcurrencyTag>
class Base_darts
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Relief_sampler<ConcurrencyTag> Sampler;

public:
  /// \param is_wanted per sample of the base: whether there are to be darts around it
  Base_darts(const Patch& patch, const Sampler& sampler, const std::vector<char>& is_wanted)
    : m_patch(patch), m_sampler(sampler)
  {
    std::mt19937 generator(1);
    const auto random = [&]() { return double(generator()) / 4294967296.; };
    for(std::size_t s = 0; s < patch.samples().size(); ++s)
    {
      if(!is_wanted[s])
        continue;
      const Base_sample& sample = patch.samples()[s];
      const Vector u = sample.normal.unitOrthogonal(), v = sample.normal.cross(u);
      for(std::size_t k = 0; k < per_sample; ++k)
      {
        const double r = reach() * std::sqrt(random()), angle = 2 * CGAL_PI * random();
        Base_dart dart;
        dart.position = sample.position + r * (std::cos(angle) * u + std::sin(angle) * v);
        dart.sample = s;
        m_darts.push_back(dart);
      }
    }
    for_each_index<ConcurrencyTag>(m_darts.size(), [&](std::size_t i) { settle(m_darts[i]); });
    m_darts.erase(std::remove_if(m_darts.begin(), m_darts.end(), [](const Base_dart& dart) {
      return dart.sample == no_index; }), m_darts.end());
    for(std::size_t i = m_darts.size(); i > 1; --i)
      std::swap(m_darts[i - 1], m_darts[std::size_t(random() * double(i))]);
  }

  const std::vector<Base_dart>& darts() const { return m_darts; }

private:
  static constexpr std::size_t per_sample = 12;

  // A little more than half way to the samples around.
  double reach() const { return 0.6 * m_patch.spacing(); }

  void settle(Base_dart& dart) const
  {
    const Vector from = m_patch.samples()[dart.sample].position;
    Vector normal;
    dart.sample = no_index;
    if(!m_patch.project(dart.position, normal) || (dart.position - from).norm() > 1.5 * reach())
      return;
    const std::size_t nearest = m_sampler.search().nearest(dart.position).first;
    if(is_between(dart.position, from, nearest))
      dart.sample = nearest;
  }

  // The base may end at an edge, beyond which there is nothing.
  bool is_between(const Vector& x, const Vector& from, std::size_t sample) const
  {
    const double ahead = 1.3 * m_patch.spacing();
    const auto is_ahead = [&](const Vector& y) { return (y - x).dot(x - from) > 0 && (y - x).norm() < ahead; };
    for(std::size_t t : m_sampler.neighbors(sample))
      if(is_ahead(m_patch.samples()[t].position))
        return true;
    const Surface_model<ConcurrencyTag>& model = m_patch.surroundings()->model();
    std::vector<std::size_t> ball;
    model.search().in_ball(x, ahead, ball);
    return std::any_of(ball.begin(), ball.end(), [&](std::size_t i) {
      return is_same_side(model.normal(i), m_patch.samples()[sample].normal) && is_ahead(model.position(i)); });
  }

  const Patch& m_patch;
  const Sampler& m_sampler;
  std::vector<Base_dart> m_darts;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_DARTS_H
