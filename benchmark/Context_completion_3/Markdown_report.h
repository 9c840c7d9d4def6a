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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MARKDOWN_REPORT_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MARKDOWN_REPORT_H

#include "Score_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iomanip>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Completion_benchmark {

/// Ranks from 1, the mean rank among equals.
inline std::vector<double> ranks(const std::vector<double>& values)
{
  std::vector<double> result;
  for(double v : values)
  {
    double below = 0, equal = 0;
    for(double w : values)
    {
      below += w < v;
      equal += w == v;
    }
    result.push_back(below + 0.5 * (equal + 1));
  }
  return result;
}

/// Spearman's rank correlation.
inline double rank_correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  const std::vector<double> x = ranks(a), y = ranks(b);
  const double mx = mean(x), my = mean(y);
  double xy = 0, xx = 0, yy = 0;
  for(std::size_t i = 0; i < x.size(); ++i)
  {
    xy += (x[i] - mx) * (y[i] - my);
    xx += (x[i] - mx) * (x[i] - mx);
    yy += (y[i] - my) * (y[i] - my);
  }
  return xy / std::sqrt(xx * yy);
}

/// The tables of a benchmark for people.
class Markdown_report
{
public:
  /// \param methods in the order of the columns, ours first
  Markdown_report(const Score_table& table, const std::vector<std::string>& methods,
                  const std::vector<std::string>& own)
    : m_table(table), m_methods(methods), m_own(own)
  {
    for(const Score_row& row : table.rows())
      if(std::find(m_cases.begin(), m_cases.end(), row.name) == m_cases.end())
        m_cases.push_back(row.name);
  }

  void write(const std::string& file_name) const
  {
    std::ofstream file(file_name);
    write_distances(file, "Distance to the true surface (`cham`, in spacings)", &Measures::cham);
    file << "\n";
    write_distances(file, "Distance of the removed points (`hole_distance`, in thousandths of the diagonal)",
                    &Measures::hole_distance);
    for(const std::string& method : m_own)
    {
      write_scores(file, method);
      write_spread(file, method);
      write_forecast(file, method);
    }
    write_comparison(file);
    if(!file.flush())
      throw std::runtime_error("cannot write " + file_name);
  }

private:
  typedef std::function<double(const Score_row&)> Figure;

  static std::string text(double value)
  {
    if(!std::isfinite(value))
      return "-";
    std::ostringstream out;
    out << std::setprecision(3) << value;
    return out.str();
  }

  const Score_row* find(const std::string& name, const std::string& method) const
  {
    for(const Score_row& row : m_table.rows())
      if(row.name == name && row.method == method)
        return &row;
    return nullptr;
  }

  std::vector<const Score_row*> rows_of(const std::string& method) const
  {
    std::vector<const Score_row*> rows;
    for(const std::string& name : m_cases)
      if(const Score_row* row = find(name, method))
        rows.push_back(row);
    return rows;
  }

  // against the best peer; of a run that failed infinity
  double ratio(const Score_row& row, double Measures::*distance = &Measures::cham) const
  {
    const double best = m_table.best_peer(row.name, distance);
    if(!std::isfinite(best))
      return std::numeric_limits<double>::quiet_NaN();
    return row.is_ok() ? row.rank(distance) / best : std::numeric_limits<double>::infinity();
  }

  static void write_rule(std::ostream& out, std::size_t left, std::size_t right)
  {
    for(std::size_t i = 0; i < left; ++i)
      out << "|---";
    for(std::size_t i = 0; i < right; ++i)
      out << "|---:";
    out << "|\n";
  }

