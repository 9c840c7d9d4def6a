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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_PIECE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_PIECE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// What is known or settled near a piece: what its filling has to fit to.
struct Piece_controls
{
  std::vector<double> centers;           ///< weight of each centre around the hole, 0 of those far from the piece
  std::vector<std::size_t> rim;          ///< centres at the rim that are near
  std::vector<std::size_t> settled;      ///< samples that a finer level has filled
  double known_share = 0;                ///< of the surroundings of the piece
};

/// A part of a hole that a finer level fills on its own.
struct Hole_piece
{
  std::size_t number = 0;                ///< among the pieces of its level
  std::size_t middle = 0;                ///< sample of the base
  double radius = 0;
  std::vector<std::size_t> samples;      ///< of the base, within the radius and a few spacings
  std::vector<double> weights;           ///< parallel to it: 1 in the middle, 0 from the radius on
};

/*!
  Pieces of a hole, each as large as a cell of its level, that overlap: a partition of the base for the finer levels of
  the loop (paper, section 4). Their middles are samples of the base, so they do not depend on how the model lies in
  space.
*/
template <typename ConcurrencyTag>
class Hole_pieces
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

public:
  /// \param samples search structure over the samples of the base
  Hole_pieces(const Patch& patch, const Neighbor_search& samples) : m_patch(patch), m_samples(samples) {}

  /// Width of the surroundings that a piece is matched by.
  static double width(double radius, double spacing) { return (std::max)(4 * spacing, 0.6 * radius); }

  /// \param radius of the pieces
  std::vector<Hole_piece> of_radius(double radius) const
  {
    const double distance = 0.7 * radius, halo = 2.5 * m_patch.spacing();
    std::vector<Hole_piece> pieces;
    Point_grid grid(distance);
    for(std::size_t s = 0; s < m_patch.samples().size(); ++s)
    {
      const Base_sample& sample = m_patch.samples()[s];
      bool is_free = sample.is_uncovered;
      grid.for_each_in_ball(sample.position, distance, [&](std::size_t p, double) {
        is_free = is_free && !is_same_side(m_patch.samples()[pieces[p].middle].normal, sample.normal);
        return is_free; });
      if(!is_free)
        continue;
      grid.insert(sample.position);
      Hole_piece piece;
      piece.number = pieces.size();
      piece.middle = s;
      piece.radius = radius;
      std::vector<std::size_t> ball;
      m_samples.in_ball(sample.position, radius + halo, ball);
      for(std::size_t t : ball)
      {
        if(!is_same_side(sample.normal, m_patch.samples()[t].normal))
          continue;
        const double r = (m_patch.samples()[t].position - sample.position).norm() / radius;
        const double x = (std::max)(0., (std::min)(1., (1 - r) / 0.4));
        piece.samples.push_back(t);
        piece.weights.push_back(x * x * (3 - 2 * x));
      }
      pieces.push_back(piece);
    }
    return pieces;
  }

  /// What a piece has to fit to. The known share compares centres and settled samples with the samples inside that are
  /// open; with half a rim and nothing settled it is about a half.
  /// \param settled_by per sample: number of the piece that has filled it on this level, or `no_index`; what the piece
  ///        itself has filled is not known to it
  Piece_controls controls(const Hole_piece& piece, const std::vector<std::size_t>& settled_by) const
  {
    const Base_sample& middle = m_patch.samples()[piece.middle];
    const double width = Hole_pieces::width(piece.radius, m_patch.spacing());
    Piece_controls result;
    result.centers.assign(m_patch.centers().size(), 0.);
    // a centre at the rim stands for what is behind it, too
    double known = 0, unknown = 0;
    for(std::size_t i = 0; i < m_patch.centers().size(); ++i)
    {
      const Base_center& c = m_patch.centers()[i];
      const double distance = (c.position - middle.position).norm() - piece.radius;
      if(distance > width || !is_same_side(c.normal, middle.normal))
        continue;
      result.centers[i] = std::exp(-((std::max)(0., distance) + c.distance) / (0.4 * piece.radius));
      if(c.distance < 1.6 * m_patch.spacing())
      {
        result.rim.push_back(i);
        if(distance < 0)
          known += 2;
      }
    }
    std::vector<std::size_t> ball;
    m_samples.in_ball(middle.position, piece.radius + width, ball);
    Point_grid grid(1.5 * m_patch.spacing());
    for(std::size_t s : ball)
    {
      const Base_sample& sample = m_patch.samples()[s];
      if(!is_same_side(sample.normal, middle.normal))
        continue;
      if(settled_by[s] == no_index || settled_by[s] == piece.number)
      {
        unknown += (sample.position - middle.position).norm() < piece.radius ? 0.5 : 0;
        continue;
      }
      known += 1;
      bool is_free = true;
      grid.for_each_in_ball(sample.position, 1.5 * m_patch.spacing(), [&](std::size_t, double) {
        is_free = false;
        return false; });
      if(!is_free)
        continue;
      grid.insert(sample.position);
      result.settled.push_back(s);
    }
    result.known_share = known / (known + unknown + 1e-300);
    return result;
  }

private:
  const Patch& m_patch;
  const Neighbor_search& m_samples;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_HOLE_PIECE_H
