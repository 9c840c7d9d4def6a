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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_ENGINE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_ENGINE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cancellation.h>
#include <CGAL/Context_completion_3/internal/Completion_loop.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Example_policy.h>
#include <CGAL/Context_completion_3/internal/Hole_completion.h>
#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Paper_policy.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// The engine behind the public door: flat arrays in, holes and new points out.
template <typename ConcurrencyTag>
class Completion_engine
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Example_source<ConcurrencyTag> Source;

public:
  typedef std::function<bool(double)> Callback;

  /// \param points finite positions, unit normals; kept by reference \param parameters see there
  Completion_engine(const Surface_points& points, const Engine_parameters& parameters)
    : m_points(points), m_parameters(parameters),
      m_model(std::make_shared<Model>(points))
  {}

  /// Median distance to the nearest neighbour.
  double spacing() const { return m_model->spacing(); }

  /// Finds the holes. \return `false` if the callback stopped it; then nothing is kept.
  bool detect(const Callback& callback)
  {
    if(m_is_detected)
      return true;
    if(m_parameters.paper ? !detect_by_paper(callback) : !detect_by_rims(callback))
      return false;
    m_is_detected = true;
    return true;
  }

  const std::vector<Hole_data>& holes() const { return m_holes; }

  /// Fills the chosen holes. \return `false` if the callback stopped it; then the points added before stay.
  bool complete(const std::vector<std::size_t>& chosen, const Callback& callback)
  {
    if(!detect(Callback()))
      return false;
    if(m_parameters.paper)
    {
      m_paper->choose(chosen);
      const bool is_complete = Completion_loop<Paper_policy>(*m_paper, callback).run();
      m_added = m_paper->added();
      m_outcomes = m_paper->outcomes();
      return is_complete;
    }
    prepare_sources();
    const Hole_completion<ConcurrencyTag> completion = hole_completion();
    Example_policy<ConcurrencyTag> policy(*m_map, completion, m_detected, chosen, m_added, m_outcomes);
    return Completion_loop<Example_policy<ConcurrencyTag> >(policy, callback).run();
  }

  /// Whether it makes no difference in which order holes are filled, and with which others. By the paper's policy a
  /// hole changes the fits of the cells that another one sees, and the cells of all holes compete for the next turn.
  bool are_holes_independent() const { return !m_parameters.paper; }

  const std::vector<Added_point>& added() const { return m_added; }
  const std::vector<Hole_outcome>& outcomes() const { return m_outcomes; }

