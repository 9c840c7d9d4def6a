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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HEIGHT_FIELD_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HEIGHT_FIELD_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Motion.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>
#include <CGAL/Context_completion_3/internal/Thinned_points.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  A hole and its surroundings as heights over a plane. Heights along one direction add up, which those along the normals
  of a base that follows the relief do not: there, the higher a place rises, the farther aside it is seen. So linear
  predictors are learnt from these.

  Places are carried with the least turn that brings their mean normal to that of the hole, and are seen as the hole is:
  their points inside tell nothing about their heights around.
*/
template <typename ConcurrencyTag>
class Height_field
{
  typedef Smooth_patch<ConcurrencyTag> Patch;
  typedef Surface_model<ConcurrencyTag> Model;

public:
  typedef Eigen::Vector2d Point_2;

  /// Of a place, or of the hole.
  struct Heights
  {
    Eigen::VectorXd inside;              ///< per sample of the base
    Eigen::VectorXd around;              ///< per probe around the rim
    double inside_share = 0;             ///< of the samples that are covered; the others repeat the nearest one
    double around_share = 0;
  };

  /// \param radius of the hole
  Height_field(const Model& known, const Patch& patch, double radius)
    : m_patch(patch), m_radius(radius), m_width((std::max)(0.6 * radius, 4 * patch.spacing()))
  {
    for(const Base_sample& s : patch.samples())
    {
      m_direction += s.normal;
      m_middle += s.position / double(patch.samples().size());
    }
    for(const Band_point& b : patch.band())
      if(b.distance < m_width)
        m_direction += known.normal(b.index);
    if(m_direction.norm() > 0)
      m_direction.normalize();
    else
      m_direction = Vector::UnitZ();
    m_u = m_direction.unitOrthogonal();
    m_v = m_direction.cross(m_u);
    see(known);
    make_bins();
  }

  /// Whether all but a twentieth of the hole and its surroundings face the direction of the heights.
  bool is_valid() const { return m_facing >= 0.95; }

  /// Positions in the plane, in radii of the hole.
  const std::vector<Point_2>& inside() const { return m_inside; }
  const std::vector<Point_2>& around() const { return m_around; }

  /// Of the probes around, to the rim, in radii.
  const std::vector<double>& distance() const { return m_distance; }

  const Vector& middle() const { return m_middle; }

  /// Number of points that the hole and its surroundings have, about: the work of seeing a place.
  std::size_t size() const { return m_marks.size(); }

  /// Heights of the hole around its rim; there are none inside.
  Heights of_hole(const Model& known) const
  {
    std::vector<std::size_t> points;
    known.search().in_ball(m_middle, m_reach, points);
    return heights(known, Motion(), points);
  }

  /// Heights of the surface around point `i`, and where it was taken from; none where it faces too many ways.
  std::optional<Heights> of_place(const Model& model, std::size_t i, Vector& origin) const
  {
    std::vector<std::size_t> points;
    const Vector at = model.position(i);
    model.search().in_ball(at, m_reach, points);
    Vector normal = Vector::Zero(), middle = Vector::Zero();
    std::size_t number = 0;
    for(std::size_t j : points)
      if(model.normal(j).dot(model.normal(i)) > -0.2)
      {
        normal += model.normal(j);
        middle += model.position(j);
        ++number;
      }
    if(normal.norm() < 0.5 * double(number))
      return std::nullopt;
    normal.normalize();
    middle /= double(number);
    // upside down there is no least turn
    if(normal.dot(m_direction) < -0.9)
      return std::nullopt;
    origin = at + normal * normal.dot(middle - at);
    Motion motion;
    motion.linear = least_rotation(normal, m_direction);
    motion.translation = m_middle - motion.linear * origin;
    return heights(model, motion, points);
  }

  /// The same surface as heights over the base, per sample. \param inside heights over the plane
  Eigen::VectorXd over_base(const Eigen::VectorXd& inside) const
  {
    Eigen::VectorXd result(inside.size());
    for(Eigen::Index s = 0; s < inside.size(); ++s)
    {
      const Base_sample& b = m_patch.samples()[std::size_t(s)];
      const double rise = inside[s] - height(b.position);
      const Vector normal = normal_at(s, inside);
      const double facing = normal.dot(b.normal);
      result[s] = rise * (facing > 0.3 ? normal.dot(m_direction) / facing : b.normal.dot(m_direction));
    }
    return result;
  }

private:
  double height(const Vector& x) const { return (x - m_middle).dot(m_direction); }
  Point_2 flat(const Vector& x) const { return Point_2((x - m_middle).dot(m_u), (x - m_middle).dot(m_v)) / m_radius; }

