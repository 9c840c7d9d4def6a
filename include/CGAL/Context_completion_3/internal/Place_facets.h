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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_FACETS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_FACETS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Example_source.h>
#include <CGAL/Context_completion_3/internal/Facet_continuation.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Place.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <CGAL/number_utils.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A surface over the samples of a base.
struct Faceted_relief
{
  Eigen::VectorXd height;             ///< per sample
  std::vector<char> is_found;         ///< per sample
  std::vector<Vector> normal;         ///< per sample, where it is found
  double share = 0;                   ///< of samples where it is found

  bool is_complete() const { return share > 0.9; }
};

/// Continues the facets around a hole, and those around its source places as if each had that hole, over the samples of
/// the base.
template <typename ConcurrencyTag>
class Place_facets
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Example_source<ConcurrencyTag> Source;

public:
  Place_facets(const Model& known, const Patch& patch, const Relief_sampler<ConcurrencyTag>& sampler,
               const std::vector<Source>& sources)
    : m_patch(patch), m_sampler(sampler), m_sources(sources)
  {
    for(const Band_point& b : patch.band())
    {
      m_band.push_back(known.position(b.index), known.normal(b.index));
      m_distance.push_back(b.distance);
    }
    m_own = std::make_unique<Facet_continuation>(m_band, m_distance, patch.area_spacing(), patch.scale());
    if(m_own->is_sharp())
      m_search = std::make_unique<Neighbor_search>(m_band.position);
  }

  /// Whether sharp edges go into the hole.
  bool is_sharp() const { return m_own->is_sharp(); }

  /// The facets around the hole. \param guess heights, per sample: of several surfaces the nearest is taken
  Faceted_relief own_relief(const Eigen::VectorXd& guess) const { return relief(*m_own, guess); }

  /// The facets around a place, without what it has in the hole.
  Faceted_relief relief(const Place& place, const Eigen::VectorXd& guess) const
  {
    const Model& model = *m_sources[place.source].model;
    std::vector<std::size_t> indices;
    m_sampler.points_around(place, m_distance.back(), indices);
    Surface_points points;
    std::vector<double> distance;
    for(std::size_t i : indices)
    {
      const Vector x = place.motion(model.position(i)), n = place.motion.normal(model.normal(i));
      // what lies where the surroundings of the hole are
      const Neighbor_search::Neighbor nearest = m_search->nearest(x);
      if(nearest.second > 3 * m_patch.spacing() || !is_same_side(n, m_band.normal[nearest.first]))
        continue;
      points.push_back(x, n);
      distance.push_back(m_distance[nearest.first]);
    }
    return relief(Facet_continuation(points, distance, m_patch.area_spacing(), m_patch.scale()), guess);
  }

  /// Mean error of the facets in the prediction of six sectors of the surroundings from the others.
  double sector_error() const
  {
    Vector middle = Vector::Zero(), axis = Vector::Zero();
    for(const Base_sample& s : m_patch.samples())
    {
      middle += s.position;
      axis += s.normal;
    }
    middle /= double(m_patch.samples().size());
    axis = axis.norm() > 0 ? axis.normalized() : Vector(Vector::UnitZ());
    const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
    const std::size_t sectors = 6;
    std::vector<std::size_t> sector_of;
    for(const Vector& p : m_band.position)
    {
      const double turn = std::atan2((p - middle).dot(v), (p - middle).dot(u)) / (2 * CGAL_PI) + 0.5;
      sector_of.push_back((std::min)(sectors - 1, std::size_t(double(sectors) * turn)));
    }
    const double limit = 0.3 * m_patch.scale();
    double sum = 0;
    std::size_t count = 0;
    for(std::size_t sector = 0; sector < sectors; ++sector)
    {
      Surface_points others;
      std::vector<double> distance;
      for(std::size_t i = 0; i < m_band.size(); ++i)
        if(sector_of[i] != sector)
        {
          others.push_back(m_band.position[i], m_band.normal[i]);
          distance.push_back(m_distance[i]);
        }
      const Facet_continuation facets(others, distance, m_patch.area_spacing(), m_patch.scale());
      for(std::size_t i = 0; i < m_band.size(); ++i)
        if(sector_of[i] == sector && m_distance[i] < 0.35 * m_patch.scale())
        {
          double height = limit;
          Vector normal;
          if(!facets.find(m_band.position[i], m_band.normal[i], 0, limit, height, normal))
            height = limit;
          sum += std::abs(height);
          ++count;
        }
    }
    return count > 0 ? sum / double(count) : limit;
  }

private:
  Faceted_relief relief(const Facet_continuation& facets, const Eigen::VectorXd& guess) const
  {
    const std::vector<Base_sample>& samples = m_patch.samples();
    Faceted_relief result;
    result.height = guess;
    result.is_found.assign(samples.size(), 0);
    result.normal.assign(samples.size(), Vector::Zero());
    std::size_t found = 0;
    for(std::size_t s = 0; s < samples.size(); ++s)
    {
      double& height = result.height[Eigen::Index(s)];
      if(!facets.find(samples[s].position, samples[s].normal, height, m_sampler.height_limit(), height, result.normal[s]))
        continue;
      result.is_found[s] = 1;
      ++found;
    }
    result.share = samples.empty() ? 0. : double(found) / double(samples.size());
    return result;
  }

  const Patch& m_patch;
  const Relief_sampler<ConcurrencyTag>& m_sampler;
  const std::vector<Source>& m_sources;
  Surface_points m_band;                        // known points around the hole
  std::vector<double> m_distance;               // of those to the rim
  std::unique_ptr<Facet_continuation> m_own;
  std::unique_ptr<Neighbor_search> m_search;    // of the band, if the facets are sharp
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_FACETS_H
