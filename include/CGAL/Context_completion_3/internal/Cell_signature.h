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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SIGNATURE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SIGNATURE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell_surface.h>
#include <CGAL/Context_completion_3/internal/Cell_symmetry.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The signature of a cell (section 6.1) as one flat vector: signed distances and directions at 27 points in the cell,
  by the approximation of the parent; the same at the centres of the 27 cells around it, each by its own
  approximation; the depths of the subtrees of the valid adjacent cells.

  What the paper leaves open is settled so:
  - distances carry the sign of f (it says "signed" and writes absolute values), in units of the cell's edge, and end
    at two edges: farther away a low-degree fit knows nothing, and cells of all levels become comparable;
  - directions are gradients of unit length (raw gradients depend on how a fit was scaled), zero where there is none;
  - an adjacent cell without an approximation lends its place to the parent's of the cell in the middle, which is all
    that is known of the surface there; so every signature has all components;
  - a parent without an approximation is replaced by its nearest ancestor that has one;
  - depths exist for valid adjacent cells alone; the others hold `undefined_detail`.
*/
struct Cell_signature
{
  static constexpr int inner_distance = 0, inner_direction = 27, outer_distance = 108, outer_direction = 135,
                       detail = 216, size = 243;
  static constexpr float undefined_detail = -1;
  static constexpr double farthest = 2;

  typedef Eigen::Matrix<float, size, 1, Eigen::DontAlign> Components;
  Components vector = Components::Zero();

  /// Writes the distance and direction of `f` at `p`, directions along the columns of `axes`.
  void write(const Local_approximation& f, const Vector& p, double edge, const Matrix& axes, int distance,
             int direction)
  {
    const double d = edge > 0 ? f.distance(p) / edge : 0.;
    vector[distance] = float((std::min)((std::max)(d, -farthest), farthest));
    const Vector g = axes.transpose() * f.gradient(p);
    const double length = g.norm();
    if(length > 0)
      for(int k = 0; k < 3; ++k)
        vector[direction + k] = float(g[k] / length);
  }

  /// The signature of the cell whose content is this one's, moved by the symmetry.
  Cell_signature transformed(const Cell_symmetry& symmetry) const
  {
    const auto turn = [&](int from, int to, Components& turned)
    {
      for(int r = 0; r < 3; ++r)
        for(int c = 0; c < 3; ++c)
          turned[to + r] += float(symmetry.matrix()(r, c)) * vector[from + c];
    };
    Cell_signature result;
    for(std::size_t i = 0; i < 27; ++i)
    {
      const int from = int(i), to = int(symmetry.image(i));
      result.vector[inner_distance + to] = vector[inner_distance + from];
      result.vector[outer_distance + to] = vector[outer_distance + from];
      result.vector[detail + to] = vector[detail + from];
      turn(inner_direction + 3 * from, inner_direction + 3 * to, result.vector);
      turn(outer_direction + 3 * from, outer_direction + 3 * to, result.vector);
    }
    return result;
  }
};

/// \pre the surface holds a point
inline Cell_signature cell_signature(const Cell_surface& surface, const Cell& cell)
{
  Cell_signature signature;
  const Local_approximation* parent = surface.find_coarser(cell);
  if(parent == nullptr) // the root has no parent
    parent = surface.find(cell);
  const double edge = surface.grid().edge(cell.level);
  const Vector center = surface.grid().center(cell);
  const Matrix axes = Matrix::Identity();
  for(std::size_t i = 0; i < 27; ++i)
  {
    const int k = int(i);
    const Cell_offset offset = cell_offset(i);
    const Vector step = edge * Vector(offset[0], offset[1], offset[2]);
    signature.write(*parent, center + 0.5 * step, edge, axes,
                    Cell_signature::inner_distance + k, Cell_signature::inner_direction + 3 * k);
    const bool exists = cell.has_neighbor(offset);
    const Local_approximation* own = exists ? surface.find(cell.neighbor(offset)) : nullptr;
    signature.write(own != nullptr ? *own : *parent, center + step, edge, axes,
                    Cell_signature::outer_distance + k, Cell_signature::outer_direction + 3 * k);
    signature.vector[Cell_signature::detail + k] = i != own_offset && exists && surface.is_valid(cell.neighbor(offset))
      ? float(surface.tree().subtree_depth(cell.neighbor(offset))) : Cell_signature::undefined_detail;
  }
  return signature;
}

/// Weights of equations 1 to 3 on one level.
struct Signature_weights
{
  double inner = 0.5;      ///< w_i
  double distance = 0.5;   ///< w_d (once called w_s in section 6.2)
  double detail = 0.1;     ///< w_l

  /// w_i rises from 0.3 at the root to 0.7 at the finest level: "we increase w_i with the decreasing distance to the
  /// maximum depth".
  static Signature_weights of_level(double level, double finest)
  {
    Signature_weights weights;
    const double share = finest > 0 ? level / finest : 1.;
    weights.inner = 0.3 + 0.4 * (std::min)(1., (std::max)(0., share));
    return weights;
  }
};

/// Equations 1 to 3.
inline double signature_distance(const Cell_signature::Components& a, const Cell_signature::Components& b,
                                 const Signature_weights& weights)
{
  typedef Cell_signature S;
  typedef Eigen::Map<const Eigen::VectorXf> Part;
  const auto norm = [&](int first, int number)
    { return double((Part(a.data() + first, number) - Part(b.data() + first, number)).norm()); };
  const auto part = [&](int distances, int directions)
    { return weights.distance * norm(distances, 27) + (1 - weights.distance) * norm(directions, 81); };
  double squared_detail = 0; // over the elements defined in both
  for(int i = S::detail; i < S::size; ++i)
    if(a[i] >= 0 && b[i] >= 0)
      squared_detail += double((a[i] - b[i]) * (a[i] - b[i]));
  return weights.inner * part(S::inner_distance, S::inner_direction)
       + (1 - weights.inner) * part(S::outer_distance, S::outer_direction)
       + weights.detail * std::sqrt(squared_detail);
}

inline double signature_distance(const Cell_signature& a, const Cell_signature& b, const Signature_weights& weights)
{
  return signature_distance(a.vector, b.vector, weights);
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CELL_SIGNATURE_H
