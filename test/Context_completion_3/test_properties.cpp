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

// New points carry the properties of their sources; old points stay bit for bit, come what may.

#include "include/point_set_snapshot.h"
#include "include/surface_samples.h"

#include <CGAL/context_complete.h>
#include <CGAL/IO/Color.h>

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_properties {

using CGAL::Context_completions_3::combine;
namespace parameters = CGAL::parameters;
namespace samples = Test_surfaces;
using samples::Point;
using samples::Vector;

namespace {

typedef CGAL::Point_set_3<Point> Point_set;
typedef Point_set::Index Index;

/// A property whose copy fails when the budget is used up.
struct Fragile
{
  static int budget;
  int value = 0;

  Fragile(int v = 0) : value(v) {}
  Fragile(const Fragile& other) : value(other.value) { spend(); }
  Fragile& operator=(const Fragile& other) { value = other.value; spend(); return *this; }
  static void spend()
  {
    if(budget == 0)
      throw std::runtime_error("the budget is used up");
    if(budget > 0)
      --budget;
  }
};
int Fragile::budget = -1; // unlimited

/// A writable map that fails at the n-th value.
struct Failing_map
{
  typedef Index key_type;
  typedef int value_type;
  typedef void reference;
  typedef boost::writable_property_map_tag category;
  std::shared_ptr<int> left;

  friend void put(const Failing_map& map, const Index&, int)
  {
    if((*map.left)-- == 0)
      throw std::runtime_error("the map is full");
  }
};

/// Properties that tell the point, of several types.
void add_properties(Point_set& points, int first = 0)
{
  const auto label = points.add_property_map<int>("label", -1).first;
  const auto intensity = points.add_property_map<float>("intensity", -1.f).first;
  const auto name = points.add_property_map<std::string>("name", "none").first;
  const auto flag = points.add_property_map<bool>("flag", false).first;
  const auto color = points.add_property_map<CGAL::IO::Color>("color", CGAL::IO::Color(0, 0, 0)).first;
  for(const Index& i : points)
  {
    label[i] = first + int(i);
    intensity[i] = 0.5f * float(i);
    name[i] = "the point with the number " + std::to_string(first + int(i));
    flag[i] = i % 3 == 0;
    color[i] = CGAL::IO::Color((unsigned char)(i % 251), (unsigned char)(i % 83), 9);
  }
}

template <typename T>
Point_set::Property_map<T> property(Point_set& points, const std::string& name)
{
  return points.add_property_map<T>(name).first; // the one that exists
}

Index nearest_old_point(const Point_set& points, const std::vector<Index>& old_points, const Point& p)
{
  Index best = old_points.front();
  for(const Index& i : old_points)
    if(CGAL::squared_distance(points.point(i), p) < CGAL::squared_distance(points.point(best), p))
      best = i;
  return best;
}

} // namespace

TEST(Properties, Travel_from_the_source)
{
  for(const bool is_bumpy : { true, false })
  {
    const samples::Samples surface = is_bumpy ? samples::bumpy_plane_with_hole() : samples::plane_with_hole();
    Point_set points = samples::point_set(surface);
    add_properties(points);
    const Point_set_snapshot<Point_set> before(points);
    const std::vector<Index> old_points(points.begin(), points.end());
    std::vector<int> source(100000, -7);

    const std::size_t added = CGAL::context_complete(points, parameters::source_map(CGAL::make_property_map(source)));
    ASSERT_GT(added, 0u);
    EXPECT_TRUE(before.is_prefix_of(points));
    const auto label = property<int>(points, "label");
    const auto intensity = property<float>(points, "intensity");
    const auto name = property<std::string>(points, "name");
    const auto flag = property<bool>(points, "flag");
    const auto color = property<CGAL::IO::Color>(points, "color");
    std::size_t number_of_copies = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_EQ(*(points.begin() + std::ptrdiff_t(i)), Index(i));
      EXPECT_EQ(source[i] == -7, i < old_points.size());
      std::size_t s = i;
      if(i >= old_points.size())
      {
        number_of_copies += source[i] >= 0;
        s = source[i] >= 0 ? std::size_t(source[i])
                           : std::size_t(nearest_old_point(points, old_points, points.point(i)));
      }
      EXPECT_EQ(label[i], int(s));
      EXPECT_EQ(intensity[i], 0.5f * float(s));
      EXPECT_EQ(name[i], "the point with the number " + std::to_string(s));
      EXPECT_EQ(bool(flag[i]), s % 3 == 0);
      EXPECT_EQ(color[i], CGAL::IO::Color((unsigned char)(s % 251), (unsigned char)(s % 83), 9));
      EXPECT_NEAR(points.normal(i).squared_length(), 1., 1e-12);
    }
    // on a plane nothing is worth copying: its new points take after their nearest neighbours
    EXPECT_EQ(number_of_copies > 0, is_bumpy);
  }
}

