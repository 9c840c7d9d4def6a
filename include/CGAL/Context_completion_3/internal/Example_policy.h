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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_EXAMPLE_POLICY_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_EXAMPLE_POLICY_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cancellation.h>
#include <CGAL/Context_completion_3/internal/Hole_completion.h>
#include <CGAL/Context_completion_3/internal/Hole_map.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The default policy of the `Completion_loop`. A hole is filled as a whole at the level whose cells just hold it, so
  large holes come before small ones, each on the coarse surface that its own size calls for. The levels below fill
  pieces of it anew, each as large as a cell, those first whose surroundings are known best. The points follow its last
  level.
*/
template <typename ConcurrencyTag>
class Example_policy
{
  typedef Detected_hole<ConcurrencyTag> Hole;
  typedef Hole_refinement<ConcurrencyTag> Refinement;

  struct Progress
  {
    std::size_t first_level = 0, last_level = 0, finest_copy = 0;
    Hole_match<ConcurrencyTag> match;
    std::unique_ptr<Refinement> refinement;          // once the hole has been filled as a whole
  };

public:
  /// A hole or a piece of it.
  struct Target
  {
    std::size_t chosen;                              ///< index into the chosen holes
    std::size_t piece;                               ///< `no_index`: the whole hole
    std::size_t pass = 0;                            ///< over the pieces of a level
  };

  struct Match
  {
    Hole_match<ConcurrencyTag> hole;
    Piece_match<ConcurrencyTag> piece;
  };

  struct Patch
  {
    Hole_relief hole;
    Piece_filling piece;
  };

  /*!
    \param holes all of them \param chosen indices of those to fill
    \param added, outcomes receive the result
  */
  Example_policy(const Hole_map<ConcurrencyTag>& map, const Hole_completion<ConcurrencyTag>& completion,
                 const std::vector<Hole>& holes, const std::vector<std::size_t>& chosen,
                 std::vector<Added_point>& added, std::vector<Hole_outcome>& outcomes)
    : m_map(map), m_completion(completion), m_holes(holes), m_added(added), m_outcomes(outcomes),
      m_piece_search(completion.piece_search())
  {
    for(std::size_t hole : chosen)
    {
      if(!holes[hole].patch)
      {
        outcomes[hole].reason = "not filled: it opens outwards, so that no base closes it";
        continue;
      }
      m_chosen.push_back(hole);
      m_progress.emplace_back();
      const Smooth_patch<ConcurrencyTag>& patch = *holes[hole].patch;
      Progress& p = m_progress.back();
      p.first_level = p.finest_copy = map.level(patch);
      p.last_level = (std::min)(p.first_level + completion.number_of_finer_levels(patch),
                                (std::max)(p.first_level, map.tree().maximum_depth()));
    }
  }

  /// \name Concept of `Completion_loop`
  /// @{
  std::size_t first_level() const
  {
    std::size_t level = no_index;
    for(const Progress& p : m_progress)
      level = (std::min)(level, p.first_level);
    return m_progress.empty() ? 0 : level;
  }

  bool is_last_level(std::size_t level) const { return level >= last_level(); }

  void begin_level(std::size_t level)
  {
    m_level = level;
    for(Progress& p : m_progress)
      if(p.refinement && level <= p.last_level)
        p.refinement->begin_level(level - p.first_level);
  }

  std::vector<Target> find_invalid(std::size_t level) const
  {
    std::vector<Target> targets;
    for(std::size_t i = 0; i < m_progress.size(); ++i)
    {
      const Progress& p = m_progress[i];
      if(level == p.first_level)
        targets.push_back({i, no_index, 0});
      if(p.refinement && level <= p.last_level)
        for(std::size_t pass = 0; pass < m_completion.number_of_passes(); ++pass)
          for(std::size_t piece = 0; piece < p.refinement->pieces().size(); ++piece)
            targets.push_back({i, piece, pass});
    }
    return targets;
  }

