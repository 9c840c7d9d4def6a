#include "include/sampled_sheet.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/context_complete.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Point_set_3<Point> Point_set;
typedef CGAL::Context_completions_3::Hole_report_3 Hole_report;

Point_set point_set(const std::vector<Oriented_point>& samples)
{
  Point_set points;
  points.add_normal_map();
  for(const Oriented_point& sample : samples)
    points.insert(sample.first, sample.second);
  return points;
}

// A gently curved sheet with one rosette.
double sheet_with_rosette(double x, double y, double center_x, double center_y)
{
  const double dx = x - center_x, dy = y - center_y, r = std::sqrt(dx * dx + dy * dy);
  if(r > 1.2)
    return 0.02 * x * x;
  return 0.02 * x * x + 0.12 * std::pow(std::cos(1.3089969 * r), 2) * (1 + std::cos(6 * std::atan2(dy, dx)) * r);
}

double mean_deviation(const Point_set& points, std::size_t added, const Height& height)
{
  double sum = 0;
  for(Point_set::const_iterator it = points.end() - std::ptrdiff_t(added); it != points.end(); ++it)
    sum += deviation(points.point(*it), height);
  return added == 0 ? 0. : sum / double(added);
}

int main()
{
  namespace parameters = CGAL::parameters;
  using CGAL::Context_completions_3::combine;

  // 1. The hole takes the better part of the only rosette, but a second scan shows another one.
  const Height truth = [](double x, double y) { return sheet_with_rosette(x, y, 3.2, 2.9); };
  std::vector<Oriented_point> damaged = sample_sheet(truth, 6);
  cut_hole(damaged, Point(3.3, 2.9, truth(3.3, 2.9)), 0.7);
  const Height other = [](double x, double y) { return sheet_with_rosette(x, y, 2.1, 2.2); };
  const std::vector<Point_set> examples(1, point_set(sample_sheet(other, 4.5)));

  Point_set alone = point_set(damaged), taught = point_set(damaged);
  std::size_t added = CGAL::context_complete<CGAL::Parallel_if_available_tag>(alone);
  std::cout << "Without the example: " << added << " points, mean distance to the truth "
            << mean_deviation(alone, added, truth) << std::endl;

  const auto source_set = taught.add_property_map<int>("source_set", 0).first;
  std::vector<Hole_report> reports;
  added = CGAL::context_complete<CGAL::Parallel_if_available_tag>(
    taught, combine(parameters::example_point_sets(std::cref(examples)), parameters::source_set_map(source_set),
                    parameters::hole_reports(std::back_inserter(reports))));
  const std::ptrdiff_t from_example = std::count_if(taught.end() - std::ptrdiff_t(added), taught.end(),
    [&](Point_set::Index i) { return source_set[i] == 1; });
  std::cout << "With the example: " << added << " points, " << from_example << " from it, mean distance to the truth "
            << mean_deviation(taught, added, truth) << std::endl;
  for(const Hole_report& report : reports)
    std::cout << "  " << report.reason << std::endl;

  // 2. Only the left half may be copied, say because the right half was scanned badly.
  std::vector<Oriented_point> samples = sample_sheet(egg_box);
  cut_hole(samples, Point(5.6, 2.4, 0), 0.7);
  Point_set points = point_set(samples);
  const auto is_example = points.add_property_map<bool>("is_example", true).first;
  for(Point_set::Index i : points)
    is_example[i] = points.point(i).x() < 4;
  const auto source = points.add_property_map<int>("source", -1).first;
  added = CGAL::context_complete<CGAL::Parallel_if_available_tag>(
    points, combine(parameters::example_mask(is_example), parameters::source_map(source)));
  const std::ptrdiff_t from_right = std::count_if(points.end() - std::ptrdiff_t(added), points.end(),
    [&](Point_set::Index i)
      { return source[i] >= 0 && points.point(Point_set::Index(std::size_t(source[i]))).x() >= 4; });
  std::cout << "With a mask: " << added << " points, " << from_right << " from the barred half, mean distance to the "
            << "truth " << mean_deviation(points, added, egg_box) << std::endl;
  return added > 0 && from_right == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
