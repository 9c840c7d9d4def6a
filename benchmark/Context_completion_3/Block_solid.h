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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BLOCK_SOLID_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BLOCK_SOLID_H

#include "Model_surface.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace Completion_benchmark {

/*!
  The boundary of a union of boxes of a grid: planes that cross at right angles, sharp edges, convex and concave
  corners. `planes[d]` are the positions of the grid's planes along axis d, `is_solid` says which boxes are full.
*/
inline Benchmark_surface block_solid(const std::array<std::vector<double>, 3>& planes,
                                     const std::function<bool(int, int, int)>& is_solid)
{
  Benchmark_surface surface;
  std::map<std::array<int, 3>, std::size_t> index_of;
  const int size[3] = { int(planes[0].size()) - 1, int(planes[1].size()) - 1, int(planes[2].size()) - 1 };
  const auto is_full = [&](const std::array<int, 3>& c)
  {
    for(int d = 0; d < 3; ++d)
      if(c[d] < 0 || c[d] >= size[d])
        return false;
    return is_solid(c[0], c[1], c[2]);
  };
  const auto vertex = [&](const std::array<int, 3>& c)
  {
    const auto inserted = index_of.insert({ c, surface.vertices.size() });
    if(inserted.second)
      surface.vertices.emplace_back(planes[0][c[0]], planes[1][c[1]], planes[2][c[2]]);
    return inserted.first->second;
  };
  for(int i = 0; i < size[0]; ++i)
    for(int j = 0; j < size[1]; ++j)
      for(int k = 0; k < size[2]; ++k)
      {
        const std::array<int, 3> cell = { { i, j, k } };
        if(!is_full(cell))
          continue;
        for(int d = 0; d < 3; ++d)
          for(int side = 0; side < 2; ++side)
          {
            std::array<int, 3> neighbor = cell, a = cell;
            neighbor[d] += 2 * side - 1;
            if(is_full(neighbor))
              continue;
            a[d] += side;
            std::array<int, 3> b = a, c = a, e = a;          // counterclockwise around +d: a b c e
            ++b[(d + 1) % 3];
            ++c[(d + 1) % 3];
            ++c[(d + 2) % 3];
            ++e[(d + 2) % 3];
            if(side == 0)
              std::swap(b, e);
            const std::size_t v[4] = { vertex(a), vertex(b), vertex(c), vertex(e) };
            surface.faces.push_back({ v[0], v[1], v[2] });
            surface.faces.push_back({ v[0], v[2], v[3] });
          }
      }
  set_corner_normals(surface, 40.);
  return surface;
}

/// `number` + 1 planes from 0, with alternating distances `first` and `second`.
inline std::vector<double> alternating_planes(std::size_t number, double first, double second)
{
  std::vector<double> planes(1, 0.);
  for(std::size_t i = 0; i < number; ++i)
    planes.push_back(planes.back() + (i % 2 == 0 ? first : second));
  return planes;
}

inline Benchmark_surface staircase()
{
  return block_solid({ { alternating_planes(9, 0.2, 0.2), alternating_planes(3, 0.5, 0.4),
                         alternating_planes(9, 0.15, 0.15) } }, [](int i, int, int k) { return k <= i; });
}

inline Benchmark_surface comb()
{
  return block_solid({ { alternating_planes(15, 0.12, 0.16), alternating_planes(1, 0.9, 0.9),
                         alternating_planes(2, 0.2, 0.22) } }, [](int i, int, int k) { return k == 0 || i % 2 == 0; });
}

inline Benchmark_surface crossing_beams()
{
  return block_solid({ { alternating_planes(3, 0.7, 0.4), alternating_planes(3, 0.6, 0.4),
                         alternating_planes(3, 0.7, 0.3) } },
                     [](int i, int j, int k) { return (i == 1) + (j == 1) + (k == 1) >= 2; });
}

inline Benchmark_surface pegs()
{
  return block_solid({ { alternating_planes(13, 0.13, 0.17), alternating_planes(9, 0.13, 0.17),
                         alternating_planes(2, 0.2, 0.14) } },
                     [](int i, int j, int k) { return k == 0 || (i % 2 == 1 && j % 2 == 1); });
}

inline Benchmark_surface notched_frame()
{
  return block_solid({ { alternating_planes(11, 0.15, 0.15), alternating_planes(9, 0.15, 0.15),
                         alternating_planes(3, 0.12, 0.14) } },
    [](int i, int j, int k)
    {
      if(i >= 2 && i < 9 && j >= 2 && j < 7)
        return false;
      return k < 2 || (i % 2 == 0 && j % 2 == 0);
    });
}

inline Benchmark_surface stepped_bracket()
{
  return block_solid({ { alternating_planes(6, 0.22, 0.18), alternating_planes(5, 0.3, 0.1),
                         alternating_planes(6, 0.22, 0.18) } },
    [](int i, int j, int k) { return i == 0 || k == 0 || (j % 2 == 1 && i + k <= 4); });
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_BLOCK_SOLID_H
