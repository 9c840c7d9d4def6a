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
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Local approximations (paper, sections 3 and 4) on support balls instead of in the cells of a tree: for cells of one
  edge that lie and turn as they like. There is one for each point of a surface, and it is made when it is asked for,
  since a search looks at a part of a large surface alone.
*/
class Support_ball_fits
{
public:
  /// \param surface, search kept by reference \param edge of the cells, positive
  Support_ball_fits(const Surface_points& surface, const Neighbor_search& search, double edge)
    : m_points(surface), m_search(search), m_edge(edge), m_slots(surface.size(), no_slot)
  {}

  double edge() const { return m_edge; }
  const Vector& position(std::size_t i) const { return m_points.position[i]; }
  const Vector& normal(std::size_t i) const { return m_points.normal[i]; }

  /// \pre the surface has a point
  std::size_t nearest(const Vector& q) const { return m_search.nearest(q).first; }

  /// The nearest of the eight nearest points that is on the side of `normal`, or the nearest.
  /// \pre the surface has a point
  std::size_t nearest(const Vector& q, const Vector& normal) const
  {
    std::vector<Neighbor_search::Neighbor> found;
    m_search.k_nearest(q, 8, found);
    for(const Neighbor_search::Neighbor& f : found)
      if(is_same_side(normal, m_points.normal[f.first]))
        return f.first;
    return found.front().first;
  }

  /// Asks for the fit at a point.
  void need(std::size_t i)
  {
    if(m_slots[i] != no_slot)
      return;
    m_slots[i] = std::uint32_t(m_fits.size());
    m_fits.emplace_back();
    m_fits.back().center = i;
  }

  /// Makes the fits that were asked for.
  template <typename ConcurrencyTag>
  void make()
  {
    for_each_index<ConcurrencyTag>(m_fits.size() - m_number_of_made,
                                   [&](std::size_t k) { make(m_fits[m_number_of_made + k]); });
    m_number_of_made = m_fits.size();
  }

  /// \pre the fit was asked for and made
  const Local_approximation& fit(std::size_t i) const { return m_fits[m_slots[i]].approximation; }

  /// Largest distance of the points in the middle from the fit; 0 if a cell with them would not be subdivided.
  /// \pre as for `fit()`
  double error(std::size_t i) const { return m_fits[m_slots[i]].error; }

private:
  static constexpr std::uint32_t no_slot = static_cast<std::uint32_t>(-1);

  struct Fit
  {
    std::size_t center = 0;
    Local_approximation approximation;
    double error = 0;
  };

  void make(Fit& fit) const
  {
    const Vector& center = position(fit.center);
    const Fit_data data = ball_support(m_points, m_search, center, m_edge, normal(fit.center), m_parameters);
    fit.approximation = fit_local_approximation(data, m_parameters);
    // the ball with the volume of a cell, since a cube would have to be turned some way
    std::vector<std::size_t> inside;
    for(std::size_t j : data.indices)
      if((position(j) - center).norm() <= 0.62 * m_edge)
        inside.push_back(j);
    if(inside.size() >= m_parameters.minimum_points)
      fit.error = fit.approximation.error(m_points, inside);
  }

  const Surface_points& m_points;
  const Neighbor_search& m_search;
  double m_edge;
  Local_fit_parameters m_parameters;
  std::vector<std::uint32_t> m_slots;            // per point: where its fit is
  std::vector<Fit> m_fits;
  std::size_t m_number_of_made = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SUPPORT_BALL_FITS_H
