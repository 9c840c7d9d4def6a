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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_ANGULAR_GAP_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_ANGULAR_GAP_H

#include <CGAL/license/Context_completion_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// The widest angle, in radians, that directions in a plane leave free.
struct Angular_gap
{
  double width = 0;
  double middle = 0;

  /// \param angles of the directions, from -pi to pi; at least one
  explicit Angular_gap(std::vector<double> angles)
  {
    std::sort(angles.begin(), angles.end());
    width = angles.front() + 2 * 3.14159265358979323846 - angles.back();
    middle = angles.back() + width / 2;
    for(std::size_t k = 1; k < angles.size(); ++k)
      if(angles[k] - angles[k - 1] > width)
      {
        width = angles[k] - angles[k - 1];
        middle = angles[k - 1] + width / 2;
      }
  }

  /// Whether a point with neighbors in these directions may be on a rim: 110 degrees are free.
  bool is_open() const { return width >= 110. / 180. * 3.14159265358979323846; }
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_ANGULAR_GAP_H
