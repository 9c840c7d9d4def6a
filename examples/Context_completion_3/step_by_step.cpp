#include "include/sampled_sheet.h"

#include <CGAL/Context_completion_3.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Context_completion_3<Kernel, CGAL::Parallel_if_available_tag> Completion;
typedef CGAL::Context_completions_3::Hole_state Hole_state;
typedef CGAL::Context_completions_3::Filling Filling;

const char* name(Hole_state state)
{
  switch(state)
  {
  case Hole_state::hole: return "to be filled";
  case Hole_state::outer_border: return "outer border";
  case Hole_state::too_small: return "too small";
  case Hole_state::too_large: return "too large";
  case Hole_state::excluded: return "excluded";
  }
  return "";
}

const char* name(Filling filling)
{
  switch(filling)
  {
  case Filling::none: return "left open";
  case Filling::copied: return "copied";
  case Filling::smooth: return "smooth";
  case Filling::learned: return "learned";
  }
  return "";
}

int main()
{
  std::vector<Oriented_point> points = sample_sheet(egg_box);
  cut_hole(points, Point(2, 2, 0), 0.5);
  cut_hole(points, Point(5.6, 2.4, 0), 0.7);
  cut_hole(points, Point(4, 5.5, 0), 1);

  // Parameters of the search belong to the object; the points are read here and not needed afterwards.
  Completion completion(points, CGAL::parameters::number_of_turns(16)
                                  .point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                                  .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>()));
  std::cout << "The points are " << completion.spacing() << " apart." << std::endl;

  // Look at the holes.
  for(const Completion::Hole& hole : completion.detect_holes())
  {
    std::size_t number = 0;
    for(const std::vector<std::size_t>& loop : hole.loops)
      number += loop.size();
    std::cout << "Hole " << hole.id << " at (" << hole.center << "), diameter " << hole.diameter << ", " << number
              << " points on " << hole.loops.size() << " rims: " << name(hole.state) << std::endl;
  }

  // Fill the small ones first, then the others. Each point is written once.
  std::vector<Completion::New_point> new_points;
  completion.choose([](const Completion::Hole& hole) { return hole.is_to_be_filled() && hole.diameter < 1.6; });
  completion.complete(std::back_inserter(new_points));
  std::cout << new_points.size() << " points in " << completion.chosen().size() << " small holes." << std::endl;

  completion.choose_all();
  completion.complete(std::back_inserter(new_points));
  std::cout << new_points.size() << " points in " << completion.chosen().size() << " holes." << std::endl;

  for(const Completion::Hole_report& report : completion.report())
    std::cout << "Hole " << report.hole << ": " << name(report.filling) << ", " << report.number_of_points
              << " points, expected error " << report.expected_error << "; " << report.reason << std::endl;
  return new_points.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
