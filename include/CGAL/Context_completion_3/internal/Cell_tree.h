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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_TREE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_TREE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell_grid.h>
#include <CGAL/Context_completion_3/internal/Cgal_compatibility.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The nested spatial hierarchy of section 3. CGAL's octree decides nothing but which nodes there are; they are copied
  into flat arrays, level by level, in the order of their Morton codes.

  The points are kept once, sorted by the code of their finest cell. So every cell of the full octree, whether it is a
  node or lies below a leaf, owns a contiguous range of one permuted index array, and the cell of a point depends on
  the grid planes alone, not on how a version of CGAL rounds them.
*/
class Cell_tree
{
public:
  typedef std::vector<std::size_t>::const_iterator Point_iterator;
  typedef std::pair<Point_iterator, Point_iterator> Point_range;

  /*!
    \param positions the points
    \param cube the root cell
    \param maximum_depth level of the finest cells, reduced to `Cell::maximum_level` and to 0 for a cube without extent
    \param split called as `split(cell, point_range)` once for each node above the maximum depth, coarse before fine
  */
  template <typename Split>
  Cell_tree(const std::vector<Vector>& positions, const Cell_cube& cube, std::size_t maximum_depth, const Split& split)
    : m_grid(cube, cube.side > 0 ? maximum_depth : 0)
  {
    sort_points(positions);
    build(cube, split);
    measure_subtrees();
  }

  const Cell_grid& grid() const { return m_grid; }
  std::size_t maximum_depth() const { return m_grid.finest(); }

  /// \name Nodes
  /// @{
  std::size_t number_of_nodes() const { return m_cells.size(); }
  const Cell& cell(std::size_t node) const { return m_cells[node]; }
  std::size_t depth(std::size_t node) const { return m_cells[node].level; }
  bool is_leaf(std::size_t node) const { return m_first_child[node] == no_index; }
  /// `no_index` for the root
  std::size_t parent(std::size_t node) const { return m_parent[node]; }
  /// `no_index` for a leaf
  std::size_t child(std::size_t node, std::size_t i) const
  {
    return is_leaf(node) ? no_index : m_first_child[node] + i;
  }
  /// Levels below this node, 0 for a leaf.
  std::size_t subtree_depth(std::size_t node) const { return m_subtree_depth[node]; }
  /// First and one past the last node of a level.
  std::pair<std::size_t, std::size_t> nodes_of_level(std::size_t level) const
  {
    if(level + 1 >= m_first_of_level.size())
      return std::make_pair(number_of_nodes(), number_of_nodes());
    return std::make_pair(m_first_of_level[level], m_first_of_level[level + 1]);
  }
  /// The finest node that encloses the cell.
  std::size_t enclosing_node(const Cell& cell) const
  {
    std::size_t node = 0;
    while(depth(node) < cell.level && !is_leaf(node))
    {
      const std::size_t shift = cell.level - depth(node) - 1;
      std::size_t i = 0;
      for(std::size_t d = 0; d < 3; ++d)
        i |= std::size_t((cell.coordinates[d] >> shift) & 1) << d;
      node = child(node, i);
    }
    return node;
  }
  /// The node that is this cell, `no_index` where the tree is not that fine.
  std::size_t node(const Cell& cell) const
  {
    const std::size_t enclosing = enclosing_node(cell);
    return depth(enclosing) == cell.level ? enclosing : no_index;
  }
  /// Levels of the tree below any cell, 0 for one that is no node.
  std::size_t subtree_depth(const Cell& cell) const
  {
    const std::size_t found = node(cell);
    return found == no_index ? 0 : m_subtree_depth[found];
  }
  /// @}

