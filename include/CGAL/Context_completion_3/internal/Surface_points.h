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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_POINTS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_POINTS_H

#include <CGAL/license/Context_completion_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

typedef Eigen::Vector3d Vector;
typedef Eigen::Matrix3d Matrix;

/*!
  A sampled surface as flat arrays: positions and unit normals, in the order of the caller's range.
  All constructions of the engine run on it in `double`; positions are relative to a centre that the caller
  of the engine chose, so that georeferenced coordinates lose no digits.
*/
struct Surface_points
{
  std::vector<Vector> position;
  std::vector<Vector> normal;

  std::size_t size() const { return position.size(); }

  void push_back(const Vector& p, const Vector& n)
  {
    position.push_back(p);
    normal.push_back(n);
  }
};

/// Normals that enclose more than about 107 degrees lie on two sides of a thin part.
inline bool is_same_side(const Vector& n, const Vector& m)
{
  return n.dot(m) > -0.3;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SURFACE_POINTS_H
