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
#include <CGAL/Context_completion_3/internal/Facet_sampling.h>
#include <CGAL/Context_completion_3/internal/Fake_hole_statistics.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Place.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

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
    : m_known(known), m_patch(patch), m_sampler(sampler), m_sources(sources)
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

  /// Heights of the facets around the hole over the samples.
  /// \param guess per sample: of several surfaces the nearest to it is taken, and where there is none, it stays
  Eigen::VectorXd own_heights(const Eigen::VectorXd& guess) const { return heights(*m_own, guess); }

  /// Points on them within the hole; none if they do not close it, or only in a spike.
  Surface_points own_points() const
  {
    // as far apart as the known points, and about as many as of these there would be, which lie less evenly; a little
    // less, since the front leaves gaps narrower than a spacing
    const double spacing = 0.97 * std::sqrt(m_patch.spacing() * m_patch.surroundings()->area_spacing_behind());
    std::vector<Vector> seeds;
    for(double step : {1.4, 1.})
      for(const Rim_loop& loop : m_patch.loops())
        for(const Rim_point& p : loop.points)
          seeds.push_back(m_known.position(p.index) + step * spacing * p.outward);
    const Surface_points points = sample_facets(*m_own, m_band, seeds, spacing, 4 * m_patch.samples().size() + 60);
    return is_spike(points) ? Surface_points() : points;
  }

  /// The same of the facets around a place, without what it has in the hole.
  Eigen::VectorXd heights(const Place& place, const Eigen::VectorXd& guess) const
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
    return heights(Facet_continuation(points, distance, m_patch.area_spacing(), m_patch.scale()), guess);
  }

  /*!
    Where edges go into the hole, facets that go on until they meet take the place of the smooth base, if they do better on
    the fake holes. Without those there is nothing to learn from but the surroundings, which they explain.
    \param smooth heights of the base, a column per place, that of the hole last
    \param are_fake_holes_asked whether fake holes are to decide
    \param loss what is lost on the fake holes with some heights
    \return points on the facets; none if the base stays
  */
  Surface_points take_over(Eigen::MatrixXd& smooth, const std::vector<Place>& places,
                           const Fake_hole_statistics& statistics, bool are_fake_holes_asked,
                           const std::function<double(const Eigen::MatrixXd&)>& loss) const
  {
    Surface_points points = own_points();
    if(points.size() == 0)
      return points;
    Eigen::MatrixXd faceted = smooth;
    if(statistics.is_sufficient() && are_fake_holes_asked)
    {
      const std::vector<std::size_t>& judges = statistics.judges();
      for_each_index<ConcurrencyTag>(judges.size(), [&](std::size_t i)
      {
        const Eigen::Index column = statistics.column(judges[i]);
        faceted.col(column) = heights(places[judges[i]], smooth.col(column));
      });
      if(!(loss(faceted) < loss(smooth)))
        return Surface_points();
    }
    const Eigen::Index own = statistics.column(Fake_hole_statistics::target);
    faceted.col(own) = own_heights(smooth.col(own));
    smooth.swap(faceted);
    return points;
  }

private:
  // Whether facets meet far above or below the base, in a spike. The fake holes cannot tell: they judge heights, and these
  // have a limit, which the corner of a cube that is cut off across exceeds by a third.
  bool is_spike(const Surface_points& points) const
  {
    return std::any_of(points.position.begin(), points.position.end(), [&](const Vector& x)
      { return m_sampler.search().nearest(x).second > 2 * m_sampler.height_limit(); });
  }

  Eigen::VectorXd heights(const Facet_continuation& facets, const Eigen::VectorXd& guess) const
  {
    Eigen::VectorXd result = guess;
    for(std::size_t s = 0; s < m_patch.samples().size(); ++s)
    {
      double& height = result[Eigen::Index(s)];
      Vector normal;
      facets.find(m_patch.samples()[s].position, m_patch.samples()[s].normal, height, m_sampler.height_limit(), height,
                  normal);
    }
    return result;
  }

  const Model& m_known;
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
