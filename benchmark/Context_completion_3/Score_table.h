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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SCORE_TABLE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SCORE_TABLE_H

#include "Measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Completion_benchmark {

/// The scores of one method on one case.
struct Score_row
{
  std::string name, kind, method, status = "ok", filling;   ///< `name` of the case
  std::size_t n_input = 0;
  double spacing = 0, hole_radius = 0, noise = 0, seconds = 0;
  double expected_error = std::numeric_limits<double>::quiet_NaN();   ///< in spacings
  Measures measures;

  bool is_ok() const { return status == "ok"; }

  /// The distance that ranks methods; what nothing was added to is as far away as its nearest input.
  double rank(double Measures::*distance = &Measures::cham) const
  {
    const bool is_cham = distance == &Measures::cham;
    return is_cham && std::isnan(measures.cham) ? measures.comp_mean : measures.*distance;
  }
};

inline std::vector<std::string> split_line(const std::string& line, char separator)
{
  std::vector<std::string> cells(1);
  for(char c : line)
    if(c == separator)
      cells.emplace_back();
    else if(c != '\r')
      cells.back() += c;
  return cells;
}

/// Rows of a table with a header line, as maps from column to text.
inline std::vector<std::map<std::string, std::string> > read_csv(const std::string& file_name)
{
  std::ifstream file(file_name);
  std::string line;
  if(!std::getline(file, line))
    throw std::runtime_error("cannot read the table " + file_name);
  const std::vector<std::string> columns = split_line(line, ',');
  std::vector<std::map<std::string, std::string> > rows;
  while(std::getline(file, line))
  {
    const std::vector<std::string> cells = split_line(line, ',');
    rows.emplace_back();
    for(std::size_t i = 0; i < (std::min)(cells.size(), columns.size()); ++i)
      rows.back()[columns[i]] = cells[i];
  }
  return rows;
}

inline double to_number(const std::string& text)
{
  return text.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(text);
}

inline std::string from_number(double value, int digits = 12)
{
  if(!std::isfinite(value))
    return "";
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

class Score_table
{
public:
  void add(const Score_row& row) { m_rows.push_back(row); }
  const std::vector<Score_row>& rows() const { return m_rows; }

  /// Further peers, as a table with columns case, status and cham.
  void add_peer_table(const std::string& file_name)
  {
    for(auto& row : read_csv(file_name))
      if(row["status"] == "ok" && !std::isnan(to_number(row["cham"])))
        m_further_peers[row["case"]][row["peer"]] = to_number(row["cham"]);
  }

  void set_peers(const std::set<std::string>& names) { m_peers = names; }

  /// Lowest distance of any peer, infinity if none gave a result. Of further peers `cham` alone is known.
  double best_peer(const std::string& name, double Measures::*distance = &Measures::cham) const
  {
    double best = std::numeric_limits<double>::infinity();
    for(const Score_row& row : m_rows)
      if(row.name == name && m_peers.count(row.method) != 0 && row.is_ok()
         && !std::isnan(row.measures.*distance))
        best = (std::min)(best, row.measures.*distance);
    const auto further = m_further_peers.find(name);
    if(distance == &Measures::cham && further != m_further_peers.end())
      for(const auto& peer : further->second)
        best = (std::min)(best, peer.second);
    return best;
  }

  void write_csv(const std::string& file_name) const
  {
    std::ofstream file(file_name);
    file << "case,method,status,kind,filling,n_input,spacing,hole_radius,noise,seconds,best_peer,expected_error";
    for(const Measures::Column& column : Measures::columns())
      file << ',' << column.name;
    file << '\n';
    for(const Score_row& row : m_rows)
    {
      std::string status = row.status;
      std::replace_if(status.begin(), status.end(), [](char c) { return c == ',' || c == '\n'; }, ' ');
      file << row.name << ',' << row.method << ',' << status << ',' << row.kind << ',' << row.filling << ','
           << row.n_input << ',' << from_number(row.spacing, 17) << ',' << from_number(row.hole_radius, 17) << ','
           << from_number(row.noise) << ',' << from_number(row.seconds, 4) << ',' << from_number(best_peer(row.name))
           << ',' << from_number(row.expected_error);
      for(const Measures::Column& column : Measures::columns())
        file << ',' << from_number(row.measures.*column.value);
      file << '\n';
    }
    if(!file.flush())
      throw std::runtime_error("cannot write " + file_name);
  }

  /// Rows of an earlier run.
  static std::vector<Score_row> read_rows(const std::string& file_name)
  {
    std::vector<Score_row> rows;
    for(auto& cells : read_csv(file_name))
    {
      Score_row row;
      row.name = cells["case"];
      row.method = cells["method"];
      row.status = cells["status"];
      row.kind = cells["kind"];
      row.filling = cells["filling"];
      row.n_input = std::stoul(cells["n_input"]);
      row.spacing = to_number(cells["spacing"]);
      row.hole_radius = to_number(cells["hole_radius"]);
      row.noise = to_number(cells["noise"]);
      row.seconds = to_number(cells["seconds"]);
      row.expected_error = to_number(cells["expected_error"]);
      for(const Measures::Column& column : Measures::columns())
        row.measures.*column.value = to_number(cells[column.name]);
      rows.push_back(row);
    }
    return rows;
  }

private:
  std::vector<Score_row> m_rows;
  std::set<std::string> m_peers;
  std::map<std::string, std::map<std::string, double> > m_further_peers;
};

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_SCORE_TABLE_H
