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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SHORTLIST_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SHORTLIST_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Place_descriptor.h>

#include <CGAL/Dimension.h>
#include <CGAL/Euclidean_distance.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// The places whose descriptors are nearest to a given one (paper, section 6.3): a `Kd_tree` over descriptors, each of
/// whose values counts in units of its deviation over all places and its uncertainty.
class Place_shortlist
{
  struct Point
  {
    Place_descriptor::Values values;
    std::size_t index = 0;
  };

  struct Construct_iterator
  {
    typedef const double* result_type;
    const double* operator()(const Point& p) const { return p.values.data(); }
    const double* operator()(const Point& p, int) const { return p.values.data() + Place_descriptor::size; }
  };

  typedef Search_traits<double, Point, const double*, Construct_iterator,
                        Dimension_tag<int(Place_descriptor::size)> > Traits;
  typedef Orthogonal_k_neighbor_search<Traits, Euclidean_distance<Traits> > K_search;
  typedef K_search::Tree Tree;

public:
  explicit Place_shortlist(const std::vector<Place_descriptor>& places)
  {
    const double n = double((std::max)(places.size(), std::size_t(1)));
    for(std::size_t k = 0; k < Place_descriptor::size; ++k)
    {
      double sum = 0, squares = 0;
      for(const Place_descriptor& p : places)
        sum += p.values()[k] / n;
      for(const Place_descriptor& p : places)
        squares += (p.values()[k] - sum) * (p.values()[k] - sum) / n;
      m_factor[k] = 1 / (std::sqrt(squares) + uncertainty());
    }
    std::vector<Point> points;
    for(const Place_descriptor& p : places)
    {
      points.push_back(scaled(p));
      points.back().index = points.size() - 1;
    }
    m_tree = std::make_unique<Tree>(points.begin(), points.end());
    if(!points.empty())
      m_tree->build();
  }

  /// Indices of the `number` nearest places, by increasing index.
  std::vector<std::size_t> nearest(const Place_descriptor& target, std::size_t number) const
  {
    std::vector<std::size_t> result;
    if(m_tree->size() == 0)
      return result;
    const std::size_t all = m_tree->size();
    const K_search search(*m_tree, scaled(target), static_cast<unsigned int>((std::min)(number, all)));
    for(const auto& hit : search)
      result.push_back(hit.first.index);
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Of the values of a hole: what is smoothed near its rim lacks one side.
  static constexpr double uncertainty() { return 0.01; }

private:
  Point scaled(const Place_descriptor& descriptor) const
  {
    Point point;
    for(std::size_t k = 0; k < Place_descriptor::size; ++k)
      point.values[k] = m_factor[k] * descriptor.values()[k];
    return point;
  }

  Place_descriptor::Values m_factor;
  std::unique_ptr<Tree> m_tree;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_SHORTLIST_H
