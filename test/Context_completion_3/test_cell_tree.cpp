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

#include <CGAL/Context_completion_3/internal/Cell_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace test_cell_tree {

using namespace CGAL::Context_completions_3::internal;

namespace {

std::vector<Vector> random_points(std::size_t number, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Vector> points;
  for(std::size_t i = 0; i < number; ++i)
  {
    const Vector p(uniform(random), uniform(random), uniform(random));
    points.push_back(i % 2 == 0 ? p : Vector(p.normalized() * 0.3));
  }
  return points;
}

struct More_than
{
  std::size_t number;
  bool operator()(const Cell&, const Cell_tree::Point_range& points) const
  {
    return std::size_t(points.second - points.first) > number;
  }
};

bool contains(const CGAL::Bbox_3& box, const Vector& p)
{
  return p.x() >= box.xmin() && p.x() <= box.xmax() && p.y() >= box.ymin() && p.y() <= box.ymax()
      && p.z() >= box.zmin() && p.z() <= box.zmax();
}

} // namespace

TEST(Cell_tree, every_point_is_in_exactly_one_leaf)
{
  const std::vector<Vector> points = random_points(3000, 1);
  const Cell_tree tree(points, bounding_cube(points), 8, More_than{10});
  std::vector<int> times(points.size(), 0);
  for(std::size_t node = 0; node < tree.number_of_nodes(); ++node)
  {
    const Cell_tree::Point_range range = tree.points(tree.cell(node));
    const CGAL::Bbox_3 box = tree.grid().bbox(tree.cell(node));
    for(auto it = range.first; it != range.second; ++it)
    {
      EXPECT_TRUE(contains(box, points[*it]));
      times[*it] += tree.is_leaf(node) ? 1 : 0;
    }
    if(tree.is_leaf(node))
      EXPECT_TRUE(tree.number_of_points(tree.cell(node)) <= 10 || tree.depth(node) == 8);
    else
      EXPECT_GT(tree.number_of_points(tree.cell(node)), 10u);
  }
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), std::ptrdiff_t(points.size()));
}

TEST(Cell_tree, links_agree_with_cells)
{
  const std::vector<Vector> points = random_points(2000, 2);
  const Cell_tree tree(points, bounding_cube(points), 7, More_than{15});
  ASSERT_GT(tree.number_of_nodes(), 100u);
  EXPECT_EQ(tree.parent(0), no_index);
  std::size_t counted = 0;
  for(std::size_t level = 0; level <= 7; ++level)
    for(std::size_t node = tree.nodes_of_level(level).first; node < tree.nodes_of_level(level).second;
        ++node, ++counted)
    {
      EXPECT_EQ(tree.depth(node), level);
      EXPECT_EQ(tree.node(tree.cell(node)), node);
      std::size_t deepest = 0;
      for(std::size_t i = 0; i < 8 && !tree.is_leaf(node); ++i)
      {
        EXPECT_EQ(tree.parent(tree.child(node, i)), node);
        EXPECT_EQ(tree.cell(tree.child(node, i)), tree.cell(node).child(i));
        EXPECT_EQ(tree.cell(tree.child(node, i)).parent(), tree.cell(node));
        deepest = (std::max)(deepest, tree.subtree_depth(tree.child(node, i)) + 1);
      }
      EXPECT_EQ(tree.subtree_depth(node), deepest);
    }
  EXPECT_EQ(counted, tree.number_of_nodes());
}

TEST(Cell_tree, points_of_virtual_cells_agree_with_brute_force)
{
  const std::vector<Vector> points = random_points(1500, 3);
  const Cell_tree tree(points, bounding_cube(points), 6, More_than{200});
  for(std::size_t level = 0; level <= 6; ++level)
  {
    std::map<Cell, std::set<std::size_t> > expected;
    for(std::size_t i = 0; i < points.size(); ++i)
      expected[tree.grid().finest_cell(points[i]).ancestor(level)].insert(i);
    const std::vector<Cell> occupied = tree.occupied_cells(level);
    EXPECT_EQ(occupied.size(), expected.size());
    for(const Cell& cell : occupied)
    {
      const Cell_tree::Point_range range = tree.points(cell);
      EXPECT_EQ(std::set<std::size_t>(range.first, range.second), expected[cell]);
      const CGAL::Bbox_3 box = tree.grid().bbox(cell);
      for(std::size_t i = 0; i < points.size(); ++i) // strictly inside: nobody else's
      {
        if(points[i].x() > box.xmin() && points[i].x() < box.xmax() && points[i].y() > box.ymin()
           && points[i].y() < box.ymax() && points[i].z() > box.zmin() && points[i].z() < box.zmax())
        {
          EXPECT_EQ(expected[cell].count(i), 1u);
        }
      }
    }
  }
}

