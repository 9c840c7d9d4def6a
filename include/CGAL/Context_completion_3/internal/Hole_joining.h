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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_JOINING_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_JOINING_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Box_set.h>
#include <CGAL/Context_completion_3/internal/Cell_surface.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Cells of one level joined over faces, edges and corners; groups by their smallest cell, cells in order.
inline std::vector<std::vector<Cell> > joined_cells(const std::vector<Cell>& cells)
{
  std::set<Cell> left(cells.begin(), cells.end());
  std::vector<std::vector<Cell> > groups;
  while(!left.empty())
  {
    std::vector<Cell> group(1, *left.begin());
    left.erase(left.begin());
    for(std::size_t next = 0; next < group.size(); ++next)
      for(std::size_t i = 0; i < 27; ++i)
      {
        const Cell cell = group[next];
        if(!cell.has_neighbor(cell_offset(i)))
          continue;
        const auto found = left.find(cell.neighbor(cell_offset(i)));
        if(found == left.end())
          continue;
        group.push_back(*found);
        left.erase(found);
      }
    std::sort(group.begin(), group.end());
    groups.push_back(group);
  }
  return groups;
}

/// Largest extent of some points over 13 directions: their diameter, at most 8 percent too small.
inline double approximate_diameter(const std::vector<Vector>& points)
{
  double largest = 0;
  for(std::size_t i = own_offset + 1; i < 27 && !points.empty(); ++i)
  {
    const Cell_offset offset = cell_offset(i);
    const Vector direction = Vector(offset[0], offset[1], offset[2]).normalized();
    double low = points.front().dot(direction), high = low;
    for(const Vector& p : points)
    {
      low = (std::min)(low, p.dot(direction));
      high = (std::max)(high, p.dot(direction));
    }
    largest = (std::max)(largest, high - low);
  }
  return largest;
}

/*!
  Describes joined invalid cells as a hole. Cells know no order along a rim: the original points in them, or in the
  cells around them where they are empty, are given as one unordered rim. The diameter is that of the rim.
*/
inline Hole_data describe_hole(const Cell_surface& surface, const std::vector<Cell>& cells, double spacing,
                               const Engine_parameters& parameters, bool is_named)
{
  Hole_data hole;
  hole.spacing = spacing;
  std::set<std::size_t> rim;
  const auto collect = [&](const Cell& cell)
  {
    const Cell_tree::Point_range range = surface.tree().points(cell);
    rim.insert(range.first, range.second);
  };
  for(const Cell& cell : cells)
  {
    hole.cells.push_back(surface.grid().bbox(cell));
    hole.center += surface.grid().center(cell) / double(cells.size());
    collect(cell);
  }
  if(rim.size() < 3)
    for(const Cell& cell : cells)
      for(std::size_t i = 0; i < 27; ++i)
        if(cell.has_neighbor(cell_offset(i)))
          collect(cell.neighbor(cell_offset(i)));
  hole.loops.assign(1, std::vector<std::size_t>(rim.begin(), rim.end()));
  std::vector<Vector> positions;
  for(std::size_t i : rim)
    positions.push_back(surface.surface().position[i]);
  hole.diameter = approximate_diameter(positions);
  if(is_named) // by the user
    return hole;
  if(hole.diameter < parameters.minimum_hole_diameter)
    hole.state = Hole_state::too_small;
  else if(parameters.maximum_hole_diameter > 0 && hole.diameter > parameters.maximum_hole_diameter)
    hole.state = Hole_state::too_large;
  else if((!parameters.regions.empty() && !is_inside_any(hole.center, parameters.regions))
          || is_inside_any(hole.center, parameters.excluded_regions))
    hole.state = Hole_state::excluded;
  return hole;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_JOINING_H
