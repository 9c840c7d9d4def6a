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

#ifndef CGAL_CONTEXT_COMPLETION_3_HOLE_REPORT_3_H
#define CGAL_CONTEXT_COMPLETION_3_HOLE_REPORT_3_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/Hole_3.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {

#ifdef DOXYGEN_RUNNING
/*!
  \ingroup PkgContextCompletion3Ref
  \brief Where the new points of a hole came from.
*/
enum class Filling
{
  none,    ///< the hole was left as it was
  copied,  ///< from the best matching places of the surface or of the example point sets
  smooth,  ///< from the smooth base, as copying promised less
  learned  ///< a sum of many places, weighted as they teach the surface to go on from its surroundings
};
#else
typedef internal::Filling Filling;
#endif

/*!
  \ingroup PkgContextCompletion3Ref

  \brief tells what became of a hole.

  Lengths are in the unit of the point set. Indices of points are those of `Hole_3`.
*/
struct Hole_report_3
{
  std::size_t hole = 0;                          ///< `Hole_3::id`
  Hole_state state = Hole_state::hole;           ///< `Hole_3::state`
  double diameter = 0;                           ///< `Hole_3::diameter`
  std::vector<std::vector<std::size_t> > loops;  ///< `Hole_3::loops`
  Filling filling = Filling::none;               ///< where its points came from
  std::string reason;                            ///< a sentence that says why it was copied, smooth, learned or left
  double expected_error = 0;                     ///< expected distance of the new points to the true surface
  double match = 0;                              ///< mismatch of the best matching place, 0 is best: by default how
                                                 ///< far the surroundings differ; by the paper's policies eq. 1
  std::size_t level = 0;                         ///< finest level of the cell tree that contributed
  std::size_t number_of_points = 0;              ///< number of new points
};

} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_HOLE_REPORT_3_H