TEST(Properties, Travel_from_an_example_set)
{
  Point_set points = samples::point_set(samples::bumpy_plane_with_hole());
  add_properties(points);
  points.add_property_map<double>("not in the example", 4.5);
  points.add_property_map<int>("of another type there", 6);
  const auto mask = points.add_property_map<bool>("mask", false).first; // copies come from the example alone
  Point_set example;
  example.add_property_map<char>("only in the example", 'x'); // the order of properties differs, too
  example.add_property_map<float>("of another type there", 2.f);
  example.add_normal_map();
  for(const auto& s : samples::bumpy_plane(48, 1., 8., 1., 0.15, 9))
    example.insert(s.first + Vector(1000, 0, 0), s.second);
  add_properties(example, 100000);
  const auto source = points.add_property_map<int>("source", -7).first;
  const auto source_set = points.add_property_map<int>("source_set", -7).first;
  const Point_set_snapshot<Point_set> before(points);
  const std::vector<Index> old_points(points.begin(), points.end());
  const std::vector<Point_set> examples(1, example);

  CGAL::context_complete(points, combine(parameters::example_point_sets(std::cref(examples)),
                                         parameters::example_mask(mask), parameters::source_map(source),
                                         parameters::source_set_map(source_set)));
  ASSERT_GT(points.size(), old_points.size());
  EXPECT_TRUE(before.is_prefix_of(points));
  const auto label = property<int>(points, "label");
  const auto name = property<std::string>(points, "name");
  const auto missing = property<double>(points, "not in the example");
  const auto other_type = property<int>(points, "of another type there");
  std::size_t number_of_copies = 0;
  for(std::size_t i = old_points.size(); i < points.size(); ++i)
  {
    if(source[i] < 0)
    {
      EXPECT_EQ(label[i], int(nearest_old_point(points, old_points, points.point(i))));
      continue;
    }
    ++number_of_copies;
    EXPECT_EQ(source_set[i], 1);
    EXPECT_EQ(label[i], 100000 + source[i]);
    EXPECT_EQ(name[i], "the point with the number " + std::to_string(100000 + source[i]));
    EXPECT_EQ(missing[i], 4.5);
    EXPECT_EQ(other_type[i], 6);
  }
  EXPECT_GT(number_of_copies, 0u);
}

TEST(Properties, Every_kind_of_source)
{
  typedef CGAL::Context_completions_3::New_point_3<samples::Kernel> New_point;
  Point_set points = samples::point_set(samples::plane(8));
  add_properties(points);
  points.remove(Index(20));
  const Point_set_snapshot<Point_set> before(points);
  const std::vector<Index> old_points(points.begin(), points.end());
  std::vector<Point_set> examples(2, samples::point_set(samples::plane(5)));
  add_properties(examples[0], 1000);
  add_properties(examples[1], 2000);
  examples[1].remove(Index(0)); // indices of examples are not positions either

  std::vector<New_point> new_points(4);
  new_points[0].source = 7;
  new_points[1].source = 6;
  new_points[1].source_set = 2;
  new_points[3].source = 0;
  new_points[3].source_set = 1;
  for(std::size_t i = 0; i < new_points.size(); ++i)
  {
    new_points[i].point = Point(2. + double(i), 3., 0.25);
    new_points[i].normal = Vector(1, 0, 0);
  }
  const auto np = parameters::example_point_sets(std::cref(examples));
  CGAL::Context_completions_3::internal::Property_transfer<Point, Vector> transfer(points);
  transfer.read_examples(new_points, np);
  transfer.append(new_points, np);

  EXPECT_TRUE(before.is_prefix_of(points));
  ASSERT_EQ(points.size(), old_points.size() + 4);
  const auto label = property<int>(points, "label");
  const auto name = property<std::string>(points, "name");
  const int expected[] = { 7, 2006, int(nearest_old_point(points, old_points, Point(4, 3, 0.25))), 1000 };
  for(std::size_t i = 0; i < new_points.size(); ++i)
  {
    const Index index = *(points.begin() + std::ptrdiff_t(old_points.size() + i));
    EXPECT_EQ(label[index], expected[i]);
    EXPECT_EQ(name[index], "the point with the number " + std::to_string(expected[i]));
    EXPECT_EQ(points.point(index), new_points[i].point);
    EXPECT_EQ(points.normal(index), new_points[i].normal);
  }
}

