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

#include <CGAL/Context_completion_3/internal/Example_source.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Overlap_alignment.h>
#include <CGAL/Context_completion_3/internal/Place.h>
#include <CGAL/Context_completion_3/internal/Place_index.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// What is searched for: the surroundings of a hole and its current base.
struct Match_target
{
  Surface_frame frame;                      ///< at the middle of the hole
  double radius = 0;
  double spacing = 0;
  std::vector<Match_probe> overlap;         ///< known surroundings
  std::vector<Match_probe> base;            ///< the current approximation inside, of less weight
  std::vector<Smoothed_place> around;       ///< known surroundings, smoothed: what the shortlist goes by
};

/// Fills in what the shortlist goes by.
template <typename ConcurrencyTag>
void smooth_surroundings(const Surface_model<ConcurrencyTag>& known, Match_target& target)
{
  const double deviation = Place_index<ConcurrencyTag>::smoothing(target.radius);
  for(const Match_probe& p : target.overlap)
    target.around.push_back(smoothed_place(known, p.position, p.normal, deviation));
}

struct Search_settings
{
  std::size_t number_of_turns = 24;
  bool mirror = true;
  bool alignment = true;
  std::size_t number_of_places = 2000;      ///< at most so many places of a source are tried
  std::size_t number_of_aligned = 800;      ///< hypotheses that go on to the second round
  std::size_t number_of_measured = 72;      ///< places that go on to the third
  std::size_t number_of_results = 24;
};

/*!
  Candidates and best matches of the default policy (paper, section 6.3): source places anywhere on the surface in local
  frames, turned about the normal and mirrored, instead of axis-aligned cells.

  Places are spread as densely as their number allows; on surfaces that are large against the hole a shortlist of them
  goes on. Then three rounds, each keeping less and measuring better: all places and turns on a coarse set of probes, up
  to a shift along the normal and a tilt; a short alignment of the best; the full alignment and the exact score of what
  remains.
*/
template <typename ConcurrencyTag>
class Place_search
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Example_source<ConcurrencyTag> Source;

  struct Hypothesis
  {
    Motion motion;
    double score = 0;
  };

