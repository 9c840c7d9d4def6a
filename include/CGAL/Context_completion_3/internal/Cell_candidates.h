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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_CANDIDATES_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_CANDIDATES_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell_signature.h>
#include <CGAL/Context_completion_3/internal/Cell_surface.h>
#include <CGAL/Context_completion_3/internal/Cell_symmetry.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Turns of the point set before it is cut into cells, for further candidates (section 6.3): about X, Y and Z by each
/// angle.
inline std::vector<Matrix> rotations_about_axes(const std::vector<double>& angles)
{
  std::vector<Matrix> rotations;
  for(double angle : angles)
    for(int axis = 0; axis < 3; ++axis)
      rotations.push_back(Eigen::AngleAxisd(angle, Vector(Vector::Unit(axis))).toRotationMatrix());
  return rotations;
}

/// Points that may be copied, cut into cells of the same sizes as those of the set that is completed.
struct Candidate_source
{
  std::shared_ptr<const Cell_surface> surface;
  std::size_t source_set = 0;          ///< 0: the completed set, i: the i-th further example set
  std::size_t level_shift = 0;         ///< its cells of level l + shift are as large as the target's of level l
  std::vector<char> is_example;        ///< per point; empty: all
};

/// The best matching cell of figure 4, line 7.
struct Cell_match
{
  std::size_t source = 0;              ///< index of the `Candidate_source`
  Cell cell;
  std::size_t symmetry = 0;            ///< index of the element of the group that is applied to its content
  double distance = (std::numeric_limits<double>::infinity)();  ///< eq. 1

  bool is_found() const { return distance < (std::numeric_limits<double>::infinity)(); }
};

/*!
  The candidate set of one level (section 6.3): all cells of the right size with at least m points, in every source,
  under every element of the symmetry group.

  `find_best()` is an exhaustive search that leaves out only what cannot win: mean and spread of the distances, and
  length of the mean direction, do not change under the symmetry group and bound eq. 1 from below. Candidates are
  looked at by increasing bound until the bound exceeds the best distance, or until `maximum_evaluations` cells were
  compared, which bounds the time on large inputs.
*/
class Cell_candidates
{
public:
  Cell_candidates(const std::vector<Cell_symmetry>& group, std::size_t maximum_evaluations = 0)
    : m_group(group), m_maximum_evaluations(maximum_evaluations)
  {
    for(const Cell_symmetry& symmetry : group)
      m_inverses.push_back(symmetry.inverse());
  }

  void add_source(const Candidate_source& source) { m_sources.push_back(source); }
  const Candidate_source& source(std::size_t i) const { return m_sources[i]; }
  const Cell_symmetry& symmetry(std::size_t i) const { return m_group[i]; }

  /// Collects the candidates of a level and computes their signatures (figure 4, line 3).
  void begin_level(std::size_t level)
  {
    m_candidates.clear();
    for(std::size_t s = 0; s < m_sources.size(); ++s)
    {
      const Cell_surface& surface = *m_sources[s].surface;
      const std::size_t own_level = level + m_sources[s].level_shift;
      if(own_level > surface.tree().maximum_depth())
        continue;
      for(const Cell& cell : surface.tree().occupied_cells(own_level))
        if(number_of_examples(m_sources[s], cell) >= surface.minimum_points())
          m_candidates.emplace_back(s, cell);
    }
    m_signatures.resize(m_candidates.size());
    m_invariants.resize(m_candidates.size());
    for(std::size_t i = 0; i < m_candidates.size(); ++i)
    {
      const Cell_surface& surface = *m_sources[m_candidates[i].first].surface;
      const Cell_signature signature = cell_signature(surface, m_candidates[i].second);
      m_signatures[i] = signature.vector;
      m_invariants[i] = Invariants(signature);
    }
  }

  std::size_t number_of_candidates() const { return m_candidates.size(); }
  const Cell& candidate(std::size_t i) const { return m_candidates[i].second; }
  std::size_t source_of_candidate(std::size_t i) const { return m_candidates[i].first; }

  /// The nearest candidate by eq. 1; among equals the one of smaller index, then of smaller symmetry.
  Cell_match find_best(const Cell_signature& target, const Signature_weights& weights) const
  {
    // comparing the target, moved back, with a candidate is comparing the target with the candidate, moved
    std::vector<Cell_signature::Components> targets;
    for(const Cell_symmetry& inverse : m_inverses)
      targets.push_back(target.transformed(inverse).vector);
    const Invariants invariants(target);
    std::vector<std::pair<float, std::size_t> > order(m_candidates.size());
    for(std::size_t i = 0; i < order.size(); ++i)
      order[i] = std::make_pair(float(invariants.lower_bound(m_invariants[i], weights)), i);
    if(m_maximum_evaluations > 0 && order.size() > m_maximum_evaluations)
    {
      std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(m_maximum_evaluations), order.end());
      order.resize(m_maximum_evaluations);
    }
    std::sort(order.begin(), order.end());

