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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CARRIED_POINTS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CARRIED_POINTS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_sample.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Example_source.h>
#include <CGAL/Context_completion_3/internal/Hole_relief.h>
#include <CGAL/Context_completion_3/internal/Local_spacing.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>
#include <CGAL/Context_completion_3/internal/Thinned_points.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  What one place gives to a hole: its points whose feet are on the samples of that copy, displaced along the normals of the
  base. Which of them are wanted is decided step by step.
*/
template <typename ConcurrencyTag>
class Carried_points
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Relief_sampler<ConcurrencyTag> Sampler;

public:
  Carried_points(const Model& known, const Patch& patch, const Sampler& sampler,
                 const Example_source<ConcurrencyTag>& source, const Hole_relief& relief, std::size_t copy)
    : m_known(known), m_patch(patch), m_sampler(sampler), m_place(*source.model), m_relief(relief), m_copy(copy)
  {
    const Carried_place& carried = relief.copies[copy];
    std::vector<std::size_t> indices;
    sampler.carried_points(carried.place, indices);
    for(std::size_t i : indices)
    {
      const Vector x = carried.place.motion(m_place.position(i));
      const Foot foot = foot_of(x);
      if(relief.copy[foot.sample] != copy || std::abs(foot.up) > sampler.height_limit() || is_beside(foot))
        continue;
      const Vector& b = patch.samples()[foot.sample].normal;
      Added_point point;
      point.normal = carried.place.motion.normal(m_place.normal(i));
      if(is_below(point.normal, b))
        continue;
      double shift; Vector gradient, direction;
      sampler.interpolate(foot.sample, x, carried.displacement, shift, gradient, direction);
      const double miss = std::abs(foot.up + shift - relief.heights[Eigen::Index(foot.sample)]);
      if(miss > carried.tolerance)
        continue;
      m_misses.push_back(miss);
      m_is_wanted.push_back(miss <= 2 * patch.spacing() && point.normal.dot(b) > 0);
      point.position = x + shift * direction;
      point.normal = (point.normal - gradient * point.normal.dot(direction)).normalized();
      point.source = source.original_index(i);
      point.source_set = source.set;
      m_points.push_back(point);
      m_indices.push_back(i);
      m_samples.push_back(foot.sample);
      m_feet.push_back(x - foot.up * b);
    }
  }

  std::size_t size() const { return m_points.size(); }
  bool is_wanted(std::size_t k) const { return m_is_wanted[k]; }
  const Added_point& point(std::size_t k) const { return m_points[k]; }
  std::size_t sample(std::size_t k) const { return m_samples[k]; }   ///< nearest one
  const Vector& foot(std::size_t k) const { return m_feet[k]; }

  /// Of texture and noise; what stands out much farther than most is a fold or a wall of the place.
  void drop_outliers()
  {
    if(m_misses.empty())
      return;
    std::vector<double> sorted = m_misses;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    const double largest = 5 * sorted[sorted.size() / 2];
    for(std::size_t k = 0; k < size(); ++k)
      if(m_misses[k] > largest)
        m_is_wanted[k] = 0;
  }

  /// Walls and overhangs that the planned heights miss belong to the surface as far as they hang together with it; the
  /// far side of a thin part, and what lies within the solid, does not. Where they leave the hole they are to go on in
  /// what is known there; otherwise they are a part of the place that the hole has not.
  void join_walls()
  {
    for(std::size_t k = 0; k < size(); ++k)
      m_slot.emplace(m_indices[k], k);
    std::vector<char> is_open(size(), 1);
    std::vector<std::size_t> planned;
    for(std::size_t k = 0; k < size(); ++k)
      if(m_is_wanted[k])
      {
        planned.push_back(k);
        is_open[k] = 0;
      }
    grow(planned, is_open);
    std::vector<char> is_joined(size(), 0);
    for(std::size_t k : planned)
      is_joined[k] = !m_is_wanted[k];
    for(std::size_t k = 0; k < size(); ++k)
    {
      if(!is_joined[k])
        continue;
      std::vector<std::size_t> wall(1, k);
      is_joined[k] = 0;
      grow(wall, is_joined);
      if(goes_on(wall))
        for(std::size_t member : wall)
          m_is_wanted[member] = 1;
    }
  }

  /// Where the place is sampled more densely than the hole is to be it gives fewer points: those that keep a distance from
  /// the others, by which their number becomes what is wanted.
  void thin(const Local_spacing<ConcurrencyTag>& spacing)
  {
    Surface_points wanted;
    std::vector<std::size_t> slot;
    std::vector<double> spacings;
    double number = 0;
    for(std::size_t k = 0; k < size(); ++k)
      if(m_is_wanted[k])
      {
        spacings.push_back(spacing.area_spacing(m_samples[k]));
        const double ratio = m_place.area_spacing(m_indices[k]) / spacings.back();
        number += (std::min)(1., ratio * ratio);
        wanted.push_back(m_points[k].position, m_points[k].normal);
        slot.push_back(k);
      }
    // spacings are estimates, and a point too many does less harm than one too few
    number *= 1.1;
    if(number >= double(slot.size()))
      return;
    double low = 0, high = 1.2;
    std::vector<std::size_t> kept;
    for(int round = 0; round < 10; ++round)
    {
      const double factor = (low + high) / 2;
      std::vector<double> distances = spacings;
      for(double& d : distances)
        d *= factor;
      kept = thinned_points(wanted, distances);
      (double(kept.size()) > number ? low : high) = factor;
    }
    m_is_wanted.assign(size(), 0);
    for(std::size_t k : kept)
      m_is_wanted[slot[k]] = 1;
  }

