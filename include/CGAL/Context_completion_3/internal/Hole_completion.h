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
#include <memory>
#include <sstream>
#include <string>
#include <utility>
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

/// What was found for a hole, and which plan the forecasts chose.
template <typename ConcurrencyTag>
struct Hole_match
{
  std::shared_ptr<const Relief_sampler<ConcurrencyTag> > sampler;
  std::vector<Place> places;               ///< source places, best score first
  std::vector<Place_relief> reliefs;       ///< parallel to places
  std::shared_ptr<const Copy_forecast<ConcurrencyTag> > forecast;
  Plan_forecast smooth, chosen;
};

/// Fills a hole by the default policy: search and forecast (`find()`), then transfer (`transfer()`).
template <typename ConcurrencyTag>
class Hole_completion
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Example_source<ConcurrencyTag> Source;
  typedef Hole_match<ConcurrencyTag> Match;

public:
  Hole_completion(const Model& known, const std::vector<Source>& sources, const Search_settings& search,
                  bool keep_texture, const Ingredients& ingredients)
    : m_known(known), m_sources(sources), m_search(search), m_keep_texture(keep_texture), m_ingredients(ingredients)
  {}

  /// Places, their reliefs, the forecasts of all plans, and the choice between them. The match refers to `patch`.
  Match find(const Patch& patch) const
  {
    Match match;
    match.sampler = std::make_shared<Relief_sampler<ConcurrencyTag> >(patch, m_sources);
    const Base_family<ConcurrencyTag> family(patch);
    const Match_target target = match_target(m_known, patch);
    match.places = Place_search<ConcurrencyTag>(m_sources, m_search).search(target);
    match.reliefs.resize(match.places.size());
    std::vector<std::size_t> indices;
    for(std::size_t i = 0; i < match.places.size(); ++i)
      indices.push_back(i);
    CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t i) -> bool
    {
      match.reliefs[i] = match.sampler->relief(match.places[i]);
      return true;
    });
    const auto forecast = std::make_shared<Copy_forecast<ConcurrencyTag> >(patch, family, match.places, match.reliefs,
                                                                          target.radius, m_ingredients);
    match.forecast = forecast;
    const std::vector<Plan_forecast> forecasts = forecast->forecasts();
    match.smooth = match.chosen = forecasts.front();
    for(const Plan_forecast& f : forecasts)
      if(f.error < match.chosen.error * (match.chosen.plan.places == 0 ? copy_margin() : 1.))
        match.chosen = f;
    return match;
  }

  /// The points of the chosen plan.
  Hole_filling transfer(const Patch& patch, const Match& match) const
  {
    Hole_filling result;
    const Plan_forecast& chosen = match.chosen;
    const Relief_sampler<ConcurrencyTag>& sampler = *match.sampler;
    const Eigen::VectorXd heights = match.forecast->heights(chosen.plan);
    Eigen::VectorXd displacement = Eigen::VectorXd::Zero(heights.size());
    const Place* place = nullptr;
    if(!match.places.empty())
    {
      const std::vector<std::size_t>& ranking = match.forecast->ranking();
      result.outcome.match = match.forecast->match(ranking.front());
      std::size_t best = ranking.front();
      Texture texture;
      if(m_keep_texture)
        // with nothing else to copy, the texture may be that of a place that matches less well
        for(std::size_t r = 0; r < ranking.size() && r < (chosen.plan.places > 0 ? 1 : most_textures()); ++r)
        {
          const Texture candidate = missing_texture(patch, match, heights - match.reliefs[ranking[r]].height);
          if(match.reliefs[ranking[r]].coverage < 0.9 || !is_visible(candidate, chosen.error, patch.spacing()))
            continue;
          texture = candidate;
          best = ranking[r];
          break;
        }
      if(chosen.plan.places > 0 || texture.amplitude > 0)
      {
        place = &match.places[best];
        const bool is_whole = chosen.plan.places == 1 && chosen.plan.share > 0.9;
        displacement = is_whole ? match.forecast->fitting(best) : heights - match.reliefs[best].height;
        if(!is_whole && texture.amplitude > 0)
          displacement -= texture.field;
      }
    }
    const Patch_transfer<ConcurrencyTag> transfer(m_known, patch, sampler, m_sources);
    // a copy may overhang the base; a part of one, or a texture, has no reason to leave the plan
    const double tolerance = chosen.plan.share > 0.9 ? sampler.height_limit() : 1.5 * patch.spacing();
    result.points = transfer.points(place, displacement, heights, tolerance);
    result.outcome.filling = chosen.plan.places > 0 ? Filling::copied : Filling::smooth;
    result.outcome.expected_error = chosen.upper;
    result.outcome.reason = reason(chosen, match.smooth, patch.spacing(), match.places.size());
    result.outcome.added = result.points.size();
    for(Added_point& p : result.points)
      p.confidence = 1 / (1 + result.outcome.expected_error / patch.spacing());
    return result;
  }

  static Match_target match_target(const Model& known, const Patch& patch)
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
      target.radius = (std::max)(target.radius, (known.position(i) - mean).norm());
    const double width = (std::max)(4 * patch.spacing(), 0.6 * target.radius);
    std::vector<Match_probe> overlap, base;
    for(const Band_point& b : patch.band())
      if(b.distance <= width)
      {
        Match_probe probe;
        probe.position = known.position(b.index);
        probe.normal = known.normal(b.index);
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

private:
  // A copy must promise to be better by this factor, because a smooth patch is never absurd.
  static double copy_margin() { return 0.92; }

  struct Texture
  {
    Eigen::VectorXd field;               // height over the plan
    double amplitude = 0;                // root mean square of it
    double own = 0;                      // that of the place, before it was brought to what is missing
  };

  static std::size_t most_textures() { return 8; }

  // Finer relief than 0.05 spacings cannot be told from an uneven sampling; texture that is random against the true one
  // adds to the error, by a fifth at most below 0.7 of it; and a place with much more of it has another texture.
  static bool is_visible(const Texture& texture, double error, double spacing)
  {
    return texture.amplitude > 0.05 * spacing && texture.amplitude < 0.7 * error &&
           texture.amplitude > 0.4 * texture.own;
  }

  // What is finer than a few spacings may stay with the carried points as their texture, as far as the plan misses such
  // relief: that is known from the fake holes, sample by sample. It begins a few spacings from the rim, as it does not fit
  // what is there.
  Texture missing_texture(const Patch& patch, const Match& match, const Eigen::VectorXd& difference) const
  {
    const Relief_sampler<ConcurrencyTag>& sampler = *match.sampler;
    Eigen::MatrixXd missing = match.forecast->misses(match.chosen.plan);
    for(Eigen::Index k = 0; k < missing.cols(); ++k)
    {
      const Eigen::VectorXd miss = missing.col(k);
      missing.col(k) = low_pass(sampler, (miss - low_pass(sampler, miss)).cwiseAbs2());
    }
    Texture texture;
    texture.field = difference - low_pass(sampler, difference);
    texture.own = root_mean_square(texture.field);
    const Eigen::VectorXd own = low_pass(sampler, texture.field.cwiseAbs2());
    std::vector<std::pair<double, double> > variances(std::size_t(missing.cols()));
    for(Eigen::Index s = 0; s < own.size(); ++s)
    {
      for(Eigen::Index k = 0; k < missing.cols(); ++k)
        variances[std::size_t(k)] = std::make_pair(missing(s, k), match.forecast->judge_weights()[std::size_t(k)]);
      const double variance = upper_median(variances);
      const double distance = m_known.search().nearest(patch.samples()[std::size_t(s)].position).second / patch.spacing();
      const double fade = (std::max)(0., (std::min)(1., (distance - 1) / 3));
      texture.field[s] *= fade * (std::min)(1.25, std::sqrt(variance / (own[s] + 1e-300)));
    }
    texture.amplitude = root_mean_square(texture.field);
    return texture;
  }

  // of pairs value, weight (of sum 1): fake holes at sharp features have outliers upwards
  static double upper_median(std::vector<std::pair<double, double> >& values)
  {
    std::sort(values.begin(), values.end());
    double below = 0;
    for(const std::pair<double, double>& v : values)
    {
      below += v.second;
      if(below >= 0.65)
        return v.first;
    }
    return values.empty() ? 0. : values.back().first;
  }

  static Eigen::VectorXd low_pass(const Relief_sampler<ConcurrencyTag>& sampler, Eigen::VectorXd field)
  {
    for(int round = 0; round < 4; ++round)
    {
      Eigen::VectorXd next(field.size());
      for(Eigen::Index s = 0; s < field.size(); ++s)
      {
        double sum = 0;
        for(std::size_t t : sampler.neighbors(std::size_t(s)))
          sum += field[Eigen::Index(t)];
        next[s] = sum / double(sampler.neighbors(std::size_t(s)).size());
      }
      field.swap(next);
    }
    return field;
  }

  static double root_mean_square(const Eigen::VectorXd& v) { return std::sqrt(v.squaredNorm() / double(v.size())); }

  static std::string reason(const Plan_forecast& chosen, const Plan_forecast& smooth, double spacing,
                            std::size_t places)
  {
    std::ostringstream text;
    text.precision(2);
    if(places == 0)
      text << "smooth: no source place matches the surroundings";
    else if(chosen.plan.places == 0)
      text << "smooth: forecast " << chosen.error / spacing << " spacings, no copy promises clearly less";
    else
      text << "copied from " << chosen.plan.places << (chosen.plan.places == 1 ? " place" : " places") << ", share "
           << chosen.plan.share << ": forecast " << chosen.error / spacing << " spacings, smooth "
           << smooth.error / spacing;
    return text.str();
  }

  // Probes at known points within 0.6 radii of the rim, and at the base inside.
  static std::vector<Match_probe> at_most(const std::vector<Match_probe>& probes, std::size_t number)
  {
    std::vector<Match_probe> result;
    const std::size_t n = (std::min)(number, probes.size());
    for(std::size_t i = 0; i < n; ++i)
      result.push_back(probes[i * probes.size() / n]);
    return result;
  }

  const Model& m_known;
  const std::vector<Source>& m_sources;
  Search_settings m_search;
  bool m_keep_texture;
  Ingredients m_ingredients;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_COMPLETION_H
