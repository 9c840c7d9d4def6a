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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_REPORT_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_REPORT_H

#include "completion_run.h"

#include <CGAL/Bbox_3.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace Completion_program {

typedef nlohmann::ordered_json Json;

inline std::string name_of(CGAL::Context_completions_3::Hole_state state)
{
  typedef CGAL::Context_completions_3::Hole_state State;
  switch(state)
  {
  case State::hole: return "hole";
  case State::outer_border: return "outer border";
  case State::too_small: return "too small";
  case State::too_large: return "too large";
  case State::excluded: return "excluded";
  }
  return "";
}

inline std::string name_of(CGAL::Context_completions_3::Filling filling)
{
  typedef CGAL::Context_completions_3::Filling Filling;
  switch(filling)
  {
  case Filling::none: return "none";
  case Filling::copied: return "copied";
  case Filling::smooth: return "smooth";
  case Filling::learned: return "learned";
  }
  return "";
}

/// Rows of text in columns that are as wide as they need; the last column is flush left.
class Table
{
public:
  explicit Table(const std::vector<std::string>& titles) { m_rows.push_back(titles); }

  void add_row(const std::vector<std::string>& cells) { m_rows.push_back(cells); }

  bool is_empty() const { return m_rows.size() == 1; }

  void print(std::ostream& stream) const
  {
    std::vector<std::size_t> widths(m_rows.front().size(), 0);
    for(const std::vector<std::string>& row : m_rows)
      for(std::size_t i = 0; i < row.size(); ++i)
        widths[i] = (std::max)(widths[i], row[i].size());
    for(const std::vector<std::string>& row : m_rows)
    {
      for(std::size_t i = 0; i < row.size(); ++i)
        if(i + 1 < row.size())
          stream << std::setw(int(widths[i])) << std::right << row[i] << "  ";
        else
          stream << row[i] << '\n';
    }
  }

private:
  std::vector<std::vector<std::string> > m_rows;
};

inline std::string short_number(double number)
{
  std::ostringstream text;
  text << std::setprecision(4) << number;
  return text.str();
}

inline std::string plural(std::size_t number, const std::string& word)
{
  return std::to_string(number) + " " + word + (number == 1 ? "" : "s");
}

inline bool is_to_be_filled(const Completion_result& result, const Hole& hole)
{
  return hole.is_to_be_filled() && !result.is_covered[hole.id];
}

inline std::string state_of(const Completion_result& result, const Hole& hole)
{
  typedef CGAL::Context_completions_3::Hole_state State;
  const bool is_open = hole.state == State::hole || hole.state == State::outer_border;
  return is_open && result.is_covered[hole.id] ? "covered by faces" : name_of(hole.state);
}

// "2 outer border, 1 too small", of what was found and is not to be filled
inline std::string describe_others(const Completion_result& result)
{
  std::map<std::string, std::size_t> number;
  for(const Hole& hole : result.holes)
    if(!is_to_be_filled(result, hole))
      ++number[state_of(result, hole)];
  std::string text;
  for(const auto& entry : number)
    text += (text.empty() ? "" : ", ") + std::to_string(entry.second) + " " + entry.first;
  return text;
}

/// The answer to --list.
inline void print_holes(std::ostream& stream, const Completion_result& result, std::size_t number_of_points)
{
  Table table({ "hole", "centre", "diameter", "spacing", "rims", "state" });
  std::size_t number = 0;
  for(const Hole& hole : result.holes)
  {
    number += is_to_be_filled(result, hole) ? 1 : 0;
    table.add_row({ std::to_string(hole.id),
                    short_number(hole.center.x()) + "," + short_number(hole.center.y()) + ","
                      + short_number(hole.center.z()),
                    short_number(hole.diameter), short_number(hole.spacing), std::to_string(hole.loops.size()),
                    state_of(result, hole) });
  }
  stream << plural(number_of_points, "point") << ", spacing " << short_number(result.spacing) << ": "
         << (number == 0 ? std::string("no hole") : plural(number, "hole")) << '\n';
  if(!table.is_empty())
    table.print(stream);
}

inline Json to_json(const CGAL::Bbox_3& box)
{
  return { box.xmin(), box.ymin(), box.zmin(), box.xmax(), box.ymax(), box.zmax() };
}

/// The answer to --list --json.
inline Json list_to_json(const std::string& input, const Completion_result& result, std::size_t number_of_points)
{
  Json list = Json::array();
  for(const Hole& hole : result.holes)
  {
    Json cells = Json::array();
    for(const CGAL::Bbox_3& cell : hole.cells)
      cells.push_back(to_json(cell));
    list.push_back({ { "id", hole.id }, { "state", state_of(result, hole) },
                     { "center", { hole.center.x(), hole.center.y(), hole.center.z() } },
                     { "diameter", hole.diameter }, { "spacing", hole.spacing },
                     { "loops", hole.loops }, { "cells", cells } });
  }
  return { { "input", input }, { "points", number_of_points }, { "spacing", result.spacing },
           { "holes", list } };
}

/// The table at the end of a completion.
inline void print_reports(std::ostream& stream, const Completion_result& result, std::size_t number_of_new_points,
                          double seconds)
{
  Table table({ "hole", "diameter", "rims", "filling", "points", "expected error", "match", "level", "why" });
  for(const Hole_report& report : result.reports)
    if(is_to_be_filled(result, result.holes[report.hole])
       || report.filling != CGAL::Context_completions_3::Filling::none)
    {
      const bool is_filled = report.filling != CGAL::Context_completions_3::Filling::none;
      table.add_row({ std::to_string(report.hole), short_number(report.diameter), std::to_string(report.loops.size()),
                      name_of(report.filling), std::to_string(report.number_of_points),
                      is_filled ? short_number(report.expected_error) : "-",
                      is_filled ? short_number(report.match) : "-",
                      is_filled ? std::to_string(report.level) : "-", report.reason });
    }
  if(table.is_empty())
    stream << "There is no hole to fill; nothing was added.\n";
  else
    table.print(stream);
  const std::string others = describe_others(result);
  if(!others.empty())
    stream << "Not filled: " << others << ".\n";
  stream << plural(number_of_new_points, "point") << " added in " << short_number(seconds) << " s.\n";
}

/// The text of --report.
inline Json reports_to_json(const std::string& input, const std::string& output, const Completion_result& result,
                            std::size_t number_of_points, std::size_t number_of_new_points, double seconds)
{
  Json list = Json::array();
  for(const Hole_report& report : result.reports)
  {
    const Point& center = result.holes[report.hole].center;
    list.push_back({ { "id", report.hole }, { "state", state_of(result, result.holes[report.hole]) },
                     { "center", { center.x(), center.y(), center.z() } }, { "diameter", report.diameter },
                     { "filling", name_of(report.filling) }, { "reason", report.reason },
                     { "expected_error", report.expected_error }, { "match", report.match },
                     { "level", report.level }, { "added", report.number_of_points }, { "loops", report.loops } });
  }
  return { { "input", input }, { "output", output }, { "points", number_of_points },
           { "spacing", result.spacing }, { "added", number_of_new_points }, { "seconds", seconds },
           { "holes", list } };
}

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_REPORT_H
