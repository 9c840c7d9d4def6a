#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/io.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/context_complete.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Point_set_3<Point> Point_set;
typedef CGAL::Context_completions_3::Hole_report_3 Hole_report;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace Context_completions = CGAL::Context_completions_3;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/mech-holes-shark.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(input, mesh))
  {
    std::cerr << "Error: " << input << " is no surface mesh." << std::endl;
    return EXIT_FAILURE;
  }

  // The vertices are the points, in the same order; the mesh tells their normals.
  Point_set points(true);
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal", CGAL::NULL_VECTOR).first;
  PMP::compute_vertex_normals(mesh, normals);
  std::vector<std::size_t> index(mesh.num_vertices());
  for(Mesh::Vertex_index v : mesh.vertices())
    index[v] = *points.insert(mesh.point(v), normals[v]);

  // Each border is taken for the rim of a hole.
  std::vector<std::vector<std::size_t> > rims;
  std::vector<bool> is_in_rim(mesh.num_halfedges(), false);
  for(Mesh::Halfedge_index border : mesh.halfedges())
  {
    if(!mesh.is_border(border) || is_in_rim[border])
      continue;
    rims.emplace_back();
    for(Mesh::Halfedge_index h : CGAL::halfedges_around_face(border, mesh))
    {
      is_in_rim[h] = true;
      rims.back().push_back(index[mesh.target(h)]);
    }
  }

  std::vector<Hole_report> reports;
  const std::size_t added = CGAL::context_complete<CGAL::Parallel_if_available_tag>(
    points, Context_completions::combine(CGAL::parameters::known_rims(rims),
                                         CGAL::parameters::hole_reports(std::back_inserter(reports))));
  std::cout << rims.size() << " borders; " << added << " points were added." << std::endl;
  std::size_t filled = 0;
  for(const Hole_report& report : reports)
    if(report.number_of_points > 0)
    {
      ++filled;
      std::cout << "Hole " << report.hole << ", diameter " << report.diameter << ": " << report.number_of_points
                << " points; " << report.reason << std::endl;
    }
  std::ofstream file("completed_mesh.ply", std::ios::binary);
  CGAL::IO::set_binary_mode(file);
  file << points;
  return file.flush() && filled > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
