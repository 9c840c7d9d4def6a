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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_REFINEMENT_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_REFINEMENT_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Hole_piece.h>
#include <CGAL/Context_completion_3/internal/Hole_relief.h>
#include <CGAL/Context_completion_3/internal/Matrix_operations.h>
#include <CGAL/Context_completion_3/internal/Piece_forecast.h>
#include <CGAL/Context_completion_3/internal/Place_search.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// What was found for a piece of a hole.
template <typename ConcurrencyTag>
struct Piece_match
{
  bool is_found = false;
  Piece_controls controls;
  std::vector<Place> places;
  std::vector<Place_relief> reliefs;     ///< parallel to places
  std::shared_ptr<const Piece_forecast<ConcurrencyTag> > forecast;
  Plan_forecast chosen;
};

/// A piece of a hole, ready to be inserted.
struct Piece_filling
{
  Carried_place carried;
  Eigen::VectorXd heights;               ///< parallel to the samples of the piece
  double error = 0;                      ///< to be expected
};

/*!
  The finer levels of a hole (paper, section 4): pieces of half, a quarter, ... of its size are matched anew, with what
  is known and what has been settled around them, and replaced where a copy that is to be believed promises clearly less
  error than what the coarser level left.

  The places that filled the whole and the neighbouring pieces are tried, too (coherence): they need not be found again,
  and pieces that come from one place join without a seam.
*/
template <typename ConcurrencyTag>
class Hole_refinement
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Surface_model<ConcurrencyTag> Model;

