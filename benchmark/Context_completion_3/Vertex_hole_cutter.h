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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_VERTEX_HOLE_CUTTER_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_VERTEX_HOLE_CUTTER_H

#include "Benchmark_case.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace Completion_benchmark {

/// What a hole grows from: one vertex, or a path that runs straight on.
enum class Hole_core { vertex, path };

/*!
  Cuts holes into a mesh by taking vertices, neighbours of neighbours, with all triangles at them. A hole is refused
  unless it has one rim, which passes each of its vertices once, and keeps away from the others and from the borders.
*/
class Vertex_hole_cutter
{
public:
  explicit Vertex_hole_cutter(const Benchmark_surface& mesh)
    : m_mesh(mesh), m_neighbors(mesh.vertices.size()), m_faces(mesh.vertices.size()),
      m_is_removed(mesh.vertices.size(), false), m_is_taken(mesh.vertices.size(), false)
  {
    std::map<std::pair<std::size_t, std::size_t>, int> count;
    for(std::size_t f = 0; f < mesh.faces.size(); ++f)
      for(int i = 0; i < 3; ++i)
      {
        const std::size_t a = mesh.faces[f][i], b = mesh.faces[f][(i + 1) % 3];
        m_faces[a].push_back(f);
        ++count[std::minmax(a, b)];
      }
    for(const auto& edge : count)
    {
      const std::size_t a = edge.first.first, b = edge.first.second;
      m_neighbors[a].push_back(b);
      m_neighbors[b].push_back(a);
      if(edge.second != 2)
        m_is_taken[a] = m_is_taken[b] = true;
    }
  }

  const std::vector<char>& is_removed() const { return m_is_removed; }
  const std::vector<std::size_t>& sizes() const { return m_sizes; }

  /// Balls around the holes with their rims.
  const std::vector<Ball>& balls() const { return m_balls; }

  /// Tries to cut one hole of `number` vertices at random places. \return whether it was possible.
  bool cut(Hole_core core, std::size_t number, Random_source& random)
  {
    for(int attempt = 0; attempt < 150; ++attempt)
    {
      std::vector<std::size_t> vertices(1, random.index(m_neighbors.size()));
      if(core == Hole_core::path)
        extend_straight(vertices, std::size_t(2 * std::sqrt(double(number))), random);
      if(try_to_cut(vertices, number))
        return true;
    }
    return false;
  }

private:
  void extend_straight(std::vector<std::size_t>& path, std::size_t length, Random_source& random) const
  {
    const std::vector<std::size_t>& first = m_neighbors[path.front()];
    if(first.empty())
      return;
    path.push_back(first[random.index(first.size())]);
    while(path.size() < length)
    {
      // straight as seen from a few edges back, over which the zigzag of the edges evens out
      const Vector here = m_mesh.vertices[path.back()];
      const Vector heading = here - m_mesh.vertices[path[path.size() - (std::min)(path.size(), std::size_t(6))]];
      std::size_t best = path.back();
      double straightest = 0;
      for(std::size_t v : m_neighbors[path.back()])
      {
        const double advance = (m_mesh.vertices[v] - here).normalized().dot(heading);
        if(advance > straightest && std::find(path.begin(), path.end(), v) == path.end())
        {
          straightest = advance;
          best = v;
        }
      }
      if(best == path.back())
        return;
      path.push_back(best);
    }
  }

