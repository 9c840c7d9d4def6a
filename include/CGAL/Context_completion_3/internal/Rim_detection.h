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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_DETECTION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_DETECTION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Angular_gap.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A point at a border of the sampling, and the direction in the tangent plane in which nothing follows.
struct Rim_point
{
  std::size_t index = 0;
  Vector outward = Vector::Zero();
};

/// Rim points that follow each other.
struct Rim_loop
{
  std::vector<Rim_point> points;
  Vector center = Vector::Zero();
  double diameter = 0;

  /// Mean cosine between the outward directions and the direction to `target`: positive if the loop opens towards it.
  double opening(const Surface_points& surface, const Vector& target) const
  {
    double sum = 0;
    for(const Rim_point& p : points)
    {
      const Vector d = target - surface.position[p.index];
      const double length = d.norm();
      if(length > 0)
        sum += p.outward.dot(d) / length;
    }
    return points.empty() ? 0. : sum / double(points.size());
  }

  /// Sets centre and diameter.
  void measure(const Surface_points& surface)
  {
    center = Vector::Zero();
    for(const Rim_point& p : points)
      center += surface.position[p.index];
    center /= double(points.size());
    // the largest distance of two points; the extremes along 13 directions bound it from below within 4 %
    std::vector<std::size_t> extreme;
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
        {
          if(x == 0 && y == 0 && z == 0)
            continue;
          const Vector direction(x, y, z);
          std::size_t best = points.front().index;
          for(const Rim_point& p : points)
            if(direction.dot(surface.position[p.index] - surface.position[best]) > 0)
              best = p.index;
          extreme.push_back(best);
        }
    diameter = 0;
    for(std::size_t a : extreme)
      for(std::size_t b : extreme)
        diameter = (std::max)(diameter, (surface.position[a] - surface.position[b]).norm());
  }
};

/*!
  Finds the rims of under-sampled places: the evidence that the default policy asks for besides few points in a cell
  (the paper, section 5, counts only, and a surface that clips the corner of a cell is then taken for a hole).

  A point is on a rim if its neighbours leave a large angle free in the plane through them, and if the empty place
  there has room for a further sample.
*/
template <typename ConcurrencyTag>
class Rim_detection
{
  typedef Surface_model<ConcurrencyTag> Model;

public:
  explicit Rim_detection(const Model& model) : m_model(model) {}

  /// All loops of at least three points, in the order of their smallest index.
  std::vector<Rim_loop> loops() const
  {
    const std::size_t n = m_model.size();
    std::vector<Vector> outward(n, Vector::Zero());
    std::vector<std::size_t> indices(n);
    for(std::size_t i = 0; i < n; ++i)
      indices[i] = i;
    CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t i) -> bool
    {
      outward[i] = free_direction(i);
      return true;
    });
    return connect(outward);
  }

private:
  // neighbourhood of the angle test, room of the empty place, link of a loop: in area spacings. An area spacing is
  // about 1.1 times the nearest neighbour distance of blue noise.
  static constexpr double neighborhood() { return 2.4; }
  static constexpr double probe_distance() { return 1.35; }
  static constexpr double probe_room() { return 1.1; }
  static constexpr double link() { return 2.7; }
  static constexpr double fold_distance() { return 1.2; }

  Vector free_direction(std::size_t i) const
  {
    const double radius = neighborhood() * m_model.gap_spacing(i);
    const Vector p = m_model.position(i);
    std::vector<std::size_t> ball;
    m_model.search().in_ball(p, radius, ball);
    std::vector<Vector> around, behind;
    Vector mean = Vector::Zero();
    bool is_at_fold = false;
    for(std::size_t j : ball)
      if(is_same_side(m_model.normal(i), m_model.normal(j)))
      {
        around.push_back(m_model.position(j));
        mean += around.back();
      }
      else
      {
        behind.push_back(m_model.position(j));
        if((behind.back() - p).norm() < fold_distance() * m_model.gap_spacing(i))
          is_at_fold = true;
      }
    if(around.size() < 4)
      return Vector::Zero();
    mean /= double(around.size());
    Matrix covariance = Matrix::Zero();
    for(const Vector& q : around)
      covariance += (q - mean) * (q - mean).transpose();
    // The plane through the neighbours, not the stored normal: at a sharp edge both faces are seen from it.
    const Vector axis = Eigen::SelfAdjointEigenSolver<Matrix>(covariance).eigenvectors().col(0);
    const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
    std::vector<double> angles;
    for(const Vector& q : around)
    {
      const double x = (q - p).dot(u), y = (q - p).dot(v);
      if(x * x + y * y > 0.0025 * radius * radius)
        angles.push_back(std::atan2(y, x));
    }
    if(angles.size() < 3)
      return Vector::Zero();
    const Angular_gap gap(angles);
    if(!gap.is_open())
      return Vector::Zero();
    const Vector direction = std::cos(gap.middle) * u + std::sin(gap.middle) * v;
    // The surface goes on around an acute edge. Where the other side goes on below the empty place, it is a thin plate
    // with a hole in this side.
    const auto is_ahead = [&](const Vector& q)
      { return (q - p).dot(direction) > probe_distance() * m_model.gap_spacing(i); };
    if(is_at_fold && std::none_of(behind.begin(), behind.end(), is_ahead))
      return Vector::Zero();
    const Vector probe = p + probe_distance() * m_model.gap_spacing(i) * direction;
    for(std::size_t j : ball)
      if(is_same_side(m_model.normal(i), m_model.normal(j)) &&
         (m_model.position(j) - probe).norm() < probe_room() * m_model.gap_spacing(i))
        return Vector::Zero();
    return direction;
  }

  std::vector<Rim_loop> connect(const std::vector<Vector>& outward) const
  {
    std::vector<std::size_t> rim;
    std::vector<Vector> positions;
    for(std::size_t i = 0; i < outward.size(); ++i)
      if(outward[i] != Vector::Zero())
      {
        rim.push_back(i);
        positions.push_back(m_model.position(i));
      }
    const Neighbor_search search(positions);
    std::vector<char> seen(rim.size(), 0);
    std::vector<Rim_loop> loops;
    std::vector<std::size_t> ball;
    for(std::size_t start = 0; start < rim.size(); ++start)
    {
      if(seen[start])
        continue;
      std::vector<std::size_t> members(1, start);
      seen[start] = 1;
      for(std::size_t k = 0; k < members.size(); ++k)
      {
        const std::size_t a = rim[members[k]];
        search.in_ball(m_model.position(a), link() * m_model.gap_spacing(a), ball);
        for(std::size_t b : ball)
          if(!seen[b] && is_same_side(m_model.normal(a), m_model.normal(rim[b])))
          {
            seen[b] = 1;
            members.push_back(b);
          }
      }
      if(members.size() < 3)
        continue;
      std::sort(members.begin(), members.end());
      Rim_loop loop;
      for(std::size_t m : members)
      {
        Rim_point point;
        point.index = rim[m];
        point.outward = outward[rim[m]];
        loop.points.push_back(point);
      }
      loop.measure(m_model.points());
      loops.push_back(loop);
    }
    return loops;
  }

  const Model& m_model;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_RIM_DETECTION_H
