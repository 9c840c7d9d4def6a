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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SECOND_LOOK_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SECOND_LOOK_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_edge.h>
#include <CGAL/Context_completion_3/internal/Base_evidence.h>
#include <CGAL/Context_completion_3/internal/Detected_hole.h>
#include <CGAL/Context_completion_3/internal/Island_search.h>
#include <CGAL/Context_completion_3/internal/Rim_cycles.h>
#include <CGAL/Context_completion_3/internal/Rim_grouping.h>
#include <CGAL/Context_completion_3/internal/Rim_surroundings.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Looks again at loops that would be outer borders: at rims that end at an acute edge, at pieces around a bent slot, and at
  rims that turn as that of a hole does, whole or tied to a border.
*/
template <typename ConcurrencyTag>
class Second_look
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Rim_grouping<ConcurrencyTag> Grouping;

public:
  /// \param loops not copied
  /// \param grouping of these loops, not copied: what it has in use is left out
  Second_look(const Model& model, const std::vector<Rim_loop>& loops, const Grouping& grouping)
    : m_model(model), m_loops(loops), m_grouping(grouping)
  {}

  /*!
    A rim in one side of the surface that is open towards an acute edge, where the other side ends with a rim that looks
    away. Both together are whole.
    \param group becomes the loops that the base uses
    \return none if there is no such base
  */
  std::shared_ptr<const Patch> base_up_to_edge(std::size_t l, std::vector<std::size_t>& group) const
  {
    const Rim_loop& loop = m_loops[l];
    if(loop.opening(m_model.points(), loop.center) < 2 * least_opening())
      return nullptr;
    Vector mean = Vector::Zero();
    for(const Rim_point& p : loop.points)
      mean += m_model.normal(p.index);
    std::vector<Rim_point> edge;
    for(std::size_t m = 0; m < m_loops.size(); ++m)
      if(m != l && !m_grouping.is_used(m))
        std::copy_if(m_loops[m].points.begin(), m_loops[m].points.end(), std::back_inserter(edge), [&](const Rim_point& p)
        {
          return !is_same_side(m_model.normal(p.index), mean.normalized()) &&
                 (m_model.position(p.index) - loop.center).norm() < loop.diameter;
        });
    if(edge.size() < 3)
      return nullptr;
    const auto surroundings =
      std::make_shared<const Rim_surroundings<ConcurrencyTag> >(m_model, std::vector<Rim_loop>(1, loop), edge);
    const std::vector<Base_center> guides = Base_edge<ConcurrencyTag>(*surroundings).guides();
    for(bool is_stiff : { false, true })
    {
      const auto patch = base(surroundings, is_stiff, guides);
      if(!is_beyond_doubt(*patch) || !is_faced(*patch, 3 * least_opening()) ||
         !goes_around_once(*surroundings, patch->reached_edge().size()))
        continue;
      group.assign(1, l);
      for(std::size_t m = 0; m < m_loops.size(); ++m)
        if(m != l && 2 * common_points(m_loops[m], patch->reached_edge()) > m_loops[m].points.size())
          group.push_back(m);
      return patch;
    }
    return nullptr;
  }

  /// Pieces that follow each other around a bent slot, which need not open towards their centre. They are tried once, with
  /// the largest.
  std::shared_ptr<const Patch> base_of_pieces(std::size_t l, std::vector<std::size_t>& group) const
  {
    group = m_grouping.pieces_of_rim(l);
    std::vector<Rim_loop> pieces;
    for(std::size_t g : group)
    {
      if(m_loops[g].diameter > m_loops[l].diameter)
        return nullptr;
      pieces.push_back(m_loops[g]);
    }
    if(pieces.size() < 2)
      return nullptr;
    const auto surroundings = std::make_shared<const Rim_surroundings<ConcurrencyTag> >(m_model, pieces);
    if(!goes_around_once(*surroundings, 0))
      return nullptr;
    for(bool is_stiff : { false, true })
    {
      const auto patch = base(surroundings, is_stiff);
      if(!is_beyond_doubt(*patch) || !is_faced(*patch, least_opening()) || patch->joined_share() < 1 - largest_fragment())
        continue;
      m_grouping.take_in_reached(patch->reached(), group);
      return patch;
    }
    return nullptr;
  }

  /// The centre of a rim says little where the hole bends, or where the rim is tied to a border, by a narrow strip of the
  /// surface or along an acute edge: then its turns tell that it bounds a hole. Adds the holes, and returns the rest of the
  /// loop.
  Rim_loop split_off_holes(const Rim_loop& loop, std::vector<Detected_hole<ConcurrencyTag> >& holes) const
  {
    Rim_loop rest = loop;
    for(const Rim_cycle& cycle : Rim_cycles<ConcurrencyTag>(m_model, loop).cycles())
    {
      if(!cycle.bounds_hole() || cycle.rim.points.size() < fewest_rim_points())
        continue;
      const auto surroundings =
        std::make_shared<const Rim_surroundings<ConcurrencyTag> >(m_model, std::vector<Rim_loop>(1, cycle.rim));
      for(bool is_stiff : { false, true })
      {
        const auto patch = base(surroundings, is_stiff);
        if(!is_beyond_doubt(*patch))
          continue;
        holes.push_back(hole_of(with_islands(patch), largest_fragment()));
        rest = without(rest, cycle.rim);
        break;
      }
    }
    return rest;
  }

private:
  static double least_opening() { return Grouping::least_opening(); }

  // A base over a covered place is found out before it is sampled as a whole, which may be the outside of a large border.
  // The middle of a narrow slot is told to be uncovered only when it is: so the bound is wider than the one below.
  static std::shared_ptr<const Patch> base(const std::shared_ptr<const Rim_surroundings<ConcurrencyTag> >& surroundings,
                                           bool is_stiff,
                                           const std::vector<Base_center>& guides = std::vector<Base_center>())
  {
    return std::make_shared<const Patch>(surroundings, is_stiff, std::nullopt, guides, 2.);
  }

  // What a second look finds has to be beyond doubt: loops can be taken apart and led on in many ways, and in irregular
  // samplings some of these close by chance, over places that are covered for the most part. In a narrow slot, too, all
  // but the middle is near to the rim; but no more than one sample stands before each of its points.
  static bool is_beyond_doubt(const Patch& patch)
  {
    return patch.is_closed() && is_evident(patch) && !is_sparse(patch) &&
           double(patch.samples().size() - patch.number_of_uncovered()) <= 1.3 * double(patch.rim().size());
  }

  static std::size_t common_points(const Rim_loop& loop, const std::vector<std::size_t>& points)
  {
    return std::size_t(std::count_if(loop.points.begin(), loop.points.end(), [&](const Rim_point& p)
      { return std::binary_search(points.begin(), points.end(), p.index); }));
  }

  Rim_loop without(const Rim_loop& loop, const Rim_loop& part) const
  {
    Rim_loop rest;
    std::set_difference(loop.points.begin(), loop.points.end(), part.points.begin(), part.points.end(),
                        std::back_inserter(rest.points),
                        [](const Rim_point& a, const Rim_point& b) { return a.index < b.index; });
    if(!rest.points.empty())
      rest.measure(m_model.points());
    return rest;
  }

  const Model& m_model;
  const std::vector<Rim_loop>& m_loops;
  const Grouping& m_grouping;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SECOND_LOOK_H
