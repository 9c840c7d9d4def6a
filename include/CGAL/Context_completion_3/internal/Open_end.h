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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_OPEN_END_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_OPEN_END_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The end of a tube is a border of the surface, or a hole: a limb that was cut off leaves the same rim as the neck of a
  bust. It is a hole where the surroundings match those of a place, beyond doubt, whose surface goes on and closes: the
  other leg, the other blade. This tells which places do.
*/
template <typename ConcurrencyTag>
class Open_end
{
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Example_source<ConcurrencyTag> Source;

public:
  /// \param patch the base that closes the end
  Open_end(const Model& known, const Patch& patch, const Relief_sampler<ConcurrencyTag>& sampler,
           const std::vector<Source>& sources)
    : m_known(known), m_patch(patch), m_sampler(sampler), m_sources(sources)
  {}

  /*!
    Whether the surface of a place closes the end. The integral of the normals over a surface depends on its border
    alone: a place that closes has that of the base. A tube that has no end there, or an open one, goes on around the
    base, and has none.
  */
  bool is_closed_by(const Place& place) const
  {
    const double least = 0.75, spacing = m_patch.spacing();
    Vector base = Vector::Zero();
    for(const Base_sample& s : m_patch.samples())
      if(s.is_uncovered)
        base += s.normal * (spacing * spacing);
    Vector carried = Vector::Zero();
    return spread(place, carried) && carried.dot(base) >= least * base.squaredNorm();
  }

private:
  // The surface of the place from where it is near the base to where it meets the known points. \param normals receives
  // the integral of its normals \return whether it goes no farther than a copy could carry it
  bool spread(const Place& place, Vector& normals) const
  {
    const Model& model = *m_sources[place.source].model;
    std::vector<std::size_t> front, links;
    m_sampler.carried_points(place, front);
    front.erase(std::remove_if(front.begin(), front.end(), [&](std::size_t i) { return !is_near_base(place, i); }),
                front.end());
    std::unordered_set<std::size_t> reached(front.begin(), front.end());
    while(!front.empty())
    {
      const std::size_t i = front.back();
      front.pop_back();
      const Vector x = place.motion(model.position(i)), normal = place.motion.normal(model.normal(i));
      if(is_known(x, normal))
        continue;
      if(m_sampler.search().nearest(x).second > m_sampler.height_limit())
        return false;
      normals += normal * (model.area_spacing(i) * model.area_spacing(i));
      model.linked_points(i, links);
      for(std::size_t j : links)
        if(reached.insert(j).second)
          front.push_back(j);
    }
    return true;
  }

  bool is_near_base(const Place& place, std::size_t i) const
  {
    const Model& model = *m_sources[place.source].model;
    const Neighbor_search::Neighbor foot = m_sampler.search().nearest(place.motion(model.position(i)));
    return foot.second <= 2 * m_patch.spacing() &&
           is_same_side(place.motion.normal(model.normal(i)), m_patch.samples()[foot.first].normal);
  }

  // as near to a known point as the covered samples of the base are
  bool is_known(const Vector& x, const Vector& normal) const
  {
    std::vector<std::size_t> ball;
    m_known.search().in_ball(x, 1.5 * m_patch.spacing(), ball);
    return std::any_of(ball.begin(), ball.end(), [&](std::size_t k)
      { return is_same_side(m_known.normal(k), normal); });
  }

  const Model& m_known;
  const Patch& m_patch;
  const Relief_sampler<ConcurrencyTag>& m_sampler;
  const std::vector<Source>& m_sources;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_OPEN_END_H
