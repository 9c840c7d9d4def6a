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
// Cuts holes into models of CGAL's data and into synthetic surfaces and writes them as folders with
// input.ply, removed.ply, truth.ply and meta.json.
//
//   cut_cases OUTPUT_FOLDER [--generate N] [--seed S] [--set all|synthetic|models] [--only NAME] [--data FOLDER]
//
// Without --generate the forty named cases are written.

#include "Case_generator.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv)
{
  using namespace Completion_benchmark;
  std::string folder, only, data = std::getenv("CGAL_DATA_DIR") ? std::getenv("CGAL_DATA_DIR") : "data";
  std::size_t number = 0;
  std::uint64_t seed = 1;
  Case_set set = Case_set::all;
  for(int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    if(option.compare(0, 2, "--") != 0)
    {
      folder = option;
      continue;
    }
    ++i;
    if(option == "--generate")
      number = std::stoul(value);
    else if(option == "--seed")
      seed = std::stoull(value);
    else if(option == "--only")
      only = value;
    else if(option == "--data")
      data = value;
    else if(option == "--set" && (value == "all" || value == "synthetic" || value == "models"))
      set = value == "all" ? Case_set::all : value == "models" ? Case_set::models : Case_set::synthetic;
    else
    {
      std::cerr << "unknown option " << option << " " << value << std::endl;
      return 2;
    }
  }
  if(folder.empty())
  {
    std::cerr << "usage: cut_cases OUTPUT_FOLDER [--generate N] [--seed S] [--set all|synthetic|models] [--only NAME]"
                 " [--data FOLDER]" << std::endl;
    return 2;
  }
  const Case_generator generate(data);
  std::size_t failures = 0;
  for(const Case_description& description : number == 0 ? development_cases() : random_cases(number, seed, set))
  {
    if(!only.empty() && description.name != only)
      continue;
    try
    {
      const Benchmark_case c = generate(description);
      std::filesystem::create_directories(folder + "/" + c.name);
      write_case(folder + "/" + c.name, c);
      std::cout << c.name << " (" << c.kind << ", " << c.shape << "): " << c.input.size() << " points, "
                << c.removed.size() << " removed, radius " << c.hole_radius / c.spacing << " spacings, " << c.rims
                << " rims" << std::endl;
    }
    catch(const std::exception& error)
    {
      std::cerr << description.name << ": " << error.what() << std::endl;
      ++failures;
    }
  }
  return failures == 0 ? 0 : 1;
}
