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

#include <CGAL/Context_completion_3/internal/Cancellation.h>
#include <CGAL/Context_completion_3/internal/Copy_forecast.h>
#include <CGAL/Context_completion_3/internal/Detected_hole.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Hole_match.h>
#include <CGAL/Context_completion_3/internal/Hole_refinement.h>
#include <CGAL/Context_completion_3/internal/Hole_relief.h>
#include <CGAL/Context_completion_3/internal/Missing_texture.h>
#include <CGAL/Context_completion_3/internal/Open_end.h>
#include <CGAL/Context_completion_3/internal/Patch_transfer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <sstream>
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

/// Fills a hole by the default policy: search and forecast (`find()`), a planned surface (`relief()`), its finer levels
/// (`refinement()`), and points (`transfer()`).
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

  /// Places, their reliefs, the forecasts of all plans, and the choice between them; and the same over the stiff base, where
  /// the first one bulges, or lies elsewhere and no copy over it is to be believed.
  Match find(const Detected_hole<ConcurrencyTag>& hole, const Poll& poll) const
  {
    const Match match = find_over(hole.patch, hole.is_end, poll);
    if(!hole.stiff)
      return match;
    const bool bulges = is_bulge(*hole.patch, *hole.stiff);
    // the end of a tube may be meant to be open: nothing but a bulge is looked at twice
    if(!bulges && (hole.is_end || match.chosen.belief() > 0.9))
      return match;
    const Match stiff = find_over(hole.stiff, hole.is_end, poll);
    return is_better_over_stiff_base(stiff, match, bulges) ? stiff : match;
  }

  /// Whether the end of a tube is a hole: a place that closes is to be believed, and none where the tube just goes on
  /// matches better; or facets that go on close it.
  bool is_cut_off(const Detected_hole<ConcurrencyTag>& end, const Poll& poll) const
  {
    const Match match = find(end, poll);
    return match.is_faceted() ||
           (match.chosen.belief() > 0 && match.best <= 1.25 * match.forecast->least_mismatch() + 0.01);
  }

  /// The heights of the chosen plan, and what of its places is carried into the hole.
  Hole_relief relief(const Match& match) const
  {
    const Patch& patch = *match.patch;
    const Plan_forecast& chosen = match.chosen;
    const bool is_whole = chosen.plan.is_whole();
    Hole_relief result;
    result.heights = match.forecast->heights(chosen.plan);
    result.errors = match.forecast->errors(chosen);
    result.copy.assign(patch.samples().size(), no_index);
    if(match.is_faceted())
    {
      result.facets = match.forecast->facet_points();
      result.is_faceted.assign(patch.samples().size(), 1);
    }
    if(match.places.empty())
      return result;
    std::size_t source = no_index;
    Eigen::VectorXd displacement;
    const std::size_t first = match.forecast->ranking().front();
    if(is_whole)
    {
      // The whole relief of the best place, which is fitted to the rim and keeps all else. The mean over places, which the
      // plan may be, tells what to expect; at a wall, a little beside each other, they have heights between top and foot.
      source = first;
      displacement = match.forecast->fitting();
    }
    else
    {
      if(chosen.plan.places > 0)
      {
        source = first;
        displacement = result.heights - match.reliefs[first].height;
      }
      if(m_keep_texture && m_ingredients.copies)
        add_texture(patch, match, result.heights, source, displacement);
    }
    if(source == no_index)
      return result;
    result.copies.emplace_back();
    result.copies.back().place = match.places[source];
    result.copies.back().displacement = displacement;
    result.copies.back().set_surface(match.reliefs[source], result.heights);
    // a part of a copy, or a texture, has no reason to leave the plan
    result.copies.back().is_whole = is_whole;
    result.copies.back().tolerance = is_whole ? match.sampler->height_limit() : 1.5 * patch.spacing();
    result.copy.assign(patch.samples().size(), 0);
    return result;
  }

  /// The search for pieces of holes. It keeps its index of the last radius, which is large, so there is to be one only.
  Place_search<ConcurrencyTag> piece_search() const
  {
    // a piece has less to be compared, but there are many
    Search_settings search = m_search;
    search.number_of_places = (search.number_of_places + 1) / 2;
    search.number_of_aligned = 300;
    search.number_of_measured = 32;
    search.number_of_results = 18;
    return Place_search<ConcurrencyTag>(m_sources, search);
  }

  /// The finer levels of a hole, beginning with what `relief()` gave.
  std::unique_ptr<Hole_refinement<ConcurrencyTag> > refinement(const Match& match, const Hole_relief& relief,
                                                               const Place_search<ConcurrencyTag>& search) const
  {
    return std::make_unique<Hole_refinement<ConcurrencyTag> >(m_known, search, match.patch, match.sampler, match.places,
                                                              relief, m_ingredients);
  }

  /// Number of levels that `refinement()` is to be asked for.
  std::size_t number_of_finer_levels(const Patch& patch) const
  {
    // without fake holes pieces cannot tell what they are worth
    const bool is_refined = m_ingredients.copies && m_ingredients.levels && m_ingredients.fake_holes;
    return is_refined ? Hole_refinement<ConcurrencyTag>::number_of_levels(patch) : 0;
  }

  /// How often the pieces of a level are gone through.
  std::size_t number_of_passes() const { return m_ingredients.passes ? 3 : 1; }

  /// The points of a hole after its last level.
  Hole_filling transfer(const Match& match, const Hole_refinement<ConcurrencyTag>& refinement) const
  {
    Hole_filling result;
    const Patch& patch = *match.patch;
    const Plan_forecast& chosen = match.chosen;
    const std::size_t replaced = refinement.number_of_replaced();
    const Patch_transfer<ConcurrencyTag> transfer(m_known, patch, *match.sampler, m_sources);
    result.points = transfer.points(refinement.relief());
    result.outcome.match = match.best;
    if(chosen.plan.places > 0 || replaced > 0)
      result.outcome.filling = Filling::copied;
    else
      result.outcome.filling = match.teachers > 0 ? Filling::learned : Filling::smooth;
    // pieces that differ from the first level say that its forecast was too low; they know nothing of the rest
    result.outcome.expected_error = (std::max)(chosen.upper, refinement.change());
    result.outcome.reason = reason(match, patch.spacing(), replaced);
    result.outcome.added = result.points.size();
    for(Added_point& p : result.points)
      p.confidence = 1 / (1 + result.outcome.expected_error / patch.spacing());
    return result;
  }

  /// What is searched for: probes at known points within 0.6 radii of the rim, and at the base inside.
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
    target.overlap = thinned(overlap, 400);
    target.base = thinned(base, 100);
    target.describe_surroundings(known);
    for(const Base_sample& b : patch.samples())
      target.surface.push_back(b.position, b.normal);
    return target;
  }

