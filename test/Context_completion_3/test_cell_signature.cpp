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

#include <CGAL/Context_completion_3/internal/Cell_candidates.h>
#include <CGAL/Context_completion_3/internal/Cell_classification.h>
#include <CGAL/Context_completion_3/internal/Cell_signature.h>
#include <CGAL/Context_completion_3/internal/Cell_symmetry.h>

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace test_cell_signature {

using namespace CGAL::Context_completions_3::internal;

namespace {

// a bumpy height field over [-1, 1]^2, without a disk if asked for
Surface_points bumpy_sheet(std::size_t number, double hole_radius, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Surface_points surface;
  while(surface.size() < number)
  {
    const double x = uniform(random), y = uniform(random);
    if(Vector(x - 0.1, y, 0).norm() < hole_radius)
      continue;
    surface.push_back(Vector(x, y, 0.2 * std::sin(5 * x + 2 * y) + 0.1 * y),
                      Vector(-std::cos(5 * x + 2 * y), -0.4 * std::cos(5 * x + 2 * y) - 0.1, 1).normalized());
  }
  return surface;
}

Surface_points transformed(const Surface_points& surface, const Matrix& m)
{
  Surface_points result;
  for(std::size_t i = 0; i < surface.size(); ++i)
    result.push_back(m * surface.position[i], m * surface.normal[i]);
  return result;
}

Cell_cube unit_cube()
{
  Cell_cube cube;
  cube.lower = Vector(-1, -1, -1);
  cube.side = 2;
  return cube;
}

// the cell of the transformed content
Cell image(const Cell& cell, const Cell_symmetry& symmetry)
{
  const double size = double(std::uint32_t(1) << cell.level);
  Vector v;
  for(int d = 0; d < 3; ++d)
    v[d] = 2 * cell.coordinates[std::size_t(d)] + 1 - size;
  const Vector w = symmetry.matrix() * v;
  Cell result = cell;
  for(int d = 0; d < 3; ++d)
    result.coordinates[std::size_t(d)] = std::uint32_t((w[d] + size - 1) / 2 + 0.5);
  return result;
}

Cell_candidates make_candidates(const std::shared_ptr<const Cell_surface>& surface, std::size_t level,
                                std::size_t maximum_evaluations = 0)
{
  Cell_candidates candidates(paper_symmetry_group(), maximum_evaluations);
  Candidate_source source;
  source.surface = surface;
  candidates.add_source(source);
  candidates.begin_level(level);
  return candidates;
}

} // namespace

TEST(Cell_symmetry, groups_are_groups)
{
  for(const std::vector<Cell_symmetry>& group : { paper_symmetry_group(), full_symmetry_group(),
                                                  paper_symmetry_group(false), full_symmetry_group(false) })
  {
    EXPECT_TRUE(group[0].matrix().isIdentity());
    const auto contains = [&](const Matrix& m)
    {
      return std::count_if(group.begin(), group.end(), [&](const Cell_symmetry& s) { return s.matrix() == m; }) == 1;
    };
    for(const Cell_symmetry& a : group)
    {
      EXPECT_TRUE(contains(a.inverse().matrix()));
      for(const Cell_symmetry& b : group)
        EXPECT_TRUE(contains(a.matrix() * b.matrix()));
      std::set<std::size_t> images;
      for(std::size_t i = 0; i < 27; ++i)
      {
        images.insert(a.image(i));
        EXPECT_EQ(a.inverse().image(a.image(i)), i);
      }
      EXPECT_EQ(images.size(), 27u);
    }
  }
  EXPECT_EQ(paper_symmetry_group().size(), 8u);
  EXPECT_EQ(full_symmetry_group().size(), 48u);
  EXPECT_EQ(full_symmetry_group(false).size(), 24u);
}

TEST(Cell_signature, is_permuted_by_the_symmetry_group)
{
  const Surface_points sheet = bumpy_sheet(3000, 0.2, 1);
  const Cell_surface surface(sheet, unit_cube(), 4, 15, 1e-3);
  const Signature_weights weights;
  double largest_change = 0;
  for(const Cell_symmetry& symmetry : full_symmetry_group())
  {
    const Cell_surface moved(transformed(sheet, symmetry.matrix()), unit_cube(), 4, 15, 1e-3);
    for(std::size_t level = 1; level <= 4; ++level)
    {
      const std::vector<Cell> cells = surface.tree().occupied_cells(level);
      for(std::size_t i = 0; i < cells.size(); i += 1 + cells.size() / 10)
      {
        const Cell_signature original = cell_signature(surface, cells[i]),
                             expected = original.transformed(symmetry),
                             found = cell_signature(moved, image(cells[i], symmetry));
        EXPECT_LT(signature_distance(expected, found, weights), 1e-3);
        largest_change = (std::max)(largest_change, signature_distance(original, found, weights));
        // back again
        EXPECT_LT((expected.transformed(symmetry.inverse()).vector - original.vector).norm(), 1e-5);
      }
    }
  }
  EXPECT_GT(largest_change, 1.); // the sheet itself is not symmetric
}

TEST(Cell_signature, of_a_plane_is_known)
{
  Surface_points plane;
  for(int i = 0; i < 100; ++i)
    for(int j = 0; j < 100; ++j)
      plane.push_back(Vector(-0.99 + 0.02 * i, -0.99 + 0.02 * j, 0.1), Vector(0, 0, 1));
  const Cell_surface surface(plane, unit_cube(), 3, 15, 1e-6);
  Cell cell;
  cell.level = 2;
  cell.coordinates = {{ 1, 2, 2 }}; // z from 0 to 0.5
  const Cell_signature signature = cell_signature(surface, cell);
  for(std::size_t i = 0; i < 27; ++i)
  {
    const double z = cell_offset(i)[2];
    EXPECT_NEAR(signature.vector[Cell_signature::inner_distance + int(i)], (0.25 + 0.25 * z - 0.1) / 0.5, 1e-5);
    EXPECT_NEAR(signature.vector[Cell_signature::outer_distance + int(i)], (0.25 + 0.5 * z - 0.1) / 0.5, 1e-5);
    EXPECT_NEAR(signature.vector[Cell_signature::inner_direction + 3 * int(i) + 2], 1, 1e-5);
    EXPECT_NEAR(signature.vector[Cell_signature::outer_direction + 3 * int(i) + 2], 1, 1e-5);
    const bool is_valid_neighbor = z == 0 && i != own_offset; // subtree depth 0: a plane needs no subdivision
    EXPECT_EQ(signature.vector[Cell_signature::detail + int(i)],
              is_valid_neighbor ? 0 : Cell_signature::undefined_detail);
  }
}

TEST(Cell_signature, distance_follows_the_equations)
{
  std::mt19937 random(2);
  std::normal_distribution<float> normal;
  Cell_signature a, b;
  for(int i = 0; i < Cell_signature::detail; ++i)
  {
    a.vector[i] = normal(random);
    b.vector[i] = normal(random);
  }
  a.vector.tail<27>().setConstant(3);
  b.vector.tail<27>().setConstant(Cell_signature::undefined_detail);
  b.vector[Cell_signature::detail + 5] = 1;
  b.vector[Cell_signature::detail + 9] = 0;
  Signature_weights weights;
  weights.inner = 0.7;
  weights.distance = 0.2;
  weights.detail = 0.4;
  double parts[4] = { 0, 0, 0, 0 };
  for(int i = 0; i < Cell_signature::detail; ++i)
    parts[i < 27 ? 0 : i < 108 ? 1 : i < 135 ? 2 : 3] += std::pow(a.vector[i] - b.vector[i], 2);
  const double expected = 0.7 * (0.2 * std::sqrt(parts[0]) + 0.8 * std::sqrt(parts[1]))
                        + 0.3 * (0.2 * std::sqrt(parts[2]) + 0.8 * std::sqrt(parts[3])) + 0.4 * std::sqrt(4. + 9.);
  EXPECT_NEAR(signature_distance(a, b, weights), expected, 1e-4);
  EXPECT_EQ(signature_distance(a, a, weights), 0);
  EXPECT_LT(Signature_weights::of_level(1, 5).inner, Signature_weights::of_level(4, 5).inner);
}

TEST(Cell_candidates, search_equals_exhaustive_search)
{
  const auto surface = std::make_shared<Cell_surface>(bumpy_sheet(4000, 0.25, 3), unit_cube(), 4, 15, 1e-3);
  const std::vector<Cell_symmetry> group = paper_symmetry_group();
  for(std::size_t level = 2; level <= 4; ++level)
  {
    const Cell_candidates candidates = make_candidates(surface, level);
    ASSERT_GT(candidates.number_of_candidates(), 4u);
    const Signature_weights weights = Signature_weights::of_level(level, 4);
    for(const Cell& target : surface->tree().occupied_cells(level))
    {
      if(surface->is_valid(target))
        continue;
      const Cell_signature signature = cell_signature(*surface, target);
      double least = std::numeric_limits<double>::infinity();
      for(const Cell& cell : surface->tree().occupied_cells(level))
        for(const Cell_symmetry& symmetry : group)
          if(surface->is_valid(cell))
            least = (std::min)(least,
              signature_distance(signature, cell_signature(*surface, cell).transformed(symmetry), weights));
      const Cell_match match = candidates.find_best(signature, weights);
      ASSERT_TRUE(match.is_found());
      EXPECT_NEAR(match.distance, least, 1e-4);
      EXPECT_NEAR(signature_distance(signature,
        cell_signature(*surface, match.cell).transformed(group[match.symmetry]), weights), match.distance, 1e-4);
    }
  }
}

TEST(Cell_candidates, a_mirrored_copy_is_found_with_its_symmetry)
{
  // a cell's own mirrored signature has distance 0 to the cell, under that very mirror
  const auto surface = std::make_shared<Cell_surface>(bumpy_sheet(4000, 0, 4), unit_cube(), 3, 15, 1e-3);
  const std::vector<Cell_symmetry> group = paper_symmetry_group();
  const Cell_candidates candidates = make_candidates(surface, 3);
  const Cell cell = candidates.candidate(candidates.number_of_candidates() / 2);
  for(std::size_t g = 0; g < group.size(); ++g)
  {
    const Cell_match match = candidates.find_best(cell_signature(*surface, cell).transformed(group[g]),
                                                  Signature_weights());
    EXPECT_EQ(match.cell, cell);
    EXPECT_EQ(match.symmetry, g);
    EXPECT_NEAR(match.distance, 0, 1e-5);
  }
}

TEST(Cell_candidates, a_turned_set_is_matched_by_its_rotated_copy)
{
  const Surface_points sheet = bumpy_sheet(4000, 0, 6);
  const auto surface = std::make_shared<Cell_surface>(sheet, unit_cube(), 3, 15, 1e-3);
  for(const Matrix& rotation : rotations_about_axes({ CGAL_PI / 4, CGAL_PI / 3 }))
  {
    const Surface_points turned = transformed(sheet, rotation.transpose());
    Cell_candidates candidates(paper_symmetry_group());
    for(const Matrix& m : { Matrix(Matrix::Identity()), rotation })
    {
      Candidate_source source;
      source.surface = std::make_shared<Cell_surface>(transformed(turned, m), unit_cube(), 3, 15, 1e-3);
      candidates.add_source(source);
    }
    candidates.begin_level(3);
    for(const Cell& cell : surface->tree().occupied_cells(3))
      if(surface->is_valid(cell))
      {
        const Cell_match match = candidates.find_best(cell_signature(*surface, cell), Signature_weights());
        EXPECT_EQ(match.source, 1u);
        EXPECT_EQ(match.cell, cell);
        EXPECT_NEAR(match.distance, 0, 1e-3);
      }
  }
}

TEST(Cell_candidates, all_symmetries_of_the_cube_match_what_is_turned_by_a_quarter)
{
  const Surface_points sheet = bumpy_sheet(4000, 0, 7);
  const Cell_surface surface(sheet, unit_cube(), 3, 15, 1e-3);
  Candidate_source source;
  source.surface = std::make_shared<Cell_surface>(transformed(sheet, rotations_about_axes({ CGAL_PI / 2 })[2]),
                                                  unit_cube(), 3, 15, 1e-3);
  Cell_candidates paper(paper_symmetry_group()), cube(full_symmetry_group());
  for(Cell_candidates* candidates : { &paper, &cube })
  {
    candidates->add_source(source);
    candidates->begin_level(3);
  }
  for(const Cell& cell : surface.tree().occupied_cells(3))
    if(surface.is_valid(cell))
    {
      const Cell_signature signature = cell_signature(surface, cell);
      EXPECT_NEAR(cube.find_best(signature, Signature_weights()).distance, 0, 1e-3);
      EXPECT_GT(paper.find_best(signature, Signature_weights()).distance, 0.01);
    }
}

TEST(Cell_candidates, masked_points_are_neither_chosen_nor_copied)
{
  Candidate_source source;
  const Surface_points sheet = bumpy_sheet(4000, 0, 5);
  source.surface = std::make_shared<Cell_surface>(sheet, unit_cube(), 3, 15, 1e-3);
  for(const Vector& p : sheet.position)
    source.is_example.push_back(p.x() > 0.1 ? 1 : 0);
  Cell_candidates candidates(paper_symmetry_group());
  candidates.add_source(source);
  candidates.begin_level(3);
  ASSERT_GT(candidates.number_of_candidates(), 0u);
  for(const Cell& target : source.surface->tree().occupied_cells(3))
  {
    const Cell_match match = candidates.find_best(cell_signature(*source.surface, target), Signature_weights());
    const std::vector<std::size_t> copied = candidates.example_points(match);
    EXPECT_GE(copied.size(), 15u);
    for(std::size_t i : copied)
      EXPECT_GT(sheet.position[i].x(), 0.1);
  }
  source.is_example.assign(sheet.size(), 0);
  Cell_candidates none(paper_symmetry_group());
  none.add_source(source);
  none.begin_level(3);
  EXPECT_FALSE(none.find_best(Cell_signature(), Signature_weights()).is_found());
}

TEST(Cell_classification, agrees_with_the_definition_and_is_dynamic)
{
  Surface_points plane;
  for(int i = 0; i < 64; ++i)
    for(int j = 0; j < 64; ++j)
    {
      const Vector p(-1 + (i + 0.5) / 32, -1 + (j + 0.5) / 32, 0.1);
      if(!(p.x() > 0 && p.x() < 0.5 && p.y() > 0 && p.y() < 0.5))
        plane.push_back(p, Vector(0, 0, 1));
    }
  Cell_surface surface(plane, unit_cube(), 3, 15, 1e-6);
  const Cell_classification exact(surface);
  const Cell_classification paper(surface, Box_quadric_test(true));
  std::vector<Cell> invalid;
  for(std::size_t level = 1; level <= 3; ++level)
  {
    invalid = exact.invalid_cells(level, invalid);
    EXPECT_EQ(invalid, paper.invalid_cells(level, std::vector<Cell>()));
    const std::uint32_t n = std::uint32_t(1) << level;
    std::size_t counted[3] = { 0, 0, 0 };
    for(std::uint32_t x = 0; x < n; ++x)
      for(std::uint32_t y = 0; y < n; ++y)
        for(std::uint32_t z = 0; z < n; ++z)
        {
          Cell cell;
          cell.level = level;
          cell.coordinates = {{ x, y, z }};
          const CGAL::Bbox_3 box = surface.grid().bbox(cell);
          const bool is_met = box.zmin() <= 0.1 && box.zmax() >= 0.1;
          const Cell_status expected = surface.number_of_points(cell) >= 15 ? Cell_status::valid
                                     : is_met ? Cell_status::invalid : Cell_status::void_cell;
          EXPECT_EQ(exact.status(cell), expected);
          ++counted[int(expected)];
          EXPECT_EQ(std::count(invalid.begin(), invalid.end(), cell), expected == Cell_status::invalid ? 1 : 0);
        }
    EXPECT_EQ(counted[int(Cell_status::invalid)], level == 1 ? 0u : level == 2 ? 1u : 4u); // the square hole
  }
  // points make it valid; another approximation makes a void cell invalid
  const Cell hole = invalid.front();
  const Vector center = surface.grid().center(hole);
  Cell above = hole;
  ++above.coordinates[2];
  EXPECT_EQ(exact.status(above), Cell_status::void_cell);
  surface.assign(hole, Local_approximation(Local_approximation::Kind::plane,
    make_plane_quadric(surface.grid().center(above), Vector(0, 0, 1))));
  EXPECT_EQ(exact.status(above), Cell_status::invalid);
  for(int i = 0; i < 15; ++i)
  {
    EXPECT_EQ(exact.status(hole), Cell_status::invalid);
    surface.add_point(Vector(center.x(), center.y(), 0.1), Vector(0, 0, 1));
  }
  EXPECT_EQ(exact.status(hole), Cell_status::valid);
  EXPECT_EQ(exact.number_of_valid_neighbors(invalid.back()), 6u);
}

} // namespace test_cell_signature
