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

// The calls of the package, in a file of their own because they take long to compile.

#include "completion_run.h"
#include "failure.h"
#include "mesh_borders.h"
#include "mesh_faces.h"

#include <CGAL/Context_completion_3.h>
#include <CGAL/Context_completion_3/internal/Property_transfer.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace Completion_program {

namespace {

typedef CGAL::Context_completion_3<Kernel, CGAL::Parallel_if_available_tag> Completion;
using CGAL::Context_completions_3::combine;
namespace parameters = CGAL::parameters;

/// Names the stage on the progress bar.
struct Stage_visitor : CGAL::Context_completions_3::Default_completion_visitor
{
  explicit Stage_visitor(Progress_bar& bar) : bar(bar) {}

  void on_hole_begin(std::size_t hole) { bar.set_stage("filling hole " + std::to_string(hole)); }

  Progress_bar& bar;
};

// What has no neutral value is a parameter only if it was given.
std::unique_ptr<Completion> make_completion(const Options& options, const Point_file& file,
                                            const std::vector<Point_set>& examples)
{
  const std::vector<std::vector<std::size_t> > rims = rims_of_holes(file);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<CGAL::Bbox_3> boxes = options.boxes, excluded_boxes = options.excluded_boxes;
  if(boxes.empty())
    boxes.emplace_back(-infinity, -infinity, -infinity, infinity, infinity, infinity);
  if(excluded_boxes.empty()) // a box without any finite point
    excluded_boxes.emplace_back(infinity, infinity, infinity, infinity, infinity, infinity);

  std::unique_ptr<Completion> completion;
  const auto make = [&](const auto& np) { completion = std::make_unique<Completion>(file.points, np); };
  const auto make_with_tolerance = [&](const auto& np)
  {
    if(options.tolerance > 0)
      make(combine(np, parameters::tolerance(options.tolerance)));
    else
      make(np);
  };
  const auto np = combine(parameters::regions(std::cref(boxes)),
                          parameters::excluded_regions(std::cref(excluded_boxes)),
                          parameters::user_holes(std::cref(options.user_holes)),
                          parameters::known_rims(std::cref(rims)),
                          parameters::example_point_sets(std::cref(examples)),
                          parameters::minimum_hole_diameter(options.minimum_diameter),
                          parameters::maximum_hole_diameter(
                            options.maximum_diameter > 0 ? options.maximum_diameter : infinity),
                          parameters::minimum_cell_points(options.minimum_cell_points),
                          parameters::number_of_turns(options.turns),
                          parameters::number_of_candidates(options.candidates),
                          parameters::use_mirrors(options.use_mirrors),
                          parameters::keep_texture(!options.is_nearest),
                          parameters::use_paper_policies(options.is_paper),
                          parameters::random_seed(options.seed));
  if(options.depth > 0)
    make_with_tolerance(combine(np, parameters::maximum_depth(options.depth)));
  else
    make_with_tolerance(np);
  return completion;
}

void throw_if_cancelled(const Completion& completion)
{
  if(completion.is_cancelled())
    throw Failure("interrupted; nothing was written");
}

// Parallel to the holes. Without faces none is covered, nor is what the user has bounded himself.
std::vector<char> covered_holes(const Options& options, const Completion& completion, const Point_file& file)
{
  std::vector<char> result(completion.holes().size(), 0);
  if(file.faces.empty())
    return result;
  const std::vector<char> is_at_border = points_at_border(file.faces, file.points.size());
  for(const Hole& hole : completion.holes())
    result[hole.id] = is_covered(hole.loops, is_at_border) &&
      std::none_of(options.user_holes.begin(), options.user_holes.end(),
                   [&](const CGAL::Bbox_3& box) { return CGAL::do_overlap(hole.center.bbox(), box); });
  return result;
}

// \param is_covered receives, parallel to the holes, whether faces cover it
std::unique_ptr<Completion> detect(const Options& options, const Point_file& file,
                                   const std::vector<Point_set>& examples, Progress_bar& bar,
                                   std::vector<char>& is_covered)
{
  bar.start("finding holes");
  std::unique_ptr<Completion> completion = make_completion(options, file, examples);
  completion->detect_holes(parameters::callback(bar.callback()));
  throw_if_cancelled(*completion);
  const std::size_t number = completion->holes().size();
  for(std::size_t hole : options.holes)
    if(hole >= number)
      throw Usage_error("--holes: there is no hole " + std::to_string(hole) + "; "
                        + (number == 0 ? std::string("there is none at all")
                                       : "they are numbered 0 to " + std::to_string(number - 1)));
  is_covered = covered_holes(options, *completion, file);
  if(!options.holes.empty())
    completion->choose(options.holes);
  else
    completion->choose([&](const Hole& hole) { return hole.is_to_be_filled() && !is_covered[hole.id]; });
  return completion;
}

Completion_result result_of(const Completion& completion, const std::vector<char>& is_covered)
{
  Completion_result result;
  result.spacing = completion.spacing();
  result.holes = completion.holes();
  result.is_covered = is_covered;
  result.reports = completion.report();
  return result;
}

} // namespace

Completion_result find_holes(const Options& options, const Point_file& file, const std::vector<Point_set>& examples,
                             Progress_bar& bar)
{
  std::vector<char> is_covered;
  return result_of(*detect(options, file, examples, bar, is_covered), is_covered);
}

Completion_result fill_holes(const Options& options, Point_file& file, const std::vector<Point_set>& examples,
                             const History_names& names, Progress_bar& bar)
{
  Point_set& points = file.points;
  std::vector<char> is_covered;
  const std::unique_ptr<Completion> completion = detect(options, file, examples, bar, is_covered);
  std::vector<Completion::New_point> new_points;
  Stage_visitor visitor(bar);
  completion->complete(std::back_inserter(new_points),
                       parameters::callback(bar.callback()).visitor(std::ref(visitor)));
  throw_if_cancelled(*completion);

  const auto hole_map = points.add_property_map<int>(names.hole, -1).first;
  const auto source_map = points.add_property_map<int>(names.source, -1).first;
  const auto source_set_map = points.add_property_map<int>(names.source_set, 0).first;
  const auto np = combine(parameters::hole_map(hole_map), parameters::source_map(source_map),
                          parameters::source_set_map(source_set_map),
                          parameters::example_point_sets(std::cref(examples)));
  CGAL::Context_completions_3::internal::Property_transfer<Point, Vector> transfer(points);
  transfer.read_examples(new_points, np);
  transfer.append(new_points, np);
  return result_of(*completion, is_covered);
}

} // namespace Completion_program
