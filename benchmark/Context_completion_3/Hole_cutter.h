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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_HOLE_CUTTER_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_HOLE_CUTTER_H

#include "Benchmark_case.h"
#include "Blue_noise.h"
#include "Local_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace Completion_benchmark {

/// What a hole looks like.
enum class Hole_shape { round, ragged, elongated, two_rims, island };

inline const char* name_of(Hole_shape shape)
{
  static const char* names[] = { "round", "ragged", "elongated", "two_rims", "island" };
  return names[static_cast<int>(shape)];
}

/// A hole with its frame; x and y of the frame are tangential.
struct Hole_cut
{
  Hole_shape shape = Hole_shape::round;
  Vector center = Vector::Zero();
  double radius = 0;
  Matrix frame = Matrix::Identity();
  double phase = 0;

  bool contains(const Vector& p) const
  {
    const Vector q = frame.transpose() * (p - center) / radius;
    const double angle = std::atan2(q.y(), q.x());
    switch(shape)
    {
    case Hole_shape::ragged:
      return q.norm() < 0.8 + 0.13 * std::sin(3 * angle + phase) + 0.07 * std::sin(8 * angle - 2 * phase);
    case Hole_shape::elongated:
      return q.cwiseProduct(Vector(1, 2.6, 1)).norm() < 1;
    case Hole_shape::island:
      return q.norm() < 1 && (q - Vector(0.12 * std::cos(phase), 0.12 * std::sin(phase), q.z())).norm() > 0.34;
    default:
      return q.norm() < 1;
    }
  }
};

/*!
  Cuts holes into samples of a surface. A cut takes the connected part of the samples in the shape that holds
  the sample at its centre, so that the far side of a thin part stays, and is refused unless it has the
  number of rims that its shape should have.
*/
class Hole_cutter
{
public:
  /// \param local_spacing spacing around each sample \param border samples of the borders of the surface
  Hole_cutter(const Surface_points& points, const std::vector<double>& local_spacing, const std::vector<Vector>& border)
    : m_points(points), m_spacing(local_spacing), m_border(border), m_search(points.position),
      m_largest(*std::max_element(local_spacing.begin(), local_spacing.end())), m_is_removed(points.size(), false)
  {}

  const std::vector<char>& is_removed() const { return m_is_removed; }
  const std::vector<Hole_cut>& cuts() const { return m_cuts; }
  std::size_t number_of_rims() const { return m_rims; }

  /// Tries to cut one hole of `radius` at random places. \return whether it was possible.
  bool cut(Hole_shape shape, double radius, Random_source& random)
  {
    for(int attempt = 0; attempt < 150; ++attempt)
    {
      const std::size_t seed = random.index(m_points.size());
      Hole_cut hole;
      hole.shape = shape;
      hole.radius = radius;
      hole.center = m_points.position[seed];
      hole.phase = random.uniform(0, two_pi);
      const Vector n = m_points.normal[seed];
      const Vector x = n.cross(random.direction()).normalized();
      hole.frame << x, n.cross(x), n;
      if(shape == Hole_shape::two_rims && !move_to_axis(hole, n))
        continue;
      if(is_acceptable_place(hole) && try_to_cut(hole, seed))
        return true;
    }
    return false;
  }

private:
  // half way to the opposite side of the strand
  bool move_to_axis(Hole_cut& hole, const Vector& n) const
  {
    std::vector<std::size_t> near;
    m_search.in_ball(hole.center, 2.2 * hole.radius, near);
    double best = std::numeric_limits<double>::infinity();
    for(std::size_t i : near)
    {
      const Vector d = m_points.position[i] - hole.center;
      const double depth = -d.dot(n);
      if(m_points.normal[i].dot(n) < -0.7 && (d + depth * n).norm() < 0.3 * depth && depth > 4 * m_spacing[i])
        best = (std::min)(best, depth);
    }
    hole.center -= 0.5 * best * n;
    return best < 1.7 * hole.radius;
  }

  bool is_acceptable_place(const Hole_cut& hole) const
  {
    for(const Vector& b : m_border)
      if((b - hole.center).norm() < 1.1 * hole.radius + 6 * m_largest)
        return false;
    for(const Hole_cut& other : m_cuts)
      if((other.center - hole.center).norm() < 1.4 * (hole.radius + other.radius))
        return false;
    return true;
  }

