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
  The default policy of the `Completion_loop`. The targets of a level are the holes that a cell of that level just holds,
  so large holes are filled before small ones, on the coarse surface that their own size calls for.
*/
template <typename ConcurrencyTag>
class Example_policy
{
  typedef Detected_hole<ConcurrencyTag> Hole;

public:
  typedef std::size_t Target;                       ///< index of a hole
  typedef Hole_match<ConcurrencyTag> Match;
  typedef Hole_filling Patch;

  /*!
    \param holes all of them \param chosen indices of those to fill
    \param added, outcomes receive the result
  */
  Example_policy(const Hole_map<ConcurrencyTag>& map, const Hole_completion<ConcurrencyTag>& completion,
                 const std::vector<Hole>& holes, const std::vector<std::size_t>& chosen,
                 std::vector<Added_point>& added, std::vector<Hole_outcome>& outcomes)
    : m_map(map), m_completion(completion), m_holes(holes), m_chosen(chosen), m_added(added), m_outcomes(outcomes)
  {
    for(std::size_t hole : chosen)
      m_levels.push_back(map.level(*holes[hole].patch));
  }

  /// \name Concept of `Completion_loop`
  /// @{
  std::size_t first_level() const
  {
    return m_levels.empty() ? 0 : *std::min_element(m_levels.begin(), m_levels.end());
  }

  bool is_last_level(std::size_t level) const
  {
    return m_levels.empty() || level >= *std::max_element(m_levels.begin(), m_levels.end());
  }

  void begin_level(std::size_t) {}

  std::vector<Target> find_invalid(std::size_t level) const
  {
    std::vector<Target> targets;
    for(std::size_t i = 0; i < m_chosen.size(); ++i)
      if(m_levels[i] == level)
        targets.push_back(m_chosen[i]);
    return targets;
  }

  std::size_t number_of_valid_neighbors(Target hole) const
  {
    return m_map.number_of_valid_neighbors(*m_holes[hole].patch);
  }

  bool is_still_invalid(Target) const { return true; }

  Match find_best_match(Target hole) const { return m_completion.find(m_holes[hole]); }

  bool is_found(const Match&) const { return true; }

  Patch transfer(Target, const Match& match) const { return m_completion.transfer(match); }

  void insert(Target hole, const Match&, const Patch& patch)
  {
    for(Added_point point : patch.points)
    {
      point.hole = hole;
      m_added.push_back(point);
    }
    m_outcomes[hole] = patch.outcome;
    m_outcomes[hole].level = m_map.level(*m_holes[hole].patch);
    ++m_done;
  }

  void end_level(std::size_t) {}

  double progress(std::size_t, double) const
  {
    return m_chosen.empty() ? 1. : double(m_done) / double(m_chosen.size());
  }
  /// @}

private:
  const Hole_map<ConcurrencyTag>& m_map;
  const Hole_completion<ConcurrencyTag>& m_completion;
  const std::vector<Hole>& m_holes;
  std::vector<std::size_t> m_chosen;
  std::vector<std::size_t> m_levels;
  std::vector<Added_point>& m_added;
  std::vector<Hole_outcome>& m_outcomes;
  std::size_t m_done = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_EXAMPLE_POLICY_H
