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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SURFACE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SURFACE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell_tree.h>
#include <CGAL/Context_completion_3/internal/Local_fit.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  A point set with its tree and the local approximations of its cells on all levels (sections 3 and 4).

  Every cell of the full octree with at least m points carries a fit, whether the tree subdivides that far or not
  ("we further subdivide octcells if necessary", section 4). Other cells carry one if it was assigned to them while
  they were filled. Points may be added; they count at once, while fits change when asked to.
*/
class Cell_surface
{
public:
  /*!
    \param surface the points, which are copied
    \param cube the root cell
    \param finest level of the finest cells
    \param minimum_points m
    \param tolerance epsilon: a cell of more than m points whose fit is worse is subdivided
    \param support_balls whether a cell is fitted to the points of a ball around it that look the same way, instead of
           those in it alone
  */
  Cell_surface(const Surface_points& surface, const Cell_cube& cube, std::size_t finest, std::size_t minimum_points,
               double tolerance, bool support_balls = false)
    : m_surface(surface), m_minimum_points(minimum_points)
  {
    if(support_balls)
      m_original = std::make_unique<Neighbor_search>(surface.position);
    m_fits.resize(finest + 1);
    m_fit_parameters.minimum_points = minimum_points;
    const Cell_grid grid(cube, finest);
    m_tree = std::make_unique<Cell_tree>(m_surface.position, cube, finest,
      [&](const Cell& cell, const Cell_tree::Point_range& range)
      {
        const std::vector<std::size_t> indices(range.first, range.second);
        if(indices.size() < minimum_points)
          return false;
        const Local_approximation& f = m_fits[cell.level][cell] = fitted(grid, cell, indices);
        return indices.size() > minimum_points && f.error(m_surface, indices) > tolerance;
      });
    for(std::size_t level = 0; level <= m_tree->maximum_depth(); ++level)
      for(const Cell& cell : m_tree->occupied_cells(level))
        if(m_tree->number_of_points(cell) >= minimum_points && find(cell) == nullptr)
          fit(cell);
    // the root stands in for every cell without a better one
    if(find(Cell()) == nullptr && m_surface.size() > 0)
      fit(Cell());
  }

  const Surface_points& surface() const { return m_surface; }
  const Cell_tree& tree() const { return *m_tree; }
  const Cell_grid& grid() const { return m_tree->grid(); }
  std::size_t minimum_points() const { return m_minimum_points; }

  /// \name Points
  /// @{
  std::size_t number_of_points(const Cell& cell) const
  {
    const std::pair<Added_iterator, Added_iterator> added = added_points(cell);
    return m_tree->number_of_points(cell) + std::size_t(std::distance(added.first, added.second));
  }

  /// Original points first, then those added.
  std::vector<std::size_t> points(const Cell& cell) const
  {
    const Cell_tree::Point_range original = m_tree->points(cell);
    std::vector<std::size_t> result(original.first, original.second);
    const std::pair<Added_iterator, Added_iterator> added = added_points(cell);
    for(Added_iterator it = added.first; it != added.second; ++it)
      result.push_back(it->second);
    return result;
  }

  /// \return the index of the new point
  std::size_t add_point(const Vector& position, const Vector& normal)
  {
    m_surface.push_back(position, normal);
    m_added.insert(std::make_pair(grid().finest_code(position), m_surface.size() - 1));
    return m_surface.size() - 1;
  }

  /// "Valid if it contains at least m points" (section 3).
  bool is_valid(const Cell& cell) const { return number_of_points(cell) >= m_minimum_points; }
  /// @}

  /// \name Approximations
  /// @{
  /// The approximation that the cell itself carries, or null.
  const Local_approximation* find(const Cell& cell) const
  {
    const auto found = m_fits[cell.level].find(cell);
    return found == m_fits[cell.level].end() ? nullptr : &found->second;
  }

  /// That of the nearest proper ancestor that carries one: the parent, unless it is void; never null but for the root.
  const Local_approximation* find_coarser(const Cell& cell) const
  {
    for(std::size_t level = cell.level; level-- > 0; )
      if(const Local_approximation* f = find(cell.ancestor(level)))
        return f;
    return nullptr;
  }

  /// Fits the cell anew to its points. \pre the cell holds a point
  void fit(const Cell& cell) { assign(cell, fitted(grid(), cell, points(cell))); }

  void assign(const Cell& cell, const Local_approximation& f) { m_fits[cell.level][cell] = f; }

  /// A fit to any points as an approximation of the cell.
  Local_approximation fit_to(const Cell& cell, const Surface_points& surface) const
  {
    std::vector<std::size_t> all(surface.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      all[i] = i;
    return fit_local_approximation(bare_cell_support(surface, all, grid().center(cell), grid().edge(cell.level)),
                                   m_fit_parameters);
  }

  /// All cells of a level that carry an approximation.
  const std::map<Cell, Local_approximation>& fits(std::size_t level) const { return m_fits[level]; }
  /// @}

  /// Original points and those added within `radius`, by increasing index. \pre support balls are used
  void in_ball(const Vector& q, double radius, std::vector<std::size_t>& found) const
  {
    m_original->in_ball(q, radius, found);
    for(std::size_t i = m_original->size(); i < m_surface.size(); ++i)
      if((m_surface.position[i] - q).norm() <= radius)
        found.push_back(i);
  }

private:
  typedef std::multimap<std::uint64_t, std::size_t> Added;
  typedef Added::const_iterator Added_iterator;

  std::pair<Added_iterator, Added_iterator> added_points(const Cell& cell) const
  {
    const std::pair<std::uint64_t, std::uint64_t> range = grid().code_range(cell);
    return std::make_pair(m_added.lower_bound(range.first), m_added.lower_bound(range.second));
  }

  Local_approximation fitted(const Cell_grid& grid, const Cell& cell, const std::vector<std::size_t>& indices) const
  {
    const Vector center = grid.center(cell);
    const double edge = grid.edge(cell.level);
    if(!m_original)
      return fit_local_approximation(bare_cell_support(m_surface, indices, center, edge), m_fit_parameters);
    Vector side = Vector::Zero();
    for(std::size_t i : indices)
      side += m_surface.normal[i];
    // a cell with points on both sides is fitted to all: the far side of a thin part is not far there
    for(std::size_t i : indices)
      if(m_surface.normal[i].dot(side) < 0)
      {
        side.setZero();
        break;
      }
    return fit_local_approximation(ball_support(m_surface, *this, center, edge, side, m_fit_parameters),
                                   m_fit_parameters);
  }

  Surface_points m_surface;
  std::unique_ptr<const Neighbor_search> m_original;        // of the original points, if support balls are used
  std::size_t m_minimum_points;
  Local_fit_parameters m_fit_parameters;
  std::vector<std::map<Cell, Local_approximation> > m_fits; // by level
  std::unique_ptr<Cell_tree> m_tree;
  Added m_added;                                            // by code of the finest level
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SURFACE_H
