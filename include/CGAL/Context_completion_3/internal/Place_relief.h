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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_RELIEF_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_RELIEF_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Example_source.h>
#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Place.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  A source place seen from the base of the hole: height of the carried source surface over the samples of the base, and
  its difference from the known surface (value and slope) at the centres around the rim.
*/
struct Place_relief
{
  Eigen::VectorXd height;             ///< per base sample
  std::vector<char> is_covered;       ///< per base sample: the source has a surface there
  Eigen::VectorXd rim;                ///< per centre: value, then gradient (4 numbers), 0 where nothing is found
  Eigen::VectorXd rim_by_normals;     ///< the same by fits that use the normals of points, too
  std::vector<char> is_found;         ///< per centre: the source has a surface there that faces the same way
  double coverage = 0;                ///< share of covered samples
  bool may_fill = true;               ///< the hole; otherwise it serves as a fake hole only
};

/// The part of a hole that a relief is asked for.
struct Relief_window
{
  Vector middle = Vector::Zero();
  double reach = 0;                   ///< samples that are farther from the middle are not needed
  std::vector<char> is_center_needed; ///< per centre
};

/// Computes `Place_relief` for the places of one hole.
template <typename ConcurrencyTag>
class Relief_sampler
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Surface_model<ConcurrencyTag> Model;
  typedef Example_source<ConcurrencyTag> Source;

public:
  Relief_sampler(const Patch& patch, const std::vector<Source>& sources)
    : m_patch(patch), m_sources(sources)
  {
    std::vector<Vector> positions;
    for(const Base_sample& s : patch.samples())
      positions.push_back(s.position);
    m_search = std::make_unique<Neighbor_search>(positions);
    m_neighbors.resize(positions.size());
    for(std::size_t i = 0; i < positions.size(); ++i)
      m_search->in_ball(positions[i], 2.2 * patch.spacing(), m_neighbors[i]);
    Vector low = positions[0], high = positions[0];
    for(const Vector& p : positions)
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    m_whole.middle = (low + high) / 2;
    for(const Vector& p : positions)
      m_whole.reach = (std::max)(m_whole.reach, (p - m_whole.middle).norm());
    m_whole.is_center_needed.assign(patch.centers().size(), 1);
  }

  /// Neighbours of a sample on the base, itself included.
  const std::vector<std::size_t>& neighbors(std::size_t sample) const { return m_neighbors[sample]; }
  const Neighbor_search& search() const { return *m_search; }

  /// Source points that may come to lie over the hole.
  void carried_points(const Place& place, std::vector<std::size_t>& indices) const
  {
    carried_points(place, m_whole, indices);
  }

  /// Source points that come to lie within `width` of the hole but not in it. By increasing index.
  void points_around(const Place& place, double width, std::vector<std::size_t>& indices) const
  {
    carried_points(place, m_whole, indices);
    const std::unordered_set<std::size_t> inside = points_inside(place, indices);
    m_sources[place.source].model->search().in_ball(place.motion.inverse(m_whole.middle), m_whole.reach + width, indices);
    indices.erase(std::remove_if(indices.begin(), indices.end(), [&](std::size_t i) { return inside.count(i) > 0; }),
                  indices.end());
  }

  /// Relief beyond this height over the base belongs to another part of the shape.
  double height_limit() const { return (std::max)(4 * m_patch.spacing(), 0.7 * m_whole.reach); }

  Place_relief relief(const Place& place) const { return relief(place, m_whole); }

  /// The relief in a part of the hole; what it says outside is not to be used.
  Place_relief relief(const Place& place, const Relief_window& window) const
  {
    Place_relief result;
    std::vector<std::size_t> points;
    carried_points(place, window, points);
    sample_heights(place, points, result);
    sample_rim(place, points, window, result);
    return result;
  }

  /// Value, gradient in the tangent plane and direction of a field of the samples at `x`, above or below sample `foot`.
  void interpolate(std::size_t foot, const Vector& x, const Eigen::VectorXd& field, double& value, Vector& gradient,
                   Vector& direction) const
  {
    const Base_sample& b = m_patch.samples()[foot];
    const Vector u = b.normal.unitOrthogonal(), v = b.normal.cross(u);
    const double sigma = m_patch.spacing();
    Matrix a = Matrix::Zero();
    Vector right = Vector::Zero();
    direction = Vector::Zero();
    const Vector p = x - b.normal * b.normal.dot(x - b.position);
    for(std::size_t s : m_neighbors[foot])
    {
      const Base_sample& c = m_patch.samples()[s];
      const Vector d = c.position - p;
      const Vector row(1, d.dot(u) / sigma, d.dot(v) / sigma);
      const double w = std::exp(-0.5 * (row[1] * row[1] + row[2] * row[2]));
      a.noalias() += w * row * row.transpose();
      right += w * field[Eigen::Index(s)] * row;
      direction += w * c.normal;
    }
    a(1, 1) += 0.05 * a(0, 0);
    a(2, 2) += 0.05 * a(0, 0);
    const Vector c = solve_damped_system(a, right);
    value = c[0];
    gradient = (c[1] * u + c[2] * v) / sigma;
    direction.normalize();
  }

