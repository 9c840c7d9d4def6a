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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_COMMAND_LINE_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_COMMAND_LINE_H

#include "failure.h"

#include <CGAL/Bbox_3.h>

#include <boost/program_options.hpp>

#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace Completion_program {

/// What the user asked for. Lengths in model units, 0 meaning "chosen by the package".
struct Options
{
  std::string input, output, added, report;
  std::vector<std::string> examples;
  bool is_help = false, is_list = false, is_json = false, is_quiet = false;
  bool use_faces = true;                        ///< of a mesh: for normals, and to tell holes

  std::vector<std::size_t> holes;               ///< empty: all
  std::vector<CGAL::Bbox_3> boxes, excluded_boxes, user_holes;
  double minimum_diameter = 0, maximum_diameter = 0, tolerance = 0;
  std::size_t depth = 0, minimum_cell_points = 15, turns = 24, candidates = 2000;
  bool is_paper = false, is_nearest = false, use_mirrors = true;

  std::size_t estimate_normals = 0;             ///< number of neighbours, 0: normals are in the file
  std::size_t threads = 0;                      ///< 0: all
  unsigned int seed = 0;
};

namespace internal {

namespace po = boost::program_options;

inline double parse_number(const std::string& text, const std::string& option)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if(text.empty() || *end != '\0' || !std::isfinite(number))
    throw Usage_error(option + ": '" + text + "' is no finite number");
  return number;
}

inline std::size_t parse_integer(const std::string& text, const std::string& option, std::size_t low, std::size_t high)
{
  char* end = nullptr;
  errno = 0;
  const long long number = std::strtoll(text.c_str(), &end, 10);
  if(text.empty() || *end != '\0')
    throw Usage_error(option + ": '" + text + "' is no integer");
  if(errno != 0 || number < 0 || std::size_t(number) < low || std::size_t(number) > high)
    throw Usage_error(option + ": " + text + " is not between " + std::to_string(low) + " and " + std::to_string(high));
  return std::size_t(number);
}

