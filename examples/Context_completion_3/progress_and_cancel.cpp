#include "include/sampled_sheet.h"

#include <CGAL/Context_completion_3/Default_completion_visitor.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/context_complete.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <vector>

typedef CGAL::Point_set_3<Point> Point_set;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

// A visitor overrides what it wants to hear of.
struct Events : public CGAL::Context_completions_3::Default_completion_visitor
{
  std::size_t number_of_events = 0;

  void on_detection_end(std::size_t number_of_holes)
  {
    ++number_of_events;
    std::cout << "  " << number_of_holes << " holes were found" << std::endl;
  }
  void on_hole_begin(std::size_t hole)
  {
    ++number_of_events;
    std::cout << "  hole " << hole << " is being filled" << std::endl;
  }
  void on_hole_end(std::size_t hole, std::size_t number_of_new_points)
  {
    ++number_of_events;
    std::cout << "  hole " << hole << " got " << number_of_new_points << " points" << std::endl;
  }
};

int main()
{
  std::vector<Oriented_point> samples = sample_sheet(egg_box);
  cut_hole(samples, Point(2, 2, 0), 0.6);
  cut_hole(samples, Point(5.6, 5.5, 0), 0.6);
  Point_set points;
  points.add_normal_map();
  for(const Oriented_point& sample : samples)
    points.insert(sample.first, sample.second);
  const std::size_t number = points.size();

  // 1. The callback returns false after the first hole: nothing is changed.
  Events events;
  std::cout << "A run that is cancelled:" << std::endl;
  std::size_t added = CGAL::context_complete<Concurrency_tag>(points, CGAL::parameters::callback([](double fraction)
    { return fraction < 0.5; }).visitor(std::ref(events)));
  std::cout << "  " << added << " points were added" << std::endl;
  if(added != 0 || points.size() != number)
    return EXIT_FAILURE;

  // 2. The callback prints the progress in steps of a quarter.
  int quarters = 0;
  std::cout << "A full run:" << std::endl;
  added = CGAL::context_complete<Concurrency_tag>(points, CGAL::parameters::callback([&](double fraction)
    {
      for(; quarters < 4 && 4 * fraction >= quarters + 1; ++quarters)
        std::cout << "  " << 25 * (quarters + 1) << " % are done" << std::endl;
      return true;
    }).visitor(std::ref(events)));
  std::cout << "  " << added << " points were added" << std::endl;
  return events.number_of_events > 0 && points.size() == number + added ? EXIT_SUCCESS : EXIT_FAILURE;
}