  void write_distances(std::ostream& out, const std::string& title, double Measures::*distance) const
  {
    double logarithms = 0;
    std::size_t with_ratio = 0;
    out << "## " << title << "\n\n| case | kind ";
    for(const std::string& method : m_methods)
      out << "| " << method << " ";
    out << "| best peer | ratio |\n";
    write_rule(out, 2, m_methods.size() + 2);
    for(const std::string& name : m_cases)
    {
      const Score_row* first = nullptr;
      std::ostringstream cells;
      for(const std::string& method : m_methods)
      {
        const Score_row* row = find(name, method);
        cells << "| " << (row == nullptr ? "-" : row->is_ok() ? text(row->rank(distance)) : "failed") << " ";
        first = first == nullptr ? row : first;
      }
      out << "| " << name << " | " << first->kind << " " << cells.str() << "| "
          << text(m_table.best_peer(name, distance)) << " | " << text(ratio(*first, distance)) << " |\n";
      // where a peer is exact to rounding, as on a plane, ratios mean nothing
      if(m_table.best_peer(name, distance) > 1e-6 && std::isfinite(ratio(*first, distance)))
      {
        ++with_ratio;
        logarithms += std::log((std::max)(ratio(*first, distance), 1e-6));
      }
    }
    out << "\nThe ratio is " << m_methods.front() << " over the best peer";
    if(with_ratio > 0)
      out << "; its geometric mean is " << text(std::exp(logarithms / double(with_ratio))) << " (" << with_ratio
          << " cases in which the peer is not exact)";
    out << ".\n";
  }

  void write_scores(std::ostream& out, const std::string& method) const
  {
    const std::vector<const Score_row*> rows = rows_of(method);
    if(rows.empty())
      return;
    const char* shown[] = { "count_ratio", "coverage", "hole_max", "spurious", "outside", "acc_rms", "acc_max", "cham",
                            "hole_distance", "normal_deg", "detail_true", "detail_ratio", "detail_w1", "density",
                            "nn_p5", "seam_med", "seam_p95" };
    out << "\n## All scores of " << method << "\n\n| case | filling | s ";
    for(const char* name : shown)
      out << "| " << name << " ";
    out << "|\n";
    write_rule(out, 2, 1 + std::size(shown));
    for(const Score_row* row : rows)
    {
      out << "| " << row->name << " | " << (row->is_ok() ? row->filling : row->status) << " | " << text(row->seconds)
          << " ";
      for(const char* name : shown)
        for(const Measures::Column& column : Measures::columns())
          if(std::string(column.name) == name)
            out << "| " << text(row->measures.*column.value) << " ";
      out << "|\n";
    }
  }

  // quantiles over the cases of each kind and over all
  void write_spread(std::ostream& out, const std::string& method) const
  {
    // the geometric mean says something of what is compared by its ratio
    const std::set<std::string> proportional = { "cham over best peer", "cham", "seconds" };
    const std::pair<const char*, Figure> figures[] = {
      { "cham over best peer", [this](const Score_row& row) { return ratio(row); } },
      { "cham", [](const Score_row& row) { return row.rank(); } },
      { "coverage", [](const Score_row& row) { return row.measures.coverage; } },
      { "spurious", [](const Score_row& row) { return row.measures.spurious; } },
      { "normal_deg", [](const Score_row& row) { return row.measures.normal_deg; } },
      { "detail_ratio", [](const Score_row& row) { return row.measures.detail_ratio; } },
      { "density", [](const Score_row& row) { return row.measures.density; } },
      { "nn_p5", [](const Score_row& row) { return row.measures.nn_p5; } },
      { "seam_med", [](const Score_row& row) { return row.measures.seam_med; } },
      { "seconds", [](const Score_row& row) { return row.seconds; } } };
    const std::vector<const Score_row*> rows = rows_of(method);
    if(rows.empty())
      return;
    std::vector<std::string> kinds(1, "all");
    for(const Score_row* row : rows)
      if(std::find(kinds.begin(), kinds.end(), row->kind) == kinds.end())
        kinds.push_back(row->kind);
    out << "\n## Spread of " << method << "\n\n"
           "| figure | kind | cases | failed | geometric mean | least | 10 % | 25 % | median | 75 % | 90 % | most |\n";
    write_rule(out, 2, 10);
    for(const auto& figure : figures)
      for(const std::string& kind : kinds)
      {
        std::vector<double> values;
        std::size_t failed = 0;
        double logarithms = 0;
        for(const Score_row* row : rows)
        {
          if(kind != "all" && row->kind != kind)
            continue;
          const double value = figure.second(*row);
          if(!row->is_ok() || row->measures.n_added == 0)
            ++failed;
          if(!std::isfinite(value))
            continue;
          values.push_back(value);
          logarithms += std::log((std::max)(value, 1e-6));
        }
        if(values.empty())
          continue;
        out << "| " << figure.first << " | " << kind << " | " << values.size() << " | " << failed << " | "
            << (proportional.count(figure.first) != 0 ? text(std::exp(logarithms / double(values.size()))) : "-");
        for(double q : { 0., 0.1, 0.25, 0.5, 0.75, 0.9, 1. })
          out << " | " << text(quantile(values, q));
        out << " |\n";
      }
    std::size_t above = 0, known = 0;
    for(const Score_row* row : rows)
    {
      known += !std::isnan(ratio(*row));
      above += ratio(*row) > 1.05;
    }
    out << "\n" << above << " of " << known << " cases lie above 1.05 of the best peer.\n";
  }

