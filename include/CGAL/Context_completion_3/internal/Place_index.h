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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_INDEX_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_INDEX_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Motion.h>
#include <CGAL/Context_completion_3/internal/Nearest_point_grid.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Place_descriptor.h>
#include <CGAL/Context_completion_3/internal/Place_shortlist.h>
#include <CGAL/Context_completion_3/internal/Place_signature.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>
#include <CGAL/Context_completion_3/internal/Thinned_points.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The places of one source that holes of some radius are compared with: frames spread over its surface, their
  signatures, a grid for coarse scores, and, on surfaces that are large against the hole, a shortlist by descriptors.
  Holes of the same radius share it.
*/
template <typename ConcurrencyTag>
class Place_index
{
  typedef Surface_model<ConcurrencyTag> Model;

public:
  /// Deviation of the smoothing of places around a hole.
  static double smoothing(double radius) { return 0.25 * radius; }

  /*!
    \param radius of the hole
    \param spacing of points around it
    \param number_of_places that are compared with a hole, at most
  */
  Place_index(const Model& model, double radius, double spacing, std::size_t number_of_places)
    : m_radius(radius), m_spacing(spacing), m_number_of_places(number_of_places),
      m_tau((std::max)(3 * spacing, 0.12 * radius))
  {
    const double voxel = (std::max)(0.7 * spacing, 0.05 * radius);
    m_grid = std::make_unique<Nearest_point_grid>(model.points(), voxel, int(std::ceil(m_tau / voxel)) + 1);
    const std::vector<std::size_t> chosen = spread_places(model);
    m_places.resize(chosen.size());
    for_each_index<ConcurrencyTag>(chosen.size(), [&](std::size_t k)
      { m_places[k] = smoothed_place(model, model.position(chosen[k]), model.normal(chosen[k]), smoothing(radius)); });
    for(std::size_t i : chosen)
      m_coarse.push_back(model.position(i), model.normal(i));
    m_signatures = std::make_unique<Place_signatures>(model.points(), model.search(), m_coarse, radius, spacing);
    Eigen::AlignedBox3d box;
    for(const Vector& p : m_coarse.position)
      box.extend(p);
    const double root = box.sizes().maxCoeff();
    m_weights = Signature_weights::of_level(std::log2(root / (2 * radius)), std::log2(root / (4 * spacing)));
    if(m_places.size() > number_of_places)
      describe_places();
  }

  /// Weights of signatures by the level on which the cells of a tree would be as large as those of the places; the
  /// cells of the finest level would be four spacings wide.
  Signature_weights weights() const { return m_weights; }

  double radius() const { return m_radius; }
  double spacing() const { return m_spacing; }

  /// Distance at which a probe counts as missed in coarse scores.
  double tau() const { return m_tau; }

  const Nearest_point_grid& grid() const { return *m_grid; }

  /// The points that the places were made of.
  const Surface_points& coarse() const { return m_coarse; }

  /// The places that are to be compared with a hole: all, or, of more than are to be tried, those whose surroundings
  /// resemble its own.
  std::vector<std::size_t> candidates(const Surface_frame& frame, const std::vector<Smoothed_place>& around) const
  {
    if(m_shortlist)
      return m_shortlist->nearest(described(frame, around), m_number_of_places);
    std::vector<std::size_t> all(m_places.size());
    for(std::size_t k = 0; k < all.size(); ++k)
      all[k] = k;
    return all;
  }

  const Surface_frame& frame(std::size_t place) const { return m_places[place].frame; }

  /// Makes the signatures of some places, unless they are there already.
  void sign(const std::vector<std::size_t>& places)
  {
    std::vector<std::size_t> unsigned_places;
    std::vector<Surface_frame> frames;
    m_signature_of.resize(m_places.size());
    for(std::size_t place : places)
      if(!m_signature_of[place])
      {
        unsigned_places.push_back(place);
        frames.push_back(m_places[place].frame);
      }
    const std::vector<Cell_signature> made = m_signatures->template signatures<ConcurrencyTag>(frames);
    for(std::size_t i = 0; i < made.size(); ++i)
      m_signature_of[unsigned_places[i]] = std::make_unique<const Cell_signature>(made[i]);
  }

  /// \pre the place was signed
  const Cell_signature& signature(std::size_t place) const { return *m_signature_of[place]; }

private:
  Place_descriptor described(const Surface_frame& frame, const std::vector<Smoothed_place>& around) const
  {
    std::vector<const Smoothed_place*> places;
    for(const Smoothed_place& place : around)
      places.push_back(&place);
    return Place_descriptor(frame, places, m_radius);
  }

  void describe_places()
  {
    std::vector<Vector> origins;
    for(const Smoothed_place& place : m_places)
      origins.push_back(place.frame.origin);
    const Neighbor_search search(origins);
    std::vector<Place_descriptor> descriptors(m_places.size(), described(m_places[0].frame, {}));
    for_each_index<ConcurrencyTag>(m_places.size(), [&](std::size_t k)
    {
      std::vector<std::size_t> ball;
      search.in_ball(origins[k], 1.5 * Place_descriptor::reach() * m_radius, ball);
      std::vector<const Smoothed_place*> neighbors;
      for(std::size_t j : ball)
        neighbors.push_back(&m_places[j]);
      descriptors[k] = Place_descriptor(m_places[k].frame, neighbors, m_radius);
    });
    m_shortlist = std::make_unique<Place_shortlist>(descriptors);
  }

  // Evenly spread points: no more than are asked for, unless they would be too far apart to be found from each other.
  std::vector<std::size_t> spread_places(const Model& model) const
  {
    const double farthest = (std::max)(1.5 * m_spacing, 0.3 * m_radius);
    double distance = (std::max)(1.5 * m_spacing, 0.15 * m_radius);
    for(;;)
    {
      const std::vector<std::size_t> chosen = thinned_points(model.points(), distance);
      // the shortlist has a price, too: so many places are described for each that is tried
      const std::size_t most = (distance < farthest ? 1 : 30) * m_number_of_places;
      if(chosen.size() <= most)
        return chosen;
      const double larger = distance * (std::max)(1.1, std::sqrt(double(chosen.size()) / double(most)));
      distance = distance < farthest ? (std::min)(farthest, larger) : larger;
    }
  }

  double m_radius, m_spacing;
  std::size_t m_number_of_places;
  double m_tau;
  Surface_points m_coarse;
  Signature_weights m_weights;
  std::unique_ptr<Place_signatures> m_signatures;
  std::vector<std::unique_ptr<const Cell_signature> > m_signature_of;   // of those places that were compared
  std::unique_ptr<Nearest_point_grid> m_grid;
  std::vector<Smoothed_place> m_places;      // smoothed: their frames must be those of the base, not of its detail
  std::unique_ptr<Place_shortlist> m_shortlist;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_INDEX_H
