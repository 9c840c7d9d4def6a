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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_SHARP_FIT_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_SHARP_FIT_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Local_approximation.h>
#include <CGAL/Context_completion_3/internal/Quadric_fit.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>


#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Piecewise fits for sharp edges and corners of degree 3 and 4, by the tests and constants of the multi-level
  partition of unity: normals that differ by less than acos 0.9 are one smooth piece; two pieces whose normals span a
  plane from which no normal rises above 0.7 make an edge, otherwise a corner.
*/
class Sharp_fit
{
public:
  static constexpr double smooth_cosine = 0.9;
  static constexpr double corner_sine = 0.7;

  /// \return an edge or corner, or an empty approximation where the points are smooth or the corner has no unique
  /// reading (degree 4 with convex and concave edges)
  static Local_approximation fit(const Fit_data& data)
  {
    std::size_t first = 0, second = 0;
    std::vector<std::size_t> all(data.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      all[i] = i;
    if(!find_extremes(data, all, first, second))
      return Local_approximation();
    const Vector n1 = data.normal(first), n2 = data.normal(second);
    const Vector cross = n1.cross(n2);
    // opposite normals span no plane: a thin plate, not an edge
    if(cross.norm() < 1e-6)
      return Local_approximation();
    const Vector n3 = cross.normalized();
    double rise = 0;
    for(std::size_t i : all)
      rise = (std::max)(rise, std::abs(data.normal(i).dot(n3)));

    std::vector<std::vector<std::size_t> > clusters(2);
    std::vector<std::size_t> rising;
    for(std::size_t i : all)
    {
      const double d1 = data.normal(i).dot(n1), d2 = data.normal(i).dot(n2), d3 = std::abs(data.normal(i).dot(n3));
      if(rise >= corner_sine && d3 > d1 && d3 > d2)
        rising.push_back(i);
      else
        clusters[d1 >= d2 ? 0 : 1].push_back(i);
    }
    if(!rising.empty())
    {
      std::size_t third = 0, fourth = 0;
      if(find_extremes(data, rising, third, fourth))
      {
        clusters.resize(4);
        for(std::size_t i : rising)
          clusters[data.normal(i).dot(data.normal(third)) >= data.normal(i).dot(data.normal(fourth)) ? 2 : 3]
            .push_back(i);
      }
      else
        clusters.push_back(rising);
    }
    return join(data, clusters);
  }

private:
  typedef Local_approximation::Operation Operation;

  // the pair of least dot product; false if all agree to within the smooth angle
  static bool find_extremes(const Fit_data& data, const std::vector<std::size_t>& among,
                            std::size_t& first, std::size_t& second)
  {
    double least = smooth_cosine;
    bool found = false;
    for(std::size_t i = 0; i < among.size(); ++i)
      for(std::size_t j = i + 1; j < among.size(); ++j)
      {
        const double dot = data.normal(among[i]).dot(data.normal(among[j]));
        if(dot >= least)
          continue;
        least = dot;
        first = among[i];
        second = among[j];
        found = true;
      }
    return found;
  }

  struct Piece
  {
    Vector mean, normal;
    Quadric quadric;
  };

  static Local_approximation join(const Fit_data& data, const std::vector<std::vector<std::size_t> >& clusters)
  {
    std::vector<Piece> pieces;
    for(const std::vector<std::size_t>& cluster : clusters)
    {
      if(cluster.empty())
        return Local_approximation();
      Fit_data part;
      part.surface = data.surface;
      part.center = data.center;
      part.half_edge = data.half_edge;
      for(std::size_t i : cluster)
      {
        part.indices.push_back(data.indices[i]);
        part.weights.push_back(data.weights[i]);
      }
      pieces.push_back(Piece{ part.mean_position(), part.mean_normal(),
                              fit_bivariate_quadric(part, part.size() < 6, 1e-3) });
    }
    if(pieces.size() == 2)
    {
      Local_approximation edge(Local_approximation::Kind::edge, pieces[0].quadric);
      edge.join(Local_approximation::Kind::edge, operation(pieces[0], pieces[1]), pieces[1].quadric);
      return edge;
    }
    return pieces.size() == 3 ? join_three(pieces) : join_four(pieces);
  }

  // Convex if the normals lean away from each other: the two angles between the line of the means and the normals
  // add up to less than pi.
  static Operation operation(const Piece& a, const Piece& b)
  {
    return angle(a.mean - b.mean, a.normal) + angle(b.mean - a.mean, b.normal) < CGAL_PI
         ? Operation::maximum : Operation::minimum;
  }

  static double angle(const Vector& a, const Vector& b)
  {
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  // Of three pairs two are of one kind; they share a piece, which is joined last.
  static Local_approximation join_three(const std::vector<Piece>& pieces)
  {
    for(std::size_t last = 0; last < 3; ++last)
    {
      const Piece& a = pieces[(last + 1) % 3];
      const Piece& b = pieces[(last + 2) % 3];
      const Operation with_a = operation(pieces[last], a);
      if(with_a != operation(pieces[last], b))
        continue;
      Local_approximation corner(Local_approximation::Kind::corner, a.quadric);
      corner.join(Local_approximation::Kind::corner, operation(a, b), b.quadric);
      corner.join(Local_approximation::Kind::corner, with_a, pieces[last].quadric);
      return corner;
    }
    return Local_approximation();
  }

  static Local_approximation join_four(const std::vector<Piece>& pieces)
  {
    const Operation first = operation(pieces[0], pieces[1]);
    Local_approximation corner(Local_approximation::Kind::corner, pieces[0].quadric);
    for(std::size_t i = 1; i < 4; ++i)
    {
      for(std::size_t j = 0; j < i; ++j)
        if(operation(pieces[i], pieces[j]) != first)
          return Local_approximation();
      corner.join(Local_approximation::Kind::corner, first, pieces[i].quadric);
    }
    return corner;
  }
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_SHARP_FIT_H
