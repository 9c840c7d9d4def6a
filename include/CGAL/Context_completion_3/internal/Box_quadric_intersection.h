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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_QUADRIC_INTERSECTION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_QUADRIC_INTERSECTION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Quadric_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Does {q = 0} meet a closed box? Exact, for every quadric and box of finite coordinates.

  q is continuous and the box connected, so it does exactly if min q <= 0 <= max q. If the corners differ in sign or
  one of them is zero, it does. Otherwise let all corners be positive (else negate q): the question is whether the
  minimum is <= 0. Among all faces of the box (edges, faces, the interior) that hold a minimiser in their relative
  interior take one of lowest dimension. The Hessian of q restricted to it is positive semidefinite there; were it
  singular, q would be constant along a line through the minimiser, up to a face of lower dimension. So it is
  positive definite and the minimiser is the one critical point, which Cramer's rule gives without a division.

  Written once over the number type: intervals decide nearly all, rationals the rest (tangency, degenerate quadrics).
*/
template <typename FT>
class Box_quadric_decision
{
public:
  /// In the coordinates u of the unit cube, x = lower + (upper - lower) u: q = c + b u + u H u / 2.
  Box_quadric_decision(const Quadric& q, const Bbox_3& box)
  {
    const FT lower[3] = { FT(box.xmin()), FT(box.ymin()), FT(box.zmin()) };
    const FT extent[3] = { FT(box.xmax()) - lower[0], FT(box.ymax()) - lower[1], FT(box.zmax()) - lower[2] };
    FT k[10];
    for(std::size_t i = 0; i < 10; ++i)
      k[i] = FT(q.c[i]);
    const FT h[3][3] = { { k[0] + k[0], k[3], k[4] }, { k[3], k[1] + k[1], k[5] }, { k[4], k[5], k[2] + k[2] } };
    m_constant = (k[0] * lower[0] + k[3] * lower[1] + k[4] * lower[2] + k[6]) * lower[0]
               + (k[1] * lower[1] + k[5] * lower[2] + k[7]) * lower[1] + (k[2] * lower[2] + k[8]) * lower[2] + k[9];
    for(int i = 0; i < 3; ++i)
    {
      m_linear[i] = (h[i][0] * lower[0] + h[i][1] * lower[1] + h[i][2] * lower[2] + k[6 + i]) * extent[i];
      for(int j = 0; j < 3; ++j)
        m_hessian[i][j] = h[i][j] * extent[i] * extent[j];
    }
  }

  Uncertain<bool> operator()()
  {
    bool positive = false, negative = false, unsure = false;
    for(int corner = 0; corner < 8; ++corner)
    {
      const FT twice = twice_value_at_corner(corner);
      if(CGAL::certainly(twice == FT(0)))
        return true;
      if(CGAL::certainly(twice > FT(0)))
        positive = true;
      else if(CGAL::certainly(twice < FT(0)))
        negative = true;
      else
        unsure = true;
    }
    if(positive && negative)
      return true;
    if(unsure)
      return Uncertain<bool>::indeterminate();
    if(negative)
      negate();
    for(int free = 1; free < 8; ++free)
      for(int fixed = 0; fixed < 8; ++fixed)
      {
        if((free & fixed) != 0) // `fixed`: the upper ones among the axes that are not free
          continue;
        const Uncertain<bool> found = has_nonpositive_minimum(free, fixed);
        if(CGAL::certainly(found))
          return true;
        unsure = unsure || CGAL::possibly(found);
      }
    return unsure ? Uncertain<bool>::indeterminate() : Uncertain<bool>(false);
  }

private:
  FT twice_value_at_corner(int corner) const
  {
    FT result = m_constant + m_constant;
    for(int i = 0; i < 3; ++i)
    {
      if(((corner >> i) & 1) == 0)
        continue;
      result = result + m_linear[i] + m_linear[i];
      for(int j = 0; j < 3; ++j)
        if(((corner >> j) & 1) != 0)
          result = result + m_hessian[i][j];
    }
    return result;
  }

  void negate()
  {
    m_constant = -m_constant;
    for(int i = 0; i < 3; ++i)
    {
      m_linear[i] = -m_linear[i];
      for(int j = 0; j < 3; ++j)
        m_hessian[i][j] = -m_hessian[i][j];
    }
  }

