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

#ifndef CGAL_CONTEXT_COMPLETION_3_TEST_POINT_SET_SNAPSHOT_H
#define CGAL_CONTEXT_COMPLETION_3_TEST_POINT_SET_SNAPSHOT_H

#include <CGAL/Point_set_3.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

// Everything that can be asked of a point set, to see later whether it was left alone.
template <typename Point_set>
class Point_set_snapshot
{
  typedef typename Point_set::Index Index;

public:
  explicit Point_set_snapshot(const Point_set& points)
    : m_copy(points), m_indices(points.begin(), points.garbage_end()), m_properties(points.properties_and_types())
  {}

  /// Whether the points of the snapshot are there, in the same order and with the same bits.
  bool is_prefix_of(const Point_set& points) const
  {
    if(points.number_of_points() < m_copy.number_of_points() ||
       points.number_of_removed_points() != m_copy.number_of_removed_points() ||
       points.properties_and_types() != m_properties)
      return false;
    const std::size_t alive = m_copy.number_of_points(), added = points.number_of_points() - alive;
    for(std::size_t i = 0; i < m_indices.size(); ++i)
    {
      const std::size_t place = i < alive ? i : i + added; // removed points stay behind the last one
      if(*(points.begin() + static_cast<std::ptrdiff_t>(place)) != m_indices[i])
        return false;
      if(!is_same(points.point(m_indices[i]), m_copy.point(m_indices[i])))
        return false;
      if(m_copy.has_normal_map() && !is_same(points.normal(m_indices[i]), m_copy.normal(m_indices[i])))
        return false;
    }
    return true;
  }

  bool is_equal_to(const Point_set& points) const
  {
    return points.number_of_points() == m_copy.number_of_points() && is_prefix_of(points);
  }

  std::size_t number_of_points() const { return m_copy.number_of_points(); }

private:
  // bits, so that NaN equals NaN
  template <typename T>
  static bool is_same(const T& a, const T& b)
  {
    for(int i = 0; i < 3; ++i)
    {
      const double x = CGAL::to_double(a[i]), y = CGAL::to_double(b[i]);
      if(std::memcmp(&x, &y, sizeof x) != 0)
        return false;
    }
    return true;
  }

  Point_set m_copy;
  std::vector<Index> m_indices;
  std::vector<std::pair<std::string, std::type_index> > m_properties;
};

#endif // CGAL_CONTEXT_COMPLETION_3_TEST_POINT_SET_SNAPSHOT_H
