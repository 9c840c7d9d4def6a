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

#ifndef CGAL_CONTEXT_COMPLETION_3_NEW_POINT_3_H
#define CGAL_CONTEXT_COMPLETION_3_NEW_POINT_3_H

#include <CGAL/license/Context_completion_3.h>

#include <cstddef>

namespace CGAL {
namespace Context_completions_3 {

/*!
  \ingroup PkgContextCompletion3Ref

  \brief is a point that was added to fill a hole, with its history.

  \tparam GeomTraits a model of `Kernel`
*/
template <typename GeomTraits>
struct New_point_3
{
  typedef typename GeomTraits::FT FT;              ///< number type
  typedef typename GeomTraits::Point_3 Point_3;    ///< point type
  typedef typename GeomTraits::Vector_3 Vector_3;  ///< vector type

  /// the value of `source` if the point was not copied but lies on the smooth base
  static constexpr std::size_t no_source() { return static_cast<std::size_t>(-1); }

  Point_3 point = Point_3(FT(0), FT(0), FT(0));      ///< position
  Vector_3 normal = Vector_3(FT(0), FT(0), FT(0));   ///< normal of length 1
  std::size_t source = no_source();                  ///< index of the point that it was copied from (see `Hole_3`)
  std::size_t source_set = 0;                        ///< 0: that point is in the point set itself,
                                                     ///< i: in the i-th of the `example_point_sets`, counted from 1
  std::size_t hole = 0;                              ///< `Hole_3::id` of the hole that it fills
  double confidence = 0;                             ///< 0 (a guess) to 1 (certain)

  /// returns whether the point is the copy of another one.
  bool has_source() const { return source != no_source(); }
};

} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_NEW_POINT_3_H
