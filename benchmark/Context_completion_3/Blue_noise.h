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

#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BLUE_NOISE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BLUE_NOISE_H

#include "Benchmark_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace Completion_benchmark {

/// Buckets of points in the cells of a regular grid, for balls that are not much larger than a cell.
class Point_buckets
{
public:
  explicit Point_buckets(double cell_size) : m_size(cell_size) {}

  void insert(const Vector& p, std::size_t index) { m_cells[key(p, 0, 0, 0)].push_back(index); }

  /// Calls `visit(index)` for all points in the 27 cells around `p`, until it returns `false`.
  template <typename Visitor>
  void visit(const Vector& p, const Visitor& visit) const
  {
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
        {
          const auto cell = m_cells.find(key(p, x, y, z));
          if(cell == m_cells.end())
            continue;
          for(std::size_t i : cell->second)
            if(!visit(i))
              return;
        }
  }

private:
  std::uint64_t key(const Vector& p, int x, int y, int z) const
  {
    const auto cell = [this](double c, int shift)
      { return std::uint64_t(std::int64_t(std::floor(c / m_size)) + shift + (1 << 20)) & 0x1fffff; };
    return cell(p.x(), x) << 42 | cell(p.y(), y) << 21 | cell(p.z(), z);
  }

  double m_size;
  std::unordered_map<std::uint64_t, std::vector<std::size_t> > m_cells;
};

/*!
  Greedy Poisson-disk thinning in random order: indices of points of which no two on the same side of the surface are
  closer than the smaller of their radii.
*/
inline std::vector<std::size_t> thin_to_blue_noise(const Surface_points& points, const std::vector<double>& radius,
                                                   Random_source& random)
{
  std::vector<std::size_t> kept;
  if(points.size() == 0)
    return kept;
  Point_buckets buckets(*std::max_element(radius.begin(), radius.end()));
  for(std::size_t i : random.permutation(points.size()))
  {
    bool is_free = true;
    buckets.visit(points.position[i], [&](std::size_t j)
    {
      const double distance = (std::min)(radius[i], radius[j]);
      is_free = (points.position[i] - points.position[j]).squaredNorm() >= distance * distance
             || points.normal[i].dot(points.normal[j]) < -0.2;
      return is_free;
    });
    if(!is_free)
      continue;
    buckets.insert(points.position[i], i);
    kept.push_back(i);
  }
  return kept;
}

inline Surface_points subset(const Surface_points& points, const std::vector<std::size_t>& indices)
{
  Surface_points chosen;
  for(std::size_t i : indices)
    chosen.push_back(points.position[i], points.normal[i]);
  return chosen;
}

/// Blue noise on some faces of a surface; `factor` (at least 1) says how much coarser than `radius` it is at a place.
inline Surface_points blue_noise(const Benchmark_surface& surface, const std::vector<std::size_t>& faces, double radius,
                                 const std::function<double(const Vector&)>& factor, Random_source& random)
{
  double area = 0;
  for(std::size_t f : faces)
    area += 0.5 * surface.face_vector(f).norm();
  const std::size_t number = std::size_t((std::min)(8 * area / (radius * radius), 4e6)) + 1;
  const Surface_points samples = draw_samples(surface, faces, number, random);
  std::vector<double> radii(samples.size(), radius);
  if(factor)
    for(std::size_t i = 0; i < samples.size(); ++i)
      radii[i] = radius * factor(samples.position[i]);
  return subset(samples, thin_to_blue_noise(samples, radii, random));
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BLUE_NOISE_H
