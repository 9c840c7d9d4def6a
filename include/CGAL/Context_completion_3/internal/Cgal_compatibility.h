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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_CGAL_COMPATIBILITY_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_CGAL_COMPATIBILITY_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Octree.h>
#include <CGAL/version.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

// The only place that asks for CGAL's version. CGAL 5.5 and 6.x differ in the octree: node handles against node
// indices, an enlarged against a tight cube, and what the split predicate receives.

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6,0,0)

template <typename Kernel, typename Range, typename PointMap>
using Cubic_octree = CGAL::Octree<Kernel, Range, PointMap, true>;

template <typename Tree>
using Octree_node = typename Tree::Node_index;

template <typename Tree, typename Range, typename PointMap>
std::unique_ptr<Tree> make_cubic_octree(Range& range, const PointMap& map)
{
  return std::make_unique<Tree>(range, map);
}

template <typename Tree>
bool is_octree_leaf(const Tree& tree, Octree_node<Tree> node) { return tree.is_leaf(node); }

template <typename Tree>
Octree_node<Tree> octree_child(const Tree& tree, Octree_node<Tree> node, std::size_t i) { return tree.child(node, i); }

template <typename Tree>
std::array<std::uint32_t, 3> octree_coordinates(const Tree& tree, Octree_node<Tree> node)
{
  const auto g = tree.global_coordinates(node);
  return {{ std::uint32_t(g[0]), std::uint32_t(g[1]), std::uint32_t(g[2]) }};
}

/// Splits every node for which `split(depth, coordinates)` holds.
template <typename Tree, typename Split>
void refine_octree(Tree& tree, const Split& split)
{
  tree.refine([&split](typename Tree::Node_index node, const Tree& t)
    { return t.is_leaf(node) && split(std::size_t(t.depth(node)), octree_coordinates(t, node)); });
}

#else

template <typename Kernel, typename Range, typename PointMap>
using Cubic_octree = CGAL::Octree<Kernel, Range, PointMap>;

template <typename Tree>
using Octree_node = typename Tree::Node;

template <typename Tree, typename Range, typename PointMap>
std::unique_ptr<Tree> make_cubic_octree(Range& range, const PointMap& map)
{
  return std::make_unique<Tree>(range, map, 1.); // 1: the cube is not enlarged
}

template <typename Tree>
bool is_octree_leaf(const Tree&, Octree_node<Tree> node) { return node.is_leaf(); }

template <typename Tree>
Octree_node<Tree> octree_child(const Tree&, Octree_node<Tree> node, std::size_t i) { return node[i]; }

template <typename Tree>
std::array<std::uint32_t, 3> octree_coordinates(const Tree&, Octree_node<Tree> node)
{
  const auto g = node.global_coordinates();
  return {{ std::uint32_t(g[0]), std::uint32_t(g[1]), std::uint32_t(g[2]) }};
}

/// Splits every node for which `split(depth, coordinates)` holds.
template <typename Tree, typename Split>
void refine_octree(Tree& tree, const Split& split)
{
  tree.refine([&](typename Tree::Node node)
    { return split(std::size_t(node.depth()), octree_coordinates(tree, node)); });
}

#endif

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_CGAL_COMPATIBILITY_H
