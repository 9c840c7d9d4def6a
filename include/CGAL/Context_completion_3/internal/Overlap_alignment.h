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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_OVERLAP_ALIGNMENT_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_OVERLAP_ALIGNMENT_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Motion.h>
#include <CGAL/Context_completion_3/internal/Nearest_point_grid.h>
#include <CGAL/Context_completion_3/internal/Normal_equations.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Where a hypothesis is measured: a known point of the overlap, or a sample of the current base in the hole.
struct Match_probe
{
  Vector position = Vector::Zero();
  Vector normal = Vector::Zero();
  double weight = 1;
};

/// Every k-th probe. Probes come by increasing distance from the rim, so all distances stay represented.
inline std::vector<Match_probe> thinned(const std::vector<Match_probe>& probes, std::size_t number)
{
  if(probes.size() <= number)
    return probes;
  std::vector<Match_probe> result;
  for(std::size_t i = 0; i < number; ++i)
    result.push_back(probes[i * probes.size() / number]);
  return result;
}

/// Weights of the match score; the terms are those of equations 1 to 3 of the paper, truncated.
struct Match_weights
{
  double tau = 1;      ///< distance at which a probe counts as missed
  double kappa = 0.5;  ///< weight of the directions against the distances (w_d)
};

/*!
  Score and alignment of motions on the known overlap around a hole (paper, section 7.1, with distances to planes:
  closest points let a patch drift along the surface).
*/
template <typename ConcurrencyTag>
class Overlap_alignment
{
  typedef Surface_model<ConcurrencyTag> Model;

public:
  /// Looks up near points in the grid (fast) or, without one, in the search structure of the model (exact).
  Overlap_alignment(const Model& source, const Nearest_point_grid* grid)
    : m_source(source), m_grid(grid)
  {}

  /// Weighted mean over the probes: 0 perfect, 1 + kappa nothing there.
  double score(const std::vector<Match_probe>& probes, const Motion& motion, const Match_weights& weights) const
  {
    double sum = 0, total = 0;
    for(const Match_probe& p : probes)
    {
      total += p.weight;
      sum += p.weight * term(p, motion, weights);
    }
    return total > 0 ? sum / total : 1 + weights.kappa;
  }

  /// One summand of the score.
  double term(const Match_probe& p, const Motion& motion, const Match_weights& weights) const
  {
    double distance, agreement;
    if(!residual(p, motion, weights.tau, distance, agreement))
      return 1 + weights.kappa;
    const double d = distance / weights.tau;
    return (std::min)(1., d * d) + weights.kappa * (std::min)(1., 1 - agreement);
  }

  /// Distance of a probe to the tangent plane of the nearest source point and the agreement of the normals.
  bool residual(const Match_probe& p, const Motion& motion, double reach, double& distance, double& agreement) const
  {
    const Vector y = motion.inverse(p.position);
    const std::size_t s = nearest(y, reach);
    if(s == m_source.size())
      return false;
    const Vector& n = m_source.normal(s);
    distance = n.dot(y - m_source.position(s));
    agreement = n.dot(motion.inverse_normal(p.normal));
    return true;
  }

