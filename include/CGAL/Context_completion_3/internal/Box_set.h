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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_SET_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_SET_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/Bbox_3.h>

#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

inline bool is_inside(const Vector& p, const Bbox_3& box)
{
  return p.x() >= box.xmin() && p.x() <= box.xmax() && p.y() >= box.ymin() && p.y() <= box.ymax() &&
         p.z() >= box.zmin() && p.z() <= box.zmax();
}

inline bool is_inside_any(const Vector& p, const std::vector<Bbox_3>& boxes)
{
  for(const Bbox_3& box : boxes)
    if(is_inside(p, box))
      return true;
  return false;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_SET_H
