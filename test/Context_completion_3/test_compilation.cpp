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

// Every overload, kernel, kind of range and named parameter is compiled and run once.

#include "include/surface_samples.h"

#include <CGAL/context_complete.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/vector_property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <list>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace test_compilation {

using CGAL::Context_completions_3::combine;
namespace parameters = CGAL::parameters;
namespace samples = Test_surfaces;

namespace {

template <typename Kernel>
class Completion_with_kernel : public ::testing::Test {};

typedef ::testing::Types<CGAL::Exact_predicates_inexact_constructions_kernel,
                         CGAL::Simple_cartesian<double>,
                         CGAL::Simple_cartesian<float>,
                         CGAL::Exact_predicates_exact_constructions_kernel> Kernels;
TYPED_TEST_SUITE(Completion_with_kernel, Kernels);

template <typename Kernel>
std::vector<std::pair<typename Kernel::Point_3, typename Kernel::Vector_3> > completed(
  const std::vector<std::pair<typename Kernel::Point_3, typename Kernel::Vector_3> >& points)
{
  typedef std::pair<typename Kernel::Point_3, typename Kernel::Vector_3> Pair;
  std::vector<Pair> added;
  CGAL::context_complete(points, std::back_inserter(added),
                         parameters::point_map(CGAL::First_of_pair_property_map<Pair>()).
                         normal_map(CGAL::Second_of_pair_property_map<Pair>()));
  return added;
}

// a visitor that has no base class
struct Counting_visitor
{
  std::size_t number_of_points = 0, number_of_holes = 0, chosen = 0, begun = 0, ended = 0, added = 0, total = 0;

  void on_detection_begin(std::size_t n) { number_of_points = n; }
  void on_detection_end(std::size_t n) { number_of_holes = n; }
  void on_completion_begin(std::size_t n) { chosen = n; }
  void on_hole_begin(std::size_t) { ++begun; }
  void on_hole_end(std::size_t, std::size_t n) { ++ended; added += n; }
  void on_completion_end(std::size_t n) { total = n; }
};

} // namespace

TYPED_TEST(Completion_with_kernel, Fills_a_point_set)
{
  auto points = samples::point_set<TypeParam>(samples::plane_with_hole());
  const std::size_t before = points.size();
  const std::size_t added = CGAL::context_complete(points);
  EXPECT_GT(added, 0u);
  ASSERT_EQ(points.size(), before + added);
  for(std::size_t i = before; i < points.size(); ++i)
  {
    EXPECT_LT(std::hypot(CGAL::to_double(points.point(i).x()) - 16., CGAL::to_double(points.point(i).y()) - 16.), 4.5);
    EXPECT_NEAR(CGAL::to_double(points.point(i).z()), 0., 0.1);
    EXPECT_NEAR(CGAL::to_double(points.normal(i).squared_length()), 1., 1e-5);
  }
}

TYPED_TEST(Completion_with_kernel, Writes_pairs_to_an_output_iterator)
{
  auto points = samples::point_set<TypeParam>(samples::plane_with_hole());
  const std::size_t before = points.size();
  const auto added = completed<TypeParam>(samples::converted<TypeParam>(samples::plane_with_hole()));
  ASSERT_EQ(CGAL::context_complete(points), added.size());
  for(std::size_t i = 0; i < added.size(); ++i)
  {
    EXPECT_EQ(points.point(before + i), added[i].first);
    EXPECT_EQ(points.normal(before + i), added[i].second);
  }
}

TYPED_TEST(Completion_with_kernel, Works_step_by_step)
{
  typedef CGAL::Context_completion_3<TypeParam> Completion;
  Completion completion(samples::point_set<TypeParam>(samples::plane_with_hole()));
  EXPECT_GT(CGAL::to_double(completion.spacing()), 0.5);
  EXPECT_LT(CGAL::to_double(completion.spacing()), 1.5);
  completion.detect_holes();
  std::vector<typename Completion::New_point> added;
  completion.complete(std::back_inserter(added));
  EXPECT_FALSE(added.empty());
}

TEST(Compilation, Georeferenced_coordinates_lose_no_digits)
{
  // multiples of 2^-20 and an offset of integers below 2^23: the moved coordinates are exact
  samples::Samples near, far;
  const samples::Vector offset(4194304., -8388000., 2048.);
  for(const auto& s : samples::plane_with_hole())
  {
    const auto rounded = [](double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); };
    near.emplace_back(samples::Point(rounded(s.first.x()), rounded(s.first.y()), rounded(s.first.z())), s.second);
    far.emplace_back(near.back().first + offset, s.second);
  }
  const auto added_near = completed<samples::Kernel>(near), added_far = completed<samples::Kernel>(far);
  ASSERT_EQ(added_near.size(), added_far.size());
  for(std::size_t i = 0; i < added_near.size(); ++i)
  {
    EXPECT_LT(std::sqrt(CGAL::squared_distance(added_near[i].first + offset, added_far[i].first)), 1e-8);
    EXPECT_EQ(added_near[i].second, added_far[i].second);
  }
}

