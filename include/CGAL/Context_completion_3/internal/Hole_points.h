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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_POINTS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_POINTS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Distances that a new point keeps: from new points, from rim points, and from other known points.
struct Point_room
{
  double to_new, to_rim, to_known;
};

/// The new points of a hole, which arrive one by one, and are taken where there is room.
template <typename ConcurrencyTag>
class Hole_points
{
public:
  Hole_points(const Surface_model<ConcurrencyTag>& known, const Smooth_patch<ConcurrencyTag>& patch)
    : m_known(known), m_grid(patch.spacing())
  {
    // Close to rim points is where new points belong; other known points keep them at a distance.
    for(const Band_point& b : patch.band())
      if(b.distance <= 1.2 * patch.spacing())
        m_rim.insert(b.index);
  }

  const std::vector<Added_point>& points() const { return m_points; }

  void add(const Added_point& point, const Point_room& room)
  {
    if(!point.position.allFinite() || !point.normal.allFinite())
      return;
    bool is_free = true;
    m_grid.for_each_in_ball(point.position, room.to_new, [&](std::size_t k, double) {
      is_free = !is_same_side(m_points[k].normal, point.normal);
      return is_free; });
    if(!is_free)
      return;
    m_known.search().in_ball(point.position, (std::max)(room.to_rim, room.to_known), m_ball);
    for(std::size_t k : m_ball)
    {
      const double distance = (m_known.position(k) - point.position).norm();
      if(distance < (m_rim.count(k) > 0 ? room.to_rim : room.to_known) && is_same_side(m_known.normal(k), point.normal))
        return;
    }
    m_grid.insert(point.position);
    m_points.push_back(point);
  }

private:
  const Surface_model<ConcurrencyTag>& m_known;
  Point_grid m_grid;
  std::unordered_set<std::size_t> m_rim;
  std::vector<Added_point> m_points;
  std::vector<std::size_t> m_ball;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_POINTS_H