  // A critical point `numerator / determinant` counts if the leading minors are positive (a strict minimum), it lies
  // in the closed face, and the value there is not positive.
  class Conditions
  {
  public:
    template <typename Bool>
    bool require(const Bool& condition)
    {
      m_sure = m_sure && CGAL::certainly(condition);
      m_possible = m_possible && CGAL::possibly(condition);
      return m_possible;
    }
    Uncertain<bool> result() const
    {
      return m_sure ? Uncertain<bool>(true)
                    : m_possible ? Uncertain<bool>::indeterminate() : Uncertain<bool>(false);
    }
  private:
    bool m_sure = true, m_possible = true;
  };

  Uncertain<bool> has_nonpositive_minimum(int free, int fixed) const
  {
    int axis[3], n = 0;
    for(int i = 0; i < 3; ++i)
      if(((free >> i) & 1) != 0)
        axis[n++] = i;
    FT gradient[3];
    for(int k = 0; k < n; ++k)
    {
      gradient[k] = m_linear[axis[k]];
      for(int j = 0; j < 3; ++j)
        if(((fixed >> j) & 1) != 0)
          gradient[k] = gradient[k] + m_hessian[axis[k]][j];
    }
    const FT zero(0), twice_constant = twice_value_at_corner(fixed);
    const FT& h00 = m_hessian[axis[0]][axis[0]];
    Conditions conditions;
    if(!conditions.require(h00 > zero))
      return conditions.result();
    FT determinant = h00, numerator[3];
    if(n == 1)
      numerator[0] = -gradient[0];
    else
    {
      const FT& h01 = m_hessian[axis[0]][axis[1]];
      const FT& h11 = m_hessian[axis[1]][axis[1]];
      const FT minor = h00 * h11 - h01 * h01;
      if(!conditions.require(h11 > zero) || !conditions.require(minor > zero))
        return conditions.result();
      if(n == 2)
      {
        determinant = minor;
        numerator[0] = gradient[1] * h01 - gradient[0] * h11;
        numerator[1] = gradient[0] * h01 - gradient[1] * h00;
      }
      else
      {
        const FT& h02 = m_hessian[axis[0]][axis[2]];
        const FT& h12 = m_hessian[axis[1]][axis[2]];
        const FT& h22 = m_hessian[axis[2]][axis[2]];
        const FT a00 = h11 * h22 - h12 * h12, a01 = h02 * h12 - h01 * h22, a02 = h01 * h12 - h02 * h11,
                 a11 = h00 * h22 - h02 * h02, a12 = h01 * h02 - h00 * h12;
        determinant = h00 * a00 + h01 * a01 + h02 * a02;
        numerator[0] = -(a00 * gradient[0] + a01 * gradient[1] + a02 * gradient[2]);
        numerator[1] = -(a01 * gradient[0] + a11 * gradient[1] + a12 * gradient[2]);
        numerator[2] = -(a02 * gradient[0] + a12 * gradient[1] + minor * gradient[2]);
        if(!conditions.require(determinant > zero))
          return conditions.result();
      }
    }
    FT twice_value = twice_constant * determinant;
    for(int k = 0; k < n; ++k)
    {
      if(!conditions.require(numerator[k] >= zero) || !conditions.require(numerator[k] <= determinant))
        return conditions.result();
      twice_value = twice_value + gradient[k] * numerator[k];
    }
    conditions.require(twice_value <= zero);
    return conditions.result();
  }

  FT m_constant, m_linear[3], m_hessian[3][3];
};

/// Whether {q = 0} meets the closed box, exactly. \pre finite coefficients and coordinates
inline bool do_intersect_exactly(const Quadric& q, const Bbox_3& box)
{
  {
    Protect_FPU_rounding<true> protection;
    const Uncertain<bool> filtered = Box_quadric_decision<Interval_nt<false> >(q, box)();
    if(CGAL::is_certain(filtered))
      return CGAL::get_certain(filtered);
  }
  return CGAL::get_certain(Box_quadric_decision<Exact_rational>(q, box)());
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BOX_QUADRIC_INTERSECTION_H
