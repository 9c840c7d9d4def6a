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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CLOSEST_POINT_SEARCH_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CLOSEST_POINT_SEARCH_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// The nearest of some points. A patch of a fine cell has a few dozen points, over which a plain loop is ten times
/// faster than a tree; patches of coarse cells have thousands. Ties go to the smaller index in both.
class Closest_point_search
{
public:
  static constexpr std::size_t smallest_tree = 300;

  /// \param positions must outlive the search
  explicit Closest_point_search(const std::vector<Vector>& positions)
    : m_positions(positions)
  {
    if(positions.size() >= smallest_tree)
      m_tree = std::make_unique<Neighbor_search>(positions);
  }

  /// Index and distance. \pre there are points
  Neighbor_search::Neighbor nearest(const Vector& q) const
  {
    if(m_tree)
      return m_tree->nearest(q);
    std::size_t best = 0;
    double least = (m_positions[0] - q).squaredNorm();
    for(std::size_t i = 1; i < m_positions.size(); ++i)
    {
      const double d = (m_positions[i] - q).squaredNorm();
      if(d >= least)
        continue;
      best = i;
      least = d;
    }
    return Neighbor_search::Neighbor(best, std::sqrt(least));
  }

private:
  const std::vector<Vector>& m_positions;
  std::unique_ptr<Neighbor_search> m_tree;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CLOSEST_POINT_SEARCH_H
