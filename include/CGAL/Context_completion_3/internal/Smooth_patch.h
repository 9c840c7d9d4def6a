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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SMOOTH_PATCH_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SMOOTH_PATCH_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Base_edge.h>
#include <CGAL/Context_completion_3/internal/Base_sample.h>
#include <CGAL/Context_completion_3/internal/Box_set.h>
#include <CGAL/Context_completion_3/internal/Narrow_slot.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Polyharmonic_base.h>
#include <CGAL/Context_completion_3/internal/Rim_surroundings.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The smooth base over a whole hole: polyharmonic through the surroundings, sampled from the rim inwards. It is the
  coarsest approximation of the missing surface (in place of the quadric of the parent cell, which cannot cover a hole
  as large as the cell), the guide of the search, and the answer where no example is trusted.
*/
template <typename ConcurrencyTag>
class Smooth_patch
{
  typedef Surface_model<ConcurrencyTag> Model;

public:
  typedef Rim_surroundings<ConcurrencyTag> Surroundings;

  /// \param is_stiff lets the base miss the surroundings a little, which keeps it from following relief at the rim off
  /// \param domain where the base ends at the latest, which then closes it; none: nowhere
  /// \param guides further places through which the base leads
  /// \param most_covered as soon as more samples for each rim point are near to known points, the sampling is given up, and
  ///        the base is not closed
  explicit Smooth_patch(const std::shared_ptr<const Surroundings>& surroundings, bool is_stiff = false,
                        const std::optional<Bbox_3>& domain = std::nullopt,
                        const std::vector<Base_center>& guides = std::vector<Base_center>(),
                        double most_covered = std::numeric_limits<double>::infinity())
    : m_surroundings(surroundings), m_model(surroundings->model()), m_spacing(surroundings->spacing()), m_domain(domain),
      m_guides(guides)
  {
    if(centers().size() < 4)
      return;
    std::vector<Vector> positions;
    for(const Base_center& c : centers())
      positions.push_back(c.position);
    for(const Base_center& c : guides)
      positions.push_back(c.position);
    m_base = is_stiff ? std::make_unique<Polyharmonic_base>(positions, scale(), 1., 300.)
                      : std::make_unique<Polyharmonic_base>(positions, scale());
    m_coefficients = m_base->solve(normal_data()).col(0);
    project_band();
    grow(most_covered);
    if(m_is_closed)
    {
      relax();
      if(number_of_uncovered() < fewest_uncovered() && is_rim_whole())
      {
        const Narrow_slot slot(m_footprints, m_footprint_normals, m_surroundings->gap_spacing(),
                               [&](Vector& x, Vector& normal) { return project(x, normal); });
        if(!slot.look_between(m_samples, fewest_uncovered()) && joins_rims())
          slot.look_for_void(m_samples, rim().size());
      }
    }
  }

  /// The least number of uncovered samples that is evidence of a hole.
  static std::size_t fewest_uncovered() { return 4; }

  const std::shared_ptr<const Surroundings>& surroundings() const { return m_surroundings; }
  const std::vector<Rim_loop>& loops() const { return m_surroundings->loops(); }
  const std::vector<std::size_t>& rim() const { return m_surroundings->rim(); }
  const std::vector<Band_point>& band() const { return m_surroundings->band(); }
  const std::vector<Base_center>& centers() const { return m_surroundings->centers(); }
  const std::vector<Base_sample>& samples() const { return m_samples; }
  const Polyharmonic_base& base() const { return *m_base; }
  double spacing() const { return m_spacing; }
  double area_spacing() const { return m_surroundings->area_spacing(); }
  double diameter() const { return m_surroundings->diameter(); }
  double fit_radius() const { return m_surroundings->fit_radius(); }

  /// Whether the base ends at the rim everywhere; otherwise it runs off to infinity: an outer border.
  bool is_closed() const { return m_is_closed; }