public:
  /*!
    \param known the known surface
    \param search for places; it may be shared by holes that are refined one after the other
    \param patch, sampler the base of the hole
    \param places of the whole hole
    \param relief what the first level gave
    \param ingredients among them, whether places are taken over from the whole hole and from other pieces
  */
  Hole_refinement(const Model& known, const Place_search<ConcurrencyTag>& search,
                  const std::shared_ptr<const Patch>& patch,
                  const std::shared_ptr<const Relief_sampler<ConcurrencyTag> >& sampler,
                  const std::vector<Place>& places, const Hole_relief& relief, const Ingredients& ingredients)
    : m_known(known), m_search(search), m_patch(patch), m_sampler(sampler), m_ingredients(ingredients),
      m_relief(relief), m_first(relief.heights),
      m_is_copy(!relief.copies.empty() && relief.copies.front().is_whole), m_settled_by(patch->samples().size(), no_index),
      m_pieces_of(*patch, sampler->search())
  {
    if(ingredients.coherence)
      m_hints = places;
  }

  const Hole_relief& relief() const { return m_relief; }
  const std::vector<Hole_piece>& pieces() const { return m_pieces; }

  /// Number of pieces that were replaced, on all levels.
  std::size_t number_of_replaced() const { return m_replaced; }

  /// How far, in the mean, the result is from the first level.
  double change() const { return mean_absolute_value(m_relief.heights - m_first); }

  /// How many finer levels a hole has: pieces have a radius of more than four spacings.
  static std::size_t number_of_levels(const Patch& patch)
  {
    std::size_t levels = 0;
    while(radius(patch, levels + 1) > 4 * patch.spacing())
      ++levels;
    return levels;
  }

  /// Cuts the hole into the pieces of a finer level, the first being 1.
  void begin_level(std::size_t level)
  {
    m_pieces = m_pieces_of.of_radius(radius(*m_patch, level));
    m_settled_by.assign(m_patch->samples().size(), no_index);
    m_settled_at.assign(m_patch->samples().size(), 0);
    m_tried_at.assign(m_pieces.size(), no_index);
    m_time = 0;
    m_known_share.clear();
    for(const Hole_piece& piece : m_pieces)
      m_known_share.push_back(m_pieces_of.controls(piece, m_settled_by).known_share);
  }

  /// Share of the surroundings of a piece that is known or settled; changes with each insertion.
  double known_share(const Hole_piece& piece) const { return m_known_share[piece.number]; }

  /// Error to expect in a piece as it is.
  double error(const Hole_piece& piece) const
  {
    double sum = 0, total = 0;
    for(std::size_t i = 0; i < piece.samples.size(); ++i)
    {
      sum += piece.weights[i] * m_relief.errors[Eigen::Index(piece.samples[i])];
      total += piece.weights[i];
    }
    return sum / total;
  }

  /// Whether something is known to match, and something to gain; for a piece that was tried before, whether enough of
  /// its surroundings has been settled since.
  bool is_open(const Hole_piece& piece) const
  {
    const Piece_controls controls = m_pieces_of.controls(piece, m_settled_by);
    if(controls.known_share <= 0.25 || error(piece) <= 0.1 * m_patch->spacing())
      return false;
    if(m_tried_at[piece.number] == no_index)
      return true;
    std::size_t changed = 0;
    for(std::size_t s : controls.settled)
      changed += m_settled_at[s] > m_tried_at[piece.number] ? 1 : 0;
    return double(changed) > 0.1 * double(controls.rim.size() + controls.settled.size());
  }

  Piece_match<ConcurrencyTag> find(const Hole_piece& piece)
  {
    m_tried_at[piece.number] = m_time;
    Piece_match<ConcurrencyTag> match;
    match.controls = m_pieces_of.controls(piece, m_settled_by);
    match.places = m_search.search(match_target(piece, match.controls), m_hints);
    Relief_window window;
    window.middle = m_patch->samples()[piece.middle].position;
    window.reach = piece.radius + Hole_pieces<ConcurrencyTag>::width(piece.radius, m_patch->spacing());
    for(double weight : match.controls.centers)
      window.is_center_needed.push_back(weight > 0);
    match.reliefs.resize(match.places.size());
    for_each_index<ConcurrencyTag>(match.places.size(), [&](std::size_t i)
      { match.reliefs[i] = m_sampler->relief(match.places[i], window); });
    match.forecast = std::make_shared<Piece_forecast<ConcurrencyTag> >(
      *m_patch, piece, match.controls, m_relief.heights, match.places, match.reliefs, m_ingredients);
    match.chosen = match.forecast->best();
    // what has been settled is not the truth
    double drift = 0;
    for(std::size_t s : match.controls.settled)
      drift += m_relief.errors[Eigen::Index(s)];
    match.chosen.error += drift / double(match.controls.settled.size() + match.controls.rim.size());
    match.is_found = match.chosen.plan.places > 0 && match.chosen.error < margin() * error(piece) &&
                     !(m_is_copy && contradicts(piece, match.forecast->copy(match.chosen.plan.places)));
    return match;
  }

  /// Heights of the chosen plan, and what of its best place is carried there.
  Piece_filling transfer(const Hole_piece& piece, const Piece_match<ConcurrencyTag>& match) const
  {
    Piece_filling result;
    result.error = match.chosen.error;
    result.heights = match.forecast->copy(match.chosen.plan.places);
    const std::size_t best = match.forecast->ranking().front();
    result.carried.place = match.places[best];
    result.carried.displacement = m_relief.heights - match.reliefs[best].height;
    // the whole relief of one place is fitted to what is known and keeps all else
    const bool is_whole = match.chosen.plan.places == 1;
    const Eigen::VectorXd fitting = match.forecast->fitting(best);
    Eigen::VectorXd planned = m_relief.heights;
    for(std::size_t i = 0; i < piece.samples.size(); ++i)
    {
      const Eigen::Index p = Eigen::Index(i), s = Eigen::Index(piece.samples[i]);
      const double displacement = is_whole ? fitting[p] : result.heights[p] - match.reliefs[best].height[s];
      const double blend = (1 - piece.weights[i]) * (m_relief.heights[s] - result.heights[p]);
      result.carried.displacement[s] = displacement + blend;
      planned[s] = result.heights[p] + blend;
    }
    result.carried.set_surface(match.reliefs[best], planned);
    result.carried.is_whole = is_whole;
    result.carried.tolerance = is_whole ? m_sampler->height_limit() : 1.5 * m_patch->spacing();
    return result;
  }

  /// Settles a piece. \return whether it was replaced; otherwise it was confirmed as it is
  bool insert(const Hole_piece& piece, const Piece_filling& filling)
  {
    // where the piece says what is there already, it is confirmed: another patch would but add a seam
    const bool is_replaced = change(piece, filling.heights) >= 0.05 * m_patch->spacing();
    m_tried_at[piece.number] = ++m_time;   // what it settles itself is no news to it
    for(std::size_t i = 0; i < piece.samples.size(); ++i)
    {
      const Eigen::Index s = Eigen::Index(piece.samples[i]);
      const double w = piece.weights[i];
      m_relief.errors[s] += w * (filling.error - m_relief.errors[s]);
      if(w > 0.5)
      {
        m_settled_by[std::size_t(s)] = piece.number;
        m_settled_at[std::size_t(s)] = m_time;
      }
      if(!is_replaced)
        continue;
      const double step = w * (filling.heights[Eigen::Index(i)] - m_relief.heights[s]);
      m_relief.heights[s] += step;
      for(Carried_place& other : m_relief.copies) // where it keeps its points, they follow
      {
        other.displacement[s] += step;
        other.surface[s] += step;
      }
      if(w > 0.5)
        m_relief.copy[std::size_t(s)] = m_relief.copies.size();
    }
    update_known_shares(piece);
    if(m_ingredients.coherence)
      m_hints.insert(m_hints.begin(), filling.carried.place);
    if(is_replaced)
    {
      m_relief.copies.push_back(filling.carried);
      ++m_replaced;
    }
    return is_replaced;
  }