private:
  void carried_points(const Place& place, const Relief_window& window, std::vector<std::size_t>& indices) const
  {
    const Model& model = *m_sources[place.source].model;
    model.search().in_ball(place.motion.inverse(window.middle), 1.15 * window.reach + height_limit(), indices);
  }

  // Each carried point raises the samples near the foot of its perpendicular by its tangent plane.
  void sample_heights(const Place& place, const std::vector<std::size_t>& points, Place_relief& result) const
  {
    const Model& model = *m_sources[place.source].model;
    const std::vector<Base_sample>& samples = m_patch.samples();
    const Eigen::Index n = Eigen::Index(samples.size());
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(n), total = Eigen::VectorXd::Zero(n);
    const double sigma = 0.6 * m_patch.spacing();
    for(std::size_t i : points)
    {
      const Vector x = place.motion(model.position(i)), m = place.motion.normal(model.normal(i));
      const Neighbor_search::Neighbor foot = m_search->nearest(x);
      if(foot.second > height_limit())
        continue;
      for(std::size_t s : m_neighbors[foot.first])
      {
        const Base_sample& b = samples[s];
        const double facing = m.dot(b.normal);
        if(facing < 0.1)
          continue;
        const Vector d = x - b.position;
        const double up = d.dot(b.normal), lateral = (d - up * b.normal).norm();
        if(lateral > 2.2 * m_patch.spacing())
          continue;
        // tangent planes steeper than 60 degrees say nothing about the height beside them
        const double height = facing > 0.5 ? m.dot(d) / facing : up;
        const double w = facing * std::exp(-lateral * lateral / (2 * sigma * sigma));
        sum[Eigen::Index(s)] += w * height;
        total[Eigen::Index(s)] += w;
      }
    }
    result.height = Eigen::VectorXd::Zero(n);
    result.is_covered.assign(samples.size(), 0);
    std::size_t covered = 0;
    for(Eigen::Index s = 0; s < n; ++s)
      if(total[s] > 0.05)
      {
        result.height[s] = sum[s] / total[s];
        result.is_covered[std::size_t(s)] = 1;
        ++covered;
      }
    result.coverage = double(covered) / double(n);
    fill_gaps(result);
  }

  // Uncovered samples take the mean of covered neighbours, ring by ring.
  void fill_gaps(Place_relief& result) const
  {
    std::vector<char> known = result.is_covered;
    for(bool changed = true; changed; )
    {
      changed = false;
      std::vector<char> next = known;
      for(std::size_t s = 0; s < known.size(); ++s)
      {
        if(known[s])
          continue;
        double sum = 0;
        std::size_t count = 0;
        for(std::size_t t : m_neighbors[s])
          if(known[t])
          {
            sum += result.height[Eigen::Index(t)];
            ++count;
          }
        if(count > 0)
        {
          result.height[Eigen::Index(s)] = sum / double(count);
          next[s] = 1;
          changed = true;
        }
      }
      known.swap(next);
    }
  }

  // Source points over the hole. The fits at the rim must do without them, as those of the hole itself do: a rim that
  // is seen from both sides would be continued too well.
  std::unordered_set<std::size_t> points_inside(const Place& place, const std::vector<std::size_t>& points) const
  {
    const Model& model = *m_sources[place.source].model;
    std::unordered_set<std::size_t> inside;
    for(std::size_t i : points)
    {
      const Vector x = place.motion(model.position(i));
      const Base_sample& b = m_patch.samples()[m_search->nearest(x).first];
      const Vector d = x - b.position;
      const double up = d.dot(b.normal);
      if(std::abs(up) < height_limit() && (d - up * b.normal).norm() < 0.6 * m_patch.spacing())
        inside.insert(i);
    }
    return inside;
  }

  void sample_rim(const Place& place, const std::vector<std::size_t>& points, const Relief_window& window,
                  Place_relief& result) const
  {
    const Model& model = *m_sources[place.source].model;
    const std::vector<Base_center>& centers = m_patch.centers();
    const Eigen::Index n = Eigen::Index(centers.size());
    result.rim = result.rim_by_normals = Eigen::VectorXd::Zero(4 * n);
    result.is_found.assign(centers.size(), 0);
    const double limit = 0.5 * m_whole.reach;
    const std::unordered_set<std::size_t> inside = points_inside(place, points);
    std::vector<std::size_t> buffer;
    for(Eigen::Index i = 0; i < n; ++i)
    {
      if(!window.is_center_needed[std::size_t(i)])
        continue;
      const Base_center& c = centers[std::size_t(i)];
      Surface_element fit, by_normals;
      const Vector axis = place.motion.inverse_normal(c.normal), foot = place.motion.inverse(c.position);
      if(!model.quadratic_fits(foot, axis, m_patch.fit_radius(), fit, by_normals, buffer, inside))
        continue;
      const double facing = fit.normal.dot(axis);
      const double height = axis.dot(fit.position - foot);
      if(facing < 0.3 || std::abs(height) > limit)
        continue;
      if(by_normals.normal.dot(axis) < 0.3)
        by_normals = fit;
      const auto set = [&](const Surface_element& element, Eigen::VectorXd& rim)
      {
        const std::array<double, 4> data = element.height_over(foot, axis);
        const Vector slope = place.motion.normal(Vector(data[1], data[2], data[3]));
        rim[4 * i] = data[0];
        for(Eigen::Index k = 0; k < 3; ++k)
          rim[4 * i + 1 + k] = slope[k];
      };
      result.is_found[std::size_t(i)] = 1;
      set(fit, result.rim);
      set(by_normals, result.rim_by_normals);
    }
  }

  const Patch& m_patch;
  const std::vector<Source>& m_sources;
  std::unique_ptr<Neighbor_search> m_search;
  std::vector<std::vector<std::size_t> > m_neighbors;
  Relief_window m_whole;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_RELIEF_H
