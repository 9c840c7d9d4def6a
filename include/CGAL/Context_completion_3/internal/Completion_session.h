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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_SESSION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_SESSION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Runs the engine hole by hole where holes are independent, so that a visitor hears of each as it is done and a later
  call goes on behind the last one; otherwise all at once. Keeps account of what has been handed out. Neither copied nor
  moved: the engine may refer to the points.
*/
template <typename ConcurrencyTag>
class Completion_session
{
  typedef Completion_engine<ConcurrencyTag> Engine;

public:
  typedef std::function<bool(double)> Callback;

  Completion_session(Surface_points points, const Engine_parameters& parameters)
    : m_points(std::move(points)), m_engine(m_points, parameters)
  {}

  Completion_session(const Completion_session&) = delete;
  Completion_session& operator=(const Completion_session&) = delete;

  double spacing() const { return m_engine.spacing(); }
  bool is_detected() const { return m_is_detected; }
  const std::vector<Hole_data>& holes() const { return m_engine.holes(); }
  const std::vector<Hole_outcome>& outcomes() const { return m_engine.outcomes(); }

  /// \return `false` if the callback cancelled
  template <typename Visitor>
  bool detect(const Callback& callback, Visitor& visitor)
  {
    if(m_is_detected)
      return true;
    visitor.on_detection_begin(m_points.size());
    if(!m_engine.detect(callback))
      return false;
    visitor.on_detection_end(holes().size());
    m_is_completed.assign(holes().size(), false);
    m_is_handed_out.assign(holes().size(), false);
    m_is_detected = true;
    return true;
  }

  /// Fills those of the chosen holes that are not yet completed. \return `false` if the callback cancelled
  template <typename Visitor>
  bool complete(const std::vector<std::size_t>& chosen, const Callback& callback, Visitor& visitor)
  {
    std::vector<std::size_t> waiting;
    for(std::size_t hole : chosen)
      if(!m_is_completed[hole])
        waiting.push_back(hole);

    visitor.on_completion_begin(waiting.size());
    std::size_t number_of_new_points = 0;
    const std::size_t step = m_engine.are_holes_independent() ? 1 : waiting.size();
    for(std::size_t i = 0; i < waiting.size(); i += step)
    {
      const std::vector<std::size_t> holes(waiting.begin() + std::ptrdiff_t(i),
                                           waiting.begin() + std::ptrdiff_t(i + step));
      const auto part = [&](double fraction)
        { return !callback || callback((double(i) + fraction * double(step)) / double(waiting.size())); };
      for(std::size_t hole : holes)
        visitor.on_hole_begin(hole);
      if(!complete(holes, part))
        return false;
      for(std::size_t hole : holes)
      {
        number_of_new_points += outcomes()[hole].added;
        visitor.on_hole_end(hole, outcomes()[hole].added);
      }
    }
    visitor.on_completion_end(number_of_new_points);
    return true;
  }

  /// The points of all completed holes that no earlier call has returned.
  std::vector<Added_point> hand_out()
  {
    std::vector<Added_point> result;
    for(const Added_point& point : m_engine.added())
      if(m_is_completed[point.hole] && !m_is_handed_out[point.hole])
        result.push_back(point);
    m_is_handed_out = m_is_completed;
    return result;
  }

private:
  bool complete(const std::vector<std::size_t>& holes, const Callback& callback)
  {
    // a callback that cancels or throws after the last point of the hole must not have it filled a second time
    const std::size_t number_before = m_engine.added().size();
    const auto account = [&](bool is_done)
    {
      const bool has_points = m_engine.are_holes_independent() && m_engine.added().size() > number_before;
      for(std::size_t hole : holes)
        m_is_completed[hole] = is_done || has_points;
    };
    bool is_done = false;
    try
    {
      is_done = m_engine.complete(holes, callback);
    }
    catch(...)
    {
      account(false);
      throw;
    }
    account(is_done);
    return is_done;
  }

  const Surface_points m_points;
  Engine m_engine;
  bool m_is_detected = false;
  std::vector<bool> m_is_completed;
  std::vector<bool> m_is_handed_out;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_SESSION_H
