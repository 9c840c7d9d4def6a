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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PAPER_POLICY_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PAPER_POLICY_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Box_set.h>
#include <CGAL/Context_completion_3/internal/Cancellation.h>
#include <CGAL/Context_completion_3/internal/Cell_candidates.h>
#include <CGAL/Context_completion_3/internal/Cell_classification.h>
#include <CGAL/Context_completion_3/internal/Cell_filling.h>
#include <CGAL/Context_completion_3/internal/Cell_signature.h>
#include <CGAL/Context_completion_3/internal/Cell_surface.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Hole_cells.h>
#include <CGAL/Context_completion_3/internal/Hole_joining.h>
#include <CGAL/Context_completion_3/internal/Message.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The paper's own choice at every stage, as a policy of `Completion_loop`.

  Levels run from 1 (the root has nothing to be copied from) to the finest. The paper does not say how fine that is.
  Unless a depth was asked for, it is the last level whose cells are at least four spacings wide and on which at least
  half of the cells that hold points hold m; on a finer one most of the surface would be a hole by the size of the
  cells alone. That, and the number of candidates that are compared for one cell, bound the time: at most some
  2 n / m cells on the finest level, and about a quarter of that on each coarser one.

  Where the paper leaves a choice:
  - acceptance: "only if the adjacent valid cells have no descendants"; without a valid adjacent cell the points are
    kept as intermediate, except on the finest level, where everything is accepted;
  - an accepted cell "is changed to valid", so its subtree is not looked into any more;
  - intermediate points leave nothing but the fit to them and the points that the cell had;
  - "fine enough around the hole" (figure 4, line 13): no finest cell of a hole is invalid any more.
*/
class Paper_policy
{
public:
  struct Target
  {
    Cell cell;
    std::size_t hole = 0;
    std::size_t index = 0;   ///< among the targets of its level
  };
  typedef Cell_match Match;
  typedef Cell_patch Patch;

  /// Cells compared with one target in full; more are left out by their bound.
  static constexpr std::size_t maximum_evaluations = 1000;

  /// Builds the trees and fits and detects the holes. \param spacing median distance of nearest neighbours
  /// \param poll called between the stages
  Paper_policy(const Surface_points& points, const Engine_parameters& parameters, double spacing,
               const Poll& poll = Poll([]() {}))
    : m_parameters(parameters), m_spacing(spacing),
      m_candidates(parameters.cube_symmetries ? full_symmetry_group(parameters.mirror)
                                              : paper_symmetry_group(parameters.mirror), maximum_evaluations)
  {
    const Cell_cube cube = offset_cube(points.position);
    const double tolerance = parameters.tolerance > 0 ? parameters.tolerance : 0.5 * spacing;
    const std::size_t finest = choose_finest_level(points.position, cube);
    m_surface = std::make_shared<Cell_surface>(points, cube, finest, parameters.minimum_cell_points, tolerance,
                                               parameters.support_balls);
    poll();
    m_classification = std::make_unique<Cell_classification>(*m_surface, Box_quadric_test(parameters.box_subdivision));
    add_sources(points, rotations_about_axes(parameters.rotation_angles), tolerance, poll);
    poll();
    detect();
  }

  /// \name Holes
  /// @{
  const std::vector<Hole_data>& holes() const { return m_holes; }
  const std::vector<Hole_outcome>& outcomes() const { return m_outcomes; }
  const std::vector<Added_point>& added() const { return m_added; }
  const Cell_surface& surface() const { return *m_surface; }
  std::size_t finest_level() const { return m_surface->tree().maximum_depth(); }

  /// To be called before the loop runs; the loop may run again for others.
  void choose(const std::vector<std::size_t>& chosen)
  {
    m_hole_cells.choose(m_groups, chosen);
    m_unfilled.clear();
    for(std::size_t hole : chosen)
      m_outcomes[hole].reason = "no cell of its size holds enough points to be copied";
  }
  /// @}

  /// \name Concept of `Completion_loop`
  /// @{
  std::size_t first_level() const { return 1; }

  bool is_last_level(std::size_t level) const
  {
    if(level >= finest_level())
      return true;
    for(const Cell& cell : m_hole_cells.finest())
      if(!is_accepted(cell) && m_classification->status(cell) == Cell_status::invalid)
        return false;
    return true;
  }

  void begin_level(std::size_t level)
  {
    m_candidates.begin_level(level);
    m_weights = Signature_weights::of_level(double(level), double(finest_level()));
  }

  std::vector<Target> find_invalid(std::size_t level)
  {
    std::vector<Target> targets;
    if(level > finest_level())
      return targets;
    std::vector<Cell> left;
    for(const Cell& cell : m_classification->invalid_cells(level, m_unfilled))
    {
      Target target;
      target.cell = cell;
      target.hole = m_hole_cells.hole(cell);
      target.index = targets.size();
      if(target.hole == no_index || is_accepted(cell))
        continue;
      targets.push_back(target);
      left.push_back(cell);
    }
    m_unfilled.swap(left);
    m_index.clear();
    m_valid_neighbors.clear();
    for(const Target& target : targets)
    {
      m_index[target.cell] = target.index;
      m_valid_neighbors.push_back(m_classification->number_of_valid_neighbors(target.cell));
    }
    return targets;
  }

