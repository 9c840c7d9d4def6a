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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_NARROW_SLOT_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_NARROW_SLOT_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_sample.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Evidence of a hole that is too narrow for a place as far from all points as covers nothing: each sample of its base is
  near to the one or the other rim. The rim is whole.
*/
class Narrow_slot
{
public:
  /*!
    \param footprints, normals known points on the base; not copied
    \param spacing of points
    \param project moves a place onto the base and tells the normal there; `false` if it does not arrive
  */
  Narrow_slot(const std::vector<Vector>& footprints, const std::vector<Vector>& normals, double spacing,
              std::function<bool(Vector&, Vector&)> project)
    : m_footprints(footprints), m_normals(normals), m_spacing(spacing), m_project(std::move(project))
  {}

  /*!
    In a slot that is hardly wider than the distance that covers, the middle between the rims is empty. It is sampled
    again, twice as finely. What has room for as many samples as are evidence elsewhere is no less a hole: the samples
    around it are uncovered. \return whether it is
  */
  bool look_between(std::vector<Base_sample>& samples, std::size_t fewest) const
  {
    const double h = m_spacing, distance = 0.41 * h;   // half of that of the samples
    const Point_grid known = grid_of_points(1.5 * h);
    Point_grid grid(distance);
    std::vector<Vector> normals;
    const auto try_place = [&](Vector x) -> bool
    {
      Vector normal;
      if(!m_project(x, normal) || has_point_on_side(known, m_normals, x, normal, 1.5 * h))
        return false;
      bool is_free = true;
      grid.for_each_in_ball(x, distance, [&](std::size_t p, double) {
        is_free = !is_same_side(normal, normals[p]);
        return is_free; });
      if(is_free)
      {
        grid.insert(x);
        normals.push_back(normal);
      }
      return true;
    };
    std::vector<std::size_t> around;
    for(std::size_t i = 0; i < samples.size(); ++i)
    {
      const Base_sample& s = samples[i];
      const Vector u = s.normal.unitOrthogonal(), v = s.normal.cross(u);
      bool is_around = try_place(s.position);
      for(int k = 0; k < 6; ++k)
      {
        const double angle = 1.0472 * k;
        is_around |= try_place(s.position + h / 2 * (std::cos(angle) * u + std::sin(angle) * v));
      }
      if(is_around)
        around.push_back(i);
    }
    if(grid.number_of_points() < 4 * fewest)
      return false;
    for(std::size_t i : around)
      samples[i].is_uncovered = true;
    return true;
  }

  /*!
    A slot of one or two rows can be so long that no chance explains it. Of points at random, n of them, about n A exp(-A)
    voids have room for A points, and few of those a rim that is whole: on models of a million such points in sum there
    was none. All samples are uncovered then. \return whether they are
  */
  bool look_for_void(std::vector<Base_sample>& samples, std::size_t rim_points) const
  {
    const double least = 13, clear = 0.85 * m_spacing;   // points
    if(double(samples.size()) + 0.5 * double(rim_points) < least)
      return false;
    const Point_grid known = grid_of_points(clear);
    if(std::any_of(samples.begin(), samples.end(), [&](const Base_sample& s) {
         return has_point_on_side(known, m_normals, s.position, s.normal, clear); }))
      return false;
    for(Base_sample& s : samples)
      s.is_uncovered = true;
    return true;
  }

private:
  Point_grid grid_of_points(double width) const
  {
    Point_grid grid(width);
    for(const Vector& x : m_footprints)
      grid.insert(x);
    return grid;
  }

  const std::vector<Vector>& m_footprints;
  const std::vector<Vector>& m_normals;
  double m_spacing;
  std::function<bool(Vector&, Vector&)> m_project;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_NARROW_SLOT_H
