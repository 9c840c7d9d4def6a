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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_NEAREST_POINT_GRID_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_NEAREST_POINT_GRID_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The index of a near point for each voxel in a band around the surface: the distance field of the paper's signature
  (section 6.1) as a table, so that a hypothesis costs one look-up per probe. It answers for the centre of the voxel,
  which is exact enough to rank hypotheses; what is kept is measured again with the `Kd_tree`.
*/
class Nearest_point_grid
{
public:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  /// \param voxel edge of a voxel \param layers width of the band in voxels
  Nearest_point_grid(const Surface_points& points, double voxel, int layers)
    : m_points(points), m_voxel(voxel)
  {
    Vector low = Vector::Zero(), high = Vector::Zero();
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      low = i == 0 ? points.position[0] : Vector(low.cwiseMin(points.position[i]));
      high = i == 0 ? points.position[0] : Vector(high.cwiseMax(points.position[i]));
    }
    const double largest = 40e6;
    for(;;)
    {
      m_low = low - Vector::Constant((layers + 1) * m_voxel);
      double blocks = 1;
      for(int k = 0; k < 3; ++k)
      {
        m_blocks[k] = std::int64_t(std::floor((high[k] - low[k] + 2 * (layers + 1) * m_voxel) / m_voxel)) / block + 1;
        blocks *= double(m_blocks[k]);
      }
      if(blocks <= largest)
        break;
      m_voxel *= 1.5;
    }
    m_first.assign(std::size_t(m_blocks[0] * m_blocks[1] * m_blocks[2]), none);
    fill(layers);
  }

  double voxel() const { return m_voxel; }

  /// A point that is nearest to `x` up to the resolution, or `none` outside the band.
  std::uint32_t operator()(const Vector& x) const
  {
    std::int64_t c[3];
    for(int k = 0; k < 3; ++k)
    {
      const double t = (x[k] - m_low[k]) / m_voxel;
      if(!(t >= 0))
        return none;
      c[k] = std::int64_t(t);
      if(c[k] >= m_blocks[k] * block)
        return none;
    }
    const std::uint32_t first = m_first[block_index(c)];
    return first == none ? none : m_nearest[first + inside(c)];
  }

private:
  typedef std::array<std::int64_t, 3> Coordinates;
  static constexpr std::int64_t block = 8;

  template <typename C>
  std::size_t block_index(const C& c) const
  {
    return std::size_t(((c[2] / block) * m_blocks[1] + c[1] / block) * m_blocks[0] + c[0] / block);
  }

  template <typename C>
  static std::size_t inside(const C& c)
  {
    return std::size_t(((c[2] % block) * block + c[1] % block) * block + c[0] % block);
  }

  std::uint32_t& at(const Coordinates& c)
  {
    std::uint32_t& first = m_first[block_index(c)];
    if(first == none)
    {
      first = std::uint32_t(m_nearest.size());
      m_nearest.resize(m_nearest.size() + std::size_t(block * block * block), std::uint32_t(none));
    }
    return m_nearest[first + inside(c)];
  }

  double squared_distance(const Coordinates& c, std::uint32_t i) const
  {
    const Vector center = m_low + m_voxel * Vector(double(c[0]) + 0.5, double(c[1]) + 0.5, double(c[2]) + 0.5);
    return (center - m_points.position[i]).squaredNorm();
  }

  bool offer(const Coordinates& c, std::uint32_t i)
  {
    for(int k = 0; k < 3; ++k)
      if(c[k] < 0 || c[k] >= m_blocks[k] * block)
        return false;
    std::uint32_t& current = at(c);
    if(current == i)
      return false;
    if(current != none)
    {
      const double d = squared_distance(c, i), e = squared_distance(c, current);
      if(d > e || (d == e && i >= current))
        return false;
    }
    current = i;
    return true;
  }

  // Indices spread layer by layer from the voxels that hold points.
  void fill(int layers)
  {
    std::vector<Coordinates> front, next;
    for(std::size_t i = 0; i < m_points.size(); ++i)
    {
      Coordinates c;
      for(int k = 0; k < 3; ++k)
        c[k] = std::int64_t((m_points.position[i][k] - m_low[k]) / m_voxel);
      if(offer(c, std::uint32_t(i)))
        front.push_back(c);
    }
    for(int layer = 0; layer < layers; ++layer)
    {
      next.clear();
      for(const Coordinates& c : front)
      {
        const std::uint32_t i = at(c);
        for(int k = 0; k < 3; ++k)
          for(int s = -1; s <= 1; s += 2)
          {
            Coordinates d = c;
            d[k] += s;
            if(offer(d, i))
              next.push_back(d);
          }
      }
      front.swap(next);
    }
  }

  const Surface_points& m_points;
  double m_voxel;
  Vector m_low = Vector::Zero();
  std::array<std::int64_t, 3> m_blocks = {{1, 1, 1}};
  std::vector<std::uint32_t> m_first;
  std::vector<std::uint32_t> m_nearest;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_NEAREST_POINT_GRID_H
