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
// input.ply, removed.ply, truth.ply and meta.json, those of vertices with input.off, too.
//
//   cut_cases OUTPUT_FOLDER [OPTIONS]
//
//   --generate N         N random cases instead of the forty named ones
//   --vertices N         N random cases of the vertices of meshes, with several holes
//   --seed S             of the random cases (1)
//   --set SET            all, synthetic or models (all), with --generate
//   --only NAME          one case
//   --data FOLDER        CGAL's data (the environment's CGAL_DATA_DIR)

#include "Case_generator.h"
#include "Vertex_case_generator.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace Completion_benchmark;

/// Makes and writes the cases. \return how many failed.
template <typename Generator, typename Description>
std::size_t write_cases(const Generator& generate, const std::vector<Description>& descriptions,
                        const std::string& only, const std::string& folder)
{
  std::size_t failures = 0;
  for(const Description& description : descriptions)
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
  return failures;
}

} // namespace

int main(int argc, char** argv)
{
  std::string folder, only, data = std::getenv("CGAL_DATA_DIR") ? std::getenv("CGAL_DATA_DIR") : "data";
  std::size_t number = 0, number_of_vertex_cases = 0;
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
    else if(option == "--vertices")
      number_of_vertex_cases = std::stoul(value);
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
    std::cerr << "usage: cut_cases OUTPUT_FOLDER [--generate N | --vertices N] [--seed S] [--set all|synthetic|models]"
                 " [--only NAME] [--data FOLDER]" << std::endl;
    return 2;
  }
  const std::size_t failures =
    number_of_vertex_cases > 0
    ? write_cases(Vertex_case_generator(data), random_vertex_cases(number_of_vertex_cases, seed), only, folder)
    : write_cases(Case_generator(data), number == 0 ? development_cases() : random_cases(number, seed, set), only,
                  folder);
  return failures == 0 ? 0 : 1;
}