  // What is inside and what around, in the plane, which is brought to the mean height of the surroundings.
  void see(const Model& known)
  {
    std::size_t facing = 0, number = 0;
    for(const Base_sample& s : m_patch.samples())
    {
      m_inside.push_back(flat(s.position));
      m_marks.push_back({m_inside.back(), true, m_inside.size() - 1});
      facing += s.normal.dot(m_direction) > 0.3 ? 1 : 0;
      ++number;
    }
    Surface_points ring;
    std::vector<double> distances;
    double mean = 0;
    for(const Band_point& b : m_patch.band())
    {
      if(b.distance >= m_width)
        continue;
      ++number;
      if(known.normal(b.index).dot(m_direction) <= 0.2)
        continue;
      ++facing;
      const Point_2 x = flat(known.position(b.index));
      ring.push_back(Vector(x[0], x[1], 0), Vector::UnitZ());
      distances.push_back(b.distance / m_radius);
      mean += height(known.position(b.index));
    }
    m_facing = double(facing) / double(number);
    if(ring.size() == 0)
      return;
    m_middle += mean / double(ring.size()) * m_direction;
    std::vector<std::size_t> probe(ring.size(), no_index);
    // as dense as relief of a few spacings calls for, but what is learnt from them is the work of their number cubed
    const double most = 800, apart = (std::max)(2., std::sqrt(double(ring.size()) / (1.6 * most)));
    for(std::size_t i : thinned_points(ring, apart * m_patch.spacing() / m_radius))
    {
      probe[i] = m_around.size();
      m_around.push_back(Point_2(ring.position[i].x(), ring.position[i].y()));
      m_distance.push_back(distances[i]);
    }
    for(std::size_t i = 0; i < ring.size(); ++i)
      m_marks.push_back({Point_2(ring.position[i].x(), ring.position[i].y()), false, probe[i]});
  }

  void make_bins()
  {
    m_edge = 2.2 * m_patch.spacing() / m_radius;
    const double infinity = std::numeric_limits<double>::infinity();
    Point_2 high(-infinity, -infinity);
    m_low = Point_2(infinity, infinity);
    for(const Mark& mark : m_marks)
    {
      for(int axis : {0, 1})
      {
        m_low[axis] = (std::min)(m_low[axis], mark.position[axis]);
        high[axis] = (std::max)(high[axis], mark.position[axis]);
      }
      m_reach = (std::max)(m_reach, m_radius * mark.position.norm());
    }
    for(int axis : {0, 1})
      m_size[axis] = std::ptrdiff_t((high[axis] - m_low[axis]) / m_edge) + 1;
    m_bins.resize(std::size_t(m_size[0] * m_size[1]));
    for(std::size_t i = 0; i < m_marks.size(); ++i)
      m_bins[std::size_t(bin(m_marks[i].position, 0) + m_size[0] * bin(m_marks[i].position, 1))].push_back(i);
  }

  std::ptrdiff_t bin(const Point_2& x, int axis) const
  {
    return std::ptrdiff_t(std::floor((x[axis] - m_low[axis]) / m_edge));
  }

  // calls `visit(mark, squared distance)` for all marks within the edge of a bin
  template <typename Visit>
  void for_each_mark_near(const Point_2& x, const Visit& visit) const
  {
    const std::ptrdiff_t a = bin(x, 0), b = bin(x, 1);
    for(std::ptrdiff_t i = (std::max)(std::ptrdiff_t(0), a - 1); i <= (std::min)(m_size[0] - 1, a + 1); ++i)
      for(std::ptrdiff_t j = (std::max)(std::ptrdiff_t(0), b - 1); j <= (std::min)(m_size[1] - 1, b + 1); ++j)
        for(std::size_t k : m_bins[std::size_t(i + m_size[0] * j)])
        {
          const double d = (m_marks[k].position - x).squaredNorm();
          if(d < m_edge * m_edge)
            visit(m_marks[k], d);
        }
  }