TEST(Compilation, Ranges_and_maps)
{
  typedef samples::Kernel Kernel;
  const samples::Samples pairs = samples::plane_with_hole();
  const samples::Samples expected = completed<Kernel>(pairs);
  ASSERT_FALSE(expected.empty());

  {
    typedef std::tuple<int, samples::Vector, samples::Point> Tuple;
    std::list<Tuple> tuples;
    for(const auto& p : pairs)
      tuples.emplace_back(7, p.second, p.first);
    samples::Samples added;
    CGAL::context_complete(tuples, std::back_inserter(added),
                           parameters::point_map(CGAL::Nth_of_tuple_property_map<2, Tuple>()).
                           normal_map(CGAL::Nth_of_tuple_property_map<1, Tuple>()).geom_traits(Kernel()));
    EXPECT_EQ(added, expected);
  }
  {
    std::vector<samples::Point> positions;
    std::vector<samples::Vector> normals;
    std::vector<std::size_t> indices;
    for(const auto& p : pairs)
    {
      indices.push_back(positions.size());
      positions.push_back(p.first);
      normals.push_back(p.second);
    }
    samples::Samples added;
    CGAL::context_complete(indices, std::back_inserter(added),
                           parameters::point_map(CGAL::make_property_map(positions)).
                           normal_map(CGAL::make_property_map(normals)));
    EXPECT_EQ(added, expected);
  }
  {
    // points alone, whose normals are known by another function
    std::vector<samples::Point> positions;
    for(const auto& p : pairs)
      positions.push_back(p.first);
    samples::Samples added;
    const auto up = boost::make_function_property_map<samples::Point>(
      [](const samples::Point&) { return samples::Vector(0, 0, 1); });
    CGAL::context_complete(positions, std::back_inserter(added), parameters::normal_map(up));
    EXPECT_EQ(added, expected);
  }
  {
    const auto points = samples::point_set(pairs);
    samples::Samples added;
    CGAL::context_complete(points, std::back_inserter(added));
    EXPECT_EQ(added, expected);
    added.clear();
    CGAL::context_complete(points, std::back_inserter(added), points.parameters());
    EXPECT_EQ(added, expected);
  }
}

TEST(Compilation, All_parameters_of_a_point_set)
{
  typedef samples::Kernel Kernel;
  typedef CGAL::Point_set_3<samples::Point> Point_set;
  Point_set points = samples::point_set(samples::bumpy_plane_with_hole());
  const auto source = points.add_property_map<int>("source", -7).first;
  const auto source_set = points.add_property_map<int>("source_set", -7).first;
  const auto hole = points.add_property_map<int>("hole", -7).first;
  const auto confidence = points.add_property_map<float>("confidence", -7.f).first;
  const auto mask = points.add_property_map<bool>("mask", true).first;
  const std::size_t before = points.size();
  const std::vector<Point_set> examples(1, samples::point_set(samples::bumpy_plane(36, 1., 8., 1., 0.15, 5)));
  const std::vector<Kernel::Iso_cuboid_3> regions(1, Kernel::Iso_cuboid_3(0, 0, -9, 99, 99, 9));
  const std::vector<CGAL::Bbox_3> excluded(1, CGAL::Bbox_3(-9, -9, -9, -8, -8, -8));
  std::vector<CGAL::Context_completions_3::Hole_report_3> reports;
  Counting_visitor visitor;
  double last = -1.;
  std::size_t number_of_decreases = 0;
  const std::function<bool(double)> callback = [&](double fraction)
  {
    number_of_decreases += fraction < last;
    last = fraction;
    return true;
  };

  const std::size_t added = CGAL::context_complete<CGAL::Parallel_if_available_tag>(points,
    combine(points.parameters().callback(callback).visitor(std::ref(visitor)).random_seed(3u),
            parameters::minimum_hole_diameter(1), parameters::maximum_hole_diameter(20.f),
            parameters::regions(regions), parameters::excluded_regions(excluded), parameters::user_holes(regions),
            parameters::known_rims(std::vector<std::vector<int> >()),
            parameters::example_mask(mask), parameters::example_point_sets(std::cref(examples)),
            parameters::maximum_depth(6), parameters::minimum_cell_points(15u), parameters::tolerance(0.5),
            parameters::number_of_turns(12), parameters::use_mirrors(true), parameters::number_of_candidates(500),
            parameters::use_paper_policies(false), parameters::keep_texture(true),
            parameters::rotation_angles(std::vector<double>(1, 1.5)), parameters::use_cube_symmetries(true),
            parameters::use_support_balls(true), parameters::use_box_subdivision(true),
            parameters::source_map(source), parameters::source_set_map(source_set), parameters::hole_map(hole),
            parameters::confidence_map(confidence), parameters::hole_reports(std::back_inserter(reports))));

  EXPECT_GT(added, 0u);
  EXPECT_EQ(visitor.number_of_points, before);
  EXPECT_EQ(visitor.number_of_holes, reports.size());
  EXPECT_EQ(visitor.chosen, 1u);
  EXPECT_EQ(visitor.begun, 1u);
  EXPECT_EQ(visitor.ended, 1u);
  EXPECT_EQ(visitor.added, added);
  EXPECT_EQ(visitor.total, added);
  EXPECT_EQ(number_of_decreases, 0u);
  EXPECT_GT(last, 0.);
  EXPECT_LE(last, 1.);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const bool is_new = i >= before;
    EXPECT_EQ(source[i] == -7, !is_new);
    EXPECT_EQ(source_set[i] == -7, !is_new);
    EXPECT_EQ(hole[i] == -7, !is_new);
    EXPECT_EQ(confidence[i] == -7.f, !is_new);
    if(is_new)
    {
      ASSERT_LE(source_set[i], 1);
      EXPECT_LT(source[i], int(source_set[i] == 0 ? before : examples[0].size()));
      ASSERT_LT(hole[i], int(reports.size()));
      EXPECT_EQ(reports[std::size_t(hole[i])].state, CGAL::Context_completions_3::Hole_state::hole);
      EXPECT_GE(confidence[i], 0.f);
      EXPECT_LE(confidence[i], 1.f);
    }
  }
  std::size_t reported = 0;
  for(const auto& report : reports)
    reported += report.number_of_points;
  EXPECT_EQ(reported, added);
}

