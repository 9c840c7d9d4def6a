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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_ONE_SHOT_COMPLETION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_ONE_SHOT_COMPLETION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Parameter_reading.h>
#include <CGAL/Context_completion_3/internal/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <iterator>
#include <type_traits>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

template <typename T>
struct Is_named_parameters : std::false_type {};

template <typename T, typename Tag, typename Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base> > : std::true_type {};

/// Runs all steps with one progress from 0 to 1. \return `false` if the callback cancelled.
template <typename Completion, typename New_points, typename NamedParameters>
bool complete_at_once(Completion& completion, New_points& new_points, const NamedParameters& np)
{
  const double share_of_detection = 0.1;
  const std::function<bool(double)> callback = read_callback(np);
  const std::function<bool(double)> detecting = [&](double fraction)
    { return !callback || callback(share_of_detection * fraction); };
  const std::function<bool(double)> completing = [&](double fraction)
    { return !callback || callback(share_of_detection + (1. - share_of_detection) * fraction); };

  return with_visitor(np, [&](auto& visitor)
  {
    completion.detect_holes(parameters::callback(detecting).visitor(std::ref(visitor)));
    if(!completion.is_detected())
      return false;
    completion.complete(std::back_inserter(new_points), parameters::callback(completing).visitor(std::ref(visitor)));
    return !completion.is_cancelled();
  });
}

/// Writes the reports to the output iterator `hole_reports`, if it was given.
template <typename Reports, typename NamedParameters>
void write_reports(const Reports& reports, const NamedParameters& np)
{
  auto output = parameters::get_parameter(np, own_np::hole_reports);
  if constexpr(is_given<decltype(output)>())
    for(const auto& report : reports)
      *output++ = report;
  else
    CGAL_USE(reports);
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_ONE_SHOT_COMPLETION_H
