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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SYMMETRY_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SYMMETRY_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <Eigen/LU>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  One element of the symmetry group of a cube: an orthogonal matrix of signs, and what it does to the 27 symmetrically
  placed points of a cell (section 6.1) or, which is the same, to the 27 offsets of adjacent cells.
*/
class Cell_symmetry
{
public:
  /// The identity.
  Cell_symmetry() : Cell_symmetry(Matrix::Identity()) {}

  /// \pre a signed permutation matrix
  explicit Cell_symmetry(const Matrix& matrix)
    : m_matrix(matrix)
  {
    for(std::size_t i = 0; i < 27; ++i)
    {
      const Cell_offset from = cell_offset(i);
      const Vector to = matrix * Vector(from[0], from[1], from[2]);
      m_image[i] = offset_index(Cell_offset{{ rounded(to.x()), rounded(to.y()), rounded(to.z()) }});
    }
  }

  /// Acts on points relative to the centre of the cell, and on normals: a normal that points outward still does after
  /// a reflection.
  const Matrix& matrix() const { return m_matrix; }

  /// Where the i-th of the 27 places goes.
  std::size_t image(std::size_t i) const { return m_image[i]; }

  bool is_reflection() const { return m_matrix.determinant() < 0; }

  Cell_symmetry inverse() const { return Cell_symmetry(m_matrix.transpose()); }

private:
  static int rounded(double x) { return x > 0.5 ? 1 : x < -0.5 ? -1 : 0; }

  Matrix m_matrix;
  std::array<std::size_t, 27> m_image;
};

/// The paper's group (section 6.3): "rotations of the cell by pi around the canonical axes and reflections", the eight
/// changes of signs, the identity first. Without mirrors its four rotations.
inline std::vector<Cell_symmetry> paper_symmetry_group(bool mirror = true)
{
  std::vector<Cell_symmetry> group;
  for(int signs = 0; signs < 8; ++signs)
  {
    const Vector diagonal(signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1);
    if(mirror || diagonal.prod() > 0)
      group.push_back(Cell_symmetry(diagonal.asDiagonal()));
  }
  return group;
}

/// All 48 symmetries of a cube, the identity first; without mirrors its 24 rotations.
inline std::vector<Cell_symmetry> full_symmetry_group(bool mirror = true)
{
  static const int permutations[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 },
                                          { 1, 2, 0 }, { 2, 0, 1 }, { 2, 1, 0 } };
  std::vector<Cell_symmetry> group;
  for(const int (&permutation)[3] : permutations)
    for(int signs = 0; signs < 8; ++signs)
    {
      Matrix matrix = Matrix::Zero();
      for(int d = 0; d < 3; ++d)
        matrix(d, permutation[d]) = (signs >> d) & 1 ? -1 : 1;
      const Cell_symmetry symmetry(matrix);
      if(mirror || !symmetry.is_reflection())
        group.push_back(symmetry);
    }
  return group;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SYMMETRY_H