  std::size_t number_of_uncovered() const
  {
    std::size_t n = 0;
    for(const Base_sample& s : m_samples)
      n += s.is_uncovered;
    return n;
  }

  /// Known points at which the sampling arrived: rims that belong to the same hole.
  const std::vector<std::size_t>& reached() const { return m_reached; }

  /// Points of the edge of the surroundings at which the sampling ended, by increasing index.
  const std::vector<std::size_t>& reached_edge() const { return m_reached_edge; }

  /// Whether the sampling went on from each rim to the others; otherwise each of some rims is closed alone.
  bool joins_rims() const { return m_joined_share == 1; }

  /// Share of rim points in the largest set of rims that the sampling joins.
  double joined_share() const { return m_joined_share; }

  /// As given.
  const std::vector<Base_center>& guides() const { return m_guides; }

  double scale() const { return (std::max)(diameter() / 2, 2 * m_spacing); }

  /// Right hand side "value 0, gradient = normal" of the centres and, after them, the guides: the base itself.
  Eigen::MatrixXd normal_data() const
  {
    Eigen::MatrixXd data = Eigen::MatrixXd::Zero(4 * Eigen::Index(centers().size() + guides().size()), 1);
    Eigen::Index row = 1;
    for(const std::vector<Base_center>* part : { &centers(), &guides() })
      for(const Base_center& c : *part)
      {
        for(Eigen::Index k = 0; k < 3; ++k)
          data(row + k, 0) = c.normal[k];
        row += 4;
      }
    return data;
  }

  /// Moves `x` onto the base along the gradient. \return whether it arrived
  bool project(Vector& x, Vector& normal) const
  {
    const double reach = scale();
    for(int step = 0; step < 6; ++step)
    {
      Vector gradient;
      const double f = m_base->value(x, m_coefficients, gradient);
      const double g2 = gradient.squaredNorm();
      if(!(g2 > 1e-4))
        return false;
      const Vector move = (-f / g2) * gradient;
      if(!(move.norm() < reach))
        return false;
      x += move;
      normal = gradient / std::sqrt(g2);
      if(move.norm() < 1e-3 * m_spacing)
        break;
    }
    return x.allFinite();
  }

private:
  // What is covered is decided on the base: relief of any height over it covers the place below.
  void project_band()
  {
    for(const Band_point& b : band())
    {
      Vector x = m_model.position(b.index), normal;
      if(!project(x, normal) || (x - m_model.position(b.index)).norm() > scale() ||
         !is_same_side(normal, m_model.normal(b.index)))
        continue;
      m_footprints.push_back(x);
      m_footprint_normals.push_back(normal);
      m_footprint_index.push_back(b.index);
    }
  }

