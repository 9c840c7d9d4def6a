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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_CLASSIFICATION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_CLASSIFICATION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Box_quadric_intersection.h>
#include <CGAL/Context_completion_3/internal/Box_quadric_subdivision.h>
#include <CGAL/Context_completion_3/internal/Cell_surface.h>

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Section 3. Surface cells are valid or invalid; the others are void.
enum class Cell_status { void_cell, invalid, valid };

/*!
  Void, invalid or valid (section 5), from the present points and approximations: nothing is stored, so the answer
  follows every change of them, as the paper asks.

  The set of approximations that a cell with fewer than m points is tested against are those of the parent and of the
  26 adjacent cells of its level, as far as they carry one. A void parent carries none; then its nearest ancestor with
  one takes its place. (That one does not meet the parent, or the parent would not be void.) A cell's own
  approximation, known after an intermediate filling, counts, too.
*/
class Cell_classification
{
public:
  explicit Cell_classification(const Cell_surface& surface, const Box_quadric_test& test = Box_quadric_test())
    : m_surface(surface), m_test(test)
  {}

  Cell_status status(const Cell& cell) const
  {
    if(m_surface.is_valid(cell))
      return Cell_status::valid;
    return is_met(cell) ? Cell_status::invalid : Cell_status::void_cell;
  }

  /// Adjacent cells of the same level with at least m points: the order of figure 4, line 6.
  std::size_t number_of_valid_neighbors(const Cell& cell) const
  {
    std::size_t number = 0;
    for(std::size_t i = 0; i < 27; ++i)
      if(i != own_offset && cell.has_neighbor(cell_offset(i)) && m_surface.is_valid(cell.neighbor(cell_offset(i))))
        ++number;
    return number;
  }

  /*!
    All invalid cells of a level of the full octree, in order. Only the children of cells that carry an approximation
    or were invalid themselves, and the cells adjacent to one of their own level that carries one, can be met by any.
    \param invalid_parents the invalid cells of the next coarser level, without those that were filled
  */
  std::vector<Cell> invalid_cells(std::size_t level, const std::vector<Cell>& invalid_parents) const
  {
    std::set<Cell> candidates;
    for(const auto& fit : m_surface.fits(level))
      for(std::size_t i = 0; i < 27; ++i)
        if(fit.first.has_neighbor(cell_offset(i)))
          candidates.insert(fit.first.neighbor(cell_offset(i)));
    if(level > 0)
      for(const auto& fit : m_surface.fits(level - 1))
        for(std::size_t i = 0; i < 8; ++i)
          candidates.insert(fit.first.child(i));
    for(const Cell& parent : invalid_parents)
      for(std::size_t i = 0; i < 8; ++i)
        candidates.insert(parent.child(i));
    std::vector<Cell> result;
    for(const Cell& cell : candidates)
      if(status(cell) == Cell_status::invalid)
        result.push_back(cell);
    return result;
  }

private:
  bool is_met(const Cell& cell) const
  {
    const Bbox_3 box = m_surface.grid().bbox(cell);
    bool met = false;
    for_each_approximation(cell, [&](const Local_approximation& f)
      {
        met = meets(f, box);
        return !met;
      });
    return met;
  }

  // of a piecewise approximation every member is asked: conservative
  bool meets(const Local_approximation& f, const Bbox_3& box) const
  {
    for(const Quadric& q : f.members())
      if(m_test(q, box))
        return true;
    return false;
  }

  template <typename Functor>
  void for_each_approximation(const Cell& cell, const Functor& functor) const
  {
    const Local_approximation* coarser = m_surface.find_coarser(cell);
    if(coarser != nullptr && !functor(*coarser))
      return;
    for(std::size_t i = 0; i < 27; ++i)
    {
      if(!cell.has_neighbor(cell_offset(i)))
        continue;
      const Local_approximation* f = m_surface.find(cell.neighbor(cell_offset(i)));
      if(f != nullptr && !functor(*f))
        return;
    }
  }

  const Cell_surface& m_surface;
  Box_quadric_test m_test;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_CLASSIFICATION_H
