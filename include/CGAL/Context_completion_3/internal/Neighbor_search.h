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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_NEIGHBOR_SEARCH_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_NEIGHBOR_SEARCH_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Nearest neighbours and balls in a fixed array of positions: CGAL's `Kd_tree` over indices.
  Queries are `const` and safe from several threads, because the tree is built in the constructor.
  Points at the same distance come by increasing index. Which of several points at the distance of the k-th is returned
  depends on the tree, which is a function of the positions and their order alone, so results repeat.
*/
class Neighbor_search
{
  typedef Exact_predicates_inexact_constructions_kernel K;
  typedef K::Point_3 Point;
  typedef Pointer_property_map<Point>::const_type Point_map;
  typedef Search_traits_adapter<std::size_t, Point_map, Search_traits_3<K> > Traits;
  typedef Orthogonal_k_neighbor_search<Traits> K_search;
  typedef K_search::Tree Tree;
  typedef K_search::Distance Distance;
  typedef Fuzzy_sphere<Traits> Sphere;

  static Point point(const Vector& v) { return Point(v.x(), v.y(), v.z()); }

public:
  typedef std::pair<std::size_t, double> Neighbor; ///< index and distance

  explicit Neighbor_search(const std::vector<Vector>& positions)
  {
    m_points.reserve(positions.size());
    for(const Vector& p : positions)
      m_points.push_back(point(p));
    Traits traits{Point_map(m_points.data())};
    std::vector<std::size_t> indices(positions.size());
    for(std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = i;
    m_tree = std::make_unique<Tree>(indices.begin(), indices.end(), typename Tree::Splitter(), traits);
    if(!indices.empty())
      m_tree->build();
  }

  std::size_t size() const { return m_points.size(); }

  /// Nearest point; (size(), infinity) if there is none.
  Neighbor nearest(const Vector& q) const
  {
    std::vector<Neighbor> found;
    k_nearest(q, 1, found);
    return found.empty() ? Neighbor(size(), std::numeric_limits<double>::infinity()) : found.front();
  }

  /// The `k` nearest points, nearest first.
  void k_nearest(const Vector& q, std::size_t k, std::vector<Neighbor>& found) const
  {
    found.clear();
    if(m_points.empty())
      return;
    K_search search(*m_tree, point(q), static_cast<unsigned int>((std::min)(k, size())), 0., true,
                    Distance(Point_map(m_points.data())));
    for(const auto& hit : search)
      found.emplace_back(hit.first, std::sqrt(hit.second));
    std::sort(found.begin(), found.end(), [](const Neighbor& a, const Neighbor& b)
      { return a.second < b.second || (a.second == b.second && a.first < b.first); });
  }

  /// All points within `radius`, by increasing index.
  void in_ball(const Vector& q, double radius, std::vector<std::size_t>& found) const
  {
    found.clear();
    if(m_points.empty())
      return;
    m_tree->search(std::back_inserter(found), Sphere(point(q), radius, 0., m_tree->traits()));
    std::sort(found.begin(), found.end());
  }

private:
  std::vector<Point> m_points;
  std::unique_ptr<Tree> m_tree;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_NEIGHBOR_SEARCH_H