    Cell_match best;
    std::size_t best_index = m_candidates.size();
    for(const std::pair<float, std::size_t>& next : order)
    {
      if(double(next.first) > best.distance)
        break;
      for(std::size_t g = 0; g < targets.size(); ++g)
      {
        const double d = signature_distance(targets[g], m_signatures[next.second], weights);
        if(!(d < best.distance || (d == best.distance && next.second < best_index)))
          continue;
        best.distance = d;
        best.source = m_candidates[next.second].first;
        best.cell = m_candidates[next.second].second;
        best.symmetry = g;
        best_index = next.second;
      }
    }
    return best;
  }

  /// Points of a matching cell that may be copied.
  std::vector<std::size_t> example_points(const Cell_match& match) const
  {
    const Candidate_source& source = m_sources[match.source];
    const Cell_tree::Point_range range = source.surface->tree().points(match.cell);
    std::vector<std::size_t> result;
    for(auto it = range.first; it != range.second; ++it)
      if(source.is_example.empty() || source.is_example[*it])
        result.push_back(*it);
    return result;
  }

private:
  // original points alone: "points p_i in cell and P" (figure 4, line 8)
  static std::size_t number_of_examples(const Candidate_source& source, const Cell& cell)
  {
    const Cell_tree::Point_range range = source.surface->tree().points(cell);
    if(source.is_example.empty())
      return std::size_t(range.second - range.first);
    return std::size_t(std::count_if(range.first, range.second,
                                     [&](std::size_t i) { return source.is_example[i] != 0; }));
  }

  // What the symmetry group leaves alone: mean and spread of the distances, length of the mean direction and the
  // spread around it; inside the cell, then around it.
  class Invariants
  {
  public:
    Invariants() {}
    explicit Invariants(const Cell_signature& signature)
    {
      read(signature, Cell_signature::inner_distance, Cell_signature::inner_direction, m_values.data());
      read(signature, Cell_signature::outer_distance, Cell_signature::outer_direction, m_values.data() + 4);
    }

    double lower_bound(const Invariants& other, const Signature_weights& weights) const
    {
      double parts[4];
      for(std::size_t i = 0; i < 4; ++i)
      {
        const double mean = double(m_values[2 * i] - other.m_values[2 * i]),
                     spread = double(m_values[2 * i + 1] - other.m_values[2 * i + 1]);
        parts[i] = std::sqrt(27 * mean * mean + spread * spread);
      }
      const double bound = weights.inner * (weights.distance * parts[0] + (1 - weights.distance) * parts[1])
                  + (1 - weights.inner) * (weights.distance * parts[2] + (1 - weights.distance) * parts[3]);
      return (std::max)(0., bound * (1 - 1e-5) - 1e-4); // single precision must not turn it into a wrong bound
    }

  private:
    static void read(const Cell_signature& signature, int distances, int directions, float* values)
    {
      const float* s = signature.vector.data();
      float mean = 0, means[3] = {0, 0, 0}, spread = 0, spreads = 0;
      for(int i = 0; i < 27; ++i)
        mean += s[distances + i] / 27.f;
      for(int i = 0; i < 81; ++i)
        means[i % 3] += s[directions + i] / 27.f;
      for(int i = 0; i < 27; ++i)
        spread += (s[distances + i] - mean) * (s[distances + i] - mean);
      for(int i = 0; i < 81; ++i)
        spreads += (s[directions + i] - means[i % 3]) * (s[directions + i] - means[i % 3]);
      values[0] = mean;
      values[1] = std::sqrt(spread);
      values[2] = std::sqrt(means[0] * means[0] + means[1] * means[1] + means[2] * means[2]);
      values[3] = std::sqrt(spreads);
    }

    std::array<float, 8> m_values = {};
  };

  std::vector<Cell_symmetry> m_group, m_inverses;
  std::size_t m_maximum_evaluations;
  std::vector<Candidate_source> m_sources;
  std::vector<std::pair<std::size_t, Cell> > m_candidates;
  std::vector<Cell_signature::Components> m_signatures;
  std::vector<Invariants> m_invariants;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_CANDIDATES_H
