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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_EDGE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_EDGE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Rim_surroundings.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Where a hole in one side of the surface goes up to an acute edge, its rim is open there: the other side is known, and
  ends at the edge with a rim of its own, which looks away. The base must end there, too.
*/
template <typename ConcurrencyTag>
class Base_edge
{
public:
  explicit Base_edge(const Rim_surroundings<ConcurrencyTag>& surroundings)
    : m_surroundings(surroundings), m_grid(reach() * surroundings.spacing()), m_is_reached(surroundings.edge().size(), 0)
  {
    for(const Rim_point& p : surroundings.edge())
      m_grid.insert(surroundings.model().position(p.index));
  }

  /// Whether a place, where the base has some normal, is beyond the nearest point of the edge, which is then reached.
  bool is_beyond(const Vector& x, const Vector& normal)
  {
    if(m_is_reached.empty())
      return false;
    const double h = m_surroundings.spacing();
    std::size_t nearest = no_index;
    double distance = reach() * h;
    m_grid.for_each_in_ball(x, distance, [&](std::size_t k, double d) {
      if(d < distance && !is_same_side(normal, m_surroundings.model().normal(m_surroundings.edge()[k].index)))
      {
        nearest = k;
        distance = d;
      }
      return true; });
    if(nearest == no_index)
      return false;
    // Seen along the normal: where it is led by one side of the rim only, the base may miss the edge.
    const Rim_point& p = m_surroundings.edge()[nearest];
    const Vector way = p.outward - p.outward.dot(normal) * normal;
    if((x - m_surroundings.model().position(p.index)).dot(way) < room() * h * way.norm())
      return false;
    m_is_reached[nearest] = 1;
    return true;
  }

  /// The points reached so far, by increasing index.
  std::vector<std::size_t> reached() const
  {
    std::vector<std::size_t> points;
    for(std::size_t k = 0; k < m_is_reached.size(); ++k)
      if(m_is_reached[k])
        points.push_back(m_surroundings.edge()[k].index);
    std::sort(points.begin(), points.end());
    return points;
  }

  /// Places on the edge, through which the base leads, with normals as at the rim beside them, across the edge.
  std::vector<Base_center> guides() const
  {
    const Surface_model<ConcurrencyTag>& model = m_surroundings.model();
    std::vector<Base_center> result;
    for(const Rim_point& p : m_surroundings.edge())
    {
      Base_center guide;
      guide.position = model.position(p.index) + room() * m_surroundings.spacing() * p.outward;
      for(std::size_t i : m_surroundings.rim())
        guide.normal += model.normal(i) / (model.position(i) - guide.position).squaredNorm();
      // of the other side, the normal and the direction to the edge are both across it
      const Vector along = model.normal(p.index).cross(p.outward).normalized();
      guide.normal = (guide.normal - guide.normal.dot(along) * along).normalized();
      if(guide.normal.allFinite())
        result.push_back(guide);
    }
    return result;
  }

private:
  // In spacings. The last points of the other side are up to one spacing away from the edge.
  static constexpr double reach() { return 3; }
  static constexpr double room() { return 0.4; }

  const Rim_surroundings<ConcurrencyTag>& m_surroundings;
  Point_grid m_grid;
  std::vector<char> m_is_reached;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_EDGE_H
