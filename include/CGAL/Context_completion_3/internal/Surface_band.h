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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_BAND_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_BAND_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <cstddef>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A point of the surroundings and its distance to the rim, measured along the surface.
struct Band_point
{
  std::size_t index = 0;
  double distance = 0;
};

/*!
  The known surroundings of a rim: all points within `width`, by shortest paths over links of neighbouring points on the
  same side, so that the far side of a thin part stays out. By increasing distance, ties by index.
*/
template <typename ConcurrencyTag>
std::vector<Band_point> surface_band(const Surface_model<ConcurrencyTag>& model, const std::vector<std::size_t>& rim,
                                     double width)
{
  typedef std::pair<double, std::size_t> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
  std::unordered_map<std::size_t, double> distance;
  for(std::size_t i : rim)
    if(distance.emplace(i, 0.).second)
      queue.emplace(0., i);
  std::vector<Band_point> band;
  std::vector<std::size_t> links;
  while(!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    const std::size_t a = top.second;
    if(top.first > distance[a])
      continue;
    Band_point point;
    point.index = a;
    point.distance = top.first;
    band.push_back(point);
    model.linked_points(a, links);
    for(std::size_t b : links)
    {
      const double d = top.first + (model.position(a) - model.position(b)).norm();
      if(d > width)
        continue;
      const auto known = distance.find(b);
      if(known == distance.end() || d < known->second)
      {
        distance[b] = d;
        queue.emplace(d, b);
      }
    }
  }
  return band;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_BAND_H
