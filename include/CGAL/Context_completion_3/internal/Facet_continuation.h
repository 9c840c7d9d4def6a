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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_CONTINUATION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_CONTINUATION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Facet.h>
#include <CGAL/Context_completion_3/internal/Facet_segmentation.h>
#include <CGAL/Context_completion_3/internal/Sharp_fit.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Continues sharp edges into a hole: the facets around it go on until they meet.

  Which of them bounds the solid where, convex and concave edges alike, the surroundings tell. The facets divide space
  into cells, one for each combination of sides; a cell is inside or outside by the points of the surroundings, moved
  to either side of the surface, that lie in it. The surface goes along a facet where it parts a cell inside from one
  outside. A cell that reaches no rim takes its answer from those that differ in fewest sides.
*/
class Facet_continuation
{
public:
  /*!
    \param points around the hole \param distance of each to the rim
    \param spacing of the points \param scale of the hole: its radius
  */
  Facet_continuation(const Surface_points& points, const std::vector<double>& distance, double spacing, double scale)
    : m_segmentation(points, spacing, scale)
  {
    choose_facets(points, distance, spacing, scale);
    if(!m_is_sharp)
      return;
    vote(points, distance, spacing, scale);
    m_is_sharp = explained_share(points, distance, (std::max)(5 * spacing, 0.3 * scale)) > 0.9;
  }

  /// Whether facets meet at sharp edges that reach the rim, and what is near the rim is nothing but facets: where they
  /// leave much unexplained, edges are folds of a shape that is not made of facets, and would go on anyhow.
  bool is_sharp() const { return m_is_sharp; }

  /*!
    The surface on the line through `x` along `direction`, which is to face it.
    \param guess a parameter on the line; the surface nearest to it is taken
    \param limit largest absolute value of the parameter
    \return whether there is one
  */
  bool find(const Vector& x, const Vector& direction, double guess, double limit, double& height, Vector& normal) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      for(double t : m_facets[f].intersections(x, direction))
      {
        if(!(std::abs(t) <= limit) || !(std::abs(t - guess) < nearest))
          continue;
        const Vector p = x + t * direction, n = m_facets[f].normal(p);
        if(n.dot(direction) < 0.1 || !is_surface(f, p))
          continue;
        nearest = std::abs(t - guess);
        height = t;
        normal = n;
      }
    return nearest < std::numeric_limits<double>::infinity();
  }

  /// Moves `x` to the nearest place of the surface up to `reach` away. \return whether there is one
  bool project(Vector& x, double reach, Vector& normal) const
  {
    double nearest = reach;
    bool is_found = false;
    const Vector from = x;
    for(std::size_t f = 0; f < m_facets.size(); ++f)
    {
      const Vector p = m_facets[f].projection(from);
      if(!((p - from).norm() <= nearest) || !is_surface(f, p))
        continue;
      nearest = (p - from).norm();
      x = p;
      normal = m_facets[f].normal(p);
      is_found = true;
    }
    return is_found;
  }

