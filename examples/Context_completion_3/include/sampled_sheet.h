#ifndef SAMPLED_SHEET_H
#define SAMPLED_SHEET_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

// The surfaces of the examples: graphs z = height(x, y) over a square, so that the truth is known in a hole, too.

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::pair<Point, Vector> Oriented_point;
typedef std::function<double(double, double)> Height;

// Bumps and dents that repeat every 1.6 units.
inline double egg_box(double x, double y)
{
  return 0.15 * std::sin(3.9269908 * x) * std::sin(3.9269908 * y);
}

// Points on the graph over [0, side] x [0, side], irregular but evenly spread, with their normals.
inline std::vector<Oriented_point> sample_sheet(const Height& height, double side = 8, double spacing = 0.1)
{
  std::mt19937 engine(1);
  const auto jitter = [&]() { return 0.3 * spacing * (double(engine()) / 4294967296. - 0.5); };
  std::vector<Oriented_point> points;
  const double row_distance = 0.8660254 * spacing, epsilon = 1e-4;
  for(int j = 0; j * row_distance < side; ++j)
    for(int i = 0; i * spacing < side; ++i)
    {
      const double x = (i + (j % 2 == 0 ? 0.25 : 0.75)) * spacing + jitter(), y = j * row_distance + jitter();
      const double dx = (height(x + epsilon, y) - height(x - epsilon, y)) / (2 * epsilon);
      const double dy = (height(x, y + epsilon) - height(x, y - epsilon)) / (2 * epsilon);
      points.emplace_back(Point(x, y, height(x, y)), Vector(-dx, -dy, 1) / std::sqrt(dx * dx + dy * dy + 1));
    }
  return points;
}

// Removes the points in a ball.
inline void cut_hole(std::vector<Oriented_point>& points, const Point& center, double radius)
{
  points.erase(std::remove_if(points.begin(), points.end(), [&](const Oriented_point& p)
    { return CGAL::squared_distance(p.first, center) < radius * radius; }), points.end());
}

// How far a point lies above or below the true surface.
inline double deviation(const Point& p, const Height& height) { return std::abs(p.z() - height(p.x(), p.y())); }

#endif // SAMPLED_SHEET_H