TEST(Properties, Point_and_normal_maps_of_the_caller_are_written)
{
  Point_set points = samples::point_set(samples::plane_with_hole());
  const auto moved = points.add_property_map<Point>("moved").first;
  const auto turned = points.add_property_map<Vector>("turned").first;
  for(const Index& i : points)
  {
    moved[i] = points.point(i) + Vector(0, 0, 50);
    turned[i] = -points.normal(i);
  }
  const std::size_t before = points.size();
  ASSERT_GT(CGAL::context_complete(points, parameters::point_map(moved).normal_map(turned)), 0u);
  for(std::size_t i = before; i < points.size(); ++i)
  {
    EXPECT_NEAR(moved[i].z(), 50., 0.1);
    EXPECT_EQ(points.point(i), moved[i]);
    EXPECT_LT(turned[i].z(), -0.9);
    EXPECT_EQ(points.normal(i), turned[i]);
  }
}

TEST(Properties, Removed_points_stay_where_they_are)
{
  const samples::Samples surface = samples::bumpy_plane_with_hole();
  const auto is_removed = [](const Point& p) { return p.x() < 3.; }; // a strip at the border
  samples::Samples alive;
  for(const auto& s : surface)
    if(!is_removed(s.first))
      alive.push_back(s);
  Point_set expected = samples::point_set(alive);
  const std::size_t number_of_new_points = CGAL::context_complete(expected);
  ASSERT_GT(number_of_new_points, 0u);

  // the removed ones are put last by CGAL, so the others keep their order only if those come from the end
  samples::Samples sorted = alive;
  for(const auto& s : surface)
    if(is_removed(s.first))
      sorted.push_back(s);
  Point_set points = samples::point_set(sorted);
  add_properties(points);
  while(points.size() > alive.size())
    points.remove(std::prev(points.end()));
  const Point_set_snapshot<Point_set> before(points);
  ASSERT_EQ(CGAL::context_complete(points), number_of_new_points);
  EXPECT_TRUE(before.is_prefix_of(points));
  EXPECT_EQ(points.number_of_removed_points(), sorted.size() - alive.size());
  std::size_t place = 0;
  for(const Index& i : points)
  {
    EXPECT_EQ(points.point(i), expected.point(place)); // the same points as without the removed ones
    EXPECT_FALSE(points.is_removed(i));
    EXPECT_EQ(std::size_t(i), place < alive.size() ? place : place + sorted.size() - alive.size());
    ++place;
  }
  for(std::size_t i = alive.size(); i < sorted.size(); ++i)
    EXPECT_TRUE(points.is_removed(Index(i)));

  const auto label = property<int>(points, "label");
  points.cancel_removals();
  ASSERT_EQ(points.size(), sorted.size() + number_of_new_points);
  for(std::size_t i = 0; i < sorted.size(); ++i)
  {
    EXPECT_EQ(points.point(i), sorted[i].first);
    EXPECT_EQ(label[i], int(i));
  }
}

TEST(Properties, Points_removed_from_the_middle)
{
  Point_set points = samples::point_set(samples::plane_with_hole());
  add_properties(points);
  for(std::size_t i : { 0u, 100u, 3u, 50u })
    points.remove(Index(i));
  const Point_set_snapshot<Point_set> before(points);
  std::vector<int> source(100000, -7);
  std::vector<CGAL::Context_completions_3::Hole_report_3> reports;
  const std::size_t added = CGAL::context_complete(points,
    combine(parameters::source_map(CGAL::make_property_map(source)),
            parameters::hole_reports(std::back_inserter(reports))));
  ASSERT_GT(added, 0u);
  EXPECT_TRUE(before.is_prefix_of(points));
  const auto label = property<int>(points, "label");
  for(auto it = points.begin() + std::ptrdiff_t(before.number_of_points()); it != points.end(); ++it)
    if(source[*it] >= 0)
    {
      EXPECT_EQ(label[*it], source[*it]);
      EXPECT_FALSE(points.is_removed(Index(std::size_t(source[*it]))));
    }
  for(const auto& report : reports)
    for(const auto& loop : report.loops)
      for(std::size_t index : loop)
        EXPECT_FALSE(points.is_removed(Index(index)));
  points.collect_garbage();
  EXPECT_EQ(points.size(), before.number_of_points() + added);
}

