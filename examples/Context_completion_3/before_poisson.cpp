#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/context_complete.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/squared_distance_3.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Point_set_3<Point> Point_set;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  Point_set scan;
  if(!CGAL::IO::read_point_set(input, scan))
  {
    std::cerr << "Error: " << input << " cannot be read." << std::endl;
    return EXIT_FAILURE;
  }

  // Take positions only, and, without an argument, leave a hole.
  Point_set points;
  const Point center = scan.point(*(scan.begin() + std::ptrdiff_t(scan.size() / 2)));
  for(Point_set::Index i : scan)
    if(argc > 1 || CGAL::squared_distance(scan.point(i), center) > 0.08 * 0.08)
      points.insert(scan.point(i));
  points.add_normal_map();

  // 1. Normals that point to one side. Points that were not reached cannot be used.
  CGAL::jet_estimate_normals<Concurrency_tag>(points, 18);
  const Point_set::iterator unoriented = CGAL::mst_orient_normals(points, 18);
  points.remove(unoriented, points.end());
  points.collect_garbage();

  // 2. Completion.
  const std::size_t number = points.size(), added = CGAL::context_complete<Concurrency_tag>(points);
  std::cout << number << " points, and " << added << " new ones." << std::endl;

  // 3. A mesh.
  const double spacing = CGAL::compute_average_spacing<Concurrency_tag>(points, 6);
  Mesh mesh;
  if(!CGAL::poisson_surface_reconstruction_delaunay(points.begin(), points.end(), points.point_map(),
                                                    points.normal_map(), mesh, spacing))
  {
    std::cerr << "Error: the reconstruction failed." << std::endl;
    return EXIT_FAILURE;
  }
  std::ofstream file("reconstructed.off");
  file.precision(17);
  file << mesh;
  if(!file.flush())
  {
    std::cerr << "Error: reconstructed.off cannot be written." << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "The mesh has " << mesh.number_of_vertices() << " vertices." << std::endl;
  return EXIT_SUCCESS;
}