  // is the method's own forecast of its error honest?
  void write_forecast(std::ostream& out, const std::string& method) const
  {
    std::vector<double> expected, error;
    std::size_t below = 0;
    for(const Score_row* row : rows_of(method))
      if(std::isfinite(row->expected_error) && std::isfinite(row->measures.acc_mean))
      {
        expected.push_back(row->expected_error);
        error.push_back(row->measures.acc_mean);
        below += error.back() <= expected.back();
      }
    if(expected.size() < 3)
      return;
    out << "\nThe true error of " << method << " lies below the expected error in " << below << " of "
        << expected.size() << " cases (" << text(100. * double(below) / double(expected.size()))
        << " %); rank correlation " << text(rank_correlation(expected, error)) << ".\n";
  }

  // all methods on the cases that all of them have: the ablation, when variants were run
  void write_comparison(std::ostream& out) const
  {
    out << "\n## Methods compared\n\n| method | cases | failed | cham, geometric mean | over " << m_methods.front()
        << " | worst over " << m_methods.front() << " | over best peer | coverage, least | detail_ratio, median "
           "| seconds, mean |\n";
    write_rule(out, 1, 9);
    for(const std::string& method : m_methods)
    {
      double distance = 0, relative = 0, worst = 0, against_peer = 0, seconds = 0, coverage = 1;
      std::size_t cases = 0, failed = 0, with_peer = 0;
      std::vector<double> detail;
      for(const Score_row* row : rows_of(method))
      {
        const Score_row* base = find(row->name, m_methods.front());
        if(!row->is_ok() || row->measures.n_added == 0)
          ++failed;
        if(!row->is_ok() || base == nullptr || !base->is_ok())
          continue;
        ++cases;
        const double value = (std::max)(row->rank(), 1e-6), reference = (std::max)(base->rank(), 1e-6);
        distance += std::log(value);
        relative += std::log(value / reference);
        worst = (std::max)(worst, value / reference);
        if(std::isfinite(ratio(*row)))
        {
          ++with_peer;
          against_peer += std::log((std::max)(ratio(*row), 1e-6));
        }
        coverage = (std::min)(coverage, row->measures.coverage);
        seconds += row->seconds;
        if(std::isfinite(row->measures.detail_ratio))
          detail.push_back(row->measures.detail_ratio);
      }
      if(cases == 0)
        continue;
      const double n = double(cases);
      out << "| " << method << " | " << cases << " | " << failed << " | " << text(std::exp(distance / n)) << " | "
          << text(std::exp(relative / n)) << " | " << text(worst) << " | "
          << (with_peer == 0 ? "-" : text(std::exp(against_peer / double(with_peer)))) << " | " << text(coverage)
          << " | " << (detail.empty() ? "-" : text(quantile(detail, 0.5))) << " | " << text(seconds / n) << " |\n";
    }
  }

  const Score_table& m_table;
  std::vector<std::string> m_methods, m_own, m_cases;
};

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MARKDOWN_REPORT_H
