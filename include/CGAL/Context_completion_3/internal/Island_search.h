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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_ISLAND_SEARCH_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_ISLAND_SEARCH_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Angular_gap.h>
#include <CGAL/Context_completion_3/internal/Base_evidence.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Rim_surroundings.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Finds the islands of a hole: what was sampled of the missing surface and is linked to nothing else. The base over the rim
  alone knows nothing of them, since its surroundings are what links lead to from the rim.
*/
template <typename ConcurrencyTag>
class Island_search
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Smooth_patch<ConcurrencyTag> Patch;

public:
  /// \param patch a closed base over the hole, not copied
  explicit Island_search(const Patch& patch)
    : m_patch(patch), m_model(patch.surroundings()->model()), m_link(Model::link() * patch.area_spacing() * m_model.irregularity())
  {
    for(const Base_sample& s : patch.samples())
      if(s.is_uncovered)
        m_uncovered.push_back(s.position, s.normal);
    m_search = std::make_unique<const Neighbor_search>(m_uncovered.position);
    for(const Band_point& b : patch.band())
      m_part_of.emplace(b.index, mainland());
  }

  /// The rims of all islands, by their smallest point.
  std::vector<Rim_loop> rims()
  {
    std::vector<Rim_loop> result;
    if(m_uncovered.size() == 0)
      return result;
    std::vector<std::size_t> ball;
    m_model.search().in_ball(m_patch.loops().front().center, m_patch.diameter(), ball);
    for(std::size_t i : ball)
    {
      if(m_part_of.count(i) > 0 || !is_over_hole(i))
        continue;
      const std::vector<std::size_t> part = linked_part(i);
      const std::size_t over_hole =
        std::size_t(std::count_if(part.begin(), part.end(), [&](std::size_t p) { return is_over_hole(p); }));
      if(part.size() < fewest_points() || 4 * over_hole < 3 * part.size())
        continue;
      const Rim_loop rim = rim_of(part);
      if(rim.points.size() >= 3)
        result.push_back(rim);
    }
    return result;
  }

private:
  // parts by number; what reaches the surroundings, or is too large to lie in the hole, is no island
  static std::size_t mainland() { return 0; }

  // Fewer are stray points.
  static std::size_t fewest_points() { return 4; }

  // Height over the base by distance to the rim: the surface may rise so steeply over what is known of it.
  static double steepest() { return 0.75; }

  bool is_over_hole(std::size_t i) const
  {
    const Vector p = m_model.position(i);
    Vector foot = p, normal;
    // of a thin part the far side is told without a projection
    if(!is_same_side(m_uncovered.normal[m_search->nearest(p).first], m_model.normal(i)) || !m_patch.project(foot, normal) ||
       !is_same_side(normal, m_model.normal(i)) ||
       m_search->nearest(foot).second > m_patch.surroundings()->gap_spacing())
      return false;
    double to_rim = std::numeric_limits<double>::infinity();
    for(std::size_t r : m_patch.rim())
      to_rim = (std::min)(to_rim, (m_model.position(r) - foot).norm());
    return (p - foot).norm() <= steepest() * to_rim;
  }

  // Empty if it is no island.
  std::vector<std::size_t> linked_part(std::size_t start)
  {
    const std::size_t number = ++m_number_of_parts, most = m_patch.samples().size();
    std::vector<std::size_t> part(1, start), near;
    m_part_of[start] = number;
    bool is_island = true;
    for(std::size_t k = 0; k < part.size(); ++k)
    {
      m_model.linked_points(part[k], m_link, near);
      for(std::size_t j : near)
      {
        const auto added = m_part_of.emplace(j, number);
        if(added.second && part.size() <= most)
          part.push_back(j);
        is_island = is_island && (added.second || added.first->second == number) && part.size() <= most;
      }
    }
    if(!is_island)
      part.clear();
    std::sort(part.begin(), part.end());
    return part;
  }

  // Its points beside which a large angle is free.
  Rim_loop rim_of(const std::vector<std::size_t>& part) const
  {
    Rim_loop rim;
    for(std::size_t i : part)
    {
      Rim_point point;
      point.index = i;
      if(free_direction(i, part, point.outward))
        rim.points.push_back(point);
    }
    if(!rim.points.empty())
      rim.measure(m_model.points());
    return rim;
  }

  bool free_direction(std::size_t i, const std::vector<std::size_t>& part, Vector& direction) const
  {
    const double reach = 1.4 * m_link;
    const Vector u = m_model.normal(i).unitOrthogonal(), v = m_model.normal(i).cross(u);
    std::vector<double> angles;
    for(std::size_t j : part)
    {
      const Vector d = m_model.position(j) - m_model.position(i);
      if(j != i && d.norm() <= reach)
        angles.push_back(std::atan2(d.dot(v), d.dot(u)));
    }
    if(angles.empty())
      return false;
    const Angular_gap gap(angles);
    direction = std::cos(gap.middle) * u + std::sin(gap.middle) * v;
    return gap.is_open();
  }

  const Patch& m_patch;
  const Model& m_model;
  Surface_points m_uncovered;
  std::unique_ptr<const Neighbor_search> m_search;      // for these samples
  double m_link;                                        // as points of the rim are linked: a small island seems sparse
  std::unordered_map<std::size_t, std::size_t> m_part_of;
  std::size_t m_number_of_parts = 0;
};

/// A base that takes the islands of a hole for further rims, if there are any and it joins them; `patch` otherwise.
template <typename ConcurrencyTag>
std::shared_ptr<const Smooth_patch<ConcurrencyTag> >
with_islands(const std::shared_ptr<const Smooth_patch<ConcurrencyTag> >& patch)
{
  const std::vector<Rim_loop> islands = Island_search<ConcurrencyTag>(*patch).rims();
  if(islands.empty())
    return patch;
  const auto surroundings = std::make_shared<const Rim_surroundings<ConcurrencyTag> >(
    patch->surroundings()->model(), patch->loops(), patch->surroundings()->edge(), islands);
  for(bool is_stiff : { false, true })
  {
    const auto whole = std::make_shared<const Smooth_patch<ConcurrencyTag> >(surroundings, is_stiff, std::nullopt,
                                                                             patch->guides());
    if(whole->is_closed() && whole->joined_share() >= patch->joined_share() && is_evident(*whole))
      return whole;
  }
  return patch;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_ISLAND_SEARCH_H
