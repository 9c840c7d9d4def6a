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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_POINT_GRID_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_POINT_GRID_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Points that arrive one by one, in cubic buckets of the size of the queries: the neighbour search of growing sets
  (CGAL's `Kd_tree` must be rebuilt after an insertion).
*/
class Point_grid
{
  typedef std::array<long, 3> Key;

public:
  /// \param size edge of a bucket, positive
  explicit Point_grid(double size) : m_size(size) {}

  /// Adds a point under the number that `number_of_points()` returned before.
  void insert(const Vector& p)
  {
    m_buckets[key(p)].push_back(m_points.size());
    m_points.push_back(p);
  }

  std::size_t number_of_points() const { return m_points.size(); }
  const Vector& point(std::size_t i) const { return m_points[i]; }

  /// Calls `visit(index, distance)` for each point within `radius` until it returns `false`.
  template <typename Visit>
  void for_each_in_ball(const Vector& q, double radius, Visit visit) const
  {
    const Key low = key(q - Vector::Constant(radius)), high = key(q + Vector::Constant(radius));
    double buckets = 1;
    for(std::size_t c = 0; c < low.size(); ++c)
      buckets *= double(high[c] - low[c] + 1);
    if(buckets > double(m_points.size()))   // a large ball, in which nearly all of them are empty
    {
      for(std::size_t i = 0; i < m_points.size(); ++i)
        if(!visit_if_inside(i, q, radius, visit))
          return;
      return;
    }
    for(long x = low[0]; x <= high[0]; ++x)
      for(long y = low[1]; y <= high[1]; ++y)
        for(long z = low[2]; z <= high[2]; ++z)
        {
          const auto bucket = m_buckets.find(Key{{x, y, z}});
          if(bucket == m_buckets.end())
            continue;
          for(std::size_t i : bucket->second)
            if(!visit_if_inside(i, q, radius, visit))
              return;
        }
  }

private:
  template <typename Visit>
  bool visit_if_inside(std::size_t i, const Vector& q, double radius, Visit& visit) const
  {
    const double distance = (m_points[i] - q).norm();
    return distance > radius || visit(i, distance);
  }

  Key key(const Vector& p) const
  {
    return Key{{long(std::floor(p.x() / m_size)), long(std::floor(p.y() / m_size)), long(std::floor(p.z() / m_size))}};
  }

  double m_size;
  std::vector<Vector> m_points;
  std::unordered_map<Key, std::vector<std::size_t>, boost::hash<Key> > m_buckets;
};

/// Whether there is a point within a distance whose normal looks to the same side. \param normals of the points of the grid
inline bool has_point_on_side(const Point_grid& grid, const std::vector<Vector>& normals, const Vector& x,
                              const Vector& normal, double distance)
{
  bool is_found = false;
  grid.for_each_in_ball(x, distance, [&](std::size_t i, double) {
    is_found = is_same_side(normal, normals[i]);
    return !is_found; });
  return is_found;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_POINT_GRID_H