TEST(Cell_tree, neighbours_agree_with_brute_force)
{
  const std::vector<Vector> points = random_points(100, 4);
  const Cell_tree tree(points, bounding_cube(points), 3, More_than{1});
  std::vector<Cell> all;
  for(std::uint32_t x = 0; x < 8; ++x)
    for(std::uint32_t y = 0; y < 8; ++y)
      for(std::uint32_t z = 0; z < 8; ++z)
      {
        Cell cell;
        cell.level = 3;
        cell.coordinates = {{ x, y, z }};
        all.push_back(cell);
      }
  for(const Cell& a : all)
  {
    std::set<Cell> expected, found;
    const CGAL::Bbox_3 box = tree.grid().bbox(a);
    for(const Cell& b : all)
      if(b != a && CGAL::do_overlap(box, tree.grid().bbox(b))) // closed boxes touch: faces are the same numbers
        expected.insert(b);
    for(std::size_t i = 0; i < 27; ++i)
      if(i != own_offset && a.has_neighbor(cell_offset(i)))
        found.insert(a.neighbor(cell_offset(i)));
    EXPECT_EQ(found, expected);
  }
}

TEST(Cell_tree, cells_of_all_sizes_share_their_faces_bit_for_bit)
{
  Cell_cube cube;
  cube.lower = Vector(-0.1, 1. / 3, 1e5);
  cube.side = 0.7;
  const Cell_grid grid(cube, 20);
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(std::size_t level = 1; level <= 12; ++level)
      for(std::uint64_t k = 0; k <= (std::uint64_t(1) << level); k += 1 + k / 7)
        for(std::size_t finer = level; finer <= 20; ++finer)
          ASSERT_EQ(grid.plane(level, k, axis), grid.plane(finer, k << (finer - level), axis));
}

TEST(Cell_tree, points_on_split_planes_belong_to_the_upper_cell)
{
  std::vector<Vector> points;
  for(int x = 0; x <= 4; ++x)
    for(int y = 0; y <= 4; ++y)
      for(int z = 0; z <= 4; ++z)
        points.push_back(Vector(x, y, z));
  const Cell_tree tree(points, bounding_cube(points), 2, More_than{0});
  for(std::size_t node = 0; node < tree.number_of_nodes(); ++node)
  {
    const Cell& cell = tree.cell(node);
    if(cell.level < 2)
      continue;
    std::size_t expected = 1; // the outermost cells take the points of the far faces, too
    for(std::size_t d = 0; d < 3; ++d)
      expected *= cell.coordinates[d] == 3 ? 2 : 1;
    EXPECT_EQ(tree.number_of_points(cell), expected);
  }
}

TEST(Cell_tree, degenerate_inputs_end)
{
  const std::vector<Vector> none, one(1, Vector(1, 2, 3)), same(100, Vector(1, 2, 3));
  for(const std::vector<Vector>& points : { none, one, same })
  {
    const Cell_tree tree(points, bounding_cube(points), 20, More_than{5});
    EXPECT_EQ(tree.number_of_nodes(), 1u);
    EXPECT_EQ(tree.number_of_points(Cell()), points.size());
  }
  std::vector<Vector> twins(50, Vector(0, 0, 0));
  twins.resize(100, Vector(1, 1, 1));
  const Cell_tree tree(twins, bounding_cube(twins), 10, More_than{5});
  EXPECT_EQ(tree.subtree_depth(Cell()), 10u);
  std::vector<Vector> line;
  for(int i = 0; i < 1000; ++i)
    line.push_back(Vector(i * 0.001, 0.5, 0.5));
  EXPECT_GT(Cell_tree(line, bounding_cube(line), 5, More_than{5}).number_of_nodes(), 8u);
}

TEST(Cell_tree, commensurable_cubes_have_cells_of_equal_size)
{
  const std::vector<Vector> points = random_points(100, 5);
  for(const double side : { 0.3, 1., 1.9, 5. })
  {
    std::size_t doublings = 0;
    const Cell_cube cube = commensurable_cube(points, side, doublings);
    EXPECT_EQ(cube.side, std::ldexp(side, int(doublings)));
    EXPECT_TRUE(doublings == 0 || std::ldexp(side, int(doublings) - 1) < offset_cube(points).side);
    for(const Vector& p : points)
      for(int d = 0; d < 3; ++d)
        EXPECT_TRUE(p[d] > cube.lower[d] - 1e-12 && p[d] < cube.lower[d] + cube.side + 1e-12);
  }
}

TEST(Cell_tree, the_offset_cube_holds_the_points_and_parts_no_flat_set)
{
  std::vector<Vector> points = random_points(100, 6);
  for(Vector& p : points)
    p.z() = 0.25;
  const Cell_cube cube = offset_cube(points), tight = bounding_cube(points);
  EXPECT_LT(cube.side, 1.05 * tight.side);
  for(const Vector& p : points)
    EXPECT_TRUE(((p - cube.lower).array() > 0).all() && ((p - cube.lower).array() < cube.side).all());
  const double position = (0.25 - cube.lower.z()) / cube.side;
  for(int level = 1; level <= 8; ++level)   // the bounding cube has the set on a plane of its first level
    EXPECT_GT(std::abs(std::ldexp(position, level) - std::round(std::ldexp(position, level))), 1e-3);
  EXPECT_EQ((0.25 - tight.lower.z()) / tight.side, 0.5);
}

TEST(Cell_tree, morton_codes_are_inverted)
{
  std::mt19937 random(6);
  for(int i = 0; i < 1000; ++i)
  {
    std::array<std::uint32_t, 3> c;
    for(std::uint32_t& x : c)
      x = std::uint32_t(random() >> 12);
    EXPECT_EQ(morton_coordinates(morton_code(c)), c);
  }
}

} // namespace test_cell_tree
