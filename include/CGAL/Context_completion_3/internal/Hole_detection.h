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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_DETECTION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_DETECTION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_evidence.h>
#include <CGAL/Context_completion_3/internal/Detected_hole.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Island_search.h>
#include <CGAL/Context_completion_3/internal/Named_holes.h>
#include <CGAL/Context_completion_3/internal/Rim_grouping.h>
#include <CGAL/Context_completion_3/internal/Second_look.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Tube_bridge.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Joins loops to holes. A hole is a set of rims whose common smooth base ends at them everywhere and is not covered by
  points; a rim whose base runs away is an outer border of the surface, unless it ends at an acute edge or turns, whole or in
  part, as a hole does; a rim whose base is covered is no rim at all (sharp edges and a sampling that thins out raise many).
*/
template <typename ConcurrencyTag>
class Hole_detection
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Detected_hole<ConcurrencyTag> Hole;
  typedef Rim_grouping<ConcurrencyTag> Grouping;

public:
  /// \param user_holes boxes, in each of which there is a hole
  /// \param known_rims rims of holes, of points that follow each other
  explicit Hole_detection(const Model& model, const std::vector<Bbox_3>& user_holes = std::vector<Bbox_3>(),
                          const std::vector<std::vector<std::size_t> >& known_rims =
                            std::vector<std::vector<std::size_t> >())
    : m_model(model), m_user_holes(user_holes), m_known_rims(known_rims)
  {}

  /// \param progress called with the fraction done; `false` stops. \return whether it ran to its end
  bool run(std::vector<Hole>& holes, const std::function<bool(double)>& progress) const
  {
    const std::vector<Rim_loop> loops = Rim_detection<ConcurrencyTag>(m_model).loops();
    Grouping grouping(m_model, loops);
    const Second_look<ConcurrencyTag> second_look(m_model, loops, grouping);
    // Large rims first: islands and fragments are then taken in by the hole that they belong to.
    std::vector<std::size_t> order(loops.size());
    for(std::size_t l = 0; l < loops.size(); ++l)
      order[l] = l;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b)
      { return loops[a].diameter > loops[b].diameter; });
    // whole rims before pieces: a piece must not take in a rim that has its own hole
    std::vector<std::size_t> left;
    for(std::size_t k = 0; k < order.size(); ++k)
    {
      if(progress && !progress(double(k) / double(2 * order.size())))
        return false;
      std::vector<std::size_t> group;
      if(grouping.is_used(order[k]))
        continue;
      if(const auto patch = base_of_whole_rim(loops, grouping, order[k], group))
        add_hole(patch, holes, grouping, group);
      else
        left.push_back(order[k]);
    }
    // the border of a sheet or of an island, the end of a tube, or a piece of a rim
    for(std::size_t k = 0; k < left.size(); ++k)
    {
      if(progress && !progress(0.5 + double(k) / double(2 * left.size())))
        return false;
      std::vector<std::size_t> group;
      const Rim_loop& loop = loops[left[k]];
      if(grouping.is_used(left[k]) || loop.points.size() < fewest_rim_points())
        continue;
      if(const auto patch = base_of_broken_rim(loops, grouping, left[k], group))
        add_hole(patch, holes, grouping, group);
      else if(const auto up_to_edge = second_look.base_up_to_edge(left[k], group))
        add_hole(up_to_edge, holes, grouping, group);
      else if(const auto of_pieces = second_look.base_of_pieces(left[k], group))
        add_hole(of_pieces, holes, grouping, group);
      else if(loop.points.size() >= fewest_border_points())
      {
        Hole border;
        const std::size_t before = holes.size();
        border.loops.push_back(second_look.split_off_holes(loop, holes));
        for(std::size_t h = before; h < holes.size(); ++h)   // they may have islands
          grouping.use_points(holes[h].patch->rim());
        border.is_outer_border = true;
        if(border.loops[0].points.size() == loop.points.size())
          border.patch = cap(loops, grouping, left[k]);
        border.is_end = border.patch != nullptr;
        if(border.loops[0].points.size() >= fewest_border_points())
          holes.push_back(border);
      }
    }
    const Named_holes<ConcurrencyTag> named(m_model, loops);
    named.add_rims(m_known_rims, holes);
    for(std::size_t b = 0; b < m_user_holes.size(); ++b)
      named.add_box(b, m_user_holes[b], holes);
    return true;
  }

