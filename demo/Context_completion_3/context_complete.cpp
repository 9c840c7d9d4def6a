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

// The program context_complete: reads points, finds and fills the holes, writes and reports.

#include "command_line.h"
#include "completion_run.h"
#include "failure.h"
#include "mesh_faces.h"
#include "normal_estimation.h"
#include "output_file.h"
#include "point_set_io.h"
#include "progress_bar.h"
#include "report.h"

#include <CGAL/Context_completion_3/Invalid_input.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace {

using namespace Completion_program;

/// `name`, or `name_2` and so on if the points have a property that is called so.
std::string free_name(const Point_set& points, const std::string& name, std::vector<std::string>& notes)
{
  const std::vector<std::string> taken = points.properties();
  std::string result = name;
  for(int i = 2; std::find(taken.begin(), taken.end(), result) != taken.end(); ++i)
    result = name + "_" + std::to_string(i);
  if(result != name)
    notes.push_back("has a property " + name + " already; that of the result is called " + result);
  return result;
}

/// Reads a file; normals are estimated, or must be there.
void read(const std::string& name, const Options& options, Progress_bar& bar, Point_file& file)
{
  bar.start("reading " + name);
  read_point_file(name, file);
  if(!options.use_faces)
    file.faces.clear();
  if(file.points.empty())
    throw Failure(name + ": there are no points in it");
  if(options.estimate_normals > 0)
  {
    bar.start("estimating normals");
    const std::size_t number = estimate_normals(file, options.estimate_normals, bar.callback());
    if(number > 0)
      file.notes.push_back("the side of the normal is a guess at " + plural(number, "point"));
  }
  else if(!file.points.has_normal_map() && !file.faces.empty())
  {
    compute_normals(file);
    file.notes.push_back("there are no normals; they are those of the faces");
  }
  else if(!file.points.has_normal_map())
    throw Failure(name + ": the points have no normals; --estimate-normals 18 makes them from the 18 nearest points");
}

void print_notes(const Point_file& file, const Options& options, Progress_bar& bar)
{
  bar.clear();
  if(!options.is_quiet)
    for(const std::string& note : file.notes)
      std::cerr << "note: " << file.name << ": " << note << '\n';
}

void list(const Options& options, const Point_file& file, const std::vector<Point_set>& examples, Progress_bar& bar)
{
  print_notes(file, options, bar);
  const Completion_result result = find_holes(options, file, examples, bar);
  bar.clear();
  if(options.is_json)
    std::cout << list_to_json(file.name, result, file.points.size()).dump(2) << '\n';
  else
    print_holes(std::cout, result, file.points.size());
}

/// The points from `first` on.
Point_set new_points(const Point_set& points, std::size_t first)
{
  Point_set result;
  result.copy_properties(points);
  for(auto it = points.begin() + std::ptrdiff_t(first); it != points.end(); ++it)
    result.insert(points, *it);
  return result;
}

void complete(const Options& options, Point_file& file, const std::vector<Point_set>& examples, Progress_bar& bar)
{
  typedef std::chrono::steady_clock Clock;
  const Clock::time_point start = Clock::now();

  // a folder that cannot be written is told now, not after the work
  Output_file output(options.output);
  const Format output_format = format_for_writing(options.output);
  std::unique_ptr<Output_file> added, report;
  if(!options.added.empty())
    added = std::make_unique<Output_file>(options.added);
  if(!options.report.empty())
    report = std::make_unique<Output_file>(options.report);
  if((added && added->target() == output.target()) || (report && report->target() == output.target())
     || (added && report && added->target() == report->target()))
    throw Usage_error("OUTPUT, --added and --report must be different files");

  const std::size_t number_of_points = file.points.size();
  const History_names names = { free_name(file.points, "hole", file.notes),
                                free_name(file.points, "source", file.notes),
                                free_name(file.points, "source_set", file.notes) };
  print_notes(file, options, bar);

  const Completion_result result = fill_holes(options, file, examples, names, bar);
  if(examples.empty()) // all sources are in the input
  {
    auto source_set_map = file.points.add_property_map<int>(names.source_set).first;
    file.points.remove_property_map(source_set_map);
  }

  bar.start("writing");
  const std::size_t number_of_new_points = file.points.size() - number_of_points;
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  write_point_file(output.stream(), output_format, file.points, file);
  output.close();
  if(added)
  {
    Point_set points = new_points(file.points, number_of_points);
    write_point_file(added->stream(), format_for_writing(options.added), points, file);
    added->close();
  }
  if(report)
  {
    report->stream() << reports_to_json(options.input, options.output, result, number_of_points, number_of_new_points,
                                        seconds).dump(2) << '\n';
    report->close();
  }
  // all files are complete; now they appear
  output.commit();
  if(added)
    added->commit();
  if(report)
    report->commit();

  bar.clear();
  if(!options.is_quiet)
    print_reports(std::cout, result, number_of_new_points, seconds);
}

void run(const Options& options)
{
  Progress_bar bar(!options.is_quiet);
#ifdef CGAL_LINKED_WITH_TBB
  std::unique_ptr<tbb::global_control> control;
  if(options.threads > 0)
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, options.threads);
#else
  if(options.threads > 1 && !options.is_quiet)
    std::cerr << "note: this program was built without TBB and runs in one thread\n";
#endif
  // wrong names of results are told before the input is read
  for(const std::string& name : { options.output, options.added })
    if(!name.empty())
      format_for_writing(name);

  Point_file file;
  read(options.input, options, bar, file);
  std::vector<Point_set> examples;
  for(const std::string& name : options.examples)
  {
    Point_file example;
    read(name, options, bar, example);
    examples.push_back(example.points);
  }
  try
  {
    if(options.is_list)
      list(options, file, examples, bar);
    else
      complete(options, file, examples, bar);
  }
  catch(const CGAL::Context_completions_3::Invalid_input& error)
  {
    std::string name = options.input, reason = error.what();
    // "Example point set 2: ..." is the second file of --examples
    const std::string example = "Example point set ";
    const std::size_t colon = reason.find(": ");
    if(reason.compare(0, example.size(), example) == 0 && colon != std::string::npos)
    {
      const std::size_t number = std::strtoul(reason.c_str() + example.size(), nullptr, 10);
      if(number >= 1 && number <= options.examples.size())
      {
        name = options.examples[number - 1];
        reason = reason.substr(colon + 2);
      }
    }
    const bool is_about_normals = reason.find("normals can be estimated") != std::string::npos;
    throw Failure(name + ": " + reason + (is_about_normals ? " Here: --estimate-normals 18." : ""));
  }
}

extern "C" void on_interrupt(int) { interrupt_flag() = 1; }

} // namespace

int main(int argc, char* argv[])
{
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  try
  {
    const Options options = parse_command_line(argc, argv);
    if(options.is_help)
      print_usage(std::cout);
    else
      run(options);
    return 0;
  }
  catch(const Usage_error& error)
  {
    std::cerr << "context_complete: " << error.what() << "\nTry context_complete --help.\n";
    return 2;
  }
  catch(const std::bad_alloc&)
  {
    std::cerr << "context_complete: the memory is not enough\n";
  }
  catch(const std::exception& error)
  {
    std::cerr << "context_complete: " << error.what() << '\n';
  }
  return 1;
}
