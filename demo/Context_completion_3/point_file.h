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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_POINT_FILE_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_POINT_FILE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Completion_program {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Point_set_3<Point> Point_set;

enum class Format { ply, xyz, off, obj, las };

/*!
  What is around the points of a LAS file: everything before the first record (header, projection, ...) and after the
  last. The records themselves are the property `las_record` of the points, so that they travel to copies.
*/
struct Las_frame
{
  std::string before, after;
};

/// A point set and what else its file held.
struct Point_file
{
  std::string name;
  Format format = Format::ply;
  bool is_ascii = false;            ///< PLY only
  std::string comments;             ///< PLY only
  Las_frame las;                    ///< LAS only
  std::vector<std::string> notes;   ///< what of the file is not kept
  std::vector<std::vector<std::size_t> > faces;   ///< of a mesh, as indices of points; empty: points alone
  Point_set points;
};

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_POINT_FILE_H
