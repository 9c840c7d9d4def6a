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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRIC_3_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRIC_3_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A trivariate quadratic polynomial; coefficients of xx yy zz xy xz yz x y z 1.
template <typename FT>
struct Quadric_3
{
  std::array<FT, 10> c = {};

  FT operator()(const FT& x, const FT& y, const FT& z) const
  {
    return (c[0] * x + c[3] * y + c[4] * z + c[6]) * x + (c[1] * y + c[5] * z + c[7]) * y
         + (c[2] * z + c[8]) * z + c[9];
  }
};

typedef Quadric_3<double> Quadric;

inline double value(const Quadric& q, const Vector& p)
{
  return q(p.x(), p.y(), p.z());
}

inline Vector gradient(const Quadric& q, const Vector& p)
{
  return Vector(2 * q.c[0] * p.x() + q.c[3] * p.y() + q.c[4] * p.z() + q.c[6],
                q.c[3] * p.x() + 2 * q.c[1] * p.y() + q.c[5] * p.z() + q.c[7],
                q.c[4] * p.x() + q.c[5] * p.y() + 2 * q.c[2] * p.z() + q.c[8]);
}

/*!
  Taubin's first-order distance f / |grad f| (section 4), with the sign of f. Where the gradient vanishes and f does
  not (the centre of a sphere), the first order knows no distance: the largest finite number stands for "far".
*/
inline double taubin_distance(double f, const Vector& g)
{
  const double length = g.norm(), far = (std::numeric_limits<double>::max)();
  if(f == 0)
    return 0;
  if(std::abs(f) < far * (std::min)(length, 1.))
    return f / length;
  return std::copysign(far, f);
}

inline double taubin_distance(const Quadric& q, const Vector& p)
{
  return taubin_distance(value(q, p), gradient(q, p));
}

/// The quadric s (y^T A y + b^T y + c) with y = (x - o) / s, A symmetric.
inline Quadric make_quadric(const Matrix& a, const Vector& b, double c, const Vector& o, double s)
{
  const Matrix a_world = a / s;
  const Vector b_world = b - 2 * (a_world * o);
  const double c_world = s * c - b.dot(o) + o.dot(a_world * o);
  Quadric q;
  q.c = {{ a_world(0, 0), a_world(1, 1), a_world(2, 2), 2 * a_world(0, 1), 2 * a_world(0, 2), 2 * a_world(1, 2),
           b_world.x(), b_world.y(), b_world.z(), c_world }};
  return q;
}

/// The plane through `o` with normal `n`.
inline Quadric make_plane_quadric(const Vector& o, const Vector& n)
{
  return make_quadric(Matrix::Zero(), n, 0, o, 1);
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_QUADRIC_3_H
