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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_FILLING_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_FILLING_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell_candidates.h>
#include <CGAL/Context_completion_3/internal/Cell_surface.h>
#include <CGAL/Context_completion_3/internal/Quadratic_warp.h>
#include <CGAL/Context_completion_3/internal/Rigid_alignment.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Points that are ready to be inserted into a cell.
struct Cell_patch
{
  Surface_points points;
  std::vector<std::size_t> sources;   ///< per point its index in the source set
  double residual = 0;                ///< root mean squared distance of the surroundings to the patch, eq. 4
};

/*!
  Sections 7 and 7.1: the content of the matching cell, moved by the symmetry into the target cell, aligned rigidly
  with the points around the cell and then warped.
*/
class Cell_filling
{
public:
  /// On coarse levels a ball around a cell holds half the model; this many of its points, evenly spread, are used.
  static constexpr std::size_t maximum_neighbors = 600;

  explicit Cell_filling(const Cell_surface& surface, const Warp_parameters& parameters = Warp_parameters())
    : m_surface(surface), m_parameters(parameters)
  {}

  Cell_patch fill(const Cell& target, const Cell_candidates& candidates, const Cell_match& match) const
  {
    const Cell_surface& source = *candidates.source(match.source).surface;
    const Vector from = source.grid().center(match.cell), to = m_surface.grid().center(target);
    const Matrix& symmetry = candidates.symmetry(match.symmetry).matrix();
    const double edge = m_surface.grid().edge(target.level);
    Cell_patch patch;
    for(std::size_t i : candidates.example_points(match))
    {
      patch.points.push_back(to + symmetry * (source.surface().position[i] - from),
                             symmetry * source.surface().normal[i]);
      patch.sources.push_back(i);
    }
    const std::vector<Vector> neighbors = neighbor_points(target);
    const Rigid_motion motion = iterative_closest_point(patch.points.position, neighbors, 1e-4 * edge);
    for(std::size_t i = 0; i < patch.points.size(); ++i)
    {
      patch.points.position[i] = motion(patch.points.position[i]);
      patch.points.normal[i] = motion.rotation * patch.points.normal[i];
    }
    patch.residual = warp_to_closest_points(patch.points.position, patch.points.normal, neighbors, to, edge,
                                            m_parameters);
    keep_near(to, edge, patch);
    return patch;
  }

  /*!
    "Collecting points in a ball around the cell. The radius of the ball is incremented until at least m/2 neighbor
    points are collected." It starts as the ball through the corners and grows by a quarter of the edge.
  */
  std::vector<Vector> neighbor_points(const Cell& target) const
  {
    const Vector center = m_surface.grid().center(target);
    const double edge = m_surface.grid().edge(target.level);
    double radius = 0.5 * std::sqrt(3.) * edge;
    for(std::size_t level = target.level; ; --level)
    {
      // the 27 cells around an ancestor enclose any ball of this radius around the target's centre
      const double limit = m_surface.grid().edge(level) + 0.5 * edge;
      std::vector<std::pair<double, std::size_t> > found;
      for(std::size_t i = 0; i < 27; ++i)
        if(target.ancestor(level).has_neighbor(cell_offset(i)))
          for(std::size_t p : m_surface.points(target.ancestor(level).neighbor(cell_offset(i))))
            found.emplace_back((m_surface.surface().position[p] - center).norm(), p);
      std::sort(found.begin(), found.end());
      const std::size_t needed = (m_surface.minimum_points() + 1) / 2;
      for(; radius <= limit && edge > 0; radius += 0.25 * edge)
        if(found.size() >= needed && found[needed - 1].first <= radius)
          return spread(found, radius);
      if(level == 0)
        return spread(found, found.empty() ? 0. : found.back().first);
    }
  }

private:
  // A quadratic map that few points determine can fling others away. What leaves the cell by more than half its edge
  // fills another one, if any.
  static void keep_near(const Vector& center, double edge, Cell_patch& patch)
  {
    Cell_patch kept;
    kept.residual = patch.residual;
    for(std::size_t i = 0; i < patch.points.size(); ++i)
      if((patch.points.position[i] - center).lpNorm<Eigen::Infinity>() <= edge)
      {
        kept.points.push_back(patch.points.position[i], patch.points.normal[i]);
        kept.sources.push_back(patch.sources[i]);
      }
    patch = kept;
  }

  std::vector<Vector> spread(const std::vector<std::pair<double, std::size_t> >& found, double radius) const
  {
    std::vector<std::size_t> inside;
    for(const std::pair<double, std::size_t>& f : found)
      if(f.first <= radius)
        inside.push_back(f.second);
    std::sort(inside.begin(), inside.end());
    const std::size_t number = (std::min)(inside.size(), std::size_t(maximum_neighbors));
    std::vector<Vector> result;
    for(std::size_t i = 0; i < number; ++i)
      result.push_back(m_surface.surface().position[inside[i * inside.size() / number]]);
    return result;
  }

  const Cell_surface& m_surface;
  Warp_parameters m_parameters;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_FILLING_H