  // Each point raises the samples, or the probes, beside it by its tangent plane.
  Heights heights(const Model& model, const Motion& motion, const std::vector<std::size_t>& points) const
  {
    Heights result;
    result.inside = Eigen::VectorXd::Zero(Eigen::Index(m_inside.size()));
    result.around = Eigen::VectorXd::Zero(Eigen::Index(m_around.size()));
    Eigen::VectorXd weight_inside = result.inside, weight_around = result.around;
    const double sigma = 0.6 * m_patch.spacing() / m_radius;
    std::vector<std::pair<const Mark*, double> > near;
    for(std::size_t i : points)
    {
      const Vector normal = motion.normal(model.normal(i)), x = motion(model.position(i));
      const double facing = normal.dot(m_direction), z = height(x);
      if(facing < 0.1 || std::abs(z) > 0.7 * m_radius)
        continue;
      const Point_2 p = flat(x), slope = -m_radius * Point_2(normal.dot(m_u), normal.dot(m_v)) / facing;
      near.clear();
      double least = std::numeric_limits<double>::infinity();
      bool is_inside = false;
      for_each_mark_near(p, [&](const Mark& mark, double d)
      {
        if(d < least)
        {
          least = d;
          is_inside = mark.is_inside;
        }
        if(mark.index != no_index)
          near.emplace_back(&mark, d);
      });
      for(const std::pair<const Mark*, double>& n : near)
      {
        if(n.first->is_inside != is_inside)
          continue;
        const double w = facing * std::exp(-n.second / (2 * sigma * sigma));
        // tangent planes steeper than 60 degrees say nothing about the height beside them
        const double height = facing > 0.5 ? z + slope.dot(n.first->position - p) : z;
        (is_inside ? result.inside : result.around)[Eigen::Index(n.first->index)] += w * height;
        (is_inside ? weight_inside : weight_around)[Eigen::Index(n.first->index)] += w;
      }
    }
    result.inside_share = divide(result.inside, weight_inside, m_inside);
    result.around_share = divide(result.around, weight_around, m_around);
    return result;
  }

  // Weighted sums become means; where there is no weight, that of the nearest with one. \return the share with weight
  static double divide(Eigen::VectorXd& sums, const Eigen::VectorXd& weights, const std::vector<Point_2>& positions)
  {
    std::vector<Eigen::Index> known, unknown;
    for(Eigen::Index s = 0; s < sums.size(); ++s)
      if(weights[s] > 0.05)
      {
        sums[s] /= weights[s];
        known.push_back(s);
      }
      else
        unknown.push_back(s);
    const double share = double(known.size()) / double((std::max)(sums.size(), Eigen::Index(1)));
    if(share < 0.8)
      return share;
    for(Eigen::Index s : unknown)
    {
      double least = std::numeric_limits<double>::infinity();
      for(Eigen::Index t : known)
      {
        const double d = (positions[std::size_t(s)] - positions[std::size_t(t)]).squaredNorm();
        if(d < least)
        {
          least = d;
          sums[s] = sums[t];
        }
      }
    }
    return share;
  }

  // of a surface inside, at sample `s`: from a plane through the heights around it
  Vector normal_at(Eigen::Index s, const Eigen::VectorXd& inside) const
  {
    const Point_2 x = m_inside[std::size_t(s)];
    const double sigma = m_edge / 2, damping = 1e-3 * sigma * sigma;
    double xx = damping, xy = 0, yy = damping, right_x = 0, right_y = 0;
    for_each_mark_near(x, [&](const Mark& mark, double d)
    {
      if(!mark.is_inside)
        return;
      const Point_2 step = mark.position - x;
      const double w = std::exp(-d / (2 * sigma * sigma));
      const double height = w * (inside[Eigen::Index(mark.index)] - inside[s]) / m_radius;
      xx += w * step[0] * step[0];
      xy += w * step[0] * step[1];
      yy += w * step[1] * step[1];
      right_x += height * step[0];
      right_y += height * step[1];
    });
    const double all = xx * yy - xy * xy, slope_u = (right_x * yy - right_y * xy) / all,
                 slope_v = (xx * right_y - xy * right_x) / all;
    return (m_direction - slope_u * m_u - slope_v * m_v).normalized();
  }

  struct Mark
  {
    Point_2 position;
    bool is_inside;
    std::size_t index;                   // of the sample or the probe; `no_index`: none, it but tells what is around
  };

  const Patch& m_patch;
  double m_radius, m_width;
  Vector m_direction = Vector::Zero(), m_middle = Vector::Zero(), m_u, m_v;
  double m_facing = 0, m_reach = 0;
  std::vector<Point_2> m_inside, m_around;
  std::vector<double> m_distance;
  std::vector<Mark> m_marks;
  Point_2 m_low;
  double m_edge = 0;
  std::ptrdiff_t m_size[2] = {0, 0};
  std::vector<std::vector<std::size_t> > m_bins;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HEIGHT_FIELD_H
