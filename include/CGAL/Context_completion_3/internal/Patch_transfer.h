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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PATCH_TRANSFER_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PATCH_TRANSFER_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Hole_relief.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>
#include <CGAL/Context_completion_3/internal/Thinned_points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Turns the relief of a hole into points: source points carried over, displaced along the normals of the base, thinned
  against the known surface; then, where nothing came to lie, points on facets, or samples of the base that are raised to
  the planned height.
*/
template <typename ConcurrencyTag>
class Patch_transfer
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Example_source<ConcurrencyTag> Source;

public:
  Patch_transfer(const Model& known, const Patch& patch, const Relief_sampler<ConcurrencyTag>& sampler,
                 const std::vector<Source>& sources)
    : m_known(known), m_patch(patch), m_sampler(sampler), m_sources(sources)
  {
    // Close to rim points is where new points belong; other known points keep them at a distance.
    for(const Band_point& b : patch.band())
      if(b.distance <= 1.2 * patch.spacing())
        m_rim.insert(b.index);
  }

  /// The points of a hole: those that its places give, then, where none came to lie, raised samples of the base.
  std::vector<Added_point> points(const Hole_relief& relief) const
  {
    std::vector<Added_point> result;
    Point_grid grid(m_patch.spacing()), feet(m_patch.spacing());
    for(std::size_t c = 0; c < relief.copies.size(); ++c)
      carry(relief, c, grid, feet, result);
    raise(relief, feet, grid, result);
    return result;
  }

