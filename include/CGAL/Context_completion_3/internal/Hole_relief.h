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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_RELIEF_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_RELIEF_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Place.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A source place and how its points are displaced, along the normals of the base, on their way into the hole.
struct Carried_place
{
  Place place;
  Eigen::VectorXd surface;               ///< per sample of the base: height that the place has there once it is displaced
  Eigen::VectorXd displacement;          ///< per sample of the base
  double tolerance = 0;                  ///< points that come to lie farther from the planned heights are left out
  bool is_whole = false;                 ///< may overhang the base; otherwise what stands out of the rest is left out

  /// Sets `surface`: where the place itself has a gap, the planned heights.
  void set_surface(const Place_relief& relief, const Eigen::VectorXd& planned)
  {
    surface = relief.height + displacement;
    for(Eigen::Index s = 0; s < surface.size(); ++s)
      if(!relief.is_covered[std::size_t(s)])
        surface[s] = planned[s];
  }
};

/// The planned surface of a hole: heights over its base, and whose points are carried there.
struct Hole_relief
{
  Eigen::VectorXd heights;               ///< per sample of the base
  Eigen::VectorXd errors;                ///< per sample: to be expected
  std::vector<Carried_place> copies;
  std::vector<std::size_t> copy;         ///< per sample: index of the copy, `no_index`: none
  Surface_points facets;                 ///< points on facets, which heights cannot tell where they are steep
  std::vector<char> is_faceted;          ///< per sample, or empty: those points take its place
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_RELIEF_H
