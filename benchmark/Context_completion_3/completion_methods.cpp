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
#include "Completion_method.h"

#include <CGAL/context_complete.h>
#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Input_conversion.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace Completion_benchmark {

namespace Package = CGAL::Context_completions_3;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace {

const char* name_of(Package::Filling filling)
{
  switch(filling)
  {
  case Package::Filling::none: return "none";
  case Package::Filling::copied: return "copied";
  case Package::Filling::smooth: return "smooth";
  case Package::Filling::learned: return "learned";
  }
  return "";
}

// the fillings and the mean of the expected errors, a hole counting by its points
template <typename Report, typename Number_of_points>
void summarize(const std::vector<Report>& reports, const Number_of_points& number_of_points, Completion_result& result)
{
  double sum = 0, points = 0;
  for(const Report& report : reports)
  {
    if(report.filling == Package::Filling::none)
      continue;
    result.filling += result.filling.empty() ? "" : " ";
    result.filling += name_of(report.filling);
    sum += report.expected_error * double(number_of_points(report));
    points += double(number_of_points(report));
  }
  if(points > 0)
    result.expected_error = sum / points;
}

// through the door that users take
Completion_result complete(const Benchmark_case& c, bool paper)
{
  Point_set points = to_point_set(c.input);
  std::vector<Package::Hole_report_3> reports;
  CGAL::context_complete<Concurrency_tag>(points,
    Package::combine(CGAL::parameters::use_paper_policies(paper),
                     CGAL::parameters::hole_reports(std::back_inserter(reports))));
  Completion_result result;
  const Surface_points all = to_surface_points(points);
  for(std::size_t i = c.input.size(); i < all.size(); ++i)
    result.added.push_back(all.position[i], all.normal[i]);
  summarize(reports, [](const Package::Hole_report_3& report) { return report.number_of_points; }, result);
  return result;
}

typedef Package::internal::Engine_parameters Engine_parameters;

// through the engine, whose settings are finer than the named parameters
Completion_result complete(const Benchmark_case& c, const Engine_parameters& parameters)
{
  typedef Package::internal::Completion_engine<Concurrency_tag> Engine;
  const Package::internal::Converted_input input =
    Package::internal::convert_input(to_point_set(c.input), CGAL::parameters::default_values(), "");
  Engine engine(input.points, parameters);
  engine.detect(typename Engine::Callback());
  std::vector<std::size_t> chosen;
  for(std::size_t i = 0; i < engine.holes().size(); ++i)
    if(engine.holes()[i].state == Package::internal::Hole_state::hole)
      chosen.push_back(i);
  engine.complete(chosen, typename Engine::Callback());
  Completion_result result;
  for(const Package::internal::Added_point& p : engine.added())
    result.added.push_back(input.frame.center() + p.position, p.normal);
  summarize(engine.outcomes(), [](const Package::internal::Hole_outcome& outcome) { return outcome.added; }, result);
  return result;
}

/// A change of the engine's settings with a name.
struct Variant
{
  const char* name;
  const char* description;
  void (*change)(Engine_parameters&);
};

// one entry for each ingredient
const Variant variants[] = {
  { "without_copies", "the smooth base of each hole",
    [](Engine_parameters& p) { p.ingredients.copies = false; } },
  { "without_turns", "places in one turn about their normal only",
    [](Engine_parameters& p) { p.number_of_turns = 1; } },
  { "without_mirrors", "no mirrored copies",
    [](Engine_parameters& p) { p.mirror = false; } },
  { "few_candidates", "a shortlist of 100 places",
    [](Engine_parameters& p) { p.number_of_candidates = 100; } },
  { "without_signature", "places are compared by probes around the hole alone",
    [](Engine_parameters& p) { p.ingredients.signature = false; } },
  { "without_probes", "places are compared by signatures alone",
    [](Engine_parameters& p) { p.ingredients.probes = false; } },
  { "without_alignment", "places as the search found them, not aligned to the surroundings",
    [](Engine_parameters& p) { p.ingredients.alignment = false; } },
  { "without_warp", "copies are not warped to the rim",
    [](Engine_parameters& p) { p.ingredients.warp = false; } },
  { "without_averaging", "at most one place is copied",
    [](Engine_parameters& p) { p.ingredients.averaging = false; } },
  { "without_fake_holes", "the best place is always copied, whole",
    [](Engine_parameters& p) { p.ingredients.fake_holes = false; } },
  { "without_levels", "whole holes only, no finer levels",
    [](Engine_parameters& p) { p.ingredients.levels = false; } },
  { "without_coherence", "pieces do not try the places of the hole and of their neighbours",
    [](Engine_parameters& p) { p.ingredients.coherence = false; } },
  { "without_passes", "pieces are matched once, also when others around them are filled later",
    [](Engine_parameters& p) { p.ingredients.passes = false; } },
  { "without_facets", "edges are continued by smooth bases and copies alone",
    [](Engine_parameters& p) { p.ingredients.facets = false; } },
  { "without_open_ends", "ends of tubes are outer borders, whatever the examples say",
    [](Engine_parameters& p) { p.ingredients.open_ends = false; } },
  { "without_learning", "what no place matches is continued smoothly, whatever all places together teach",
    [](Engine_parameters& p) { p.ingredients.learning = false; } },
  { "without_kriging", "smooth bases of polyharmonic trends only",
    [](Engine_parameters& p) { p.ingredients.kriging = false; } },
  { "without_texture", "nearest in distance instead of true in texture",
    [](Engine_parameters& p) { p.keep_texture = false; } } };

} // namespace

std::vector<Completion_method> own_methods()
{
  return { { "default", "default policies", [](const Benchmark_case& c) { return complete(c, false); } },
           { "paper", "the paper's own policies", [](const Benchmark_case& c) { return complete(c, true); } } };
}

std::vector<Completion_method> ablation_methods()
{
  std::vector<Completion_method> methods;
  for(const Variant& variant : variants)
    methods.push_back({ variant.name, variant.description, [&variant](const Benchmark_case& c)
    {
      Engine_parameters parameters;
      variant.change(parameters);
      return complete(c, parameters);
    } });
  return methods;
}

} // namespace Completion_benchmark