  bool try_to_cut(const Hole_cut& hole, std::size_t seed)
  {
    std::vector<std::size_t> inside, rim;
    if(hole.shape != Hole_shape::two_rims && !hole.contains(m_points.position[seed]))
      seed = first_inside(hole, seed);
    if(seed == m_points.size() || !hole.contains(m_points.position[seed]))
      return false;
    std::vector<char> is_reached(m_points.size(), false);
    const auto is_wanted = [&](std::size_t i)
      { return !is_reached[i] && !m_is_removed[i] && hole.contains(m_points.position[i]); };
    collect(seed, 2.6, is_wanted, is_reached, inside);
    const std::size_t removed = std::size_t(std::count(m_is_removed.begin(), m_is_removed.end(), true));
    if(inside.size() < 40 || removed + inside.size() > m_points.size() / 8)
      return false;

    // the rim in its connected parts
    std::vector<char> is_rim(m_points.size(), false);
    std::vector<std::size_t> near;
    for(std::size_t i : inside)
    {
      m_search.in_ball(m_points.position[i], 2.5 * m_largest, near);
      for(std::size_t j : near)
        if(!is_reached[j] && !is_rim[j] && is_linked(i, j, 2.5))
        {
          is_rim[j] = true;
          rim.push_back(j);
        }
    }
    std::size_t rims = 0;
    for(std::size_t i : rim)
      if(is_rim[i])
      {
        std::vector<std::size_t> part;
        std::vector<char> is_seen(m_points.size(), false);
        collect(i, 3.2, [&](std::size_t j) { return is_rim[j] && !is_seen[j]; }, is_seen, part);
        for(std::size_t j : part)
          is_rim[j] = false;
        if(part.size() < 8)
          return false;                           // an island that nobody asked for
        ++rims;
      }
    const bool has_two = hole.shape == Hole_shape::two_rims || hole.shape == Hole_shape::island;
    if(rims != (has_two ? 2 : 1))
      return false;
    // a strand that is cut through has normals all around; so has a limb that is cut off, which nobody could guess
    const double agreement = mean_normal(inside).norm();
    if(hole.shape == Hole_shape::two_rims ? agreement > 0.35 : agreement < 0.45)
      return false;
    for(std::size_t i : inside)
      m_is_removed[i] = true;
    m_cuts.push_back(hole);
    m_rims += rims;
    return true;
  }

  Vector mean_normal(const std::vector<std::size_t>& indices) const
  {
    Vector sum = Vector::Zero();
    for(std::size_t i : indices)
      sum += m_points.normal[i];
    return sum / double(indices.size());
  }

  std::size_t first_inside(const Hole_cut& hole, std::size_t seed) const
  {
    std::vector<std::size_t> near;
    m_search.in_ball(m_points.position[seed], hole.radius, near);
    std::size_t best = m_points.size();
    double smallest = std::numeric_limits<double>::infinity();
    for(std::size_t i : near)
    {
      const double distance = (m_points.position[i] - hole.center).norm();
      if(distance < smallest && hole.contains(m_points.position[i]) && is_linked(seed, i, 1e300))
      {
        smallest = distance;
        best = i;
      }
    }
    return best;
  }

  bool is_linked(std::size_t i, std::size_t j, double spacings) const
  {
    return is_same_side(m_points.normal[i], m_points.normal[j])
        && (m_points.position[i] - m_points.position[j]).norm() < spacings * (std::max)(m_spacing[i], m_spacing[j]);
  }

  template <typename Predicate>
  void collect(std::size_t seed, double spacings, const Predicate& is_wanted, std::vector<char>& is_reached,
               std::vector<std::size_t>& found) const
  {
    std::vector<std::size_t> near;
    found.assign(1, seed);
    is_reached[seed] = true;
    for(std::size_t next = 0; next < found.size(); ++next)
    {
      const std::size_t i = found[next];
      m_search.in_ball(m_points.position[i], spacings * m_largest, near);
      for(std::size_t j : near)
        if(is_wanted(j) && is_linked(i, j, spacings))
        {
          is_reached[j] = true;
          found.push_back(j);
        }
    }
  }

  const Surface_points& m_points;
  const std::vector<double>& m_spacing;
  const std::vector<Vector>& m_border;
  Neighbor_search m_search;
  double m_largest;
  std::vector<char> m_is_removed;
  std::vector<Hole_cut> m_cuts;
  std::size_t m_rims = 0;
};

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_HOLE_CUTTER_H