TEST(Properties, Cancelling_leaves_all_as_it_was)
{
  const Point_set original = samples::point_set(samples::plane_with_hole());
  std::size_t number_of_calls = 0;
  {
    Point_set points = original;
    CGAL::context_complete(points, parameters::callback(std::function<bool(double)>([&](double)
      { ++number_of_calls; return true; })));
    ASSERT_GT(number_of_calls, 1u);
  }
  const std::size_t step = number_of_calls / 6 + 1;
  for(std::size_t last = 0; last < number_of_calls; last += step)
  {
    Point_set points = original;
    add_properties(points);
    const Point_set_snapshot<Point_set> before(points);
    std::size_t calls = 0;
    std::vector<CGAL::Context_completions_3::Hole_report_3> reports;
    const std::function<bool(double)> callback = [&](double) { return calls++ < last; };
    EXPECT_EQ(CGAL::context_complete(points, combine(parameters::callback(callback),
                                                     parameters::hole_reports(std::back_inserter(reports)))), 0u);
    EXPECT_TRUE(before.is_equal_to(points));
    EXPECT_TRUE(reports.empty());

    std::vector<std::pair<Point, Vector> > added;
    calls = 0;
    CGAL::context_complete(points, std::back_inserter(added), parameters::callback(callback));
    EXPECT_TRUE(added.empty());
  }
}

TEST(Properties, A_callback_that_throws_leaves_all_as_it_was)
{
  Point_set points = samples::point_set(samples::plane_with_hole());
  const Point_set_snapshot<Point_set> before(points);
  const std::function<bool(double)> callback = [](double fraction)
  {
    if(fraction > 0.)
      throw std::runtime_error("the user is tired");
    return true;
  };
  EXPECT_THROW(CGAL::context_complete(points, parameters::callback(callback)), std::runtime_error);
  EXPECT_TRUE(before.is_equal_to(points));
}

TEST(Properties, A_copy_that_throws_leaves_all_as_it_was)
{
  Fragile::budget = -1;
  Point_set original = samples::point_set(samples::plane_with_hole());
  for(std::size_t i : { 4u, 2u })
    original.remove(Index(i));
  original.add_property_map<Fragile>("fragile", Fragile(3));
  add_properties(original);
  const Point_set_snapshot<Point_set> before(original);
  const std::size_t number_of_elements = original.base().size();
  // while the array grows, while it gets new elements, and while these get the values of their sources
  for(std::size_t budget : { std::size_t(0), number_of_elements / 2, number_of_elements + 1, number_of_elements + 30 })
  {
    Point_set points = original;
    const auto fragile = property<Fragile>(points, "fragile");
    Fragile::budget = int(budget);
    EXPECT_THROW(CGAL::context_complete(points), std::runtime_error) << budget;
    Fragile::budget = -1;
    EXPECT_TRUE(before.is_equal_to(points));
    EXPECT_EQ(points.base().size(), number_of_elements);
    EXPECT_EQ(fragile[5].value, 3);
    EXPECT_GT(CGAL::context_complete(points), 0u); // it still works
    EXPECT_TRUE(before.is_prefix_of(points));
  }
}

TEST(Properties, A_map_that_throws_leaves_all_as_it_was)
{
  Point_set points = samples::point_set(samples::plane_with_hole());
  add_properties(points);
  const Point_set_snapshot<Point_set> before(points);
  const Failing_map map = { std::make_shared<int>(3) };
  EXPECT_THROW(CGAL::context_complete(points, parameters::hole_map(map)), std::runtime_error);
  EXPECT_TRUE(before.is_equal_to(points));
}

TEST(Properties, Without_a_hole_nothing_is_added)
{
  Point_set points = samples::point_set(samples::sphere(900, 8.));
  const Point_set_snapshot<Point_set> before(points);
  EXPECT_EQ(CGAL::context_complete(points), 0u);
  EXPECT_TRUE(before.is_equal_to(points));
}

} // namespace test_properties
