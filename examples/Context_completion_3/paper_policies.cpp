#include "include/sampled_sheet.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/context_complete.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Point_set_3<Point> Point_set;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

int main()
{
  std::vector<Oriented_point> samples = sample_sheet(egg_box);
  const Point center(5.6, 2.4, 0);
  const double radius = 0.7;
  cut_hole(samples, center, radius);

  for(bool paper : {false, true})
  {
    Point_set points;
    points.add_normal_map();
    for(const Oriented_point& sample : samples)
      points.insert(sample.first, sample.second);

    CGAL::Real_timer timer;
    timer.start();
    const std::size_t added = CGAL::context_complete<Concurrency_tag>(
      points, CGAL::parameters::use_paper_policies(paper));
    timer.stop();

    // Points over the hole, and points that were added elsewhere.
    std::size_t inside = 0;
    double sum = 0;
    for(Point_set::const_iterator it = points.end() - std::ptrdiff_t(added); it != points.end(); ++it)
    {
      const Point& p = points.point(*it);
      if(std::hypot(p.x() - center.x(), p.y() - center.y()) > radius + 0.1)
        continue;
      ++inside;
      sum += std::pow(deviation(p, egg_box), 2);
    }
    std::cout << (paper ? "Paper:   " : "Default: ") << inside << " points in the hole, " << added - inside
              << " elsewhere, rms distance to the truth " << (inside == 0 ? 0. : std::sqrt(sum / double(inside)))
              << ", " << timer.time() << " s" << std::endl;
  }
  return EXIT_SUCCESS;
}
