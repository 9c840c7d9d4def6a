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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_CELLS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_CELLS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  To which of the chosen holes a cell of any level belongs.

  Holes are sets of cells of the finest level. A coarser cell belongs to the chosen hole of smallest index that it
  reaches into. A cell that becomes invalid later, when the approximation changed (section 5), belongs to the hole
  that its parent was filled for, unless it reaches into a hole that is not to be filled.
*/
class Hole_cells
{
public:
  /// \param groups the finest cells of each hole
  void choose(const std::vector<std::vector<Cell> >& groups, const std::vector<std::size_t>& chosen)
  {
    m_holes.clear();
    m_filled.clear();
    m_barred.clear();
    m_finest.clear();
    const std::set<std::size_t> wanted(chosen.begin(), chosen.end());
    for(std::size_t hole = 0; hole < groups.size(); ++hole)
      for(const Cell& cell : groups[hole])
      {
        const bool is_wanted = wanted.count(hole) != 0;
        if(is_wanted)
          m_finest.push_back(cell);
        for(std::size_t level = 0; level <= cell.level; ++level)
        {
          if(is_wanted)
            m_holes.insert(std::make_pair(cell.ancestor(level), hole));
          else
            m_barred.insert(cell.ancestor(level));
        }
      }
  }

  /// The hole that the cell is filled for; `no_index` if it is left alone.
  std::size_t hole(const Cell& cell) const
  {
    const auto found = m_holes.find(cell);
    if(found != m_holes.end())
      return found->second;
    if(cell.level == 0 || m_barred.count(cell) != 0)
      return no_index;
    const auto parent = m_filled.find(cell.parent());
    return parent == m_filled.end() ? no_index : parent->second;
  }

  void set_filled(const Cell& cell, std::size_t hole) { m_filled.insert(std::make_pair(cell, hole)); }

  /// The finest cells of all chosen holes.
  const std::vector<Cell>& finest() const { return m_finest; }

private:
  std::map<Cell, std::size_t> m_holes, m_filled;
  std::set<Cell> m_barred;
  std::vector<Cell> m_finest;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_CELLS_H