public:
  Place_search(const std::vector<Source>& sources, const Search_settings& settings)
    : m_sources(sources), m_settings(settings), m_indices(sources.size())
  {}

  /// The best places of all sources, best first, their origins at least half a radius apart.
  /// \param hints places that are tried, too
  std::vector<Place> search(const Match_target& target, const std::vector<Place>& hints = std::vector<Place>()) const
  {
    std::vector<Place> found;
    for(std::size_t s = 0; s < m_sources.size(); ++s)
      if(m_sources[s].model->size() > 0)
        search_source(s, target, hints, found);
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
  void search_source(std::size_t s, const Match_target& target, const std::vector<Place>& hints,
                     std::vector<Place>& found) const
  {
    const Model& model = *m_sources[s].model;
    const Place_index<ConcurrencyTag>& index = place_index(s, target);
    const Nearest_point_grid& grid = index.grid();
    const double tau = index.tau();
    const std::vector<Surface_frame> frames = index.frames(target.frame, target.around);
    const Overlap_alignment<ConcurrencyTag> fast(model, &grid), exact(model, nullptr);

    std::vector<Hypothesis> best = first_round(model, frames, target, grid, tau);
    keep_best(best, m_settings.number_of_aligned);
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
    keep_best(best, best.size());
    std::vector<Place> places;
    for(const Hypothesis& h : best)
      places.push_back(place(s, target, h.motion, h.score));
    places = separated(places, 0.25 * target.radius, m_settings.number_of_measured);

    for_each_index<ConcurrencyTag>(places.size(), [&](std::size_t i)
    {
      const Motion motion = m_settings.alignment
        ? exact.align(target.overlap, places[i].motion, weights.tau, 1.5 * target.spacing, 8) : places[i].motion;
      places[i] = place(s, target, motion, exact_score(model, target, motion));
    });
    found.insert(found.end(), places.begin(), places.end());
  }

  const Place_index<ConcurrencyTag>& place_index(std::size_t s, const Match_target& target) const
  {
    std::unique_ptr<const Place_index<ConcurrencyTag> >& index = m_indices[s];
    if(!index || index->radius() != target.radius || index->spacing() != target.spacing)
      index = std::make_unique<const Place_index<ConcurrencyTag> >(*m_sources[s].model, target.radius, target.spacing,
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

  // All turns of all places; the three best of a place go on.
  std::vector<Hypothesis> first_round(const Model& model, const std::vector<Surface_frame>& frames,
                                      const Match_target& target, const Nearest_point_grid& grid, double tau) const
  {
    const std::vector<Match_probe> probes = thinned(target.overlap, 56);
    const std::size_t turns = m_settings.number_of_turns, kept = 3;
    std::vector<Surface_frame> turned;
    for(std::size_t t = 0; t < turns; ++t)
      turned.push_back(target.frame.turned(2 * 3.14159265358979323846 * double(t) / double(turns)));
    std::vector<Hypothesis> all(frames.size() * kept);
    for_each_index<ConcurrencyTag>(frames.size(), [&](std::size_t i)
    {
      std::vector<Hypothesis> here;
      for(int mirrored = 0; mirrored < (m_settings.mirror ? 2 : 1); ++mirrored)
        for(std::size_t t = 0; t < turns; ++t)
        {
          Hypothesis h;
          h.motion = turned[t].motion_from(frames[i], mirrored != 0);
          h.score = coarse_score(model, probes, target, h.motion, grid, tau);
          here.push_back(h);
        }
      std::stable_sort(here.begin(), here.end(), [](const Hypothesis& a, const Hypothesis& b)
        { return a.score < b.score; });
      for(std::size_t k = 0; k < kept; ++k)
        all[i * kept + k] = here[(std::min)(k, here.size() - 1)];
    });
    return all;
  }

  // Score up to a shift along the normal and a tilt of the patch, which the alignment will find.
  double coarse_score(const Model& model, const std::vector<Match_probe>& probes, const Match_target& target,
                      const Motion& motion, const Nearest_point_grid& grid, double tau) const
  {
    const double kappa = 0.5;
    double distance[64], agreement[64], along[64][3];
    const std::size_t n = (std::min)(probes.size(), std::size_t(64));
    const Vector u = target.frame.axis, v = target.frame.normal.cross(u);
    Matrix a = Matrix::Zero();
    Vector b = Vector::Zero();
    double total = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Match_probe& p = probes[i];
      total += p.weight;
      distance[i] = 2 * tau;
      const Vector y = motion.inverse(p.position);
      const std::uint32_t s = grid(y);
      if(s == Nearest_point_grid::none)
        continue;
      const Vector& normal = model.normal(s);
      const double d = normal.dot(y - model.position(s));
      if(std::abs(d) > tau)
        continue;
      distance[i] = d;
      agreement[i] = normal.dot(motion.inverse_normal(p.normal));
      const Vector q = (p.position - target.frame.origin) / target.radius;
      along[i][0] = 1; along[i][1] = q.dot(u); along[i][2] = q.dot(v);
      const Vector row(along[i][0], along[i][1], along[i][2]);
      const double w = p.weight * (std::max)(0., agreement[i]);
      a.noalias() += w * row * row.transpose();
      b += w * d * row;
    }
    a.diagonal().array() += 0.05 * total;
    const Vector c = a.ldlt().solve(b);
    double sum = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double w = probes[i].weight;
      if(distance[i] > tau)
      {
        sum += w * (1 + kappa);
        continue;
      }
      const double d = (distance[i] - c[0] - c[1] * along[i][1] - c[2] * along[i][2]) / tau;
      sum += w * ((std::min)(1., d * d) + kappa * (std::min)(1., 1 - agreement[i]));
    }
    return total > 0 ? sum / total : 1 + kappa;
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
  mutable std::vector<std::unique_ptr<const Place_index<ConcurrencyTag> > > m_indices;   // of the last radius
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SEARCH_H