  void grow(double most_covered)
  {
    const double h = m_spacing, gap = m_surroundings->gap_spacing();
    Point_grid known(1.7 * gap), grid(h);
    for(const Vector& x : m_footprints)
      known.insert(x);
    if(!m_domain && runs_off(known))
      return;
    std::deque<std::pair<std::size_t, Vector> > front;
    // three discs of this rim; between two rims a tube as long as they are apart
    const double length = double(rim().size()) * gap / h, around = loops().size() > 1 ? length : 0;
    std::size_t covered = 0;
    const std::size_t most = 60 + std::size_t(3 * length * length / (4 * 3.1416) + around * diameter() / h);
    std::vector<char> is_reached(m_footprints.size(), 0);
    Base_edge<ConcurrencyTag> edge(*m_surroundings);
    // the loop that each sample comes from, and loops that are joined: of each the smallest
    std::vector<std::size_t> origin, joined(loops().size());
    std::iota(joined.begin(), joined.end(), std::size_t(0));
    const auto try_sample = [&](Vector x, const Vector& from, const Vector& from_normal, std::size_t loop) -> bool
    {
      Vector normal;
      if(!step(edge, from, from_normal, x, normal))
        return false;
      double nearest = 1.7 * gap;
      bool is_free = true;
      known.for_each_in_ball(x, 1.7 * gap, [&](std::size_t k, double d) {
        if(!is_same_side(normal, m_footprint_normals[k]))
          return true;
        is_reached[k] = 1;
        nearest = (std::min)(nearest, d);
        return true; });
      if(nearest < 0.8 * h)
        return false;
      grid.for_each_in_ball(x, 0.82 * h, [&](std::size_t s, double) {
        is_free = !is_same_side(normal, m_samples[s].normal);
        if(!is_free && joined[origin[s]] != joined[loop])
          std::replace(joined.begin(), joined.end(), (std::max)(joined[origin[s]], joined[loop]),
                       (std::min)(joined[origin[s]], joined[loop]));
        return is_free; });
      if(!is_free)
        return false;
      Base_sample sample;
      sample.position = x;
      sample.normal = normal;
      sample.is_uncovered = nearest >= 1.5 * gap;
      covered += !sample.is_uncovered;
      if(nearest >= 1.25 * gap)
        front.emplace_back(m_samples.size(), (x - from).normalized());
      grid.insert(x);
      m_samples.push_back(sample);
      origin.push_back(loop);
      return true;
    };
    for(std::size_t l = 0; l < loops().size(); ++l)
      for(const Rim_point& p : loops()[l].points)
      {
        const Vector from = m_model.position(p.index);
        // the farther one first: a sample close to the rim is covered, starts nothing and would bar the other
        try_sample(from + 1.4 * gap * p.outward, from, m_model.normal(p.index), l);
        try_sample(from + gap * p.outward, from, m_model.normal(p.index), l);
      }
    while(!front.empty())
    {
      const std::size_t a = front.front().first;
      const Vector direction = front.front().second;
      front.pop_front();
      const Base_sample sample = m_samples[a];
      const Vector u = (direction - direction.dot(sample.normal) * sample.normal).normalized();
      const Vector v = sample.normal.cross(u);
      const double angle[] = {0, 1.0472, -1.0472, 2.0944, -2.0944, 3.1416};
      for(double t : angle)
        try_sample(sample.position + h * (std::cos(t) * u + std::sin(t) * v), sample.position, sample.normal, origin[a]);
      if(!m_domain && (m_samples.size() > most || is_far_off(sample.position)))
        return;
      if(double(covered) > most_covered * double(rim().size()))
        return;
    }
    m_is_closed = true;
    std::vector<std::size_t> points(loops().size(), 0);
    for(std::size_t l = 0; l < loops().size(); ++l)
      points[joined[l]] += loops()[l].points.size();
    m_joined_share = double(*std::max_element(points.begin(), points.end())) /
                     double(std::accumulate(points.begin(), points.end(), std::size_t(0)));
    for(std::size_t k = 0; k < is_reached.size(); ++k)
      if(is_reached[k])
        m_reached.push_back(m_footprint_index[k]);
    m_reached_edge = edge.reached();
    std::sort(m_reached.begin(), m_reached.end());
    m_reached.erase(std::unique(m_reached.begin(), m_reached.end()), m_reached.end());
  }

  // Moves `x`, about one spacing beside `from`, onto the base. \return whether the base goes on there
  bool step(Base_edge<ConcurrencyTag>& edge, const Vector& from, const Vector& from_normal, Vector& x, Vector& normal) const
  {
    return project(x, normal) && normal.dot(from_normal) >= 0.2 && (x - from).norm() <= 1.8 * m_surroundings->gap_spacing() &&
           is_in_domain(x) && !edge.is_beyond(x, normal);
  }

  bool is_far_off(const Vector& x) const
  {
    return (x - loops().front().center).norm() > diameter() + 6 * m_spacing;
  }