private:
  typedef std::uint32_t Sides;       // a bit per facet: whether above it
  typedef std::array<double, 2> Votes;

  static std::size_t most_facets() { return 12; }

  // In double: near a facet, where rounding could decide, `is_surface()` sets its side and `vote()` asks no point.
  Sides sides(const Vector& p) const
  {
    Sides result = 0;
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(m_facets[f].distance(p) > 0)
        result |= Sides(1) << f;
    return result;
  }

  // Whether the cell below facet `f` at `p` is inside and the one above outside.
  bool is_surface(std::size_t f, const Vector& p) const
  {
    const Sides bit = Sides(1) << f, above = sides(p) | bit;
    return is_inside(above & ~bit) && !is_inside(above);
  }

  // Cells that the surroundings do not reach: near ones count, eight times less for each side that differs.
  bool is_inside(Sides cell) const
  {
    double balance = 0;
    for(const std::pair<const Sides, Votes>& v : m_votes)
    {
      std::size_t different = 0;
      for(Sides d = v.first ^ cell; d != 0; d &= d - 1)
        ++different;
      if(different == 0)
        return v.second[0] > v.second[1];
      balance += (v.second[0] > v.second[1] ? 1 : -1) * std::pow(0.125, double(different));
    }
    return balance > 0;
  }

  void choose_facets(const Surface_points& points, const std::vector<double>& distance, double spacing, double scale)
  {
    const std::vector<Facet>& all = m_segmentation.facets();
    std::vector<std::pair<std::size_t, std::size_t> > at_rim;
    for(std::size_t f = 0; f < all.size(); ++f)
      at_rim.emplace_back(0, f);
    std::size_t steps = 0;
    std::vector<char> is_at_edge(points.size(), 0), is_near(points.size(), 0);
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const std::size_t f = m_segmentation.facet_of(i);
      if(f == Facet_segmentation::none)
        continue;
      if(distance[i] < 2.5 * spacing)
        ++at_rim[f].first;
      if(distance[i] > (std::max)(5 * spacing, 0.4 * scale))
        continue;
      is_near[i] = 1;
      for(std::size_t j : m_segmentation.links(i))
      {
        const std::size_t g = m_segmentation.facet_of(j);
        if(j < i && g != f && g != Facet_segmentation::none &&
           all[f].normal(points.position[i]).dot(all[g].normal(points.position[j])) < 0.85)
        {
          ++steps;
          is_at_edge[i] = is_at_edge[j] = 1;
        }
      }
    }
    std::sort(at_rim.begin(), at_rim.end(), [](const std::pair<std::size_t, std::size_t>& a,
                                               const std::pair<std::size_t, std::size_t>& b)
      { return a.first > b.first || (a.first == b.first && a.second < b.second); });
    for(const std::pair<std::size_t, std::size_t>& f : at_rim)
      if(f.first >= 3 && m_facets.size() < most_facets())
        m_facets.push_back(all[f.second]);
    m_is_sharp = steps >= 4 && m_facets.size() >= 2 && !are_folds(points, is_near, is_at_edge);
  }

  // Normals turn before a fold, by clearly more than they scatter elsewhere, and stay those of the facet up to an edge.
  bool are_folds(const Surface_points& points, const std::vector<char>& is_near, const std::vector<char>& is_at_edge) const
  {
    std::vector<double> turned[2];
    for(std::size_t i = 0; i < points.size(); ++i)
      if(is_near[i])
      {
        const Facet& facet = m_segmentation.facets()[m_segmentation.facet_of(i)];
        turned[std::size_t(is_at_edge[i])].push_back((facet.normal(points.position[i]) - points.normal[i]).norm());
      }
    if(turned[0].empty() || turned[1].empty())
      return false;
    for(std::vector<double>& t : turned)
      std::nth_element(t.begin(), t.begin() + std::ptrdiff_t(t.size() / 2), t.end());
    return turned[1][turned[1].size() / 2] > 2.5 * turned[0][turned[0].size() / 2] + 0.04;
  }

  void vote(const Surface_points& points, const std::vector<double>& distance, double spacing, double scale)
  {
    const double step = m_segmentation.tolerance() + 0.3 * spacing, width = (std::max)(6 * spacing, 0.6 * scale);
    for(std::size_t i = 0; i < points.size(); ++i)
      if(m_segmentation.facet_of(i) != Facet_segmentation::none && distance[i] < width)
        for(double t : {-2., -1., 1., 2.})
        {
          const Vector p = points.position[i] + t * step * points.normal[i];
          // the surroundings are known to within some tolerance; so near to a facet a point is on neither side
          const bool is_clear = std::none_of(m_facets.begin(), m_facets.end(), [&](const Facet& f)
            { return std::abs(f.distance(p)) < 0.5 * step; });
          if(is_clear)
            m_votes[sides(p)][t < 0 ? 0 : 1] += std::exp(-distance[i] / (0.3 * width));
        }
  }

  // Of the points up to `width` from the rim those that lie on the surface that the facets make.
  double explained_share(const Surface_points& points, const std::vector<double>& distance, double width) const
  {
    std::size_t number = 0, explained = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      if(distance[i] > width)
        continue;
      ++number;
      double height;
      Vector normal;
      explained += find(points.position[i], points.normal[i], 0, m_segmentation.tolerance(), height, normal) &&
                   normal.dot(points.normal[i]) > Sharp_fit::smooth_cosine;
    }
    return number > 0 ? double(explained) / double(number) : 0.;
  }

  Facet_segmentation m_segmentation;
  std::vector<Facet> m_facets;                // that reach the rim
  bool m_is_sharp = false;
  std::map<Sides, Votes> m_votes;             // per cell: inside, outside
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_CONTINUATION_H
