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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SEARCH_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SEARCH_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cancellation.h>
#include <CGAL/Context_completion_3/internal/Example_source.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Match_target.h>
#include <CGAL/Context_completion_3/internal/Overlap_alignment.h>
#include <CGAL/Context_completion_3/internal/Place.h>
#include <CGAL/Context_completion_3/internal/Place_index.h>
#include <CGAL/Context_completion_3/internal/Place_ranking.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

struct Search_settings
{
  std::size_t number_of_turns = 24;
  bool mirror = true;
  bool alignment = true;
  bool signature = true;                    ///< the first round asks the signature
  bool probes = true;                       ///< the first round asks probes; if both, each names half
  std::size_t number_of_places = 2000;      ///< at most so many places of a source are tried
  std::size_t number_of_aligned = 800;      ///< hypotheses that go on to the second round
  std::size_t number_of_measured = 72;      ///< places that go on to the third
  std::size_t number_of_results = 24;
};

/*!
  Candidates and best matches of the default policy (paper, section 6.3): source places anywhere on the surface in local
  frames, turned about the normal and mirrored, instead of axis-aligned cells.

  Places are spread as densely as their number allows; on surfaces that are large against the hole a shortlist of them
  goes on. Then three rounds, each keeping less and measuring better: all places and turns by signature and by a coarse
  set of probes; a short alignment of the best; the full alignment and the exact score of what remains.
*/
template <typename ConcurrencyTag>
class Place_search
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Example_source<ConcurrencyTag> Source;

  typedef Place_hypothesis Hypothesis;

public:
  Place_search(const std::vector<Source>& sources, const Search_settings& settings)
    : m_sources(sources), m_settings(settings), m_indices(sources.size())
  {}

  /// The best places of all sources, best first, their origins at least half a radius apart.
  /// \param hints places that are tried, too
  /// \param poll called between the rounds
  std::vector<Place> search(const Match_target& target, const std::vector<Place>& hints = std::vector<Place>(),
                            const Poll& poll = Poll()) const
  {
    std::vector<Place> found;
    for(std::size_t s = 0; s < m_sources.size(); ++s)
      if(m_sources[s].model->size() > 0)
        search_source(s, target, hints, poll ? poll : Poll([]() {}), found);
    return separated(found, 0.5 * target.radius, m_settings.number_of_results);
  }

  /// The score of the final ranking: overlap and, with a quarter of the weight, base; tau is two spacings.
  static double exact_score(const Model& source, const Match_target& target, const Motion& motion)
  {
    Match_weights weights;
    weights.tau = 2 * target.spacing;
    const Overlap_alignment<ConcurrencyTag> exact(source, nullptr);
    const double overlap = exact.score(target.overlap, motion, weights);
    if(target.base.empty())
      return overlap;
    // Inside the hole the base is only a guess: what counts there is whether the source has a surface at all.
    double inside = 0;
    std::size_t covered = 0;
    for(const Match_probe& p : target.base)
    {
      inside += exact.term(p, motion, weights);
      const Vector y = motion.inverse(p.position);
      covered += source.search().nearest(y).second < 0.6 * target.radius;
    }
    inside /= double(target.base.size());
    const double share = double(covered) / double(target.base.size());
    return 0.8 * overlap + 0.2 * inside + 2 * (std::max)(0., 0.97 - share);
  }

private:
  void search_source(std::size_t s, const Match_target& target, const std::vector<Place>& hints, const Poll& poll,
                     std::vector<Place>& found) const
  {
    const Model& model = *m_sources[s].model;
    Place_index<ConcurrencyTag>& index = place_index(s, target);
    const Nearest_point_grid& grid = index.grid();
    const double tau = index.tau();
    poll();
    const Overlap_alignment<ConcurrencyTag> fast(model, &grid), exact(model, nullptr);

    std::vector<Hypothesis> best = first_round(model, index, target, poll);
    poll();
    for(const Place& hint : hints)
      if(hint.source == s)
      {
        best.emplace_back();
        best.back().motion = hint.motion;
      }

    const std::vector<Match_probe> some = thinned(target.overlap, 120);
    Match_weights weights;
    weights.tau = (std::max)(2 * target.spacing, 0.08 * target.radius);
    for_each_index<ConcurrencyTag>(best.size(), [&](std::size_t i)
    {
      if(m_settings.alignment)
        best[i].motion = fast.align(some, best[i].motion, tau, 1.5 * (std::max)(target.spacing, grid.voxel()), 5);
      best[i].score = fast.score(some, best[i].motion, weights);
    });
    poll();
    keep_best(best, best.size());
    std::vector<Place> places;
    for(const Hypothesis& h : best)
      places.push_back(place(s, target, h.motion, h.score));
    places = separated(places, 0.25 * target.radius, m_settings.number_of_measured);

    for_each_index<ConcurrencyTag>(places.size(), [&](std::size_t i)
    {
      const Motion motion = m_settings.alignment
        ? exact.align(target.overlap, places[i].motion, weights.tau, 1.5 * target.spacing, 8, 5) : places[i].motion;
      places[i] = place(s, target, motion, exact_score(model, target, motion));
    });
    found.insert(found.end(), places.begin(), places.end());
  }

  Place_index<ConcurrencyTag>& place_index(std::size_t s, const Match_target& target) const
  {
    std::unique_ptr<Place_index<ConcurrencyTag> >& index = m_indices[s];
    if(!index || index->radius() != target.radius || index->spacing() != target.spacing)
      index = std::make_unique<Place_index<ConcurrencyTag> >(*m_sources[s].model, target.radius, target.spacing,
                                                             m_settings.number_of_places);
    return *index;
  }

  static Place place(std::size_t s, const Match_target& target, const Motion& motion, double score)
  {
    Place result;
    result.source = s;
    result.motion = motion;
    result.origin = motion.inverse(target.frame.origin);
    result.score = score;
    return result;
  }

  // What one judge likes the other may not even know, so each names its own.
  std::vector<Hypothesis> first_round(const Model& model, Place_index<ConcurrencyTag>& index,
                                      const Match_target& target, const Poll& poll) const
  {
    const Place_ranking<ConcurrencyTag> ranking(model, index, target, m_settings.number_of_turns, m_settings.mirror);
    const std::size_t both = m_settings.signature && m_settings.probes ? 2 : 1;
    const std::size_t number = m_settings.number_of_aligned / both;
    std::vector<Hypothesis> best, more;
    if(m_settings.probes)
      best = ranking.by_probes();
    keep_best(best, number);
    poll();
    if(m_settings.signature)
      more = ranking.by_signature();
    keep_best(more, number);
    best.insert(best.end(), more.begin(), more.end());
    return best;
  }

  static void keep_best(std::vector<Hypothesis>& all, std::size_t number)
  {
    std::stable_sort(all.begin(), all.end(), [](const Hypothesis& a, const Hypothesis& b)
      { return a.score < b.score; });
    if(all.size() > number)
      all.resize(number);
  }

  static std::vector<Place> separated(std::vector<Place> places, double distance, std::size_t number)
  {
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.score < b.score; });
    std::vector<Place> kept;
    for(const Place& p : places)
    {
      bool is_free = true;
      for(const Place& q : kept)
        is_free = is_free && (q.source != p.source || (q.origin - p.origin).norm() >= distance);
      if(is_free)
        kept.push_back(p);
      if(kept.size() == number)
        break;
    }
    return kept;
  }

  const std::vector<Source>& m_sources;
  Search_settings m_settings;
  mutable std::vector<std::unique_ptr<Place_index<ConcurrencyTag> > > m_indices;   // of the last radius
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SEARCH_H
