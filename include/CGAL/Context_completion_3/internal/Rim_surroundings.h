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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_SURROUNDINGS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_SURROUNDINGS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Surface_band.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A denoised point of the surroundings, where the base interpolates position and normal.
struct Base_center
{
  Vector position = Vector::Zero();
  Vector normal = Vector::Zero();
  std::array<double, 4> by_normals = {}; ///< height and its gradient of the fit that uses normals, too
  double distance = 0;         ///< to the rim
};

/// What is known around the rims of a hole: its size, the points near it, and a denoised choice of them that a base is
/// to continue. Lengths are those of the input.
template <typename ConcurrencyTag>
class Rim_surroundings
{
  typedef Surface_model<ConcurrencyTag> Model;

public:
  /// \param edge points of the other side, of an acute edge at which the hole ends
  /// \param islands rims within the hole, whose few points tell little of spacing or size
  Rim_surroundings(const Model& model, const std::vector<Rim_loop>& loops,
                   const std::vector<Rim_point>& edge = std::vector<Rim_point>(),
                   const std::vector<Rim_loop>& islands = std::vector<Rim_loop>())
    : m_model(model), m_loops(loops), m_edge(edge)
  {
    std::vector<double> spacings, area_spacings;
    double diameter = 0;
    for(const Rim_loop& loop : loops)
    {
      for(const Rim_point& p : loop.points)
      {
        m_rim.push_back(p.index);
        spacings.push_back(model.spacing(p.index));
        area_spacings.push_back(model.area_spacing(p.index));
      }
      for(const Rim_loop& other : loops)
        diameter = (std::max)(diameter, (loop.center - other.center).norm() + (loop.diameter + other.diameter) / 2);
    }
    m_diameter = diameter;
    m_spacing = median(spacings);
    m_area_spacing = median(area_spacings);
    for(const Rim_loop& island : islands)
    {
      m_loops.push_back(island);
      for(const Rim_point& p : island.points)
        m_rim.push_back(p.index);
    }
    m_band = surface_band(model, m_rim, band_width());
    measure_behind();
    choose_fit_radius();
    choose_centers();
  }

  const Model& model() const { return m_model; }

  /// Those of islands come last.
  const std::vector<Rim_loop>& loops() const { return m_loops; }

  /// As given.
  const std::vector<Rim_point>& edge() const { return m_edge; }

  /// Rim points of all loops.
  const std::vector<std::size_t>& rim() const { return m_rim; }

  /// Known points near the rim, by increasing distance.
  const std::vector<Band_point>& band() const { return m_band; }

  const std::vector<Base_center>& centers() const { return m_centers; }
  double spacing() const { return m_spacing; }

  /// Spacing of an even sampling that has gaps as wide.
  double gap_spacing() const { return m_spacing * m_model.irregularity(); }

  /// Square root of the area per point, at the rim.
  double area_spacing() const { return m_area_spacing; }

  /// The same a little behind the rim, where neighbours are on all sides: how densely the surroundings are sampled.
  double area_spacing_behind() const { return m_area_spacing_behind; }

  /// Whether a point of the band is there.
  bool is_behind(const Band_point& b) const
  {
    return b.distance > 2.5 * m_area_spacing && b.distance < 6 * m_area_spacing;
  }

  double diameter() const { return m_diameter; }

  /// Radius of the local fits: larger where the surroundings are noisy.
  double fit_radius() const { return m_fit_radius; }

private:
  static double median(std::vector<double> v)
  {
    std::nth_element(v.begin(), v.begin() + v.size() / 2, v.end());
    return v[v.size() / 2];
  }

  double band_width() const { return (std::max)(5 * m_area_spacing, 0.45 * m_diameter); }

  // At the rim, where neighbours are on one side only, points seem farther apart than they are.
  void measure_behind()
  {
    std::vector<double> behind;
    for(const Band_point& b : m_band)
      if(is_behind(b))
        behind.push_back(m_model.area_spacing(b.index));
    m_area_spacing_behind = behind.empty() ? m_area_spacing : (std::min)(m_area_spacing, median(behind));
  }

  // The radius whose fits best predict points that they do not know: noise asks for a large one, relief for a small
  // one.
  void choose_fit_radius()
  {
    const std::size_t most = 150, step = m_band.size() / most + 1;
    std::vector<std::size_t> buffer;
    double least = 0;
    for(double factor : {3., 4., 5.})
    {
      const double radius = factor * m_area_spacing;
      double sum = 0;
      std::size_t number = 0;
      for(std::size_t b = 0; b < m_band.size(); b += step)
      {
        const std::size_t i = m_band[b].index;
        Surface_element fit;
        if(!m_model.quadratic_fit(m_model.position(i), m_model.normal(i), radius, fit, buffer, {i}))
          continue;
        sum += std::abs((m_model.position(i) - fit.position).dot(m_model.normal(i)));
        ++number;
      }
      const double error = number > 0 ? sum / double(number) : 0.;
      if(factor == 3. || error < 0.99 * least)
      {
        least = error;
        m_fit_radius = radius;
      }
    }
  }

  // Dense near the rim, thinner away from it; the number bounds the dense system.
  void choose_centers()
  {
    const std::size_t most = 280;
    std::vector<std::size_t> chosen;
    for(double factor = 1; ; factor *= 1.2)
    {
      chosen.clear();
      Point_grid grid(2 * factor * m_spacing);
      for(std::size_t b = 0; b < m_band.size() && chosen.size() <= most; ++b)
      {
        const double room = factor * (std::max)(1.2 * m_spacing, 0.4 * m_band[b].distance);
        const std::size_t index = m_band[b].index;
        bool is_free = true;
        grid.for_each_in_ball(m_model.position(index), room, [&](std::size_t c, double) {
          is_free = !is_same_side(m_model.normal(index), m_model.normal(m_band[chosen[c]].index));
          return is_free; });
        if(!is_free)
          continue;
        grid.insert(m_model.position(index));
        chosen.push_back(b);
      }
      if(chosen.size() <= most)
        break;
    }
    std::vector<std::size_t> buffer;
    for(std::size_t b : chosen)
    {
      const std::size_t i = m_band[b].index;
      Surface_element fit, by_normals;
      Base_center center;
      if(m_model.quadratic_fits(m_model.position(i), m_model.normal(i), fit_radius(), fit, by_normals, buffer))
      {
        center.position = fit.position;
        center.normal = fit.normal;
        if(by_normals.normal.dot(fit.normal) > 0.3)
          center.by_normals = by_normals.height_over(fit.position, fit.normal);
      }
      else
      {
        center.position = m_model.position(i);
        center.normal = m_model.normal(i);
      }
      center.distance = m_band[b].distance;
      m_centers.push_back(center);
    }
  }

  const Model& m_model;
  std::vector<Rim_loop> m_loops;
  std::vector<Rim_point> m_edge;
  std::vector<std::size_t> m_rim;
  std::vector<Band_point> m_band;
  std::vector<Base_center> m_centers;
  double m_spacing = 0, m_area_spacing = 0, m_area_spacing_behind = 0, m_diameter = 0, m_fit_radius = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_SURROUNDINGS_H
