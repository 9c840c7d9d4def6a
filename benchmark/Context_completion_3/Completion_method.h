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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_COMPLETION_METHOD_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_COMPLETION_METHOD_H

#include "Benchmark_case.h"
#include "Benchmark_surface.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace Completion_benchmark {

/// What a method made of a case: added points, or a surface from which they are to be sampled.
struct Completion_result
{
  Surface_points added;
  Benchmark_surface surface;
  bool is_surface = false;
  std::string filling;                          ///< per hole that was filled, "copied", "smooth" or "learned"
  double expected_error = std::numeric_limits<double>::quiet_NaN();   ///< the method's own forecast, model units
};

/// A way of completing; it sees the input, and only the peers that need a mesh see what was cut to make one.
struct Completion_method
{
  std::string name, description;
  std::function<Completion_result(const Benchmark_case&)> run;
};

/// This package with its default policies and with the paper's.
std::vector<Completion_method> own_methods();

/// The default without one ingredient at a time.
std::vector<Completion_method> ablation_methods();

/// Smooth fillers of CGAL.
std::vector<Completion_method> peer_methods();

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_COMPLETION_METHOD_H
