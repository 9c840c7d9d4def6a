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
// Cuts holes, completes them with this package and with CGAL's smooth fillers, scores all with the same measures and
// writes one table.
//
//   run_benchmark [OPTIONS] [CASE_FOLDER ...]
//
//   CASE_FOLDER          a case, or a folder of cases, as written by cut_cases; none: the forty named cases are cut
//   --generate N         N random cases instead, with the spread of all scores
//   --seed S             of the random cases (1)
//   --set SET            all, synthetic or models (all)
//   --only TEXT          only cases whose name contains TEXT
//   --methods A,B,...    of default, paper, poisson, fairing and the variants of the ablation (the first four)
//   --ablation           the default, the variants and the peers
//   --peer-table FILE    further peers: CSV with the columns case, peer, status, cham
//   --reuse FILE         CSV of an earlier run, from which the rows of the peers are taken
//   --output PREFIX      writes PREFIX.md and PREFIX.csv (benchmark)
//   --keep FOLDER        writes each case and the points that each method added there, and the meshes of the peers
//   --data FOLDER        CGAL's data (the environment's CGAL_DATA_DIR)

#include "Case_generator.h"
#include "Completion_method.h"
#include "Markdown_report.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace Completion_benchmark {

struct Options
{
  std::vector<std::string> folders, methods;
  std::string only, peer_table, reuse, output = "benchmark", keep,
              data = std::getenv("CGAL_DATA_DIR") ? std::getenv("CGAL_DATA_DIR") : "data";
  std::size_t number = 0;
  std::uint64_t seed = 1;
  Case_set set = Case_set::all;
};

inline Options read_options(int argc, char** argv)
{
  Options options;
  options.methods = { "default", "paper", "poisson", "fairing" };
  for(int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    if(option == "--ablation")
    {
      options.methods = { "default" };
      for(const Completion_method& method : ablation_methods())
        options.methods.push_back(method.name);
      for(const Completion_method& method : peer_methods())
        options.methods.push_back(method.name);
      continue;
    }
    if(option.compare(0, 2, "--") != 0)
    {
      options.folders.push_back(option);
      continue;
    }
    if(i + 1 == argc)
      throw std::invalid_argument(option + " needs a value, or is unknown");
    const std::string value = argv[++i];
    if(option == "--generate")
      options.number = std::stoul(value);
    else if(option == "--seed")
      options.seed = std::stoull(value);
    else if(option == "--set" && (value == "all" || value == "synthetic" || value == "models"))
      options.set = value == "all" ? Case_set::all : value == "models" ? Case_set::models : Case_set::synthetic;
    else if(option == "--only")
      options.only = value;
    else if(option == "--methods")
      options.methods = split_line(value, ',');
    else if(option == "--peer-table")
      options.peer_table = value;
    else if(option == "--reuse")
      options.reuse = value;
    else if(option == "--output")
      options.output = value;
    else if(option == "--keep")
      options.keep = value;
    else if(option == "--data")
      options.data = value;
    else
      throw std::invalid_argument("unknown option " + option + " " + value);
  }
  return options;
}

/// Calls `use` with one case after the other.
inline void for_each_case(const Options& options, const std::function<void(const Benchmark_case&)>& use)
{
  namespace fs = std::filesystem;
  const auto is_wanted = [&options](const std::string& name)
    { return options.only.empty() || name.find(options.only) != std::string::npos; };
  std::set<std::string> folders;
  for(const std::string& folder : options.folders)
    if(fs::exists(folder + "/meta.json"))
      folders.insert(folder);
    else
      for(const fs::directory_entry& entry : fs::directory_iterator(folder))
        if(fs::exists(entry.path() / "meta.json"))
          folders.insert(entry.path().string());
  for(const std::string& folder : folders)
    if(is_wanted(fs::path(folder).filename().string()))
      use(read_case(folder));
  if(!options.folders.empty())
    return;
  const Case_generator generate(options.data);
  for(const Case_description& description :
      options.number == 0 ? development_cases() : random_cases(options.number, options.seed, options.set))
    if(is_wanted(description.name))
    {
      try
      {
        use(generate(description));
      }
      catch(const std::exception& error)
      {
        std::cerr << description.name << ": " << error.what() << std::endl;
      }
    }
}

