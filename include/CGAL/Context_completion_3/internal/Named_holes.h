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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_NAMED_HOLES_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_NAMED_HOLES_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Box_set.h>
#include <CGAL/Context_completion_3/internal/Detected_hole.h>
#include <CGAL/Context_completion_3/internal/Island_search.h>
#include <CGAL/Context_completion_3/internal/Message.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Rim_surroundings.h>
#include <CGAL/Context_completion_3/internal/Second_base.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Holes that the caller knows of: boxes around them (the paper, section 5: the user defines invalid cells), or their rims,
  as the border cycles of a mesh.
*/
template <typename ConcurrencyTag>
class Named_holes
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Detected_hole<ConcurrencyTag> Hole;
  typedef Rim_surroundings<ConcurrencyTag> Surroundings;

public:
  /// \param loops what `Rim_detection` found; not copied
  Named_holes(const Model& model, const std::vector<Rim_loop>& loops) : m_model(model), m_loops(loops) {}

  /// What was found in a box is meant; otherwise what is open there.
  void add_box(std::size_t b, const Bbox_3& box, std::vector<Hole>& holes) const
  {
    bool is_found = false;
    std::set<std::size_t> closed;
    for(Hole& hole : holes)
    {
      if(hole.is_outer_border)
        continue;
      if(hole.patch)
        closed.insert(hole.patch->rim().begin(), hole.patch->rim().end());
      if(!hole.patch || !is_inside(hole.center(), box))
        continue;
      hole.is_named = true;
      is_found = true;
    }
    if(is_found)
      return;
    Hole hole;
    std::size_t number = 0;
    for(const Rim_loop& loop : m_loops)
    {
      Rim_loop part;
      for(const Rim_point& p : loop.points)
        if(is_inside(m_model.position(p.index), box) && closed.count(p.index) == 0)
          part.points.push_back(p);
      if(part.points.empty())
        continue;
      part.measure(m_model.points());
      number += part.points.size();
      hole.loops.push_back(part);
    }
    require(number >= 4, "Box ", b, " of the parameter user_holes holds ", number,
            " rim points; at least 4 are needed to fill what is open there.");
    std::stable_sort(hole.loops.begin(), hole.loops.end(), [](const Rim_loop& a, const Rim_loop& b)
      { return a.diameter > b.diameter; });
    const auto surroundings = std::make_shared<const Surroundings>(m_model, hole.loops);
    hole.patch = open_base(surroundings, box);
    require(hole.patch != nullptr, "Box ", b, " of the parameter user_holes holds nothing that is open.");
    hole.is_named = true;
    holes.push_back(hole);
  }

  /*!
    Adds the holes within some rims unless they were found. What was found there and follows other points for the most
    part, or less than half of the rim, gives way: outer borders, pieces, and bases over sharp edges beside the hole.
    \param rims points that follow each other around a hole
  */
  void add_rims(const std::vector<std::vector<std::size_t> >& rims, std::vector<Hole>& holes) const
  {
    std::set<std::size_t> known;
    for(const std::vector<std::size_t>& rim : rims)
      known.insert(rim.begin(), rim.end());
    for(const std::vector<std::size_t>& rim : rims)
    {
      const std::set<std::size_t> points(rim.begin(), rim.end());
      const auto holds = [&](const Hole& hole) { return 2 * number_of(hole, points) >= points.size(); };
      if(std::any_of(holes.begin(), holes.end(), [&](const Hole& hole) {
           return !hole.is_outer_border && holds(hole) && is_mostly_of(hole, known); }))
        continue;
      Hole hole;
      hole.loops.push_back(loop_of(rim));
      if(hole.loops.front().points.size() < 4)
        continue;
      hole.loops.front().measure(m_model.points());
      hole.patch = base_of_rim(hole.loops);
      if(!hole.patch)
        continue;
      hole.patch = with_islands(hole.patch);
      hole.loops = hole.patch->loops();
      hole.stiff = second_base(*hole.patch, 0.);
      const std::set<std::size_t> all_points(hole.patch->rim().begin(), hole.patch->rim().end());
      holes.erase(std::remove_if(holes.begin(), holes.end(), [&](const Hole& other) {
        return is_mostly_of(other, all_points) || (!other.is_outer_border && holds(other)); }), holes.end());
      holes.push_back(hole);
    }
  }

private:
  static std::size_t number_of(const Hole& hole, const std::set<std::size_t>& points)
  {
    std::size_t number = 0;
    for(const Rim_loop& loop : hole.loops)
      for(const Rim_point& p : loop.points)
        number += points.count(p.index);
    return number;
  }

  static bool is_mostly_of(const Hole& hole, const std::set<std::size_t>& points)
  {
    std::size_t size = 0;
    for(const Rim_loop& loop : hole.loops)
      size += loop.points.size();
    return 2 * number_of(hole, points) >= size;
  }

  // At each point the side of the rim at which the surface is not: all around the same one.
  Rim_loop loop_of(const std::vector<std::size_t>& rim) const
  {
    Rim_loop loop;
    double side = 0;
    std::vector<std::size_t> ball;
    for(std::size_t k = 0; k < rim.size(); ++k)
    {
      const std::size_t i = rim[k];
      const Vector x = m_model.position(i);
      const Vector along = m_model.position(rim[(k + 1) % rim.size()]) -
                           m_model.position(rim[(k + rim.size() - 1) % rim.size()]);
      Rim_point p;
      p.index = i;
      p.outward = along.cross(m_model.normal(i));
      if(!(p.outward.norm() > 0))
        continue;
      p.outward.normalize();
      m_model.search().in_ball(x, 2 * m_model.area_spacing(i), ball);
      for(std::size_t j : ball)
        if(is_same_side(m_model.normal(i), m_model.normal(j)))
          side += p.outward.dot(m_model.position(j) - x);
      loop.points.push_back(p);
    }
    if(side > 0)
      for(Rim_point& p : loop.points)
        p.outward = -p.outward;
    return loop;
  }

  // One that runs off is ended a spacing from the box around the rim.
  std::shared_ptr<const Patch> base_of_rim(const std::vector<Rim_loop>& loops) const
  {
    const auto surroundings = std::make_shared<const Surroundings>(m_model, loops);
    if(const auto patch = open_base(surroundings, std::nullopt))
      return patch;
    Bbox_3 box;
    for(const Rim_point& p : loops.front().points)
    {
      const Vector x = m_model.position(p.index);
      const double s = m_model.spacing(p.index);
      box += Bbox_3(x.x() - s, x.y() - s, x.z() - s, x.x() + s, x.y() + s, x.z() + s);
    }
    return open_base(surroundings, box);
  }

  // The smooth base that ends at the rim, or a stiff one; none if nothing is open there.
  static std::shared_ptr<const Patch> open_base(const std::shared_ptr<const Surroundings>& surroundings,
                                                const std::optional<Bbox_3>& domain)
  {
    for(bool is_stiff : { false, true })
    {
      const auto patch = std::make_shared<const Patch>(surroundings, is_stiff, domain);
      if(patch->is_closed() && patch->number_of_uncovered() > 0)
        return patch;
    }
    return nullptr;
  }

  const Model& m_model;
  const std::vector<Rim_loop>& m_loops;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_NAMED_HOLES_H