private:
  // Forecasts of pieces, which know but a part of their rim, were seen up to two and a half times too low.
  static double margin() { return 0.4; }

  // A copy over the whole hole was believed, which knew all of the rim. A piece that changes it by much more than is
  // expected to be missed there flattens a feature of which its own surroundings show nothing.
  bool contradicts(const Hole_piece& piece, const Eigen::VectorXd& heights) const
  {
    return change(piece, heights) > 3 * error(piece);
  }

  // Mean distance of heights, parallel to the samples of a piece, from what is there.
  double change(const Hole_piece& piece, const Eigen::VectorXd& heights) const
  {
    double sum = 0, total = 0;
    for(std::size_t i = 0; i < piece.samples.size(); ++i)
    {
      const double old = m_relief.heights[Eigen::Index(piece.samples[i])];
      sum += piece.weights[i] * std::abs(heights[Eigen::Index(i)] - old);
      total += piece.weights[i];
    }
    return sum / total;
  }

  static double radius(const Patch& patch, std::size_t level)
  {
    return std::ldexp(patch.diameter() / 2, -int(level));
  }

  // Each step of the loop asks for the shares of all pieces, so they are kept: only those of pieces near the one that
  // has been settled can be different.
  void update_known_shares(const Hole_piece& settled)
  {
    const auto middle = [&](const Hole_piece& piece) { return m_patch->samples()[piece.middle].position; };
    // a piece settles samples within its radius, and knows of those within its own and the width around it
    const double reach = 2 * settled.radius + Hole_pieces<ConcurrencyTag>::width(settled.radius, m_patch->spacing());
    for(const Hole_piece& piece : m_pieces)
      if((middle(piece) - middle(settled)).norm() <= 1.001 * reach)
        m_known_share[piece.number] = m_pieces_of.controls(piece, m_settled_by).known_share;
  }

  // No probes inside: fake pieces that were chosen for what the coarser level left would agree on it.
  Match_target match_target(const Hole_piece& piece, const Piece_controls& controls) const
  {
    Match_target target;
    target.spacing = m_patch->spacing();
    target.radius = piece.radius;
    const Base_sample& middle = m_patch->samples()[piece.middle];
    target.frame.origin = middle.position + m_relief.heights[Eigen::Index(piece.middle)] * middle.normal;
    target.frame.normal = middle.normal;
    target.frame.axis = middle.normal.unitOrthogonal();
    const double width = Hole_pieces<ConcurrencyTag>::width(piece.radius, m_patch->spacing());
    std::vector<std::pair<double, Match_probe> > overlap;
    for(const Band_point& b : m_patch->band())
    {
      Match_probe probe;
      probe.position = m_known.position(b.index);
      probe.normal = m_known.normal(b.index);
      const double distance = (std::max)(0., (probe.position - middle.position).norm() - piece.radius);
      if(distance > width || !is_same_side(probe.normal, middle.normal))
        continue;
      probe.weight = std::exp(-distance / (0.5 * width));
      overlap.emplace_back(distance, probe);
    }
    for(std::size_t s : controls.settled)
    {
      Match_probe probe = on_relief(s);
      const double distance = (std::max)(0., (probe.position - middle.position).norm() - piece.radius);
      probe.weight = 0.5 * std::exp(-distance / (0.5 * width));
      overlap.emplace_back(distance, probe);
    }
    std::stable_sort(overlap.begin(), overlap.end(), [](const std::pair<double, Match_probe>& a,
                                                        const std::pair<double, Match_probe>& b)
      { return a.first < b.first; });
    for(const std::pair<double, Match_probe>& probe : overlap)
      target.overlap.push_back(probe.second);
    target.overlap = thinned(target.overlap, 400);
    target.describe_surroundings(m_known);
    std::vector<std::size_t> ball;
    m_sampler->search().in_ball(target.frame.origin, target.reach(), ball);
    for(std::size_t s : ball)
    {
      const Match_probe probe = on_relief(s);
      target.surface.push_back(probe.position, probe.normal);
    }
    return target;
  }

  // a point of the current filling
  Match_probe on_relief(std::size_t s) const
  {
    const Base_sample& sample = m_patch->samples()[s];
    double height;
    Vector gradient, direction;
    m_sampler->interpolate(s, sample.position, m_relief.heights, height, gradient, direction);
    Match_probe probe;
    probe.position = sample.position + m_relief.heights[Eigen::Index(s)] * sample.normal;
    probe.normal = (sample.normal - gradient).normalized();
    return probe;
  }

  const Model& m_known;
  const Place_search<ConcurrencyTag>& m_search;
  std::shared_ptr<const Patch> m_patch;
  std::shared_ptr<const Relief_sampler<ConcurrencyTag> > m_sampler;
  Ingredients m_ingredients;
  std::vector<Place> m_hints;            // places of the whole hole, and those of the pieces
  Hole_relief m_relief;
  Eigen::VectorXd m_first;               // heights that the first level left
  bool m_is_copy;                        // whether that is one copy of a whole place
  std::vector<std::size_t> m_settled_by; // per sample: the piece that filled it on this level, or `no_index`
  std::vector<std::size_t> m_settled_at; // per sample: the insertion that did
  std::vector<std::size_t> m_tried_at;   // per piece: insertions before its last search, or `no_index`
  std::vector<double> m_known_share;     // per piece
  std::size_t m_time = 0;                // insertions on this level
  Hole_pieces<ConcurrencyTag> m_pieces_of;
  std::vector<Hole_piece> m_pieces;
  std::size_t m_replaced = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_REFINEMENT_H