private:
  bool detect_by_rims(const Callback& callback)
  {
    m_detected.clear();
    const double share_of_rims = 0.9;
    const Callback of_rims = [&](double fraction) { return !callback || callback(share_of_rims * fraction); };
    if(!Hole_detection<ConcurrencyTag>(*m_model, m_parameters.user_holes, m_parameters.known_rims)
         .run(m_detected, of_rims))
      return false;
    m_map = std::make_unique<Hole_map<ConcurrencyTag> >(m_points, spacing(), m_parameters.maximum_depth,
                                                        m_parameters.minimum_cell_points);
    try
    {
      tell_open_ends([&](double fraction) {
        make_poll(callback, share_of_rims + (1 - share_of_rims) * fraction)(); });
    }
    catch(const Cancelled&)
    {
      return false;
    }
    for(const Detected_hole<ConcurrencyTag>& hole : m_detected)
      m_holes.push_back(describe(hole));
    m_outcomes.resize(m_holes.size());
    return true;
  }

  // Ends of tubes that are holes, as far as they would be filled then.
  void tell_open_ends(const std::function<void(double)>& report_progress)
  {
    std::vector<std::size_t> ends;
    for(std::size_t h = 0; h < m_detected.size(); ++h)
      if(m_detected[h].is_end && describe(taken_for_hole(m_detected[h])).state == Hole_state::hole)
        ends.push_back(h);
    if(ends.empty() || !m_parameters.ingredients.open_ends)
      return;
    prepare_sources();
    const Hole_completion<ConcurrencyTag> completion = hole_completion();
    // rim points: pieces of a rim may have led to one base, or the user has named it
    std::set<std::size_t> closed;
    for(const Detected_hole<ConcurrencyTag>& hole : m_detected)
      if(hole.is_named)
        closed.insert(hole.patch->rim().begin(), hole.patch->rim().end());
    for(std::size_t i = 0; i < ends.size(); ++i)
    {
      const Detected_hole<ConcurrencyTag> hole = taken_for_hole(m_detected[ends[i]]);
      const std::vector<std::size_t>& rim = hole.patch->rim();
      const Poll poll = [&]() { report_progress(double(i) / double(ends.size())); };
      poll();
      if(std::any_of(rim.begin(), rim.end(), [&](std::size_t p) { return closed.count(p) > 0; }) ||
         !completion.is_cut_off(hole, poll))
        continue;
      m_detected[ends[i]] = hole;
      closed.insert(rim.begin(), rim.end());
    }
  }

  static Detected_hole<ConcurrencyTag> taken_for_hole(Detected_hole<ConcurrencyTag> border)
  {
    border.is_outer_border = false;
    border.loops = border.patch->loops();
    return border;
  }

  // with the sources prepared, which it refers to
  Hole_completion<ConcurrencyTag> hole_completion() const
  {
    Search_settings search;
    search.number_of_turns = m_parameters.number_of_turns;
    search.mirror = m_parameters.mirror;
    search.number_of_places = m_parameters.number_of_candidates;
    search.alignment = m_parameters.ingredients.alignment;
    search.signature = m_parameters.ingredients.signature;
    search.probes = m_parameters.ingredients.probes;
    return Hole_completion<ConcurrencyTag>(*m_model, m_sources, search, m_parameters.keep_texture,
                                           m_parameters.ingredients);
  }

  bool detect_by_paper(const Callback& callback)
  {
    if(callback && !callback(0.))
      return false;
    try
    {
      m_paper = std::make_unique<Paper_policy>(m_points, m_parameters, spacing(), make_poll(callback, 0.5));
    }
    catch(const Cancelled&)
    {
      return false;
    }
    m_holes = m_paper->holes();
    m_outcomes = m_paper->outcomes();
    return !callback || callback(1.);
  }

  Hole_data describe(const Detected_hole<ConcurrencyTag>& hole) const
  {
    Hole_data data;
    std::size_t number = 0;
    for(const Rim_loop& loop : hole.loops)
    {
      data.loops.emplace_back();
      for(const Rim_point& p : loop.points)
      {
        data.loops.back().push_back(p.index);
        data.spacing += m_model->spacing(p.index);
        ++number;
      }
    }
    data.center = hole.center();
    data.spacing /= double(number);
    data.diameter = hole.loops.front().diameter;
    if(hole.patch)
    {
      data.diameter = hole.patch->diameter();
      data.spacing = hole.patch->spacing();
      data.cells = m_map->invalid_cells(*hole.patch);
    }
    const double smallest = m_parameters.minimum_hole_diameter > 0 ? m_parameters.minimum_hole_diameter
                                                                   : 4.5 * data.spacing;
    if(hole.is_named)
      data.state = Hole_state::hole;
    else if(hole.is_outer_border)
      data.state = Hole_state::outer_border;
    else if(data.diameter < smallest)
      data.state = Hole_state::too_small;
    else if(m_parameters.maximum_hole_diameter > 0 && data.diameter > m_parameters.maximum_hole_diameter)
      data.state = Hole_state::too_large;
    else if((!m_parameters.regions.empty() && !is_inside_any(data.center, m_parameters.regions)) ||
            is_inside_any(data.center, m_parameters.excluded_regions))
      data.state = Hole_state::excluded;
    return data;
  }

  void prepare_sources()
  {
    if(!m_sources.empty())
      return;
    Source own;
    if(m_parameters.is_example.empty())
    {
      own.points = std::shared_ptr<const Surface_points>(&m_points, [](const Surface_points*) {});
      own.model = m_model;
    }
    else
    {
      const std::shared_ptr<Surface_points> allowed = std::make_shared<Surface_points>();
      for(std::size_t i = 0; i < m_points.size(); ++i)
        if(m_parameters.is_example[i])
        {
          allowed->push_back(m_points.position[i], m_points.normal[i]);
          own.original.push_back(i);
        }
      own.points = allowed;
      own.model = std::make_shared<const Model>(*allowed);
    }
    m_sources.push_back(own);
    for(std::size_t e = 0; e < m_parameters.examples.size(); ++e)
    {
      Source further;
      further.set = e + 1;
      further.points = std::shared_ptr<const Surface_points>(&m_parameters.examples[e], [](const Surface_points*) {});
      further.model = std::make_shared<const Model>(*further.points);
      m_sources.push_back(further);
    }
  }

  const Surface_points& m_points;
  Engine_parameters m_parameters;
  std::shared_ptr<const Model> m_model;
  std::unique_ptr<Hole_map<ConcurrencyTag> > m_map;
  std::unique_ptr<Paper_policy> m_paper;                // the paper's policy keeps its own model
  std::vector<Source> m_sources;
  bool m_is_detected = false;
  std::vector<Detected_hole<ConcurrencyTag> > m_detected;   // parallel to m_holes
  std::vector<Hole_data> m_holes;
  std::vector<Hole_outcome> m_outcomes;
  std::vector<Added_point> m_added;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_COMPLETION_ENGINE_H
