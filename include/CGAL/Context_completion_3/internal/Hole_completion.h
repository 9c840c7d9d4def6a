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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_COMPLETION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_COMPLETION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Copy_forecast.h>
#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Patch_transfer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// What a hole got.
struct Hole_filling
{
  std::vector<Added_point> points;
  Hole_outcome outcome;
};

/// Fills one hole by the default policy: search, forecast, transfer.
template <typename ConcurrencyTag>
class Hole_completion
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Example_source<ConcurrencyTag> Source;

public:
  Hole_completion(const Model& known, const std::vector<Source>& sources, const Search_settings& search,
                  bool keep_texture)
    : m_known(known), m_sources(sources), m_search(search), m_keep_texture(keep_texture)
  {}

  Hole_filling fill(const Patch& patch) const
  {
    const Relief_sampler<ConcurrencyTag> sampler(patch, m_sources);
    const Base_family<ConcurrencyTag> family(patch);
    const Match_target target = match_target(patch);
    const std::vector<Place> places = Place_search<ConcurrencyTag>(m_sources, m_search).search(target);
    std::vector<Place_relief> reliefs(places.size());
    std::vector<std::size_t> indices;
    for(std::size_t i = 0; i < places.size(); ++i)
      indices.push_back(i);
    CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t i) -> bool
    {
      reliefs[i] = sampler.relief(places[i]);
      return true;
    });
    const Copy_forecast<ConcurrencyTag> forecast(patch, family, places, reliefs, target.radius);
    const std::vector<Plan_forecast> forecasts = forecast.forecasts();
    // DEBUG-BEGIN
    if(getenv("CC_DEBUG"))
    {
      const double h = patch.spacing();
      std::cerr << "hole r/h " << target.radius / h << " places " << places.size() << " probes " << target.overlap.size() << "\n";
      for(std::size_t i = 0; i < places.size() && i < 12; ++i)
        std::cerr << "   place score " << places[i].score << " match " << forecast.match(i) << " cov " << reliefs[i].coverage
                  << " det " << places[i].motion.linear.determinant() << " at " << places[i].origin.transpose() << "\n";
      for(std::size_t i = 0; i < forecasts.size(); ++i)
        if(i < 6 || forecasts[i].plan.places == 0)
        std::cerr << "   plan " << forecast.describe(forecasts[i].plan) << " error/h " << forecasts[i].error / h << " upper/h " << forecasts[i].upper / h << "\n";
    }
    Hole_filling result;
    Filling_plan plan;
    result.outcome.expected_error = patch.spacing();
    if(!forecasts.empty())
    {
      plan = forecasts.front().plan;
      result.outcome.expected_error = forecasts.front().upper;
    }
    const Eigen::Index n = Eigen::Index(patch.samples().size());
    Eigen::VectorXd heights = Eigen::VectorXd::Zero(n), displacement = Eigen::VectorXd::Zero(n);
    const Place* place = nullptr;
    if(!places.empty())
    {
      heights = forecast.heights(plan);
      result.outcome.match = forecast.match(forecast.ranking().front());
    }
    if(plan.places > 0)
    {
      const std::size_t best = forecast.ranking().front();
      place = &places[best];
      displacement = heights - reliefs[best].height;
      if(plan.places == 1 && plan.share == 1)
        displacement = forecast.warp(plan.base, best);
    }
    const Patch_transfer<ConcurrencyTag> transfer(m_known, patch, sampler, m_sources);
    result.points = transfer.points(place, displacement, heights);
    result.outcome.filling = place == nullptr ? Filling::smooth : Filling::copied;
    result.outcome.reason = forecasts.empty() ? std::string("no source place to judge by") : forecast.describe(plan);
    result.outcome.added = result.points.size();
    for(Added_point& p : result.points)
      p.confidence = 1 / (1 + result.outcome.expected_error / patch.spacing());
    return result;
  }

private:
  // Probes at known points within 0.6 radii of the rim, and at the base inside.
  static std::vector<Match_probe> at_most(const std::vector<Match_probe>& probes, std::size_t number)
  {
    std::vector<Match_probe> result;
    const std::size_t n = (std::min)(number, probes.size());
    for(std::size_t i = 0; i < n; ++i)
      result.push_back(probes[i * probes.size() / n]);
    return result;
  }

  Match_target match_target(const Patch& patch) const
  {
    Match_target target;
    target.spacing = patch.spacing();
    Vector mean = Vector::Zero();
    for(const Base_sample& s : patch.samples())
      mean += s.position;
    mean /= double(patch.samples().size());
    std::size_t middle = 0;
    for(std::size_t s = 0; s < patch.samples().size(); ++s)
      if((patch.samples()[s].position - mean).norm() < (patch.samples()[middle].position - mean).norm())
        middle = s;
    target.frame.origin = patch.samples()[middle].position;
    target.frame.normal = patch.samples()[middle].normal;
    target.frame.axis = target.frame.normal.unitOrthogonal();
    for(std::size_t i : patch.rim())
      target.radius = (std::max)(target.radius, (m_known.position(i) - mean).norm());
    const double width = (std::max)(4 * patch.spacing(), 0.6 * target.radius);
    std::vector<Match_probe> overlap, base;
    for(const Band_point& b : patch.band())
      if(b.distance <= width)
      {
        Match_probe probe;
        probe.position = m_known.position(b.index);
        probe.normal = m_known.normal(b.index);
        probe.weight = std::exp(-b.distance / (0.5 * width));
        overlap.push_back(probe);
      }
    for(const Base_sample& s : patch.samples())
    {
      Match_probe probe;
      probe.position = s.position;
      probe.normal = s.normal;
      base.push_back(probe);
    }
    target.overlap = at_most(overlap, 400);
    target.base = at_most(base, 100);
    return target;
  }

  const Model& m_known;
  const std::vector<Source>& m_sources;
  Search_settings m_search;
  bool m_keep_texture;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_COMPLETION_H
