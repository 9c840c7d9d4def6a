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

// Whatever cannot be used is refused with a sentence, and nothing has changed.

#include "include/point_set_snapshot.h"
#include "include/surface_samples.h"

#include <CGAL/context_complete.h>

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace test_bad_input {

using CGAL::Context_completions_3::Invalid_input;
using CGAL::Context_completions_3::combine;
namespace parameters = CGAL::parameters;
namespace samples = Test_surfaces;
using samples::Point;
using samples::Vector;

namespace {

typedef CGAL::Point_set_3<Point> Point_set;

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The sentence of the exception, after a check that the point set is as it was; empty if there was no exception.
template <typename NamedParameters>
std::string refusal(Point_set& points, const NamedParameters& np)
{
  const Point_set_snapshot<Point_set> before(points);
  std::string sentence;
  try
  {
    CGAL::context_complete(points, np);
  }
  catch(const Invalid_input& error)
  {
    sentence = error.what();
    EXPECT_TRUE(before.is_equal_to(points));
  }
  return sentence;
}

std::string refusal(Point_set& points) { return refusal(points, parameters::default_values()); }

template <typename NamedParameters>
std::string refusal_of(const NamedParameters& np)
{
  Point_set points = samples::point_set(samples::plane(12));
  return refusal(points, np);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Point_set point_set_of(std::size_t n, const std::function<Point(double)>& position)
{
  Point_set points(true);
  for(std::size_t i = 0; i < n; ++i)
    points.insert(position(double(i)), Vector(0, 0, 1));
  return points;
}

} // namespace

TEST(Bad_input, Too_few_points)
{
  for(std::size_t n : { 0u, 1u, 10u, 14u })
  {
    Point_set points = point_set_of(n, [](double i) { return Point(i, i * i, 0); });
    EXPECT_EQ(refusal(points), "There are " + std::to_string(n) + " points; at least 15 are needed.");
  }
}

TEST(Bad_input, No_normals)
{
  Point_set points;
  for(const auto& s : samples::plane(12))
    points.insert(s.first);
  points.add_property_map<int>("label", 3);
  EXPECT_TRUE(contains(refusal(points), "no normals"));
  EXPECT_TRUE(contains(refusal(points), "jet_estimate_normals"));
  EXPECT_FALSE(points.has_normal_map());

  std::vector<Point> positions(20, Point(0, 0, 0));
  std::vector<std::pair<Point, Vector> > added;
  try
  {
    CGAL::context_complete(positions, std::back_inserter(added));
    ADD_FAILURE() << "points without normals were accepted";
  }
  catch(const Invalid_input& error)
  {
    EXPECT_TRUE(contains(error.what(), "normal_map"));
  }
}

TEST(Bad_input, A_removed_normal_map_is_no_normal_map)
{
  Point_set points = samples::point_set(samples::plane(12));
  points.remove_normal_map();
  EXPECT_TRUE(contains(refusal(points), "no normals"));
}

TEST(Bad_input, Normals_that_were_added_by_their_name_are_found)
{
  Point_set points;
  for(const auto& s : samples::plane_with_hole())
    points.insert(s.first);
  points.add_property_map<Vector>("normal", Vector(0, 0, 1));
  EXPECT_EQ(refusal(points), "");
}

TEST(Bad_input, Equal_points)
{
  Point_set points = point_set_of(50, [](double) { return Point(1, 2, 3); });
  EXPECT_EQ(refusal(points), "All 50 points are equal to (1, 2, 3); a surface is needed.");
}

TEST(Bad_input, Collinear_points)
{
  Point_set axis = point_set_of(50, [](double i) { return Point(i, 0, 0); });
  EXPECT_TRUE(contains(refusal(axis), "lie on a line"));
  Point_set skew = point_set_of(50, [](double i) { return Point(0.1 * i, 0.7 * i + 3., -0.3 * i); });
  EXPECT_TRUE(contains(refusal(skew), "lie on a line"));
  Point_set far = point_set_of(50, [](double i) { return Point(1e6 + 0.1 * i, 1e6 + 0.7 * i, -0.3 * i); });
  EXPECT_TRUE(contains(refusal(far), "lie on a line"));
  Point_set two_places = point_set_of(50, [](double i) { return i < 20. ? Point(0, 0, 0) : Point(1, 3, 2); });
  EXPECT_TRUE(contains(refusal(two_places), "lie on a line"));
}

TEST(Bad_input, Coplanar_points_are_good)
{
  Point_set points = samples::point_set(samples::plane(12));
  EXPECT_EQ(refusal(points), "");
}

TEST(Bad_input, Non_finite_positions)
{
  for(double bad : { not_a_number, infinity, -infinity })
    for(int axis = 0; axis < 3; ++axis)
    {
      Point_set points = samples::point_set(samples::plane(12));
      double c[3] = { 1, 2, 3 };
      c[axis] = bad;
      points.point(17) = Point(c[0], c[1], c[2]);
      const std::string sentence = refusal(points);
      EXPECT_TRUE(contains(sentence, "Point 17 has the non-finite position")) << sentence;
      EXPECT_TRUE(contains(sentence, bad != bad ? "nan" : "inf")) << sentence;
    }
}

TEST(Bad_input, Non_finite_normals)
{
  for(double bad : { not_a_number, infinity, -infinity })
  {
    Point_set points = samples::point_set(samples::plane(12));
    points.normal(5) = Vector(0, bad, 1);
    EXPECT_TRUE(contains(refusal(points), "Point 5 has the non-finite normal"));
  }
}

TEST(Bad_input, Zero_normals)
{
  Point_set points = samples::point_set(samples::plane(12));
  points.normal(0) = Vector(0, 0, 0);
  EXPECT_TRUE(contains(refusal(points), "Point 0 has the normal (0, 0, 0)"));
  EXPECT_TRUE(contains(refusal(points), "jet_estimate_normals"));
}

TEST(Bad_input, Normals_of_any_length_are_good)
{
  const std::vector<double> lengths = { 1e-200, 1e200, 1e-310, 3. };
  Point_set expected = samples::point_set(samples::plane_with_hole());
  Point_set points = expected;
  for(std::size_t i = 0; i < points.size(); ++i)
    points.normal(i) = Vector(0, 0, lengths[i % lengths.size()]);
  ASSERT_EQ(CGAL::context_complete(points), CGAL::context_complete(expected));
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points.point(i), expected.point(i));
}

TEST(Bad_input, Extents_at_the_limits_of_the_number_type)
{
  Point_set points = samples::point_set(samples::plane(12));
  points.point(3) = Point(1e200, 0, 0);
  EXPECT_TRUE(contains(refusal(points), "The extent of the points is 1e+200"));
  Point_set tiny = point_set_of(50, [](double i) { return Point(i * 1e-300, i * i * 1e-300, 0); });
  EXPECT_TRUE(contains(refusal(tiny), "it must lie between"));
  Point_set opposite = point_set_of(50, [](double i)
    { return Point(i < 25. ? 1e308 : -1e308, i, i * i); });
  EXPECT_TRUE(contains(refusal(opposite), "The extent of the points is inf"));
}

TEST(Bad_input, Removed_points_do_not_matter)
{
  Point_set points = samples::point_set(samples::plane_with_hole());
  points.point(3) = Point(not_a_number, 0, 0);
  points.normal(4) = Vector(0, 0, 0);
  points.remove(Point_set::Index(3));
  points.remove(Point_set::Index(4));
  EXPECT_EQ(refusal(points), "");
}

TEST(Bad_input, Lengths_out_of_range)
{
  for(double bad : { -1., not_a_number, infinity, -infinity })
  {
    EXPECT_TRUE(contains(refusal_of(parameters::minimum_hole_diameter(bad)), "minimum_hole_diameter")) << bad;
    EXPECT_TRUE(contains(refusal_of(parameters::tolerance(bad)), "tolerance")) << bad;
    EXPECT_EQ(contains(refusal_of(parameters::maximum_hole_diameter(bad)), "maximum_hole_diameter"), bad != infinity);
  }
  EXPECT_EQ(refusal_of(parameters::tolerance(0)), "The parameter tolerance is 0; it must be positive.");
  EXPECT_EQ(refusal_of(parameters::maximum_hole_diameter(0)),
            "The parameter maximum_hole_diameter is 0; it must be positive.");
  EXPECT_EQ(refusal_of(parameters::minimum_hole_diameter(0)), "");
  EXPECT_EQ(refusal_of(combine(parameters::minimum_hole_diameter(3), parameters::maximum_hole_diameter(2.5f))),
            "The parameter minimum_hole_diameter is 3, above maximum_hole_diameter, which is 2.5.");
}

TEST(Bad_input, Numbers_out_of_range)
{
  for(int bad : { -1, 0, 21 })
    EXPECT_EQ(refusal_of(parameters::maximum_depth(bad)),
              "The parameter maximum_depth is " + std::to_string(bad) + "; it must be an integer from 1 to 20.");
  for(int bad : { -1, 0, 5, 100001 })
    EXPECT_TRUE(contains(refusal_of(parameters::minimum_cell_points(bad)), "minimum_cell_points")) << bad;
  for(int bad : { -1, 0, 361 })
    EXPECT_TRUE(contains(refusal_of(parameters::number_of_turns(bad)), "number_of_turns")) << bad;
  for(int bad : { -1, 0, 10000001 })
    EXPECT_TRUE(contains(refusal_of(parameters::number_of_candidates(bad)), "number_of_candidates")) << bad;
  EXPECT_TRUE(contains(refusal_of(parameters::maximum_depth((std::numeric_limits<std::size_t>::max)())),
                       "maximum_depth"));
}

TEST(Bad_input, Angles_that_are_none)
{
  for(double bad : { not_a_number, infinity, 7. })
    EXPECT_TRUE(contains(refusal_of(parameters::rotation_angles(std::vector<double>{ 0.5, bad })),
                         "Angle 1 of the parameter rotation_angles")) << bad;
  EXPECT_EQ(refusal_of(parameters::rotation_angles(std::vector<double>())), "");
}

TEST(Bad_input, Regions_that_are_no_boxes)
{
  typedef std::vector<CGAL::Bbox_3> Boxes;
  const Boxes inverted = { CGAL::Bbox_3(0, 0, 0, 1, 1, 1), CGAL::Bbox_3(0, 2, 0, 1, 1, 1) };
  EXPECT_EQ(refusal_of(parameters::regions(inverted)), "Box 1 of the parameter regions goes from (0, 2, 0) to "
            "(1, 1, 1); its lower corner must not lie above its upper corner.");
  EXPECT_TRUE(contains(refusal_of(parameters::excluded_regions(inverted)), "excluded_regions"));
  EXPECT_TRUE(contains(refusal_of(parameters::regions(Boxes(1))), "Box 0"));
  EXPECT_TRUE(contains(refusal_of(parameters::regions(Boxes(1, CGAL::Bbox_3(not_a_number, 0, 0, 1, 1, 1)))), "Box 0"));
  EXPECT_TRUE(contains(refusal_of(parameters::regions(Boxes())), "contains no box"));
}

TEST(Bad_input, Unknown_holes)
{
  Point_set points = samples::point_set(samples::plane_with_hole());
  EXPECT_TRUE(contains(refusal(points, parameters::hole_indices(std::vector<int>(1, 1000))), "There is no hole 1000"));
  EXPECT_TRUE(contains(refusal(points, parameters::hole_indices(std::vector<int>(1, -1))), "hole_indices is -1"));
}

TEST(Bad_input, Nothing_to_copy)
{
  Point_set points = samples::point_set(samples::plane_with_hole());
  const auto mask = points.add_property_map<bool>("mask", false).first;
  EXPECT_TRUE(contains(refusal(points, parameters::example_mask(mask)), "example_mask"));
  const std::vector<Point_set> examples(1, samples::point_set(samples::plane(20)));
  EXPECT_EQ(refusal(points, combine(parameters::example_mask(mask), parameters::example_point_sets(examples))), "");
}

TEST(Bad_input, Bad_examples)
{
  std::vector<Point_set> examples(2, samples::point_set(samples::plane(12)));
  examples[1].normal(8) = Vector(0, 0, 0);
  EXPECT_TRUE(contains(refusal_of(parameters::example_point_sets(std::cref(examples))),
                       "Example point set 2: Point 8 has the normal (0, 0, 0)"));
  examples[1].clear();
  EXPECT_TRUE(contains(refusal_of(parameters::example_point_sets(std::cref(examples))),
                       "Example point set 2: The point set has no normals"));
  examples[1].add_normal_map();
  EXPECT_TRUE(contains(refusal_of(parameters::example_point_sets(std::cref(examples))),
                       "Example point set 2: There are 0 points"));
}

TEST(Bad_input, Nothing_is_written_to_the_output)
{
  Point_set points = samples::point_set(samples::plane_with_hole());
  std::vector<std::pair<Point, Vector> > added;
  std::vector<CGAL::Context_completions_3::Hole_report_3> reports;
  EXPECT_THROW(CGAL::context_complete(points, std::back_inserter(added),
                                      combine(parameters::tolerance(-1.),
                                              parameters::hole_reports(std::back_inserter(reports)))),
               std::invalid_argument);
  EXPECT_TRUE(added.empty());
  EXPECT_TRUE(reports.empty());
}

} // namespace test_bad_input