TEST(Compilation, All_parameters_of_a_range)
{
  typedef samples::Oriented_point Pair;
  const samples::Samples points = samples::plane_with_hole();
  const std::list<samples::Samples> examples(1, samples::plane(24));
  boost::vector_property_map<std::size_t> source, source_set;
  std::map<std::size_t, short> hole;
  std::vector<double> confidence(100000, -7.);
  const std::vector<CGAL::Bbox_3> everywhere(1, CGAL::Bbox_3(-HUGE_VAL, -HUGE_VAL, -HUGE_VAL,
                                                             HUGE_VAL, HUGE_VAL, HUGE_VAL));
  std::list<CGAL::Context_completions_3::Hole_report_3> reports;
  std::vector<std::pair<samples::Point, samples::Vector> > added;
  CGAL::Context_completions_3::Default_completion_visitor visitor;

  CGAL::context_complete<CGAL::Sequential_tag>(points, std::back_inserter(added),
    combine(parameters::maximum_hole_diameter(std::numeric_limits<double>::infinity()).
              point_map(CGAL::First_of_pair_property_map<Pair>()).
              normal_map(CGAL::Second_of_pair_property_map<Pair>()).geom_traits(samples::Kernel()).visitor(visitor).
              callback([](double) { return true; }),
            parameters::regions(everywhere), parameters::example_point_sets(examples),
            parameters::example_mask(boost::make_function_property_map<Pair>(
              [](const Pair& p) { return p.first.x() < 12.; })),
            parameters::source_map(source), parameters::source_set_map(source_set),
            parameters::hole_map(boost::make_assoc_property_map(hole)),
            parameters::confidence_map(CGAL::make_property_map(confidence)),
            parameters::keep_texture(false), parameters::hole_reports(std::back_inserter(reports))));

  ASSERT_FALSE(added.empty());
  EXPECT_EQ(hole.size(), added.size());
  EXPECT_FALSE(reports.empty());
  for(std::size_t i = 0; i < added.size(); ++i)
  {
    EXPECT_LE(source_set[i], 1u);
    EXPECT_GE(confidence[i], 0.);
  }
  EXPECT_EQ(confidence[added.size()], -7.);
}

TEST(Compilation, Hole_indices_and_the_policies_of_the_paper)
{
  auto points = samples::point_set(samples::plane_with_hole());
  CGAL::Context_completion_3<samples::Kernel> completion(points);
  std::vector<int> indices;
  for(const auto& hole : completion.detect_holes())
    if(hole.is_to_be_filled())
      indices.push_back(int(hole.id));
  ASSERT_EQ(indices.size(), 1u);
  EXPECT_GT(CGAL::context_complete(points, parameters::hole_indices(indices)), 0u);

  auto others = samples::point_set(samples::bumpy_plane_with_hole());
  const std::size_t before = others.size();
  const std::size_t added = CGAL::context_complete(others, parameters::use_paper_policies(true));
  EXPECT_EQ(others.size(), before + added);
}

} // namespace test_compilation
