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

#ifndef CGAL_CONTEXT_COMPLETION_3_TEST_ENGINE_SAMPLES_H
#define CGAL_CONTEXT_COMPLETION_3_TEST_ENGINE_SAMPLES_H

#include "surface_samples.h"

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// The surfaces of surface_samples.h in the types of the engine.
namespace Test_surfaces {

typedef CGAL::Context_completions_3::internal::Vector Engine_vector;
typedef CGAL::Context_completions_3::internal::Surface_points Engine_points;

inline Engine_vector engine_vector(const Point& p) { return Engine_vector(p.x(), p.y(), p.z()); }
inline Engine_vector engine_vector(const Vector& v) { return Engine_vector(v.x(), v.y(), v.z()); }

inline Engine_points engine_points(const Samples& samples)
{
  Engine_points points;
  for(const Oriented_point& s : samples)
    points.push_back(engine_vector(s.first), engine_vector(s.second));
  return points;
}

inline double nearest_distance(const Engine_vector& q, const std::vector<Engine_vector>& points)
{
  double nearest = std::numeric_limits<double>::infinity();
  for(const Engine_vector& p : points)
    nearest = (std::min)(nearest, (p - q).norm());
  return nearest;
}

} // namespace Test_surfaces

#endif // CGAL_CONTEXT_COMPLETION_3_TEST_ENGINE_SAMPLES_H