private:
  Match find_over(const std::shared_ptr<const Patch>& base, bool is_end, const Poll& poll) const
  {
    Match match;
    match.patch = base;
    const Patch& patch = *base;
    match.sampler = std::make_shared<Relief_sampler<ConcurrencyTag> >(patch, m_sources);
    const Base_family<ConcurrencyTag> family(patch);
    const Match_target target = match_target(m_known, patch);
    match.places = Place_search<ConcurrencyTag>(m_sources, m_search).search(target, {}, poll);
    poll();
    match.reliefs.resize(match.places.size());
    for_each_index<ConcurrencyTag>(match.places.size(), [&](std::size_t i)
    {
      match.reliefs[i] = match.sampler->relief(match.places[i]);
      if(is_end)
        match.reliefs[i].may_fill = Open_end<ConcurrencyTag>(m_known, patch, *match.sampler, m_sources).is_closed_by(
          match.places[i]);
    });
    if(std::none_of(match.reliefs.begin(), match.reliefs.end(), [](const Place_relief& r) { return r.may_fill; }))
    {
      match.places.clear();
      match.reliefs.clear();
    }
    std::unique_ptr<const Place_facets<ConcurrencyTag> > facets;
    if(m_ingredients.facets)
      facets = std::make_unique<const Place_facets<ConcurrencyTag> >(m_known, patch, *match.sampler, m_sources);
    const auto forecast = std::make_shared<Copy_forecast<ConcurrencyTag> >(
      patch, family, match.places, match.reliefs, target.radius, m_ingredients,
      facets && facets->is_sharp() ? facets.get() : nullptr);
    match.forecast = forecast;
    poll();
    match.has_fake_holes = forecast->has_fake_holes();
    match.continues_edges = forecast->facet_points().size() > 0;
    if(!match.places.empty())
      match.best = forecast->match(forecast->ranking().front());
    choose(*forecast, patch.spacing(), match);
    if(m_ingredients.copies)
      learn(patch, target.radius, poll, *forecast, match);
    return match;
  }

  // the smooth plan, or a copy that promises to be better
  void choose(const Copy_forecast<ConcurrencyTag>& forecast, double spacing, Match& match) const
  {
    const std::vector<Plan_forecast> forecasts = forecast.forecasts();
    match.smooth = match.chosen = forecasts.front();
    if(!m_ingredients.copies)
      return;
    for(const Plan_forecast& f : forecasts)
      if(f.plan.places > 0 && f.error < f.margin() * match.smooth.error - rounding() * spacing &&
         (match.chosen.plan.places == 0 || f.error < match.chosen.error))
        match.chosen = f;
  }

  // Where there is no copy to be believed, and more is missed than a smooth surface has, relief may go on as it does in
  // many other places.
  void learn(const Patch& patch, double radius, const Poll& poll, Copy_forecast<ConcurrencyTag>& forecast,
             Match& match) const
  {
    const double error = match.chosen.error;
    const bool is_needed = match.chosen.belief() == 0 && error > 0.15 * patch.spacing();
    if(!m_ingredients.learning || !match.has_fake_holes || match.continues_edges || !is_needed)
      return;
    const Learned_relief learned =
      Learned_continuation<ConcurrencyTag>(m_known, *m_sources.front().model, patch, radius, poll).result();
    if(learned.places == 0 || !(learned.error < Plan_forecast::least_margin() * error))
      return;
    forecast.learn(learned);
    match.teachers = learned.places;
    choose(forecast, patch.spacing(), match);
  }

  // In spacings: on a plane both are exact, and the last bits must not decide.
  static double rounding() { return 1e-6; }

  // Lets carried points keep a texture. With nothing else to copy, it may be that of a place that matches less well.
  void add_texture(const Patch& patch, const Match& match, const Eigen::VectorXd& heights, std::size_t& place,
                   Eigen::VectorXd& displacement) const
  {
    const std::size_t most = 8;
    const std::vector<std::size_t>& ranking = match.forecast->ranking();
    const Missing_texture<ConcurrencyTag> missing(m_known, patch, *match.sampler, *match.forecast, match.chosen.plan);
    for(std::size_t r = 0; missing.is_known() && r < ranking.size() && r < (place != no_index ? 1 : most); ++r)
    {
      const Place_relief& relief = match.reliefs[ranking[r]];
      if(relief.coverage < 0.9)
        continue;
      const typename Missing_texture<ConcurrencyTag>::Texture texture =
        missing.of(heights, relief.height, match.chosen.error);
      if(!missing.is_fitting(texture))
        continue;
      place = ranking[r];
      displacement = heights - relief.height - texture.field;
      return;
    }
  }

  static std::string reason(const Match& match, double spacing, std::size_t replaced)
  {
    const Plan_forecast& chosen = match.chosen;
    std::ostringstream text;
    text.precision(2);
    if(match.places.empty())
      text << "smooth: no source place matches the surroundings";
    else if(!match.has_fake_holes)
      text << "smooth: too few places resemble the hole to try a copy there";
    else if(chosen.plan.places == 0 && match.teachers > 0)
      text << "learned from " << match.teachers << " places: forecast " << chosen.error / spacing << " spacings";
    else if(chosen.plan.places == 0)
      text << "smooth: forecast " << chosen.error / spacing << " spacings, no copy promises clearly less";
    else
      text << "copied from " << chosen.plan.places << (chosen.plan.places == 1 ? " place" : " places") << ", share "
           << chosen.plan.share << ": forecast " << chosen.error / spacing << " spacings, smooth "
           << match.smooth.error / spacing;
    if(match.is_faceted())
      text << "; sharp edges go on until they meet";
    if(replaced > 0)
      text << "; finer levels copied " << replaced << (replaced == 1 ? " piece" : " pieces");
    return text.str();
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
