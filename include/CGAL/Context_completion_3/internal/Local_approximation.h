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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_APPROXIMATION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_APPROXIMATION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Quadric_3.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  A local approximation f of the surface (sections 3 and 4): one quadric, or several joined by maxima and minima at
  sharp edges and corners. f is positive on the side that the normals point to.

  The members are joined from the left, ((q0 op1 q1) op2 q2) op3 q3, which covers every case of the fits: a convex
  edge is the maximum of its two sides, a concave one the minimum, and at a corner of three faces two pairs are always
  of one kind.
*/
class Local_approximation
{
public:
  enum class Kind { none, plane, general, bivariate, edge, corner };
  enum class Operation { maximum, minimum };

  Local_approximation() {}
  Local_approximation(Kind kind, const Quadric& q) : m_kind(kind), m_members(1, q) {}

  void join(Kind kind, Operation operation, const Quadric& q)
  {
    m_kind = kind;
    m_operations.push_back(operation);
    m_members.push_back(q);
  }

  bool is_empty() const { return m_members.empty(); }
  Kind kind() const { return m_kind; }

  /// The quadrics. The zero set of a maximum or minimum is a part of the union of theirs, so a box that meets no
  /// member's zero set does not meet {f = 0}; the converse may fail.
  const std::vector<Quadric>& members() const { return m_members; }

  /// \pre !is_empty()
  double value(const Vector& p) const { return active(p).second; }

  /// Of the member that decides. \pre !is_empty()
  Vector gradient(const Vector& p) const { return internal::gradient(m_members[active(p).first], p); }

  /// Signed distance to {f = 0} of first order. \pre !is_empty()
  double distance(const Vector& p) const
  {
    const std::pair<std::size_t, double> found = active(p);
    return taubin_distance(found.second, internal::gradient(m_members[found.first], p));
  }

  /// max |f| / |grad f| over some points, the error of sections 3 and 4. \pre !is_empty()
  template <typename IndexRange>
  double error(const Surface_points& surface, const IndexRange& indices) const
  {
    double largest = 0;
    for(std::size_t i : indices)
      largest = (std::max)(largest, std::abs(distance(surface.position[i])));
    return largest;
  }

private:
  std::pair<std::size_t, double> active(const Vector& p) const
  {
    std::pair<std::size_t, double> result(0, internal::value(m_members[0], p));
    for(std::size_t i = 1; i < m_members.size(); ++i)
    {
      const double f = internal::value(m_members[i], p);
      if(m_operations[i - 1] == Operation::maximum ? f > result.second : f < result.second)
        result = std::make_pair(i, f);
    }
    return result;
  }

  Kind m_kind = Kind::none;
  std::vector<Quadric> m_members;
  std::vector<Operation> m_operations;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_LOCAL_APPROXIMATION_H