private:
  static void add_hole(const std::shared_ptr<const Patch>& patch, std::vector<Hole>& holes, Grouping& grouping,
                       const std::vector<std::size_t>& group)
  {
    grouping.use(group);
    if(!is_evident(*patch) || is_sparse(*patch))
      return;
    const auto whole = with_islands(patch);
    grouping.use_points(whole->rim());
    // the end of a thin limb is a small share, too, and no fragment
    holes.push_back(hole_of(whole, grouping.is_one_rim(group) ? largest_fragment() : largest_fragment() / 2));
  }

  static double least_opening() { return Grouping::least_opening(); }

  // Around a narrow slot there are few samples but those that points of the rim cover, each the one before it. A base
  // that is no evidence must not use up its rims.
  static bool is_mostly_covered(const Patch& patch)
  {
    const std::size_t uncovered = patch.number_of_uncovered(), covered = patch.samples().size() - uncovered;
    return covered > uncovered && (covered > patch.rim().size() || !is_evident(patch));
  }

  // shorter rims that bound nothing are irregularities of the sampling
  static std::size_t fewest_border_points() { return 12; }

  // The base over some loops and those that its sampling arrives at; none if it runs off.
  std::shared_ptr<const Patch> closed_base(const std::vector<Rim_loop>& loops, const Grouping& grouping,
                                           std::vector<std::size_t>& group, bool is_stiff = false) const
  {
    for(int round = 0; ; ++round)
    {
      std::vector<Rim_loop> members;
      for(std::size_t g : group)
        members.push_back(loops[g]);
      const auto surroundings = std::make_shared<const Rim_surroundings<ConcurrencyTag> >(m_model, members);
      const std::shared_ptr<const Patch> patch = std::make_shared<const Patch>(surroundings, is_stiff);
      if(!patch->is_closed())
        return nullptr;
      if(round == 2 || !grouping.take_in_reached(patch->reached(), group))
        return patch;
    }
  }

  // Over both rims of a tube: the smooth base if it joins them and, where it closes each alone, runs off or bulges, one
  // that is led from the one to the other.
  std::shared_ptr<const Patch> base_of_tube(const std::vector<Rim_loop>& loops, const Grouping& grouping,
                                            const std::vector<std::size_t>& rim, const std::vector<std::size_t>& other,
                                            std::vector<std::size_t>& group) const
  {
    std::vector<std::size_t> both = rim;
    both.insert(both.end(), other.begin(), other.end());
    group = both;
    const auto patch = closed_base(loops, grouping, group);
    const std::vector<Rim_loop> rims = { grouping.joined(rim), grouping.joined(other) };
    const auto led = std::make_shared<const Patch>(
      std::make_shared<const Rim_surroundings<ConcurrencyTag> >(m_model, rims), false, std::nullopt,
      Tube_bridge<ConcurrencyTag>(m_model, rims[0], rims[1]).rings());
    if(!led->is_closed() || !led->joins_rims() || !is_evident(*led) ||
       (patch && patch->joins_rims() && !is_bulge(*patch, *led)))
      return patch;
    group = both;
    return led;
  }

  // A rim, alone or with the other end of a cut tube.
  std::shared_ptr<const Patch> base_of_whole_rim(const std::vector<Rim_loop>& loops, const Grouping& grouping,
                                                 std::size_t l, std::vector<std::size_t>& group) const
  {
    const std::vector<std::size_t> pieces = grouping.pieces_of_rim(l);
    std::vector<std::vector<std::size_t> > rims(1, std::vector<std::size_t>(1, l));
    if(pieces.size() > 1)
      rims.push_back(pieces);
    for(const std::vector<std::size_t>& rim : rims)
      for(const std::vector<std::size_t>& other : grouping.facing_rims(rim))
        if(const auto patch = base_of_tube(loops, grouping, rim, other, group))
          return patch;
    group.assign(1, l);
    const double opening = loops[l].opening(m_model.points(), loops[l].center);
    // turned away altogether: the border of a sheet or of an island
    if(opening < -least_opening())
      return nullptr;
    const auto patch = closed_base(loops, grouping, group);
    // neither this nor that: the end of a tube, or the rim of a hole around sharp edges
    if(patch && opening < least_opening() &&
       (!is_faced(*patch, least_opening()) || is_mostly_covered(*patch)))
      return nullptr;
    return patch;
  }

  // A rim that sharp edges cut into pieces: each piece alone lets the base run off, or opens to nowhere. Either the
  // pieces follow each other, or loops that open towards a common place are added, the nearest first, until the base is
  // closed. Relief or edges at a whole rim can lead the base away, too, which a stiff one resists.
  std::shared_ptr<const Patch> base_of_broken_rim(const std::vector<Rim_loop>& loops, const Grouping& grouping,
                                                  std::size_t l, std::vector<std::size_t>& group) const
  {
    for(bool is_stiff : { false, true })
    {
      group = grouping.pieces_of_rim(l);
      if(group.size() < 2 || !grouping.surrounds_hole(group))
        break;
      const auto patch = closed_base(loops, grouping, group, is_stiff);
      if(patch && patch->joined_share() >= 1 - largest_fragment() && is_evident(*patch))
        return patch;
    }
    group.assign(1, l);
    for(std::size_t n = 0; n < most_fragments(); ++n)
    {
      const std::size_t next = grouping.nearest_fragment(group);
      if(next == no_index)
        break;
      group.push_back(next);
      std::vector<std::size_t> joined = group;
      const auto patch = closed_base(loops, grouping, joined, true);
      if(patch && is_evident(*patch) && is_faced(*patch, least_opening()))
      {
        group = joined;
        return patch;
      }
    }
    group.assign(1, l);
    if(loops[l].opening(m_model.points(), loops[l].center) < least_opening())
      return nullptr;
    const auto patch = closed_base(loops, grouping, group, true);
    return patch && is_faced(*patch, least_opening()) ? patch : nullptr;
  }

  static std::size_t most_fragments() { return 4; }

  // A base over the end of a tube, whose rim opens neither to its centre nor away from it; otherwise none.
  std::shared_ptr<const Patch> cap(const std::vector<Rim_loop>& loops, const Grouping& grouping, std::size_t l) const
  {
    if(loops[l].opening(m_model.points(), loops[l].center) < -least_opening())
      return nullptr;
    for(bool is_stiff : { false, true })
    {
      std::vector<std::size_t> group(1, l);
      const auto patch = closed_base(loops, grouping, group, is_stiff);
      if(patch && is_evident(*patch) && !is_sparse(*patch) &&
         2 * patch->number_of_uncovered() >= patch->samples().size())
        return patch;
    }
    return nullptr;
  }

  const Model& m_model;
  std::vector<Bbox_3> m_user_holes;
  std::vector<std::vector<std::size_t> > m_known_rims;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_DETECTION_H
