#include "include/sampled_sheet.h"

#include <CGAL/IO/Color.h>
#include <CGAL/IO/io.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/context_complete.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

typedef CGAL::Point_set_3<Point> Point_set;

// Tops are red, hollows are blue.
CGAL::IO::Color color_of_height(double z)
{
  return z > 0.05 ? CGAL::IO::Color(200, 40, 30) : z < -0.05 ? CGAL::IO::Color(30, 60, 200)
                                                             : CGAL::IO::Color(230, 230, 220);
}

int main()
{
  std::vector<Oriented_point> samples = sample_sheet(egg_box);
  cut_hole(samples, Point(5.6, 2.4, 0), 0.7);

  Point_set points;
  points.add_normal_map();
  const auto color = points.add_property_map<CGAL::IO::Color>("color").first;
  for(const Oriented_point& sample : samples)
    color[*points.insert(sample.first, sample.second)] = color_of_height(sample.first.z());

  // What was there before keeps the default values of these properties.
  const auto source = points.add_property_map<int>("source", -1).first;
  const auto hole = points.add_property_map<int>("hole", -1).first;
  const auto confidence = points.add_property_map<double>("confidence", 1.).first;

  namespace parameters = CGAL::parameters;
  const std::size_t added = CGAL::context_complete<CGAL::Parallel_if_available_tag>(
    points, CGAL::Context_completions_3::combine(parameters::source_map(source), parameters::hole_map(hole),
                                                 parameters::confidence_map(confidence)));

  if(added == 0)
  {
    std::cerr << "Error: the hole was not found." << std::endl;
    return EXIT_FAILURE;
  }

  // The new points are the last ones. Their colours were copied, not computed from their heights.
  std::size_t with_source = 0, right_color = 0;
  double sum = 0;
  for(Point_set::const_iterator it = points.end() - std::ptrdiff_t(added); it != points.end(); ++it)
  {
    with_source += source[*it] >= 0;
    right_color += color[*it] == color_of_height(egg_box(points.point(*it).x(), points.point(*it).y()));
    sum += confidence[*it];
  }
  std::cout << added << " new points, " << with_source << " of them copies, " << right_color
            << " with the colour of the true surface; mean confidence " << sum / double(added) << std::endl;

  const Point_set::Index last = *(points.end() - 1);
  std::cout << "The last one fills hole " << hole[last];
  if(source[last] >= 0)
    std::cout << " and is a copy of point " << source[last] << " at ("
              << points.point(Point_set::Index(std::size_t(source[last]))) << ")";
  std::cout << "." << std::endl;

  std::ofstream file("colored.ply", std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  file << points;
  if(!file.flush())
  {
    std::cerr << "Error: colored.ply cannot be written." << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
