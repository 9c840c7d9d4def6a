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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SUPPORT_BALL_FITS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SUPPORT_BALL_FITS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Local_fit.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Local approximations (paper, sections 3 and 4) on support balls instead of in the cells of a tree: for cells of one
  edge that lie and turn as they like. Cells near each other share a fit. There is one at each of some points that are
  spread over the surface, and it is made when it is asked for, since a search looks at a part of a large surface alone.
*/
class Support_ball_fits
{
public:
  Support_ball_fits() {}

  /*!
    \param surface is copied, thinned to an eighth of the edge, which leaves some hundred points to a support ball
    \param edge of the cells, positive
    \param smallest distance of the points that are left
  */
  Support_ball_fits(const Surface_points& surface, double edge, double smallest)
    : m_edge(edge)
  {
    const double distance = (std::max)(smallest, edge / 8);
    Point_grid grid(distance);
    for(std::size_t i = 0; i < surface.size(); ++i)
    {
      bool is_free = true;
      grid.for_each_in_ball(surface.position[i], distance, [&](std::size_t j, double) {
        is_free = !is_same_side(surface.normal[i], m_points.normal[j]);
        return is_free; });
      if(!is_free)
        continue;
      grid.insert(surface.position[i]);
      m_points.push_back(surface.position[i], surface.normal[i]);
    }
    m_search = std::make_unique<Neighbor_search>(m_points.position);
    m_states.assign(m_points.size(), State::none);
    m_fits.resize(m_points.size());
    m_errors.assign(m_points.size(), 0.);
  }

  double edge() const { return m_edge; }
  const Surface_points& points() const { return m_points; }
  std::size_t size() const { return m_points.size(); }
  const Vector& position(std::size_t i) const { return m_points.position[i]; }
  const Vector& normal(std::size_t i) const { return m_points.normal[i]; }

  /// \pre size() > 0
  std::size_t nearest(const Vector& q) const { return m_search->nearest(q).first; }

  /// The nearest of the eight nearest points that is on the side of `normal`, or the nearest. \pre size() > 0
  std::size_t nearest(const Vector& q, const Vector& normal) const
  {
    std::vector<Neighbor_search::Neighbor> found;
    m_search->k_nearest(q, 8, found);
    for(const Neighbor_search::Neighbor& f : found)
      if(is_same_side(normal, m_points.normal[f.first]))
        return f.first;
    return found.front().first;
  }

  /// Asks for the fit at a point.
  void need(std::size_t i)
  {
    if(m_states[i] == State::none)
    {
      m_states[i] = State::needed;
      m_needed.push_back(i);
    }
  }

  /// Makes the fits that were asked for.
  template <typename ConcurrencyTag>
  void make()
  {
    for_each_index<ConcurrencyTag>(m_needed.size(), [&](std::size_t k) { make(m_needed[k]); });
    for(std::size_t i : m_needed)
      m_states[i] = State::made;
    m_needed.clear();
  }

  /// \pre the fit was asked for and made
  const Local_approximation& fit(std::size_t i) const { return m_fits[i]; }

  /// Largest distance of the points of the cell from the fit; 0 if they are too few to be subdivided.
  /// \pre as for `fit()`
  double error(std::size_t i) const { return m_errors[i]; }

private:
  enum class State : char { none, needed, made };

  void make(std::size_t i)
  {
    const Fit_data data = ball_support(m_points, *m_search, position(i), m_edge, normal(i), m_parameters);
    m_fits[i] = fit_local_approximation(data, m_parameters);
    std::vector<std::size_t> inside;
    for(std::size_t j : data.indices)
      if((position(j) - position(i)).lpNorm<Eigen::Infinity>() <= m_edge / 2)
        inside.push_back(j);
    if(inside.size() >= m_parameters.minimum_points)
      m_errors[i] = m_fits[i].error(m_points, inside);
  }

  double m_edge = 0;
  Local_fit_parameters m_parameters;
  Surface_points m_points;
  std::unique_ptr<Neighbor_search> m_search;
  std::vector<State> m_states;
  std::vector<std::size_t> m_needed;
  std::vector<Local_approximation> m_fits;
  std::vector<double> m_errors;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SUPPORT_BALL_FITS_H
