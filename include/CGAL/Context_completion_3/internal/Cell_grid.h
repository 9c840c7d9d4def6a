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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_GRID_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_GRID_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// The root cell of a tree.
struct Cell_cube
{
  Vector lower = Vector::Zero();
  double side = 0;
};

/// The smallest cube around the bounding box, with the same centre.
inline Cell_cube bounding_cube(const std::vector<Vector>& positions)
{
  Cell_cube cube;
  if(positions.empty())
    return cube;
  Vector lower = positions.front(), upper = positions.front();
  for(const Vector& p : positions)
  {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  cube.side = (upper - lower).maxCoeff();
  cube.lower = 0.5 * (lower + upper) - Vector::Constant(0.5 * cube.side);
  return cube;
}

/// A little larger, and off the centre, so that what is flat or symmetric does not lie on the planes between cells:
/// a box test of closed cells would find it on both sides. The fractions are not sums of few powers of two.
inline Cell_cube offset_cube(const std::vector<Vector>& positions)
{
  Cell_cube cube = bounding_cube(positions);
  const double side = cube.side;
  cube.side *= 1.0371;
  cube.lower -= side * Vector(0.0127, 0.0191, 0.0233);
  return cube;
}

/// A cube around the bounding box whose side is `side` times a power of two, so that the cells of two trees can be
/// compared ("cells with the same size", section 6). \param doublings receives the exponent
inline Cell_cube commensurable_cube(const std::vector<Vector>& positions, double side, std::size_t& doublings)
{
  const Cell_cube tight = offset_cube(positions);
  Cell_cube cube = tight;
  cube.side = side;
  for(doublings = 0; side > 0 && cube.side < tight.side; ++doublings)
    cube.side *= 2;
  cube.lower -= Vector::Constant(0.5 * (cube.side - tight.side));
  return cube;
}

/*!
  The geometry of the cells of a cube. The planes of the grid are a function of their position alone, whatever level
  asks for them: `side / 2^level` is exact, so neighbouring cells of any sizes share their faces bit for bit.
*/
class Cell_grid
{
public:
  /// \param finest level of the codes, at most `Cell::maximum_level`
  Cell_grid(const Cell_cube& cube, std::size_t finest)
    : m_cube(cube), m_finest((std::min)(finest, std::size_t(Cell::maximum_level)))
  {}

  const Cell_cube& cube() const { return m_cube; }
  std::size_t finest() const { return m_finest; }
  double edge(std::size_t level) const { return std::ldexp(m_cube.side, -int(level)); }

  /// The k-th plane, 0 to 2^level, of the given level and axis.
  double plane(std::size_t level, std::uint64_t k, std::size_t axis) const
  {
    return m_cube.lower[Eigen::Index(axis)] + double(k) * edge(level);
  }

  Vector lower(const Cell& cell) const
  {
    return Vector(plane(cell.level, cell.coordinates[0], 0), plane(cell.level, cell.coordinates[1], 1),
                  plane(cell.level, cell.coordinates[2], 2));
  }

  Vector upper(const Cell& cell) const
  {
    return Vector(plane(cell.level, std::uint64_t(cell.coordinates[0]) + 1, 0),
                  plane(cell.level, std::uint64_t(cell.coordinates[1]) + 1, 1),
                  plane(cell.level, std::uint64_t(cell.coordinates[2]) + 1, 2));
  }

  Vector center(const Cell& cell) const { return 0.5 * (lower(cell) + upper(cell)); }

  Bbox_3 bbox(const Cell& cell) const
  {
    const Vector l = lower(cell), u = upper(cell);
    return Bbox_3(l.x(), l.y(), l.z(), u.x(), u.y(), u.z());
  }

  /// The cell of the finest level that holds the position: closed below, open above; positions outside the cube
  /// belong to the outermost cells.
  Cell finest_cell(const Vector& p) const
  {
    Cell cell;
    cell.level = m_finest;
    const std::int64_t size = std::int64_t(1) << m_finest;
    for(std::size_t d = 0; d < 3; ++d)
    {
      const double step = edge(m_finest);
      std::int64_t k = 0;
      if(step > 0)
      {
        const double guess = std::floor((p[Eigen::Index(d)] - m_cube.lower[Eigen::Index(d)]) / step);
        k = std::int64_t((std::min)((std::max)(guess, 0.), double(size - 1)));
        while(k > 0 && p[Eigen::Index(d)] < plane(m_finest, std::uint64_t(k), d))
          --k;
        while(k + 1 < size && p[Eigen::Index(d)] >= plane(m_finest, std::uint64_t(k) + 1, d))
          ++k;
      }
      cell.coordinates[d] = std::uint32_t(k);
    }
    return cell;
  }

  std::uint64_t finest_code(const Vector& p) const { return morton_code(finest_cell(p).coordinates); }

  /// First and one past the last code of the finest level inside the cell.
  std::pair<std::uint64_t, std::uint64_t> code_range(const Cell& cell) const
  {
    const std::uint64_t first = morton_code(cell.coordinates), shift = 3 * (m_finest - cell.level);
    return std::make_pair(first << shift, (first + 1) << shift);
  }

private:
  Cell_cube m_cube;
  std::size_t m_finest;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_GRID_H