  bool try_to_cut(std::vector<std::size_t> hole, std::size_t number)
  {
    std::vector<char> is_inside(m_neighbors.size(), false);
    for(std::size_t v : hole)
      is_inside[v] = true;
    for(std::size_t next = 0; next < hole.size() && hole.size() < number; ++next)
      for(std::size_t v : m_neighbors[hole[next]])
        if(!is_inside[v] && hole.size() < number)
        {
          is_inside[v] = true;
          hole.push_back(v);
        }
    if(hole.size() < number)
      return false;                               // a small part of the model, all of it
    const std::vector<std::size_t> rim = rim_of(hole, is_inside);
    const auto is_taken = [this](std::size_t v) { return m_is_taken[v] != 0; };
    if(std::any_of(hole.begin(), hole.end(), is_taken) || std::any_of(rim.begin(), rim.end(), is_taken)
       || !is_one_cycle(hole, rim, is_inside)
       || 8 * std::size_t(std::count(m_is_removed.begin(), m_is_removed.end(), true)) + 8 * hole.size()
          > m_neighbors.size())
      return false;

    Ball ball;
    for(std::size_t v : hole)
    {
      ball.center += m_mesh.vertices[v] / double(hole.size());
      m_is_removed[v] = m_is_taken[v] = true;
    }
    for(std::size_t v : rim)
    {
      ball.radius = (std::max)(ball.radius, (m_mesh.vertices[v] - ball.center).norm());
      m_is_taken[v] = true;
      for(std::size_t w : m_neighbors[v])
        m_is_taken[w] = true;
    }
    for(std::size_t v : hole)
      ball.radius = (std::max)(ball.radius, (m_mesh.vertices[v] - ball.center).norm());
    m_balls.push_back(ball);
    m_sizes.push_back(hole.size());
    return true;
  }

  // what is next to the hole and keeps a triangle; vertices that keep none are added to the hole
  std::vector<std::size_t> rim_of(std::vector<std::size_t>& hole, std::vector<char>& is_inside) const
  {
    std::vector<std::size_t> rim, lost;
    std::vector<char> is_seen(is_inside);
    for(std::size_t v : hole)
      for(std::size_t w : m_neighbors[v])
        if(!is_seen[w])
        {
          is_seen[w] = true;
          const bool keeps_face = std::any_of(m_faces[w].begin(), m_faces[w].end(),
                                              [&](std::size_t f) { return !is_cut(f, is_inside); });
          (keeps_face ? rim : lost).push_back(w);
        }
    for(std::size_t v : lost)
      is_inside[v] = true;
    hole.insert(hole.end(), lost.begin(), lost.end());
    return rim;
  }

  bool is_cut(std::size_t f, const std::vector<char>& is_inside) const
  {
    return std::any_of(m_mesh.faces[f].begin(), m_mesh.faces[f].end(), [&](std::size_t v) { return is_inside[v]; });
  }

  // follows the edges of the rim that have a triangle on one side only
  bool is_one_cycle(const std::vector<std::size_t>& hole, const std::vector<std::size_t>& rim,
                    const std::vector<char>& is_inside) const
  {
    std::map<std::size_t, std::size_t> next;
    for(std::size_t v : hole)
      for(std::size_t f : m_faces[v])
        for(int i = 0; i < 3; ++i)
        {
          const std::size_t a = m_mesh.faces[f][i], b = m_mesh.faces[f][(i + 1) % 3];
          if(is_inside[a] || is_inside[b])
            continue;
          // the triangle across the edge, too, may be one of the hole
          const std::size_t across = face_across(f, a, b);
          if(across == f || is_cut(across, is_inside))
            continue;
          const auto known = next.find(a);
          if(known != next.end() && known->second != b)
            return false;
          next[a] = b;
        }
    if(next.size() != rim.size())
      return false;
    std::size_t v = rim.front(), steps = 0;
    do
    {
      const auto found = next.find(v);
      if(found == next.end() || ++steps > rim.size())
        return false;
      v = found->second;
    }
    while(v != rim.front());
    return steps == rim.size();
  }

  // the other triangle at an edge, or the same at a border
  std::size_t face_across(std::size_t f, std::size_t a, std::size_t b) const
  {
    for(std::size_t g : m_faces[a])
      if(g != f && std::find(m_mesh.faces[g].begin(), m_mesh.faces[g].end(), b) != m_mesh.faces[g].end())
        return g;
    return f;
  }

  const Benchmark_surface& m_mesh;
  std::vector<std::vector<std::size_t> > m_neighbors, m_faces;
  std::vector<char> m_is_removed;
  std::vector<char> m_is_taken;                   // borders, and the holes with their rims and what is next to these
  std::vector<Ball> m_balls;
  std::vector<std::size_t> m_sizes;
};

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_VERTEX_HOLE_CUTTER_H