  std::size_t number_of_valid_neighbors(const Target& target) const
  {
    return m_valid_neighbors[target.index];
  }

  bool is_still_invalid(const Target& target) const
  {
    return m_classification->status(target.cell) == Cell_status::invalid;
  }

  Match find_best_match(const Target& target, const Poll&) const
  {
    return m_candidates.find_best(cell_signature(*m_surface, target.cell), m_weights);
  }

  bool is_found(const Match& match) const { return match.is_found(); }

  Patch transfer(const Target& target, const Match& match) const
  {
    return Cell_filling(*m_surface).fill(target.cell, m_candidates, match);
  }

  void insert(const Target& target, const Match& match, const Patch& patch)
  {
    if(patch.points.size() == 0) // nothing of the match ended up near the cell
      return;
    m_hole_cells.set_filled(target.cell, target.hole);
    if(is_fine_enough(target.cell))
      accept(target, match, patch);
    else
    {
      Surface_points points = patch.points;
      for(std::size_t i : m_surface->points(target.cell))
        points.push_back(m_surface->surface().position[i], m_surface->surface().normal[i]);
      m_surface->assign(target.cell, m_surface->fit_to(target.cell, points));
    }
  }

  void end_level(std::size_t) {} // the fits were updated with each insertion, signatures are made with the next level

  double progress(std::size_t level, double fraction_of_level) const
  {
    return (std::min)(1., (double(level) - 1 + fraction_of_level) / double((std::max)(finest_level(), std::size_t(1))));
  }
  /// @}

private:
  std::size_t choose_finest_level(const std::vector<Vector>& positions, const Cell_cube& cube) const
  {
    const bool is_given = m_parameters.maximum_depth > 0;
    const double smallest = (is_given ? 1 : 4) * m_spacing;
    std::size_t level = 0;
    while(level < Cell::maximum_level && smallest > 0 && std::ldexp(cube.side, -int(level) - 1) >= smallest)
      ++level;
    if(is_given)
      return (std::min)(level, m_parameters.maximum_depth);
    const Cell_tree grid(positions, cube, level, [](const Cell&, const Cell_tree::Point_range&) { return false; });
    for(level = grid.maximum_depth(); level > 1; --level)
    {
      const std::vector<Cell> occupied = grid.occupied_cells(level);
      std::size_t valid = 0;
      for(const Cell& cell : occupied)
        valid += grid.number_of_points(cell) >= m_parameters.minimum_cell_points ? 1 : 0;
      if(2 * valid >= occupied.size())
        break;
    }
    return level;
  }

  // Candidates come from the set itself, from rotated copies, and from example sets with theirs.
  void add_sources(const Surface_points& points, const std::vector<Matrix>& rotations, double tolerance,
                   const Poll& poll)
  {
    Candidate_source own;
    own.surface = m_surface;
    own.is_example = m_parameters.is_example;
    m_candidates.add_source(own);
    for(std::size_t set = 0; set <= m_parameters.examples.size(); ++set)
    {
      const Surface_points& original = set == 0 ? points : m_parameters.examples[set - 1];
      if(set > 0)
        add_source(original, Matrix::Identity(), set, tolerance);
      for(const Matrix& rotation : rotations)
      {
        poll();
        add_source(original, rotation, set, tolerance);
      }
    }
  }

  void add_source(const Surface_points& original, const Matrix& rotation, std::size_t set, double tolerance)
  {
    Surface_points rotated;
    for(std::size_t i = 0; i < original.size(); ++i)
      rotated.push_back(rotation * original.position[i], rotation * original.normal[i]);
    Candidate_source source;
    const Cell_cube cube = commensurable_cube(rotated.position, m_surface->grid().cube().side, source.level_shift);
    const std::size_t finest = (std::min)(finest_level() + source.level_shift, std::size_t(Cell::maximum_level));
    source.surface = std::make_shared<Cell_surface>(rotated, cube, finest, m_parameters.minimum_cell_points, tolerance,
                                                    m_parameters.support_balls);
    source.source_set = set;
    if(set == 0)
      source.is_example = m_parameters.is_example;
    m_candidates.add_source(source);
  }

