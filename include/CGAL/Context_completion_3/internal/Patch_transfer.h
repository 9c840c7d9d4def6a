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

#include <CGAL/Context_completion_3/internal/Base_darts.h>
#include <CGAL/Context_completion_3/internal/Carried_points.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Hole_points.h>
#include <CGAL/Context_completion_3/internal/Hole_relief.h>
#include <CGAL/Context_completion_3/internal/Local_spacing.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Turns the relief of a hole into points: source points carried over, displaced along the normals of the base, thinned
  against the known surface; then, where nothing came to lie, points on facets, or places on the base that are raised to
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
    : m_known(known), m_patch(patch), m_sampler(sampler), m_sources(sources), m_spacing(patch)
  {}

  /// The points of a hole: those that its places give, then, where none came to lie, raised places of the base.
  std::vector<Added_point> points(const Hole_relief& relief) const
  {
    Hole_points<ConcurrencyTag> result(m_known, m_patch);
    Point_grid feet(m_patch.spacing());
    for(std::size_t c = 0; c < relief.copies.size(); ++c)
      carry(relief, c, feet, result);
    lay_facets(relief, feet, result);
    raise(relief, feet, result);
    return result.points();
  }

private:
  void carry(const Hole_relief& relief, std::size_t copy, Point_grid& feet, Hole_points<ConcurrencyTag>& result) const
  {
    const Source& source = m_sources[relief.copies[copy].place.source];
    Carried_points<ConcurrencyTag> carried(m_known, m_patch, m_sampler, source, relief, copy);
    if(relief.copies[copy].is_whole)
      carried.join_walls();
    else
      carried.drop_outliers();
    for(std::size_t k = 0; k < carried.size(); ++k)
      if(carried.is_wanted(k))
        feet.insert(carried.foot(k));
    carried.thin(m_spacing);
    for(std::size_t k = 0; k < carried.size(); ++k)
      if(carried.is_wanted(k))
        result.add(carried.point(k), room(carried.sample(k), 0.6, 0.8, 1.2));
  }

  // Where a carried point is above or below a place of the base, it says where the surface is, and what is planned between a
  // ledge and what is under it does not.
  static bool has_foot(const Point_grid& feet, const Vector& x, double distance)
  {
    bool result = false;
    feet.for_each_in_ball(x, distance, [&](std::size_t, double) {
      result = true;
      return false; });
    return result;
  }

  // Points on facets, where heights cannot tell them.
  void lay_facets(const Hole_relief& relief, const Point_grid& feet, Hole_points<ConcurrencyTag>& result) const
  {
    for(std::size_t f = 0; f < relief.facets.size(); ++f)
    {
      const std::size_t s = m_sampler.search().nearest(relief.facets.position[f]).first;
      if(!relief.is_faceted[s] || has_foot(feet, m_patch.samples()[s].position, 0.8 * m_spacing.spacing(s)))
        continue;
      Added_point point;
      point.position = relief.facets.position[f];
      point.normal = relief.facets.normal[f];
      result.add(point, room(s, 0.8, 0.75, 0.9));
    }
  }

  // Places on the base to the surface of the copy there, or to the plan.
  void raise(const Hole_relief& relief, const Point_grid& feet, Hole_points<ConcurrencyTag>& result) const
  {
    std::vector<char> is_wanted(m_patch.samples().size(), 1);
    for(std::size_t s = 0; s < relief.is_faceted.size(); ++s)
      is_wanted[s] = !relief.is_faceted[s];
    const Eigen::VectorXd heights = own_heights(relief);
    // without carried points a lattice goes on; its samples keep their distance from each other
    if(relief.copies.empty() && m_spacing.is_lattice())
      for(std::size_t s = 0; s < m_patch.samples().size(); ++s)
        if(is_wanted[s])
          result.add(raised_point(m_patch.samples()[s].position, s, heights), room(s, 0.5, 0.7, 0.9));
    const Base_darts<ConcurrencyTag> darts(m_patch, m_sampler, is_wanted);
    for(const Base_dart& dart : darts.darts())
    {
      const std::size_t s = dart.sample, copy = relief.copy[s];
      if(!is_wanted[s] || has_foot(feet, dart.position, 0.8 * m_spacing.spacing(s)))
        continue;
      Added_point point = raised_point(dart.position, s, heights);
      double distance = m_spacing.dart_spacing(s);
      if(copy != no_index)
      {
        const Carried_place& carried = relief.copies[copy];
        const Source& source = m_sources[carried.place.source];
        double shift; Vector slope, axis;
        m_sampler.interpolate(s, dart.position, carried.displacement, shift, slope, axis);
        const Vector origin = carried.place.motion.inverse(point.position - shift * axis);
        const std::size_t i = source.model->search().nearest(origin).first;
        if(carried.is_whole)
        {
          distance = distance_from_carried(s, source.model->area_spacing(i));
          if(has_foot(feet, dart.position, distance) || is_elsewhere(*source.model, i, origin))
            continue;
        }
        point.source = source.original_index(i);
        point.source_set = source.set;
      }
      result.add(point, Point_room{distance, distance, distance});
    }
  }

  // over a place on the base near sample `s`
  Added_point raised_point(const Vector& x, std::size_t s, const Eigen::VectorXd& heights) const
  {
    double height; Vector gradient, direction;
    m_sampler.interpolate(s, x, heights, height, gradient, direction);
    Added_point point;
    point.position = x + height * direction;
    point.normal = (direction - gradient).normalized();
    return point;
  }

  // Whether what `x` should lie on is seen near it, above or below: heights mean over walls.
  static bool is_elsewhere(const Model& model, std::size_t nearest, const Vector& x)
  {
    const Vector d = x - model.position(nearest);
    const double spacing = model.area_spacing(nearest);
    return d.norm() < 2.5 * spacing && std::abs(d.dot(model.normal(nearest))) > 0.5 * spacing;
  }

  // What the carried points of each sample lie on: with the texture of their place, and without the mean over places.
  static Eigen::VectorXd own_heights(const Hole_relief& relief)
  {
    Eigen::VectorXd result = relief.heights;
    for(Eigen::Index s = 0; s < result.size(); ++s)
    {
      const std::size_t copy = relief.copy[std::size_t(s)];
      if(copy != no_index)
        result[s] = relief.copies[copy].surface[s];
    }
    return result;
  }

  // from distances in local spacings
  Point_room room(std::size_t sample, double to_new, double to_rim, double to_known) const
  {
    const double h = m_spacing.spacing(sample);
    return Point_room{to_new * h, to_rim * h, to_known * h};
  }

  // The points of a place are as they should be; where it has fewer of them than are wanted here, others stand between.
  double distance_from_carried(std::size_t sample, double area_spacing) const
  {
    const double ratio = area_spacing / m_spacing.area_spacing(sample), least = m_spacing.dart_spacing(sample);
    const double sparse = (std::max)(0., (std::min)(1., (ratio - 1.1) / 0.2));
    return (1 - sparse) * 1.15 * m_spacing.spacing(sample) + sparse * least;
  }

  const Model& m_known;
  const Patch& m_patch;
  const Relief_sampler<ConcurrencyTag>& m_sampler;
  const std::vector<Source>& m_sources;
  Local_spacing<ConcurrencyTag> m_spacing;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PATCH_TRANSFER_H
