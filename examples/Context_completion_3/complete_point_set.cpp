#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/io.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/context_complete.h>
#include <CGAL/squared_distance_3.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Point_set_3<Point> Point_set;
typedef CGAL::Context_completions_3::Hole_report_3 Hole_report;

// Removes the points in a ball around one of them.
void cut_hole(Point_set& points, Point_set::Index center, double radius)
{
  const Point p = points.point(center);
  for(Point_set::iterator it = points.begin(); it != points.end(); )
    if(CGAL::squared_distance(points.point(*it), p) < radius * radius)
      points.remove(it); // the last point takes this place
    else
      ++it;
  points.collect_garbage();
}

int main(int argc, char* argv[])
{
  // Without arguments, a hole is cut into a complete model.
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  const std::string output = argc > 2 ? argv[2] : "completed.ply";

  Point_set points;
  if(!CGAL::IO::read_point_set(input, points))
  {
    std::cerr << "Error: " << input << " cannot be read." << std::endl;
    return EXIT_FAILURE;
  }
  if(argc < 2)
    cut_hole(points, Point_set::Index(2000), 0.08);
  std::cout << points.size() << " points were read." << std::endl;

  std::vector<Hole_report> reports;
  try
  {
    const std::size_t added = CGAL::context_complete<CGAL::Parallel_if_available_tag>(
      points, CGAL::parameters::hole_reports(std::back_inserter(reports)));
    std::cout << added << " points were added." << std::endl;
  }
  catch(const CGAL::Context_completions_3::Invalid_input& error)
  {
    std::cerr << "Error: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }

  for(const Hole_report& report : reports)
    std::cout << "Hole " << report.hole << ", diameter " << report.diameter << ": " << report.number_of_points
              << " points, expected error " << report.expected_error << "; " << report.reason << std::endl;

  std::ofstream file(output, std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  file << points;
  if(!file.flush())
  {
    std::cerr << "Error: " << output << " cannot be written." << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