private:
  struct Foot
  {
    std::size_t sample;
    double up, beside;                   // from there, along and across its normal
  };

  Foot foot_of(const Vector& x) const
  {
    Foot foot;
    foot.sample = m_sampler.search().nearest(x).first;
    const Base_sample& b = m_patch.samples()[foot.sample];
    const Vector d = x - b.position;
    foot.up = d.dot(b.normal);
    foot.beside = (d - foot.up * b.normal).norm();
    return foot;
  }

  bool is_beside(const Foot& foot) const { return foot.beside > 1.3 * m_patch.spacing(); }

  // Whether a normal is that of the far side of a part.
  static bool is_below(const Vector& normal, const Vector& base_normal) { return normal.dot(base_normal) < -0.5; }

  // Adds what is linked to some points, and no longer open.
  void grow(std::vector<std::size_t>& part, std::vector<char>& is_open) const
  {
    std::vector<std::size_t> links;
    for(std::size_t n = 0; n < part.size(); ++n)
    {
      m_place.linked_points(m_indices[part[n]], links);
      for(std::size_t j : links)
      {
        const auto found = m_slot.find(j);
        if(found == m_slot.end() || !is_open[found->second])
          continue;
        is_open[found->second] = 0;
        part.push_back(found->second);
      }
    }
  }

  // Whether points of the place that are linked to a part of it, and come to lie beside the hole, are mostly at what is
  // known there; or there are none.
  bool goes_on(const std::vector<std::size_t>& part) const
  {
    const Carried_place& carried = m_relief.copies[m_copy];
    std::size_t known = 0, unknown = 0;
    std::vector<std::size_t> links;
    for(std::size_t k : part)
    {
      m_place.linked_points(m_indices[k], links);
      for(std::size_t j : links)
      {
        if(m_slot.count(j) > 0)
          continue;
        const Vector x = carried.place.motion(m_place.position(j)), normal = carried.place.motion.normal(m_place.normal(j));
        const Foot foot = foot_of(x);
        const Base_sample& b = m_patch.samples()[foot.sample];
        if(m_relief.copy[foot.sample] != m_copy || !is_beside(foot) || is_below(normal, b.normal) ||
           m_known.search().nearest(b.position).second > 2 * m_patch.spacing())
          continue;
        const Vector y = x + carried.displacement[Eigen::Index(foot.sample)] * b.normal;
        const Neighbor_search::Neighbor nearest = m_known.search().nearest(y);
        const bool is_known = nearest.second < 2 * m_patch.spacing() && is_same_side(m_known.normal(nearest.first), normal);
        ++(is_known ? known : unknown);
      }
    }
    return known >= unknown;
  }

  const Model& m_known;
  const Patch& m_patch;
  const Sampler& m_sampler;
  const Model& m_place;
  const Hole_relief& m_relief;
  std::size_t m_copy;
  std::vector<Added_point> m_points;
  std::vector<Vector> m_feet;            // this and the rest are parallel to the points
  std::vector<std::size_t> m_indices;    // in the source
  std::vector<std::size_t> m_samples;
  std::vector<double> m_misses;          // distances from the planned heights
  std::vector<char> m_is_wanted;
  std::unordered_map<std::size_t, std::size_t> m_slot;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CARRIED_POINTS_H
