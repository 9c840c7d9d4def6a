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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_H

#include <CGAL/license/Context_completion_3.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Offset of a neighbour: -1, 0 or 1 per axis.
typedef std::array<int, 3> Cell_offset;

/*!
  A cell of the full octree (section 5: "the full octree resulting from subdivision of the tree to maximum depth"):
  its level and its integer coordinates in the regular grid of that level. It need not be a node of the tree.
*/
struct Cell
{
  static constexpr std::size_t maximum_level = 20; ///< three coordinates of 20 bits fit in one code

  std::size_t level = 0;
  std::array<std::uint32_t, 3> coordinates = {{ 0, 0, 0 }};

  friend bool operator==(const Cell& a, const Cell& b)
  {
    return a.level == b.level && a.coordinates == b.coordinates;
  }
  friend bool operator!=(const Cell& a, const Cell& b) { return !(a == b); }
  friend bool operator<(const Cell& a, const Cell& b)
  {
    return a.level != b.level ? a.level < b.level : a.coordinates < b.coordinates;
  }

  /// The enclosing cell of the given level, which is not finer than this one.
  Cell ancestor(std::size_t coarser) const
  {
    Cell result;
    result.level = coarser;
    for(std::size_t d = 0; d < 3; ++d)
      result.coordinates[d] = coordinates[d] >> (level - coarser);
    return result;
  }

  /// \pre level > 0
  Cell parent() const { return ancestor(level - 1); }

  /// Bits 0, 1, 2 of `i` choose the upper half in x, y, z, as in CGAL's octree.
  Cell child(std::size_t i) const
  {
    Cell result;
    result.level = level + 1;
    for(std::size_t d = 0; d < 3; ++d)
      result.coordinates[d] = 2 * coordinates[d] + ((i >> d) & 1);
    return result;
  }

  /// Whether the cell beside this one lies in the root cube, too.
  bool has_neighbor(const Cell_offset& offset) const
  {
    const std::int64_t size = std::int64_t(1) << level;
    for(std::size_t d = 0; d < 3; ++d)
    {
      const std::int64_t c = std::int64_t(coordinates[d]) + offset[d];
      if(c < 0 || c >= size)
        return false;
    }
    return true;
  }

  /// \pre has_neighbor(offset)
  Cell neighbor(const Cell_offset& offset) const
  {
    Cell result = *this;
    for(std::size_t d = 0; d < 3; ++d)
      result.coordinates[d] = std::uint32_t(std::int64_t(coordinates[d]) + offset[d]);
    return result;
  }
};

/// The 27 offsets, x fastest; number 13 is the cell itself.
inline Cell_offset cell_offset(std::size_t i)
{
  return {{ int(i % 3) - 1, int(i / 3 % 3) - 1, int(i / 9) - 1 }};
}

/// Inverse of `cell_offset()`.
inline std::size_t offset_index(const Cell_offset& offset)
{
  return std::size_t((offset[0] + 1) + 3 * (offset[1] + 1) + 9 * (offset[2] + 1));
}

static constexpr std::size_t own_offset = 13; ///< index of the offset (0, 0, 0)

/// Interleaved bits, x lowest: the codes of a cell's descendants of one level are contiguous.
inline std::uint64_t morton_code(const std::array<std::uint32_t, 3>& coordinates)
{
  std::uint64_t code = 0;
  for(std::size_t bit = 0; bit < 21; ++bit)
    for(std::size_t d = 0; d < 3; ++d)
      code |= std::uint64_t((coordinates[d] >> bit) & 1) << (3 * bit + d);
  return code;
}

/// Inverse of `morton_code()`.
inline std::array<std::uint32_t, 3> morton_coordinates(std::uint64_t code)
{
  std::array<std::uint32_t, 3> coordinates = {{ 0, 0, 0 }};
  for(std::size_t bit = 0; bit < 21; ++bit)
    for(std::size_t d = 0; d < 3; ++d)
      coordinates[d] |= std::uint32_t((code >> (3 * bit + d)) & 1) << bit;
  return coordinates;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_H
