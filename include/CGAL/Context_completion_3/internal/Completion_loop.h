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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_LOOP_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_LOOP_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cancellation.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The coarse to fine loop of the paper (section 4, figure 4), once for all policies.

  A policy provides
  - `typedef Target`: an under-sampled place of the current level (a cell, or the joined cells of a hole),
    `typedef Match`: the best matching source place, `typedef Patch`: points that are ready to be inserted;
  - `std::size_t first_level()`, `bool is_last_level(std::size_t level)`: the range of levels, the stop rule of line 13;
  - `void begin_level(std::size_t level)`: signatures of the level (line 3);
  - `std::vector<Target> find_invalid(std::size_t level)`: line 4;
  - `std::size_t number_of_valid_neighbors(const Target&)`: the order of line 6, asked anew after each insertion;
  - `bool is_still_invalid(const Target&)`: void and invalid are dynamic (section 5), so a target is asked again
    when its turn comes;
  - `Match find_best_match(const Target&, const Poll&)`: line 7; if it takes long it calls the poll now and then, before
    it changes anything; `bool is_found(const Match&)`;
  - `Patch transfer(const Target&, const Match&)`: alignment and warp (section 7);
  - `void insert(const Target&, const Match&, const Patch&)`: lines 8 and 9, accepted or kept as intermediate,
    with the update of the approximations that depend on it;
  - `void end_level(std::size_t level)`: line 12;
  - `double progress(std::size_t level, double fraction_of_level)`: the fraction of the whole run.
*/
template <typename Policy>
class Completion_loop
{
public:
  typedef std::function<bool(double)> Callback;

  /// \param policy see above \param callback receives the fraction done; `false` stops the loop
  Completion_loop(Policy& policy, const Callback& callback)
    : m_policy(policy), m_callback(callback)
  {}

  /// Runs the loop. \return whether it ran to its end, `false` if the callback stopped it.
  bool run()
  {
    try
    {
      return run_to_end();
    }
    catch(const Cancelled&)
    {
      return false;
    }
  }

private:
  bool run_to_end()
  {
    typedef typename Policy::Target Target;
    for(std::size_t level = m_policy.first_level(); ; ++level)
    {
      m_policy.begin_level(level);
      std::vector<Target> targets = m_policy.find_invalid(level);
      const std::size_t number = targets.size();
      while(!targets.empty())
      {
        const double fraction = m_policy.progress(level, double(number - targets.size()) / double(number));
        const Poll poll = make_poll(m_callback, fraction);
        poll();
        const Target target = take_best(targets);
        if(!m_policy.is_still_invalid(target))
          continue;
        const typename Policy::Match match = m_policy.find_best_match(target, poll);
        if(m_policy.is_found(match))
          m_policy.insert(target, match, m_policy.transfer(target, match));
      }
      m_policy.end_level(level);
      if(m_policy.is_last_level(level))
        return !m_callback || m_callback(m_policy.progress(level, 1.));
    }
  }

  // the most valid neighbours first, the earlier one among equals
  template <typename Target>
  Target take_best(std::vector<Target>& targets) const
  {
    std::size_t best = 0, most = 0;
    for(std::size_t i = 0; i < targets.size(); ++i)
    {
      const std::size_t valid = m_policy.number_of_valid_neighbors(targets[i]);
      if(i == 0 || valid > most)
      {
        best = i;
        most = valid;
      }
    }
    const Target target = targets[best];
    targets.erase(targets.begin() + static_cast<std::ptrdiff_t>(best));
    return target;
  }

  Policy& m_policy;
  const Callback& m_callback;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_LOOP_H
