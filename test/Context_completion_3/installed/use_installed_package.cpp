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

// A sphere with a hole is completed by the installed package.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/context_complete.h>

#include <cmath>
#include <cstddef>
#include <iostream>

int main()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  CGAL::Point_set_3<Kernel::Point_3> points;
  points.add_normal_map();
  const std::size_t number = 4000;
  for(std::size_t i = 0; i < number; ++i)
  {
    // a spiral of equal areas, its end left out
    const double z = 1 - 2 * (double(i) + 0.5) / double(number);
    const double angle = 2.399963229728653 * double(i), radius = std::sqrt(1 - z * z);
    if(z < 0.95)
      points.insert(Kernel::Point_3(radius * std::cos(angle), radius * std::sin(angle), z),
                    Kernel::Vector_3(radius * std::cos(angle), radius * std::sin(angle), z));
  }
  const std::size_t added = CGAL::context_complete<CGAL::Parallel_if_available_tag>(points);
  std::cout << added << " points were added" << std::endl;
  return added > 50 && added < 200 ? 0 : 1;
}