  // Invalid cells of the finest level, found level by level: below an unfilled cell the coarser approximation holds.
  void detect()
  {
    std::vector<Cell> invalid;
    for(std::size_t level = 1; level <= finest_level(); ++level)
      invalid = m_classification->invalid_cells(level, invalid);
    // what the user names is one hole; the rest is joined
    for(std::size_t b = 0; b < m_parameters.user_holes.size(); ++b)
    {
      const auto first = std::stable_partition(invalid.begin(), invalid.end(), [&](const Cell& cell)
        { return !is_inside(m_surface->grid().center(cell), m_parameters.user_holes[b]); });
      if(first == invalid.end() && is_named(m_parameters.user_holes[b]))
        continue;
      require(first != invalid.end(), "Box ", b, " of the parameter user_holes holds no under-sampled cell.");
      m_groups.emplace_back(first, invalid.end());
      invalid.erase(first, invalid.end());
    }
    const std::size_t number_of_named = m_groups.size();
    const std::vector<std::vector<Cell> > others = joined_cells(invalid);
    m_groups.insert(m_groups.end(), others.begin(), others.end());
    for(std::size_t g = 0; g < m_groups.size(); ++g)
      m_holes.push_back(describe_hole(*m_surface, m_groups[g], m_spacing, m_parameters, g < number_of_named));
    m_outcomes.resize(m_holes.size());
    for(Hole_outcome& outcome : m_outcomes)
      outcome.reason = "not chosen";
  }

  // whether an earlier box of the user has taken cells that this one asks for
  bool is_named(const Bbox_3& box) const
  {
    for(const std::vector<Cell>& group : m_groups)
      for(const Cell& cell : group)
        if(is_inside(m_surface->grid().center(cell), box))
          return true;
    return false;
  }

  bool is_fine_enough(const Cell& cell) const
  {
    if(cell.level == finest_level())
      return true;
    bool has_valid_neighbor = false;
    for(std::size_t i = 0; i < 27; ++i)
    {
      if(i == own_offset || !cell.has_neighbor(cell_offset(i)) || !m_surface->is_valid(cell.neighbor(cell_offset(i))))
        continue;
      has_valid_neighbor = true;
      if(m_surface->tree().subtree_depth(cell.neighbor(cell_offset(i))) > 0)
        return false;
    }
    return has_valid_neighbor;
  }

  bool is_accepted(const Cell& cell) const
  {
    for(std::size_t level = 1; level <= cell.level; ++level)
      if(m_accepted.count(cell.ancestor(level)) != 0)
        return true;
    return false;
  }

  void accept(const Target& target, const Match& match, const Patch& patch)
  {
    m_accepted.insert(target.cell);
    const Candidate_source& source = m_candidates.source(match.source);
    std::set<Cell> changed;
    for(std::size_t i = 0; i < patch.points.size(); ++i)
    {
      if(!patch.points.position[i].allFinite() || !patch.points.normal[i].allFinite())
        continue;
      Added_point point;
      point.position = patch.points.position[i];
      point.normal = patch.points.normal[i].normalized();
      point.source = patch.sources[i];
      point.source_set = source.source_set;
      point.hole = target.hole;
      point.confidence = 1 / (1 + match.distance);
      m_added.push_back(point);
      m_surface->add_point(point.position, point.normal);
      const Cell finest = m_surface->grid().finest_cell(point.position);
      // the cell, its parent, and everything below that the new points reach
      for(std::size_t level = target.cell.level - 1; level <= finest_level(); ++level)
        changed.insert(finest.ancestor(level));
    }
    for(const Cell& cell : changed)
    {
      if(!m_surface->is_valid(cell))
        continue;
      m_surface->fit(cell);
      if(cell.level == target.cell.level)
        recount_around(cell);
    }
    report(target, match, patch);
  }

  // the loop asks for the numbers of all targets after each insertion; they change near the insertion only
  void recount_around(const Cell& cell)
  {
    for(std::size_t i = 0; i < 27; ++i)
    {
      if(!cell.has_neighbor(cell_offset(i)))
        continue;
      const auto found = m_index.find(cell.neighbor(cell_offset(i)));
      if(found != m_index.end())
        m_valid_neighbors[found->second] = m_classification->number_of_valid_neighbors(found->first);
    }
  }

  void report(const Target& target, const Match& match, const Patch& patch)
  {
    Hole_outcome& outcome = m_outcomes[target.hole];
    const double before = double(outcome.added), now = double(patch.points.size()), all = (std::max)(before + now, 1.);
    outcome.filling = Filling::copied;
    outcome.reason = "copied cell by cell, as the paper does";
    outcome.expected_error = (outcome.expected_error * before + patch.residual * now) / all;
    outcome.match = (outcome.match * before + match.distance * now) / all;
    outcome.level = (std::max)(outcome.level, target.cell.level);
    outcome.added += patch.points.size();
  }

  Engine_parameters m_parameters;
  double m_spacing;
  std::shared_ptr<Cell_surface> m_surface;
  std::unique_ptr<Cell_classification> m_classification;
  Cell_candidates m_candidates;
  Signature_weights m_weights;
  std::vector<std::vector<Cell> > m_groups;   // finest cells of each hole
  std::vector<Hole_data> m_holes;
  std::vector<Hole_outcome> m_outcomes;
  std::vector<Added_point> m_added;
  Hole_cells m_hole_cells;
  std::vector<Cell> m_unfilled;               // the invalid cells of the last level
  std::map<Cell, std::size_t> m_index;        // of the targets of this level
  std::vector<std::size_t> m_valid_neighbors; // by that index
  std::set<Cell> m_accepted;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PAPER_POLICY_H
