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
// Scores a result against a case, as the benchmark does.
//
//   evaluate_case CASE_FOLDER RESULT [--surface]
//
// RESULT: the added points with normals in PLY, or with --surface a mesh, which is sampled at the spacing of the case
// and cropped to the hole.

#include "Measures.h"
#include "Model_surface.h"

#include <cmath>
#include <exception>
#include <iomanip>
#include <iostream>
#include <string>

int main(int argc, char** argv)
{
  using namespace Completion_benchmark;
  if(argc < 3 || argc > 4 || (argc == 4 && std::string(argv[3]) != "--surface"))
  {
    std::cerr << "usage: evaluate_case CASE_FOLDER RESULT [--surface]" << std::endl;
    return 2;
  }
  try
  {
    const Benchmark_case c = read_case(argv[1]);
    const Scorer scorer(c);
    const Measures measures = argc == 4 ? scorer.score_surface(read_mesh(argv[2])) : scorer(read_points(argv[2]));
    std::cout << "{\"name\": \"" << c.name << "\"";
    for(const Measures::Column& column : Measures::columns())
    {
      const double value = measures.*column.value;
      std::cout << ", \"" << column.name << "\": ";
      if(std::isfinite(value))
        std::cout << std::setprecision(12) << value;
      else
        std::cout << "null";
    }
    std::cout << "}" << std::endl;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  return 0;
}