inline Score_row run(const Completion_method& method, const Benchmark_case& c, const Scorer& scorer,
                     const std::string& keep)
{
  Score_row row;
  row.name = c.name;
  row.kind = c.kind;
  row.method = method.name;
  row.n_input = c.input.size();
  row.spacing = c.spacing;
  row.hole_radius = c.hole_radius;
  row.noise = c.noise;
  try
  {
    const auto start = std::chrono::steady_clock::now();
    Completion_result result = method.run(c);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.filling = result.filling;
    row.expected_error = result.expected_error / c.spacing;
    if(result.is_surface)
      row.measures = scorer.score_surface(result.surface);
    else
      row.measures = scorer(result.added);
    if(!keep.empty() && result.is_surface)
      write_mesh(keep + "/" + c.name + "/" + method.name + ".off", result.surface);
    if(!keep.empty())
      write_points(keep + "/" + c.name + "/" + method.name + ".ply",
                   result.is_surface ? scorer.crop(result.surface) : result.added);
  }
  catch(const std::exception& error)
  {
    row.status = std::string("failed: ") + error.what();
  }
  return row;
}

inline int run_benchmark(const Options& options)
{
  std::vector<Completion_method> known = own_methods(), methods;
  const std::vector<Completion_method> variants = ablation_methods(), peers = peer_methods();
  known.insert(known.end(), variants.begin(), variants.end());
  known.insert(known.end(), peers.begin(), peers.end());
  for(const std::string& name : options.methods)
  {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const Completion_method& method) { return method.name == name; });
    if(found == known.end())
      throw std::invalid_argument("unknown method " + name);
    methods.push_back(*found);
  }
  Score_table table;
  std::set<std::string> peer_names;
  for(const Completion_method& peer : peers)
    peer_names.insert(peer.name);
  table.set_peers(peer_names);
  if(!options.peer_table.empty())
    table.add_peer_table(options.peer_table);
  std::vector<Score_row> earlier;
  if(!options.reuse.empty())
    earlier = Score_table::read_rows(options.reuse);
  std::vector<std::string> own;
  for(const Completion_method& method : own_methods())
    if(std::find(options.methods.begin(), options.methods.end(), method.name) != options.methods.end())
      own.push_back(method.name);

  for_each_case(options, [&](const Benchmark_case& c)
  {
    if(!options.keep.empty())
    {
      std::filesystem::create_directories(options.keep + "/" + c.name);
      write_case(options.keep + "/" + c.name, c);
    }
    const Scorer scorer(c);
    for(const Completion_method& method : methods)
    {
      const auto same = std::find_if(earlier.begin(), earlier.end(), [&](const Score_row& row)
        { return row.name == c.name && row.method == method.name && row.n_input == c.input.size()
              && row.spacing == c.spacing && row.measures.n_removed == double(c.removed.size()); });
      const bool is_reused = peer_names.count(method.name) != 0 && same != earlier.end();
      const Score_row row = is_reused ? *same : run(method, c, scorer, options.keep);
      std::cout << c.name << "  " << method.name << "  "
                << (row.is_ok() ? "cham " + from_number(row.rank(), 4) + "  coverage "
                                  + from_number(row.measures.coverage, 4) + "  " + row.filling
                                : row.status)
                << (is_reused ? "  (reused)" : "  " + from_number(row.seconds, 3) + " s") << std::endl;
      table.add(row);
    }
    // after each case, so that a long run can be followed and loses nothing
    table.write_csv(options.output + ".csv");
    Markdown_report(table, options.methods, own).write(options.output + ".md");
  });
  if(table.rows().empty())
    throw std::runtime_error("no cases");
  return 0;
}

} // namespace Completion_benchmark

int main(int argc, char** argv)
{
  try
  {
    return Completion_benchmark::run_benchmark(Completion_benchmark::read_options(argc, argv));
  }
  catch(const std::invalid_argument& error)
  {
    std::cerr << error.what() << std::endl;
    return 2;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
