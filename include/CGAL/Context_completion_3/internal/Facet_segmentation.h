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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_SEGMENTATION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_SEGMENTATION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Facet.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Sharp_fit.h>
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
  Divides the surroundings of a hole into facets, smooth pieces that meet at sharp edges: each grows from a flat place
  over points that lie on what it is so far and face the same way. Two that continue each other, on two sides of the
  hole, become one.
*/
class Facet_segmentation
{
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /*!
    \param spacing of the points
    \param scale of the hole: its radius
  */
  Facet_segmentation(const Surface_points& points, double spacing, double scale)
    : m_points(points)
  {
    Neighbor_search search(points.position);
    m_links.resize(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      search.in_ball(points.position[i], 2.2 * spacing, m_links[i]);
    const double noise = measure_noise();
    m_precision.position = (std::max)(noise, 0.03 * spacing);
    m_precision.normal = (std::max)(0.05, noise / spacing);
    m_precision.scale = scale;
    m_tolerance = 0.15 * spacing + 2.5 * noise;
    m_facet_of.assign(points.size(), none);
    grow_all();
    merge();
  }

  /// The facets, by no particular order but always the same.
  const std::vector<Facet>& facets() const { return m_facets; }

  /// Index of the facet that a point belongs to, `none` at edges and blends.
  std::size_t facet_of(std::size_t point) const { return m_facet_of[point]; }

  /// Points near to a point, itself included.
  const std::vector<std::size_t>& links(std::size_t point) const { return m_links[point]; }

  /// Points farther from a facet are not on it.
  double tolerance() const { return m_tolerance; }

private:
  static std::size_t least_size() { return 12; }

  // Of points from planes through their neighbours on the same facet.
  double measure_noise() const
  {
    std::vector<double> residuals;
    for(std::size_t i = 0; i < m_points.size(); ++i)
    {
      Vector mean = Vector::Zero();
      std::size_t count = 0;
      for(std::size_t j : m_links[i])
        if(j != i && m_points.normal[i].dot(m_points.normal[j]) > Sharp_fit::smooth_cosine)
        {
          mean += m_points.position[j];
          ++count;
        }
      if(count >= 4)
        residuals.push_back(std::abs(m_points.normal[i].dot(m_points.position[i] - mean / double(count))));
    }
    if(residuals.empty())
      return 0;
    std::nth_element(residuals.begin(), residuals.begin() + residuals.size() / 2, residuals.end());
    return 1.4 * residuals[residuals.size() / 2];
  }

  bool fits(const Facet& facet, std::size_t i) const
  {
    return std::abs(facet.distance(m_points.position[i])) < m_tolerance &&
           facet.normal(m_points.position[i]).dot(m_points.normal[i]) > Sharp_fit::smooth_cosine;
  }

  // A quadric has two sides, which are two facets.
  bool faces(const Vector& normal, std::size_t i) const { return normal.dot(m_points.normal[i]) > 0.3; }

  Vector mean_normal(const std::vector<std::size_t>& members) const
  {
    Vector sum = Vector::Zero();
    for(std::size_t i : members)
      sum += m_points.normal[i];
    return sum.normalized();
  }

  void grow_all()
  {
    // flattest first: the mean deviation of the normals around a point
    std::vector<std::pair<double, std::size_t> > seeds;
    for(std::size_t i = 0; i < m_points.size(); ++i)
    {
      double sum = 0;
      for(std::size_t j : m_links[i])
        sum += 1 - m_points.normal[i].dot(m_points.normal[j]);
      seeds.emplace_back(sum / double(m_links[i].size()), i);
    }
    std::sort(seeds.begin(), seeds.end());
    for(const std::pair<double, std::size_t>& seed : seeds)
      if(m_facet_of[seed.second] == none)
        grow(seed.second);
  }

  void grow(std::size_t seed)
  {
    std::vector<std::size_t> members, ring, next;
    std::vector<char> is_member(m_points.size(), 0);
    for(std::size_t j : m_links[seed])
      if(m_facet_of[j] == none && m_points.normal[seed].dot(m_points.normal[j]) > 0.95)
      {
        members.push_back(j);
        is_member[j] = 1;
      }
    if(members.size() < 5)
      return;
    Facet facet(m_points, members, m_precision);
    std::size_t fitted = members.size();
    ring = members;
    while(!ring.empty())
    {
      next.clear();
      for(std::size_t i : ring)
        for(std::size_t j : m_links[i])
          if(!is_member[j] && m_facet_of[j] == none && faces(m_points.normal[seed], j) && fits(facet, j))
          {
            is_member[j] = 1;
            next.push_back(j);
          }
      ring.swap(next);
      members.insert(members.end(), ring.begin(), ring.end());
      if(10 * members.size() > 11 * fitted)
      {
        facet = Facet(m_points, members, m_precision);
        fitted = members.size();
      }
    }
    members.erase(std::remove_if(members.begin(), members.end(),
                                 [&](std::size_t i) { return !fits(facet, i); }), members.end());
    if(members.size() < least_size())
      return;
    std::sort(members.begin(), members.end());
    for(std::size_t i : members)
      m_facet_of[i] = m_facets.size();
    m_facets.push_back(Facet(m_points, members, m_precision));
    m_members.push_back(members);
  }

  void merge()
  {
    for(std::size_t a = 0; a < m_facets.size(); ++a)
      for(std::size_t b = a + 1; b < m_facets.size(); )
      {
        std::vector<std::size_t> both = m_members[a];
        both.insert(both.end(), m_members[b].begin(), m_members[b].end());
        const Facet facet(m_points, both, m_precision);
        const Vector normal = mean_normal(both);
        std::size_t fitting[2] = {0, 0};
        for(std::size_t i : both)
          fitting[m_facet_of[i] == a ? 0 : 1] += faces(normal, i) && fits(facet, i);
        // two planes are a quadric, too, but one that fits them less well
        if(facet.loss() > 2 * (m_facets[a].loss() + m_facets[b].loss()) || 10 * fitting[0] < 9 * m_members[a].size() ||
           10 * fitting[1] < 9 * m_members[b].size())
        {
          ++b;
          continue;
        }
        std::sort(both.begin(), both.end());
        m_members[a].swap(both);
        m_facets[a] = facet;
        m_facets.erase(m_facets.begin() + std::ptrdiff_t(b));
        m_members.erase(m_members.begin() + std::ptrdiff_t(b));
        for(std::size_t& f : m_facet_of)
          if(f != none && f >= b)
            f = f == b ? a : f - 1;
        b = a + 1;
      }
  }

  const Surface_points& m_points;
  std::vector<std::vector<std::size_t> > m_links;
  Facet_precision m_precision;
  double m_tolerance = 0;
  std::vector<std::size_t> m_facet_of;                  // per point
  std::vector<Facet> m_facets;
  std::vector<std::vector<std::size_t> > m_members;     // parallel to m_facets, by increasing index
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_FACET_SEGMENTATION_H