inline std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> parts(1);
  for(char c : text)
    if(c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

inline CGAL::Bbox_3 parse_box(const std::string& text, const std::string& option)
{
  const std::vector<std::string> parts = split(text);
  if(parts.size() != 6)
    throw Usage_error(option + ": '" + text + "' has not six numbers x0,y0,z0,x1,y1,z1");
  double c[6];
  for(std::size_t i = 0; i < 6; ++i)
    c[i] = parse_number(parts[i], option);
  if(c[0] > c[3] || c[1] > c[4] || c[2] > c[5])
    throw Usage_error(option + ": in '" + text + "' the first corner is not the lower one");
  return CGAL::Bbox_3(c[0], c[1], c[2], c[3], c[4], c[5]);
}

// values of an option, none if it was not given
inline std::vector<std::string> values(const po::variables_map& given, const std::string& name)
{
  return given.count(name) == 0 ? std::vector<std::string>() : given[name].as<std::vector<std::string> >();
}

inline std::string value(const po::variables_map& given, const std::string& name)
{
  const std::vector<std::string> all = values(given, name);
  if(all.size() > 1)
    throw Usage_error("--" + name + " is given " + std::to_string(all.size()) + " times");
  if(!all.empty() && all.front().empty())
    throw Usage_error("--" + name + " is empty");
  return all.empty() ? std::string() : all.front();
}

inline void set_length(const po::variables_map& given, const std::string& name, double& target)
{
  if(given.count(name) == 0)
    return;
  target = parse_number(value(given, name), "--" + name);
  if(!(target > 0))
    throw Usage_error("--" + name + ": " + value(given, name) + " is not positive");
}

template <typename Integer>
void set_integer(const po::variables_map& given, const std::string& name, std::size_t low, std::size_t high,
                 Integer& target)
{
  if(given.count(name) > 0)
    target = Integer(parse_integer(value(given, name), "--" + name, low, high));
}

inline po::options_description visible_options()
{
  const auto text = [](const char* name) { return po::value<std::vector<std::string> >()->value_name(name); };
  po::options_description files("Files"), choice("Which holes"), normals("Normals and faces"), method("How"),
    run("Running");
  files.add_options()
    ("added", text("FILE"), "write the new points alone, too")
    ("report", text("FILE.json"), "write a report of all holes")
    ("examples", text("FILE"), "a further point set to copy from (repeatable)");
  choice.add_options()
    ("list", "find and describe the holes, fill nothing")
    ("json", "with --list: as JSON")
    ("holes", text("0,3"), "fill only these, by the numbers of --list")
    ("min-diameter", text("D"), "leave smaller holes, in model units")
    ("max-diameter", text("D"), "leave larger holes, in model units")
    ("box", text("x0,y0,z0,x1,y1,z1"), "fill only in this box (repeatable)")
    ("hole-box", text("x0,y0,z0,x1,y1,z1"), "a hole, found or not: fill what is open in this box (repeatable)")
    ("exclude-box", text("x0,y0,z0,x1,y1,z1"), "never fill in this box (repeatable)");
  normals.add_options()
    ("ignore-faces", "of a mesh: neither normals nor holes are taken from its faces")
    ("estimate-normals", text("K"), "from K nearest points (6 to 1000; 18 is a good start)");
  method.add_options()
    ("nearest", "where detail is random: nearest in distance, not true in texture")
    ("no-mirrors", "no mirrored copies")
    ("turns", text("N"), "turns of an example around its normal (1 to 360, default 24)")
    ("candidates", text("N"), "places on the shortlist of a search (default 2000)")
    ("depth", text("N"), "depth of the cell tree (1 to 20, default from the spacing)")
    ("min-cell-points", text("N"), "points that a cell needs (6 to 100000, default 15)")
    ("tolerance", text("T"), "of the local approximations, in model units (default half the spacing)")
    ("paper", "the paper's own choice at every stage");
  run.add_options()
    ("threads", text("N"), "number of threads (1 to 1024, default all)")
    ("seed", text("S"), "of the random choices (default 0)")
    ("quiet", "no progress, no notes, no table")
    ("help", "show this");
  po::options_description all;
  all.add(files).add(choice).add(normals).add(method).add(run);
  return all;
}

inline Options checked(const po::variables_map& given)
{
  Options options;
  options.is_help = given.count("help") > 0;
  if(options.is_help)
    return options;

  const std::vector<std::string> files = values(given, "file");
  options.is_list = given.count("list") > 0;
  options.is_json = given.count("json") > 0;
  options.is_quiet = given.count("quiet") > 0;
  if(files.empty())
    throw Usage_error("INPUT is missing");
  if(options.is_list && files.size() > 1)
    throw Usage_error("--list fills nothing, so that " + files[1] + " would not be written");
  if(!options.is_list && files.size() < 2)
    throw Usage_error("OUTPUT is missing");
  if(files.size() > 2)
    throw Usage_error("'" + files[2] + "' is one file too many");
  if(options.is_json && !options.is_list)
    throw Usage_error("--json goes with --list; the report of a completion is --report FILE.json");
  options.input = files[0];
  options.output = files.size() > 1 ? files[1] : std::string();
  options.added = value(given, "added");
  options.report = value(given, "report");
  if(options.is_list && !(options.added.empty() && options.report.empty()))
    throw Usage_error("--list fills nothing, so that --added and --report have nothing to write");
  options.use_faces = given.count("ignore-faces") == 0;
  options.examples = values(given, "examples");

  if(given.count("holes") > 0)
    for(const std::string& hole : split(value(given, "holes")))
      options.holes.push_back(parse_integer(hole, "--holes", 0, 1000000000));
  for(const std::string& box : values(given, "box"))
    options.boxes.push_back(parse_box(box, "--box"));
  for(const std::string& box : values(given, "exclude-box"))
    options.excluded_boxes.push_back(parse_box(box, "--exclude-box"));
  for(const std::string& box : values(given, "hole-box"))
    options.user_holes.push_back(parse_box(box, "--hole-box"));
  set_length(given, "min-diameter", options.minimum_diameter);
  set_length(given, "max-diameter", options.maximum_diameter);
  if(options.maximum_diameter > 0 && options.minimum_diameter > options.maximum_diameter)
    throw Usage_error("--min-diameter is above --max-diameter");

  set_length(given, "tolerance", options.tolerance);
  set_integer(given, "depth", 1, 20, options.depth);
  set_integer(given, "min-cell-points", 6, 100000, options.minimum_cell_points);
  set_integer(given, "turns", 1, 360, options.turns);
  set_integer(given, "candidates", 1, 10000000, options.candidates);
  set_integer(given, "estimate-normals", 6, 1000, options.estimate_normals);
  set_integer(given, "threads", 1, 1024, options.threads);
  set_integer(given, "seed", 0, 4294967295u, options.seed);
  options.is_paper = given.count("paper") > 0;
  options.is_nearest = given.count("nearest") > 0;
  options.use_mirrors = given.count("no-mirrors") == 0;
  return options;
}

} // namespace internal

inline void print_usage(std::ostream& stream)
{
  stream << "Completes the holes of a surface that is given as points, by copies of matching parts of it.\n\n"
            "  context_complete INPUT OUTPUT [options]\n"
            "  context_complete INPUT --list [--json] [options]\n\n"
            "Files are .ply, .xyz, .pwn, .off or .las; INPUT may also be .obj. OUTPUT holds the points of INPUT, then\n"
            "the new ones; in PLY they have the integer properties hole and source, which are -1 at the points of INPUT.\n"
         << internal::visible_options()
         << "\nExit codes: 0 done, also when there is no hole; 1 bad input or output; 2 wrong use.\n";
}

/// \throw Usage_error
inline Options parse_command_line(int argc, char* argv[])
{
  namespace po = boost::program_options;
  po::options_description all = internal::visible_options();
  all.add_options()("file", po::value<std::vector<std::string> >());
  po::positional_options_description positional;
  positional.add("file", -1);
  try
  {
    // whole names only: an option added later must not make a shortened one ambiguous
    const int style = po::command_line_style::allow_long | po::command_line_style::long_allow_adjacent
                    | po::command_line_style::long_allow_next;
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(), given);
    return internal::checked(given);
  }
  catch(const po::error& error)
  {
    throw Usage_error(error.what());
  }
}

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_COMMAND_LINE_H
