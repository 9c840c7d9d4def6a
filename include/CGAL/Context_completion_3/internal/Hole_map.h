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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_MAP_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_MAP_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell_tree.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Holes in the cell tree of the default policy (paper, sections 3 and 5). A cell holds as many points as the surface in
  it asks for: the area of the base inside over the squared spacing, which the samples of the base count. A cell that
  falls well below is invalid; a fixed number m would call each cell invalid whose corner the surface clips.
*/
template <typename ConcurrencyTag>
class Hole_map
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

public:
  /// \param maximum_depth 0: the finest cells have an edge of at least four spacings
  Hole_map(const Surface_points& points, double spacing, std::size_t maximum_depth, std::size_t minimum_points)
    : m_minimum_points(minimum_points)
  {
    const Cell_cube cube = bounding_cube(points.position);
    std::size_t finest = maximum_depth;
    if(finest == 0)
      while(finest < Cell::maximum_level && std::ldexp(cube.side, -int(finest) - 1) >= 4 * spacing)
        ++finest;
    m_tree = std::make_unique<Cell_tree>(points.position, cube, finest,
      [&](const Cell&, const Cell_tree::Point_range& range)
        { return std::size_t(range.second - range.first) > minimum_points; });
  }

  const Cell_tree& tree() const { return *m_tree; }

  /// The finest level whose cells are as large as the hole.
  std::size_t level(const Patch& patch) const
  {
    std::size_t level = 0;
    while(level < m_tree->maximum_depth() && m_tree->grid().edge(level + 1) >= patch.diameter())
      ++level;
    return level;
  }

  /// The invalid cells of the finest level.
  std::vector<Bbox_3> invalid_cells(const Patch& patch) const
  {
    std::map<Cell, std::size_t> expected;
    for(const Base_sample& s : patch.samples())
      if(s.is_uncovered)
        ++expected[m_tree->grid().finest_cell(s.position)];
    std::vector<Bbox_3> result;
    for(const std::pair<const Cell, std::size_t>& e : expected)
      if(m_tree->number_of_points(e.first) < e.second)
        result.push_back(m_tree->grid().bbox(e.first));
    return result;
  }

  /// Cells of the hole's level around its middle that hold enough points.
  std::size_t number_of_valid_neighbors(const Patch& patch) const
  {
    Vector middle = Vector::Zero();
    for(const Base_sample& s : patch.samples())
      middle += s.position;
    middle /= double(patch.samples().size());
    const Cell cell = m_tree->grid().finest_cell(middle).ancestor(level(patch));
    std::size_t valid = 0;
    for(std::size_t i = 0; i < 27; ++i)
      if(i != own_offset && cell.has_neighbor(cell_offset(i)))
        valid += m_tree->number_of_points(cell.neighbor(cell_offset(i))) >= m_minimum_points;
    return valid;
  }

private:
  std::size_t m_minimum_points;
  std::unique_ptr<Cell_tree> m_tree;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_MAP_H