  std::size_t number_of_valid_neighbors(const Target& target) const
  {
    if(is_whole(target))
      return m_map.number_of_valid_neighbors(patch(target));
    // of 26, as cells have; holes one after the other, because they do not depend on each other and share a search
    const std::size_t passes = m_completion.number_of_passes();
    return 27 * (passes * (m_progress.size() - target.chosen) - target.pass) +
           std::size_t(26 * refinement(target).known_share(piece(target)));
  }

  bool is_still_invalid(const Target& target) const
  {
    return is_whole(target) || refinement(target).is_open(piece(target));
  }

  Match find_best_match(const Target& target, const Poll& poll)
  {
    Match match;
    if(is_whole(target))
      match.hole = m_completion.find(m_holes[m_chosen[target.chosen]], poll);
    else
      match.piece = m_progress[target.chosen].refinement->find(piece(target));
    return match;
  }

  bool is_found(const Match& match) const { return match.hole.patch || match.piece.is_found; }

  Patch transfer(const Target& target, const Match& match) const
  {
    Patch result;
    if(is_whole(target))
      result.hole = m_completion.relief(match.hole);
    else
      result.piece = refinement(target).transfer(piece(target), match.piece);
    return result;
  }

  void insert(const Target& target, const Match& match, const Patch& patch)
  {
    Progress& p = m_progress[target.chosen];
    if(is_whole(target))
    {
      p.match = match.hole;
      p.match.shrink();
      p.refinement = m_completion.refinement(p.match, patch.hole, m_piece_search);
      // facets are exact or wrong as a whole, and the forecast of a piece, which is not one of facets, cannot tell
      if(p.match.is_faceted())
        p.last_level = p.first_level;
      if(p.last_level == p.first_level)
        finish(target.chosen);
      return;
    }
    if(p.refinement->insert(piece(target), patch.piece))
      p.finest_copy = m_level;
  }

  void end_level(std::size_t level)
  {
    for(std::size_t i = 0; i < m_progress.size(); ++i)
      if(m_progress[i].refinement && m_progress[i].last_level == level)
        finish(i);
  }

  double progress(std::size_t level, double fraction_of_level) const
  {
    const double levels = double(last_level() - first_level() + 1);
    return (std::min)(1., (double(level - first_level()) + fraction_of_level) / levels);
  }
  /// @}

private:
  static bool is_whole(const Target& target) { return target.piece == no_index; }

  const Smooth_patch<ConcurrencyTag>& patch(const Target& target) const
  {
    return *m_holes[m_chosen[target.chosen]].patch;
  }

  const Refinement& refinement(const Target& target) const { return *m_progress[target.chosen].refinement; }
  const Hole_piece& piece(const Target& target) const { return refinement(target).pieces()[target.piece]; }

  std::size_t last_level() const
  {
    std::size_t level = 0;
    for(const Progress& p : m_progress)
      level = (std::max)(level, p.last_level);
    return level;
  }

  // The points of a hole, which needs nothing more from then on.
  void finish(std::size_t i)
  {
    Progress& p = m_progress[i];
    Hole_filling filling = m_completion.transfer(p.match, *p.refinement);
    for(Added_point& point : filling.points)
    {
      point.hole = m_chosen[i];
      m_added.push_back(point);
    }
    m_outcomes[m_chosen[i]] = filling.outcome;
    m_outcomes[m_chosen[i]].level = p.finest_copy;
    p.refinement.reset();
    p.match = Hole_match<ConcurrencyTag>();
  }

  const Hole_map<ConcurrencyTag>& m_map;
  const Hole_completion<ConcurrencyTag>& m_completion;
  const std::vector<Hole>& m_holes;
  std::vector<std::size_t> m_chosen;
  std::vector<Added_point>& m_added;
  std::vector<Hole_outcome>& m_outcomes;
  std::vector<Progress> m_progress;                  // parallel to m_chosen
  Place_search<ConcurrencyTag> m_piece_search;
  std::size_t m_level = 0;                           // the current one
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_EXAMPLE_POLICY_H