  // Beside an outer border the sampling would fill a disc as large as the surface, or more, before it is far off. A straight
  // way on the base tells as much, if the sampling is sure to find a way along it: there is room on both sides.
  bool runs_off(const Point_grid& known) const
  {
    const double h = m_spacing, gap = m_surroundings->gap_spacing(), room = 2.2 * gap;
    const std::size_t most_ways = 64, every = (std::max)(std::size_t(8), rim().size() / most_ways);
    const int most_steps = int(2 * diameter() / h) + 12;   // it may be led around in circles
    Base_edge<ConcurrencyTag> edge(*m_surroundings);
    std::size_t number = 0;
    for(const Rim_loop& loop : loops())
      for(const Rim_point& p : loop.points)
      {
        if(number++ % every != 0)
          continue;
        Vector x = m_model.position(p.index), normal = m_model.normal(p.index), direction = p.outward;
        for(int k = 0; k < most_steps; ++k)
        {
          const Vector from = x, from_normal = normal;
          x += (k == 0 ? 1.4 * gap : h) * direction;
          if(!step(edge, from, from_normal, x, normal) ||
             (k > 0 && has_point_on_side(known, m_footprint_normals, x, normal, room)))
            break;
          if(is_far_off(x))
            return true;
          direction = x - from;
          direction = (direction - direction.dot(normal) * normal).normalized();
        }
      }
    return false;
  }

  // A domain may be without bounds.
  bool is_in_domain(const Vector& x) const
  {
    return !m_domain ||
           (is_inside(x, *m_domain) && (x - loops().front().center).norm() <= diameter() + 6 * m_spacing);
  }

  // Repulsion evens out the sampling that the front left, up to the rim.
  void relax()
  {
    const double h = m_spacing, reach = 1.25 * h;
    Base_edge<ConcurrencyTag> edge(*m_surroundings);
    Point_grid known(reach);
    for(const Vector& x : m_footprints)
      known.insert(x);
    for(int round = 0; round < 4; ++round)
    {
      Point_grid grid(reach);
      for(const Base_sample& s : m_samples)
        grid.insert(s.position);
      std::vector<Base_sample> moved = m_samples;
      for(std::size_t i = 0; i < m_samples.size(); ++i)
      {
        const Vector p = m_samples[i].position;
        Vector push = Vector::Zero();
        const auto repel = [&](const Vector& q, double d) {
          if(d > 0)
            push += (reach - d) / d * (p - q); };
        grid.for_each_in_ball(p, reach, [&](std::size_t k, double d) {
          if(is_same_side(m_samples[k].normal, m_samples[i].normal))
            repel(grid.point(k), d);
          return true; });
        known.for_each_in_ball(p, reach, [&](std::size_t k, double d) {
          if(is_same_side(m_footprint_normals[k], m_samples[i].normal))
            repel(known.point(k), d);
          return true; });
        Vector x = p + 0.35 * push, normal;
        if((x - p).norm() < h && project(x, normal) && (x - p).norm() < h && is_in_domain(x) &&
           !edge.is_beyond(x, normal))
        {
          moved[i].position = x;
          moved[i].normal = normal;
        }
      }
      m_samples.swap(moved);
    }
  }

  // A closed curve is at least twice as long as its diameter. Three quarters of it are found, if rim points are as near
  // to each other as points are in general.
  bool is_rim_whole() const { return double(rim().size()) * m_surroundings->gap_spacing() >= 1.5 * diameter(); }

  std::shared_ptr<const Surroundings> m_surroundings;
  const Model& m_model;
  double m_spacing;
  std::optional<Bbox_3> m_domain;
  std::vector<Base_center> m_guides;
  std::unique_ptr<Polyharmonic_base> m_base;
  Eigen::VectorXd m_coefficients;
  std::vector<Vector> m_footprints, m_footprint_normals;
  std::vector<std::size_t> m_footprint_index;
  std::vector<Base_sample> m_samples;
  std::vector<std::size_t> m_reached, m_reached_edge;
  bool m_is_closed = false;
  double m_joined_share = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SMOOTH_PATCH_H
