#include "include/sampled_sheet.h"

#include <CGAL/context_complete.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

int main()
{
  // A point with its normal can be any type, as long as two property maps tell position and normal.
  std::vector<Oriented_point> points = sample_sheet(egg_box);
  cut_hole(points, Point(5.6, 2.4, 0), 0.7);

  std::vector<Oriented_point> new_points;
  CGAL::context_complete<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(new_points),
    CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                     .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>()));
  if(new_points.empty())
  {
    std::cerr << "Error: the hole was not found." << std::endl;
    return EXIT_FAILURE;
  }

  double largest = 0, sum = 0;
  for(const Oriented_point& p : new_points)
  {
    largest = (std::max)(largest, deviation(p.first, egg_box));
    sum += deviation(p.first, egg_box);
  }
  std::cout << points.size() << " points, and " << new_points.size() << " new ones.\n"
            << "Distance to the true surface: mean " << sum / double(new_points.size()) << ", largest " << largest
            << ", where points are 0.1 apart." << std::endl;
  return EXIT_SUCCESS;
}
