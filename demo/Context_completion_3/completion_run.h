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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_COMPLETION_RUN_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_COMPLETION_RUN_H

#include "command_line.h"
#include "point_file.h"
#include "progress_bar.h"

#include <CGAL/Context_completion_3/Hole_3.h>
#include <CGAL/Context_completion_3/Hole_report_3.h>

#include <string>
#include <vector>

namespace Completion_program {

typedef CGAL::Context_completions_3::Hole_3<Kernel> Hole;
typedef CGAL::Context_completions_3::Hole_report_3 Hole_report;

/// What the package found and did.
struct Completion_result
{
  double spacing = 0;
  std::vector<Hole> holes;
  std::vector<char> is_covered;       ///< parallel to holes: faces of the file cover it
  std::vector<Hole_report> reports;   ///< empty if nothing was to be filled
};

/// Names of the integer properties that tell of each point where it came from.
struct History_names
{
  std::string hole, source, source_set;
};

/// Finds the holes. \throw Usage_error, Failure if interrupted, Context_completions_3::Invalid_input
Completion_result find_holes(const Options& options, const Point_file& file, const std::vector<Point_set>& examples,
                             Progress_bar& bar);

/*!
  Finds the holes, fills them and appends the new points, with the properties of their sources and the given ones.
  If it throws, the points are as they were. \throw as `find_holes()`
*/
Completion_result fill_holes(const Options& options, Point_file& file, const std::vector<Point_set>& examples,
                             const History_names& names, Progress_bar& bar);

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_COMPLETION_RUN_H
