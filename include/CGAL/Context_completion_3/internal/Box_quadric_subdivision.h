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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_QUADRIC_SUBDIVISION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_QUADRIC_SUBDIVISION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Box_quadric_intersection.h>
#include <CGAL/Context_completion_3/internal/Quadric_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The paper's own test of {q = 0} against a box: steps 1 to 5 of section 5, in `double`.

  Two things are settled here. The bound of step 4 is printed as min over i and d of c_id - |(d1 - d2) / 2| f_d(c_i),
  which bounds nothing as it stands: `c_id` is no value, one direction at a time forgets the other two, and the
  derivative at one corner does not bound the derivative on the way to it. Meant must be: every point of the box is
  within half an edge of a corner in each direction, and f_d, being linear, is largest in absolute value at a corner;
  so f >= min_i f(c_i) - sum_d |d1 - d2| / 2 max_j |f_d(c_j)|. And the subdivision does not end where the surface
  touches a box; at `maximum_subdivisions` the answer is "it meets", which errs on the side of looking at the cell.
*/
class Box_quadric_subdivision
{
public:
  explicit Box_quadric_subdivision(std::size_t maximum_subdivisions = 6)
    : m_maximum(maximum_subdivisions)
  {}

  bool operator()(const Quadric& q, const Bbox_3& box) const
  {
    return meets(q, Vector(box.xmin(), box.ymin(), box.zmin()), Vector(box.xmax(), box.ymax(), box.zmax()), 0);
  }

private:
  bool meets(const Quadric& q, const Vector& lower, const Vector& upper, std::size_t subdivisions) const
  {
    double least = 0, greatest = 0;
    Vector least_slope = Vector::Zero(), greatest_slope = Vector::Zero();
    for(int corner = 0; corner < 8; ++corner) // steps 1 and 2
    {
      const Vector c = mixed(lower, upper, corner);
      const double f = value(q, c);
      const Vector g = gradient(q, c);
      least = corner == 0 ? f : (std::min)(least, f);
      greatest = corner == 0 ? f : (std::max)(greatest, f);
      least_slope = corner == 0 ? g : Vector(least_slope.cwiseMin(g));
      greatest_slope = corner == 0 ? g : Vector(greatest_slope.cwiseMax(g));
    }
    if(least <= 0 && greatest >= 0)
      return true;
    bool monotone = true; // step 3
    double change = 0;    // step 4
    for(int d = 0; d < 3; ++d)
    {
      monotone = monotone && (least_slope[d] >= 0 || greatest_slope[d] <= 0);
      change += 0.5 * (upper[d] - lower[d]) * (std::max)(std::abs(least_slope[d]), std::abs(greatest_slope[d]));
    }
    if(monotone || (std::min)(std::abs(least), std::abs(greatest)) > change)
      return false;
    if(subdivisions == m_maximum)
      return true;
    const Vector middle = 0.5 * (lower + upper);
    for(int octant = 0; octant < 8; ++octant) // step 5
      if(meets(q, mixed(lower, middle, octant), mixed(middle, upper, octant), subdivisions + 1))
        return true;
    return false;
  }

  static Vector mixed(const Vector& a, const Vector& b, int choice)
  {
    return Vector((choice & 1) ? b.x() : a.x(), (choice & 2) ? b.y() : a.y(), (choice & 4) ? b.z() : a.z());
  }

  std::size_t m_maximum;
};

/// The exact decision, or the paper's own.
class Box_quadric_test
{
public:
  explicit Box_quadric_test(bool is_by_subdivision = false) : m_is_by_subdivision(is_by_subdivision) {}

  bool operator()(const Quadric& q, const Bbox_3& box) const
  {
    return m_is_by_subdivision ? m_subdivision(q, box) : do_intersect_exactly(q, box);
  }

private:
  bool m_is_by_subdivision;
  Box_quadric_subdivision m_subdivision;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_QUADRIC_SUBDIVISION_H