private:
  // Points whose feet are on the samples of that copy.
  void carry(const Hole_relief& relief, std::size_t copy, Point_grid& grid, Point_grid& feet,
             std::vector<Added_point>& result) const
  {
    const Carried_place& carried_place = relief.copies[copy];
    const Place& place = carried_place.place;
    const Source& source = m_sources[place.source];
    std::vector<std::size_t> indices;
    m_sampler.carried_points(place, indices);
    std::vector<Added_point> carried;
    std::vector<Vector> carried_foot;
    std::vector<std::size_t> carried_index;
    std::vector<char> is_planned;
    std::vector<double> misses;
    for(std::size_t i : indices)
    {
      Vector x = place.motion(source.model->position(i));
      const Neighbor_search::Neighbor foot = m_sampler.search().nearest(x);
      if(relief.copy[foot.first] != copy)
        continue;
      const Base_sample& b = m_patch.samples()[foot.first];
      const Vector d = x - b.position;
      const double up = d.dot(b.normal);
      if(std::abs(up) > m_sampler.height_limit() || (d - up * b.normal).norm() > 1.3 * m_patch.spacing())
        continue;
      Added_point point;
      point.normal = place.motion.normal(source.model->normal(i));
      if(point.normal.dot(b.normal) < -0.5)
        continue;
      double shift; Vector gradient, direction;
      m_sampler.interpolate(foot.first, x, carried_place.displacement, shift, gradient, direction);
      const double miss = std::abs(up + shift - relief.heights[Eigen::Index(foot.first)]);
      if(miss > carried_place.tolerance)
        continue;
      misses.push_back(miss);
      is_planned.push_back(miss <= 2 * m_patch.spacing() && point.normal.dot(b.normal) > 0);
      point.position = x + shift * direction;
      point.normal = (point.normal - gradient * point.normal.dot(direction)).normalized();
      point.source = source.original_index(i);
      point.source_set = source.set;
      carried.push_back(point);
      carried_index.push_back(i);
      carried_foot.push_back(x - up * b.normal);
    }
    if(carried_place.is_whole)
      join(*source.model, carried_index, is_planned);
    else
      drop_outliers(misses, is_planned);
    for(std::size_t k = 0; k < carried.size(); ++k)
      if(is_planned[k])
        feet.insert(carried_foot[k]);
    thin(*source.model, carried_index, carried, is_planned);
    for(std::size_t k = 0; k < carried.size(); ++k)
      if(is_planned[k])
        add(carried[k], 0.6, 0.8, 1.2, grid, result);
  }

  // A place that is sampled more densely than the surroundings of the hole gives fewer points: those that keep a
  // distance from the others, by which their number becomes what the surroundings would have.
  void thin(const Model& model, const std::vector<std::size_t>& indices, const std::vector<Added_point>& carried,
            std::vector<char>& is_planned) const
  {
    const double spacing = m_patch.surroundings()->area_spacing_behind();
    Surface_points planned;
    std::vector<std::size_t> slot;
    double wanted = 0;
    for(std::size_t k = 0; k < indices.size(); ++k)
      if(is_planned[k])
      {
        const double ratio = model.area_spacing(indices[k]) / spacing;
        wanted += (std::min)(1., ratio * ratio);
        planned.push_back(carried[k].position, carried[k].normal);
        slot.push_back(k);
      }
    // spacings are estimates, and a point too many does less harm than one too few
    wanted *= 1.1;
    if(wanted >= double(slot.size()))
      return;
    double low = 0, high = 1.2 * spacing;
    std::vector<std::size_t> kept;
    for(int round = 0; round < 10; ++round)
    {
      const double distance = (low + high) / 2;
      kept = thinned_points(planned, distance);
      (double(kept.size()) > wanted ? low : high) = distance;
    }
    is_planned.assign(is_planned.size(), 0);
    for(std::size_t k : kept)
      is_planned[slot[k]] = 1;
  }

  // Of texture and noise; what stands out much farther than most is a fold or a wall of the place.
  static void drop_outliers(const std::vector<double>& misses, std::vector<char>& is_planned)
  {
    if(misses.empty())
      return;
    std::vector<double> sorted = misses;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    const double largest = 5 * sorted[sorted.size() / 2];
    for(std::size_t k = 0; k < misses.size(); ++k)
      if(misses[k] > largest)
        is_planned[k] = 0;
  }

  // Walls and overhangs that the planned heights miss belong to the surface as far as they hang together with it; the
  // far side of a thin part, and what lies within the solid, does not.
  static void join(const Model& model, const std::vector<std::size_t>& indices, std::vector<char>& is_planned)
  {
    std::unordered_map<std::size_t, std::size_t> slot;
    std::vector<std::size_t> front, links;
    for(std::size_t k = 0; k < indices.size(); ++k)
    {
      slot.emplace(indices[k], k);
      if(is_planned[k])
        front.push_back(k);
    }
    while(!front.empty())
    {
      const std::size_t i = indices[front.back()];
      front.pop_back();
      model.linked_points(i, links);
      for(std::size_t j : links)
      {
        const auto found = slot.find(j);
        if(found == slot.end() || is_planned[found->second])
          continue;
        is_planned[found->second] = 1;
        front.push_back(found->second);
      }
    }
  }

  // Where a carried point is above or below a sample, it says where the surface is, and the planned height between a
  // ledge and what is under it does not.
  void raise(const Hole_relief& relief, const Point_grid& feet, Point_grid& grid,
             std::vector<Added_point>& result) const
  {
    const Eigen::VectorXd& heights = relief.heights;
    // samples keep their distance from each other; carried points may be anywhere
    const double smooth_room = relief.copies.empty() ? 0.5 : 0.8;
    const auto is_known = [&](const Vector& foot)
    {
      bool result = false;
      feet.for_each_in_ball(foot, 0.8 * m_patch.spacing(), [&](std::size_t, double) {
        result = true;
        return false; });
      return result;
    };
    for(std::size_t f = 0; f < relief.facets.size(); ++f)
    {
      const std::size_t s = m_sampler.search().nearest(relief.facets.position[f]).first;
      if(!relief.is_faceted[s] || is_known(m_patch.samples()[s].position))
        continue;
      Added_point point;
      point.position = relief.facets.position[f];
      point.normal = relief.facets.normal[f];
      add(point, 0.8, 0.75, 0.9, grid, result);
    }
    for(std::size_t s = 0; s < m_patch.samples().size(); ++s)
    {
      const Base_sample& b = m_patch.samples()[s];
      if((!relief.is_faceted.empty() && relief.is_faceted[s]) || is_known(b.position))
        continue;
      double room = smooth_room;
      double height; Vector gradient, direction;
      m_sampler.interpolate(s, b.position, heights, height, gradient, direction);
      Added_point point;
      point.position = b.position + heights[Eigen::Index(s)] * b.normal;
      point.normal = (b.normal - gradient).normalized();
      if(relief.copy[s] != no_index)
      {
        const Place& place = relief.copies[relief.copy[s]].place;
        const Source& source = m_sources[place.source];
        const std::size_t i = source.model->search().nearest(place.motion.inverse(point.position)).first;
        room = room_beside_carried(source.model->area_spacing(i));
        point.source = source.original_index(i);
        point.source_set = source.set;
      }
      add(point, room, (std::max)(0.7, room), (std::max)(0.9, room), grid, result);
    }
  }

  // In spacings. Samples fill the gaps that carried points leave, and where the place has fewer points than are wanted here,
  // they stand between these, too.
  double room_beside_carried(double spacing) const
  {
    const double ratio = spacing / m_patch.surroundings()->area_spacing_behind();
    return 1.15 - 0.3 * (std::max)(0., (std::min)(1., (ratio - 1.1) / 0.2));
  }

  // rooms in spacings: to new points, to rim points, to other known points
  void add(const Added_point& point, double room, double rim_room, double known_room, Point_grid& grid,
           std::vector<Added_point>& result) const
  {
    const double h = m_patch.spacing();
    if(!point.position.allFinite() || !point.normal.allFinite())
      return;
    bool is_free = true;
    grid.for_each_in_ball(point.position, room * h, [&](std::size_t k, double) {
      is_free = !is_same_side(result[k].normal, point.normal);
      return is_free; });
    if(!is_free)
      return;
    std::vector<std::size_t> ball;
    m_known.search().in_ball(point.position, (std::max)(rim_room, known_room) * h, ball);
    for(std::size_t k : ball)
    {
      const double distance = (m_known.position(k) - point.position).norm();
      const bool is_rim = m_rim.count(k) > 0;
      if(distance < (is_rim ? rim_room : known_room) * h && is_same_side(m_known.normal(k), point.normal))
        return;
    }
    grid.insert(point.position);
    result.push_back(point);
  }

  const Model& m_known;
  const Patch& m_patch;
  const Relief_sampler<ConcurrencyTag>& m_sampler;
  const std::vector<Source>& m_sources;
  std::unordered_set<std::size_t> m_rim;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PATCH_TRANSFER_H