  /// \name Points
  /// @{
  /// Indices of the points in any cell.
  Point_range points(const Cell& cell) const
  {
    const std::pair<std::uint64_t, std::uint64_t> range = m_grid.code_range(cell);
    const auto first = std::lower_bound(m_codes.begin(), m_codes.end(), range.first);
    const auto last = std::lower_bound(first, m_codes.end(), range.second);
    return Point_range(m_order.begin() + (first - m_codes.begin()), m_order.begin() + (last - m_codes.begin()));
  }
  std::size_t number_of_points(const Cell& cell) const
  {
    const Point_range range = points(cell);
    return std::size_t(range.second - range.first);
  }
  /// All cells of a level that hold a point, nodes or not, by increasing code.
  std::vector<Cell> occupied_cells(std::size_t level) const
  {
    std::vector<Cell> cells;
    const std::uint64_t shift = 3 * (maximum_depth() - level);
    for(std::size_t i = 0; i < m_codes.size(); ++i)
    {
      if(i > 0 && (m_codes[i] >> shift) == (m_codes[i - 1] >> shift))
        continue;
      Cell found;
      found.level = level;
      found.coordinates = morton_coordinates(m_codes[i] >> shift);
      cells.push_back(found);
    }
    return cells;
  }
  /// @}

private:
  void sort_points(const std::vector<Vector>& positions)
  {
    std::vector<std::pair<std::uint64_t, std::size_t> > coded(positions.size());
    for(std::size_t i = 0; i < positions.size(); ++i)
      coded[i] = std::make_pair(m_grid.finest_code(positions[i]), i);
    std::sort(coded.begin(), coded.end());
    m_codes.reserve(coded.size());
    m_order.reserve(coded.size());
    for(const std::pair<std::uint64_t, std::size_t>& c : coded)
    {
      m_codes.push_back(c.first);
      m_order.push_back(c.second);
    }
  }

  template <typename Split>
  void build(const Cell_cube& cube, const Split& split)
  {
    typedef Exact_predicates_inexact_constructions_kernel K;
    typedef K::Point_3 Point;
    typedef Pointer_property_map<Point>::const_type Point_map;
    typedef Cubic_octree<K, std::vector<std::size_t>, Point_map> Octree;

    // two opposite corners make CGAL's cube ours; the points themselves are already distributed
    const Vector upper = cube.lower + Vector::Constant(cube.side);
    const std::vector<Point> corners = { Point(cube.lower.x(), cube.lower.y(), cube.lower.z()),
                                         Point(upper.x(), upper.y(), upper.z()) };
    std::vector<std::size_t> range = { 0, 1 };
    const std::unique_ptr<Octree> octree = make_cubic_octree<Octree>(range, Point_map(corners.data()));
    if(maximum_depth() > 0)
      refine_octree(*octree, [&](std::size_t level, const std::array<std::uint32_t, 3>& coordinates)
        {
          Cell cell;
          cell.level = level;
          cell.coordinates = coordinates;
          return level < maximum_depth() && split(cell, points(cell));
        });
    copy(*octree);
  }

  template <typename Octree>
  void copy(const Octree& octree)
  {
    std::vector<Octree_node<Octree> > level(1, octree.root()), next;
    std::vector<std::size_t> parents(1, no_index), next_parents;
    while(!level.empty())
    {
      m_first_of_level.push_back(m_cells.size());
      next.clear();
      next_parents.clear();
      const std::size_t first_of_next = m_cells.size() + level.size();
      for(std::size_t i = 0; i < level.size(); ++i)
      {
        Cell cell;
        cell.level = m_first_of_level.size() - 1;
        cell.coordinates = octree_coordinates(octree, level[i]);
        m_parent.push_back(parents[i]);
        const bool leaf = is_octree_leaf(octree, level[i]);
        m_first_child.push_back(leaf ? no_index : first_of_next + next.size());
        for(std::size_t c = 0; c < 8 && !leaf; ++c)
        {
          next.push_back(octree_child(octree, level[i], c));
          next_parents.push_back(m_cells.size());
        }
        m_cells.push_back(cell);
      }
      level.swap(next);
      parents.swap(next_parents);
    }
    m_first_of_level.push_back(m_cells.size());
  }

  void measure_subtrees()
  {
    m_subtree_depth.assign(m_cells.size(), 0);
    for(std::size_t node = m_cells.size(); node-- > 1; )
      m_subtree_depth[m_parent[node]] = (std::max)(m_subtree_depth[m_parent[node]], m_subtree_depth[node] + 1);
  }

  Cell_grid m_grid;
  std::vector<std::uint64_t> m_codes;        // of the sorted points
  std::vector<std::size_t> m_order;          // their indices
  std::vector<Cell> m_cells;
  std::vector<std::size_t> m_parent, m_first_child, m_subtree_depth, m_first_of_level;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_TREE_H
