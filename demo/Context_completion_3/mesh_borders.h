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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_MESH_BORDERS_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_MESH_BORDERS_H

#include "mesh_faces.h"
#include "point_file.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Which borders of a mesh are rims of holes.

namespace Completion_program {

typedef std::vector<std::size_t> Face;

/// The borders of a mesh that is a surface: cycles of points with the surface on the left, in the order of their
/// smallest point. Every point is on one border at most.
inline std::vector<std::vector<std::size_t> > border_cycles(const std::vector<Face>& faces, std::size_t number_of_points)
{
  const std::vector<char> is_at_border = points_at_border(faces, number_of_points);
  std::set<std::pair<std::size_t, std::size_t> > edges;
  for(const Face& face : faces)
    for(std::size_t i = 0; i < face.size(); ++i)
    {
      const std::size_t from = face[i], to = face[(i + 1) % face.size()];
      if(is_at_border[from] && is_at_border[to])
        edges.emplace(from, to);
    }
  std::map<std::size_t, std::size_t> next;
  for(const auto& edge : edges)
    if(edges.count(std::make_pair(edge.second, edge.first)) == 0)
      next.insert(edge);
  std::vector<std::vector<std::size_t> > cycles;
  while(!next.empty())
  {
    cycles.emplace_back();
    for(auto at = next.begin(); at != next.end(); at = next.find(cycles.back().back()))
    {
      cycles.back().push_back(at->second);
      next.erase(at);
    }
  }
  return cycles;
}

/*!
  How a border turns, in full turns: the sum of its exterior angles within the surface, over two pi. By the theorem of
  Gauss and Bonnet a patch that closes it has a curvature of one turn more: none if a plane goes on (-1), half a sphere at
  the end of a tube (0). The outer border of a plane sheet has 1.
*/
inline double number_of_turns(const std::vector<std::size_t>& cycle, const std::vector<double>& angle_sum)
{
  double sum = 0;
  for(std::size_t point : cycle)
    sum += CGAL_PI - angle_sum[point];
  return sum / (2 * CGAL_PI);
}

/// At each point the sum of the angles of its faces.
inline std::vector<double> angle_sums(const std::vector<Point>& points, const std::vector<Face>& faces)
{
  std::vector<double> sums(points.size(), 0.);
  for(const Face& face : faces)
    for(std::size_t i = 0; i < face.size(); ++i)
    {
      const Point& p = points[face[i]];
      const Vector a = points[face[(i + 1) % face.size()]] - p, b = points[face[(i + face.size() - 1) % face.size()]] - p;
      const double length = CGAL::approximate_sqrt(a.squared_length() * b.squared_length());
      if(length > 0)
        sums[face[i]] += std::acos((std::min)(1., (std::max)(-1., a * b / length)));
    }
  return sums;
}

/// Follows points that are doubled where surfaces touch. Visitors are copied, hence the pointer.
struct Doubled_points : CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  explicit Doubled_points(std::map<std::size_t, std::size_t>& original_of) : original_of(&original_of) {}

  void duplicated_vertex(std::size_t original, std::size_t copy) { (*original_of)[copy] = original; }

  std::map<std::size_t, std::size_t>* original_of;
};

// without those that name a point twice, which bound nothing
inline std::vector<Face> proper_faces(const std::vector<Face>& faces)
{
  std::vector<Face> result;
  for(const Face& face : faces)
    if(face.size() >= 3 && std::set<std::size_t>(face.begin(), face.end()).size() == face.size())
      result.push_back(face);
  return result;
}

/*!
  The borders of a mesh that a surface closes with less curvature than a hemisphere, with a reserve: rims of holes, as
  indices of points. Left out are the borders of sheets and the ends of tubes, which may be meant to be open.
*/
inline std::vector<std::vector<std::size_t> > rims_of_holes(const Point_file& file)
{
  if(file.faces.empty())
    return std::vector<std::vector<std::size_t> >();
  const double most_turns = -0.375;
  std::vector<Point> points(file.points.points().begin(), file.points.points().end());
  std::vector<Face> faces = proper_faces(file.faces);
  std::map<std::size_t, std::size_t> original_of;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces,
                                                     CGAL::parameters::visitor(Doubled_points(original_of)));
  const std::vector<double> sums = angle_sums(points, faces);
  std::vector<std::vector<std::size_t> > rims;
  for(const std::vector<std::size_t>& cycle : border_cycles(faces, points.size()))
  {
    if(number_of_turns(cycle, sums) > most_turns)
      continue;
    std::vector<std::size_t> rim;
    std::set<std::size_t> seen;
    for(std::size_t point : cycle)
    {
      while(point >= file.points.size())
        point = original_of.at(point);
      if(seen.insert(point).second)
        rim.push_back(point);
    }
    if(rim.size() >= 3)
      rims.push_back(rim);
  }
  return rims;
}

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_MESH_BORDERS_H