  /*!
    Point-to-plane ICP from `motion`; the correspondence cut shrinks as max(smallest, first * 0.7^i).
    The system is damped, so that a symmetric overlap (sphere, plane) does not let the patch slide.

    \param fine_steps number of further steps, for what is nearly right. Distances are along the mean of the normals of a
    probe and of its nearest source point ("A symmetric objective function for ICP", Rusinkiewicz, SIGGRAPH 2019): between
    points of one sphere or cylinder they are zero, where the distance to the tangent plane of either is not. And far
    pairs weigh less (Huber): across an edge no distance is right, and where all others are zero such pairs must not
    move the patch. In the first steps it is far pairs that bring a few bumps on a plane together.
  */
  Motion align(const std::vector<Match_probe>& probes, Motion motion, double first, double smallest, int steps,
               int fine_steps = 0) const
  {
    Vector pivot = Vector::Zero();
    double total = 0, extent = 0;
    for(const Match_probe& p : probes)
    {
      pivot += p.weight * p.position;
      total += p.weight;
    }
    if(total <= 0)
      return motion;
    pivot /= total;
    for(const Match_probe& p : probes)
      extent = (std::max)(extent, (p.position - pivot).norm());
    if(extent <= 0)
      return motion;
    std::vector<Correspondence> pairs;
    double cut = first;
    for(int step = 0; step < steps + fine_steps; ++step, cut *= 0.7)
    {
      const double reach = (std::max)(smallest, cut);
      find_pairs(probes, motion, reach, step >= steps, pairs);
      double used = 0;
      for(const Correspondence& c : pairs)
        used += c.weight;
      if(used < 0.1 * total)
        return motion;
      if(step >= steps)
        reduce_weights_of_far_pairs(pairs, 1e-9 * reach);
      Normal_equations<6> equations;
      used = 0;
      for(const Correspondence& c : pairs)
      {
        const Vector arm = (c.position - pivot) / extent, turn = arm.cross(c.direction);
        equations.add({{turn[0], turn[1], turn[2], c.direction[0], c.direction[1], c.direction[2]}}, c.distance,
                      c.weight);
        used += c.weight;
      }
      const Normal_equations<6>::Row x = equations.solve(6, 1e-3 * used);
      if(!std::all_of(x.begin(), x.end(), [](double y) { return std::isfinite(y); }))
        return motion;
      motion = motion.moved(Vector(x[0], x[1], x[2]) / extent, Vector(x[3], x[4], x[5]), pivot);
    }
    return motion;
  }

  /// Index of the nearest source point within about `reach`, or the number of points.
  std::size_t nearest(const Vector& y, double reach) const
  {
    if(m_grid != nullptr)
    {
      const std::uint32_t s = (*m_grid)(y);
      if(s == Nearest_point_grid::none)
        return m_source.size();
      const double room = reach + m_grid->voxel() + m_source.spacing();
      return (m_source.position(s) - y).squaredNorm() <= room * room ? std::size_t(s) : m_source.size();
    }
    const Neighbor_search::Neighbor found = m_source.search().nearest(y);
    return found.second <= reach + m_source.spacing() ? found.first : m_source.size();
  }

private:
  // A probe and the source point nearest to it.
  struct Correspondence
  {
    Vector position;                     // of the probe
    Vector direction;                    // along which the distance is measured
    double distance = 0;
    double weight = 0;
  };

  void find_pairs(const std::vector<Match_probe>& probes, const Motion& motion, double reach, bool is_symmetric,
                  std::vector<Correspondence>& pairs) const
  {
    pairs.clear();
    for(const Match_probe& p : probes)
    {
      const std::size_t s = nearest(motion.inverse(p.position), reach);
      if(s == m_source.size())
        continue;
      const Vector normal = motion.normal(m_source.normal(s));
      const double agreement = normal.dot(p.normal);
      if(agreement < 0.3)
        continue;
      Correspondence pair;
      pair.position = p.position;
      pair.direction = is_symmetric ? Vector((normal + p.normal).normalized()) : normal;
      pair.distance = pair.direction.dot(p.position - motion(m_source.position(s)));
      pair.weight = p.weight * agreement;
      if(std::abs(pair.distance) <= reach)
        pairs.push_back(pair);
    }
  }

  // Far is what is beyond twice the median.
  static void reduce_weights_of_far_pairs(std::vector<Correspondence>& pairs, double least)
  {
    std::vector<double> distances;
    for(const Correspondence& c : pairs)
      distances.push_back(std::abs(c.distance));
    const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    const double far = 2 * *middle + least;
    for(Correspondence& c : pairs)
      if(std::abs(c.distance) > far)
        c.weight *= far / std::abs(c.distance);
  }

  const Model& m_source;
  const Nearest_point_grid* m_grid;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_OVERLAP_ALIGNMENT_H
