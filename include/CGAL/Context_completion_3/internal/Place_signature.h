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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SIGNATURE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SIGNATURE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell.h>
#include <CGAL/Context_completion_3/internal/Cell_signature.h>
#include <CGAL/Context_completion_3/internal/Cell_symmetry.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Local_fit.h>
#include <CGAL/Context_completion_3/internal/Motion.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Support_ball_fits.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>
#include <CGAL/Context_completion_3/internal/Thinned_points.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Signatures (paper, section 6.1) in the frames of places: of a cell that is centred at the place and whose third axis
  is the normal there. They have the 243 components of a `Cell_signature`, so equations 1 to 3 compare them. What a cell
  of the tree would look up is found so:
  - the parent is a cell of twice the edge at the same centre;
  - an adjacent cell has an approximation of its own if the point nearest to its centre lies in it;
  - its depth is the number of times that a cell at this point, halved again and again, misses half a spacing.
*/
class Place_signatures
{
public:
  /*!
    \param surface, search all points, kept by reference
    \param coarse points of the surface at about an eighth of the edge of a cell, or more: approximations of large cells
           do without the others
    \param radius of the hole that the cells just hold, positive \param spacing of all points
  */
  Place_signatures(const Surface_points& surface, const Neighbor_search& search, const Surface_points& coarse,
                   double radius, double spacing)
    : m_tolerance(0.5 * spacing)
  {
    const double edge = 2 * radius;
    m_thinned.reserve(own + 1);                  // the levels refer to what is in it
    for(std::size_t level = 0; level <= own; ++level)
      m_thinned.emplace_back(thinned_surface(coarse, edge_of(level, edge) / 8));
    for(std::size_t level = 0; level < number_of_levels; ++level)
      if(level <= own)
        m_levels.emplace_back(m_thinned[level].points, m_thinned[level].search, edge_of(level, edge));
      else
        m_levels.emplace_back(surface, search, edge_of(level, edge));
  }

  Place_signatures(const Place_signatures&) = delete;
  Place_signatures& operator=(const Place_signatures&) = delete;

  /// How far from a place its signature looks: to the corner of the farthest cell, and a support ball from there.
  static double reach(double radius) { return 8 * radius; }

  /// The signatures in some frames. Fits are kept, so that later calls find them. \pre the surface has a point
  template <typename ConcurrencyTag>
  std::vector<Cell_signature> signatures(const std::vector<Surface_frame>& frames)
  {
    std::vector<Cell_content> contents(frames.size());
    for_each_index<ConcurrencyTag>(frames.size(), [&](std::size_t i) { contents[i] = content(frames[i]); });
    for(const Cell_content& c : contents)
    {
      m_levels[parent].need(c.parent);
      for(const Adjacent_points& points : c.adjacent)
        if(points[0] != no_index)
          for(std::size_t level = own; level < number_of_levels; ++level)
            m_levels[level].need(points[level - own]);
    }
    for(Support_ball_fits& level : m_levels)
      level.make<ConcurrencyTag>();
    std::vector<Cell_signature> result(frames.size());
    for_each_index<ConcurrencyTag>(frames.size(), [&](std::size_t i)
      { result[i] = signature(frames[i], contents[i]); });
    return result;
  }

  /// Reflects a frame at the plane of its axis and normal.
  static Cell_symmetry mirror() { return Cell_symmetry(Vector(1, -1, 1).asDiagonal()); }

private:
  static constexpr std::size_t parent = 0, own = 1, number_of_levels = 4;

  // for one cell: the points of each level, from its own downwards, whose fits stand for it
  typedef std::array<std::size_t, number_of_levels - own> Adjacent_points;

  struct Cell_content
  {
    std::size_t parent = 0;
    std::array<Adjacent_points, 27> adjacent;
  };

  struct Thinned
  {
    explicit Thinned(Surface_points thinned) : points(std::move(thinned)), search(points.position) {}
    Surface_points points;
    Neighbor_search search;
  };

  static double edge_of(std::size_t level, double own_edge) { return std::ldexp(own_edge, int(own) - int(level)); }

  static Matrix axes(const Surface_frame& frame)
  {
    Matrix result;
    result << frame.axis, frame.normal.cross(frame.axis), frame.normal;
    return result;
  }

  // From the centre of the cell to that of an adjacent one.
  Vector step(const Matrix& axes, std::size_t i) const
  {
    const Cell_offset offset = cell_offset(i);
    return m_levels[own].edge() * (axes * Vector(offset[0], offset[1], offset[2]));
  }

  Cell_content content(const Surface_frame& frame) const
  {
    Cell_content result;
    result.parent = m_levels[parent].nearest(frame.origin, frame.normal);
    const Support_ball_fits& level = m_levels[own];
    const Matrix m = axes(frame);
    for(std::size_t i = 0; i < 27; ++i)
    {
      Adjacent_points& points = result.adjacent[i];
      const Vector center = frame.origin + step(m, i);
      const std::size_t p = level.nearest(center);
      const Vector y = m.transpose() * (level.position(p) - center);
      points.fill(no_index);
      if(y.lpNorm<Eigen::Infinity>() > level.edge() / 2)
        continue;
      points[0] = p;
      for(std::size_t finer = own + 1; finer < number_of_levels; ++finer)
        points[finer - own] = m_levels[finer].nearest(level.position(p), level.normal(p));
    }
    return result;
  }

  Cell_signature signature(const Surface_frame& frame, const Cell_content& content) const
  {
    typedef Cell_signature S;
    S result;
    const Matrix m = axes(frame);
    const Local_approximation& f = m_levels[parent].fit(content.parent);
    const double edge = m_levels[own].edge();
    for(std::size_t i = 0; i < 27; ++i)
    {
      const int k = int(i);
      const Vector to_center = step(m, i);
      result.write(f, frame.origin + 0.5 * to_center, edge, m, S::inner_distance + k, S::inner_direction + 3 * k);
      const Adjacent_points& points = content.adjacent[i];
      const Local_approximation& g = points[0] == no_index ? f : m_levels[own].fit(points[0]);
      result.write(g, frame.origin + to_center, edge, m, S::outer_distance + k, S::outer_direction + 3 * k);
      result.vector[S::detail + k] = points[0] == no_index || i == own_offset ? S::undefined_detail
                                                                              : float(depth(points));
    }
    return result;
  }

  std::size_t depth(const Adjacent_points& points) const
  {
    std::size_t result = 0;
    while(result < points.size() && m_levels[own + result].error(points[result]) > m_tolerance)
      ++result;
    return result;
  }

  double m_tolerance;
  std::vector<Thinned> m_thinned;
  std::vector<Support_ball_fits> m_levels;       // from the parent of the cells downwards
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SIGNATURE_H
