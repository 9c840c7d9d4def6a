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

#ifndef CGAL_CONTEXT_COMPLETION_3_HOLE_3_H
#define CGAL_CONTEXT_COMPLETION_3_HOLE_3_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Engine_types.h>

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {

#ifdef DOXYGEN_RUNNING
/*!
  \ingroup PkgContextCompletion3Ref
  \brief What detection says of an under-sampled place.
*/
enum class Hole_state
{
  hole,          ///< it is to be filled
  outer_border,  ///< it is a border of the surface itself, as around a scan of a terrain or at the neck of a bust
  too_small,     ///< its diameter is below `minimum_hole_diameter`
  too_large,     ///< its diameter is above `maximum_hole_diameter`
  excluded       ///< it lies outside all `regions`, or inside one of the `excluded_regions`
};
#else
typedef internal::Hole_state Hole_state;
#endif

/*!
  \ingroup PkgContextCompletion3Ref

  \brief describes an under-sampled place of a point set (section 5 of the paper).

  The index of a point is the value of its `Index` if the point set is a `CGAL::Point_set_3`, and its position in the
  range otherwise.

  \tparam GeomTraits a model of `Kernel`
*/
template <typename GeomTraits>
struct Hole_3
{
  typedef typename GeomTraits::FT FT;            ///< number type
  typedef typename GeomTraits::Point_3 Point_3;  ///< point type

  std::size_t id = 0;                             ///< index among all detected places, the value for `hole_indices`
  Point_3 center = Point_3(FT(0), FT(0), FT(0));  ///< centre of the place
  FT diameter = FT(0);                            ///< largest distance of two rim points
  FT spacing = FT(0);                             ///< distance of neighboring points in the surroundings
  Hole_state state = Hole_state::hole;            ///< whether it is to be filled, and if not, why
  std::vector<std::vector<std::size_t> > loops;   ///< indices of the rim points, one list for each rim, those of islands last
  std::vector<Bbox_3> cells;                      ///< the under-sampled cells of the tree that make up the place

  /// returns whether the place is filled unless the user chooses otherwise.
  bool is_to_be_filled() const { return state == Hole_state::hole; }
};

} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_HOLE_3_H
