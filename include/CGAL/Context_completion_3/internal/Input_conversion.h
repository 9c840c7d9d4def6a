// Copyright (c) 2026 The Context_completion_3 authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Context_completion_3 authors

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_INPUT_CONVERSION_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_INPUT_CONVERSION_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Message.h>
#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The place of the engine's coordinates in the caller's. Moving the centre of the bounding box to the origin keeps the
  digits of georeferenced coordinates.
*/
class Frame
{
public:
  explicit Frame(const Vector& center = Vector::Zero()) : m_center(center) {}

  const Vector& center() const { return m_center; }

  template <typename GeomTraits>
  typename GeomTraits::Point_3 point(const Vector& v, const GeomTraits& traits) const
  {
    typedef typename GeomTraits::FT FT;
    const Vector p = m_center + v;
    return traits.construct_point_3_object()(static_cast<FT>(p.x()), static_cast<FT>(p.y()), static_cast<FT>(p.z()));
  }

  template <typename GeomTraits>
  static typename GeomTraits::Vector_3 vector(const Vector& v, const GeomTraits& traits)
  {
    typedef typename GeomTraits::FT FT;
    return traits.construct_vector_3_object()(static_cast<FT>(v.x()), static_cast<FT>(v.y()), static_cast<FT>(v.z()));
  }

  Bbox_3 box_to_engine(const Bbox_3& b) const { return moved(b, -m_center); }
  Bbox_3 box(const Bbox_3& b) const { return moved(b, m_center); }

private:
  static Bbox_3 moved(const Bbox_3& b, const Vector& by)
  {
    return Bbox_3(b.xmin() + by.x(), b.ymin() + by.y(), b.zmin() + by.z(),
                  b.xmax() + by.x(), b.ymax() + by.y(), b.zmax() + by.z());
  }

  Vector m_center;
};

/// A point set as the engine takes it.
struct Converted_input
{
  Surface_points points;            ///< in the coordinates of the engine, with unit normals
  Frame frame;
  std::vector<std::size_t> index;   ///< what the caller calls the i-th point
};

/// The coordinates of a point or vector of any kernel.
template <typename Point_or_vector>
Vector to_vector(const Point_or_vector& p)
{
  return Vector(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

/// Half of the last digit that the number type can represent; exact types are read as `double`.
template <typename FT>
constexpr double precision()
{
  return std::is_same<FT, float>::value ? std::numeric_limits<float>::epsilon()
                                        : std::numeric_limits<double>::epsilon();
}

template <typename PointRange>
struct Point_set_type
{
  static constexpr bool is_point_set = false;
};

template <typename Point, typename Vector_>
struct Point_set_type<Point_set_3<Point, Vector_> >
{
  static constexpr bool is_point_set = true;
};

/// Moves the centre of the bounding box to the origin. \return the frame, after checks of the extent.
inline Frame center_points(std::vector<Vector>& positions, double precision, const std::string& name)
{
  Vector lower = positions.front(), upper = positions.front();
  for(const Vector& p : positions)
  {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  const double largest = (std::max)(lower.cwiseAbs().maxCoeff(), upper.cwiseAbs().maxCoeff());
  const double extent = (upper - lower).maxCoeff();
  require(extent > 0, name, "All ", positions.size(), " points are equal to ", coordinates(lower),
          "; a surface is needed.");
  // squares and cubes of lengths must neither overflow nor vanish
  require(extent >= 1e-90 && extent <= 1e90, name, "The extent of the points is ", extent,
          "; it must lie between 1e-90 and 1e90.");

  const Vector center = 0.5 * lower + 0.5 * upper;
  for(Vector& p : positions)
    p -= center;

  // the point farthest from the first one, then the one farthest from the line through both
  const Vector first = positions.front();
  Vector direction = Vector::Zero();
  for(const Vector& p : positions)
    if((p - first).norm() > direction.norm())
      direction = p - first;
  double height = 0;
  for(const Vector& p : positions)
    height = (std::max)(height, direction.normalized().cross(p - first).norm());
  require(height > 4 * (precision * largest + std::numeric_limits<double>::epsilon() * extent), name, "All ",
          positions.size(), " points lie on a line; a surface is needed.");
  return Frame(center);
}

/// The least number of points that a surface can be told from.
inline std::size_t minimum_number_of_points() { return 15; }

/*!
  Reads and checks a point set.
  \param name empty, or the name of the set and a colon, for the sentences of exceptions
*/
template <typename FT, typename PointRange, typename PointMap, typename NormalMap>
Converted_input convert_input(const PointRange& points, const PointMap& point_map, const NormalMap& normal_map,
                              const std::string& name)
{
  Converted_input input;
  for(auto it = points.begin(); it != points.end(); ++it)
  {
    std::size_t index = input.index.size();
    if constexpr(Point_set_type<PointRange>::is_point_set)
      index = static_cast<std::size_t>(*it);
    const Vector position = to_vector(get(point_map, *it));
    Vector normal = to_vector(get(normal_map, *it));
    require(position.allFinite(), name, "Point ", index, " has the non-finite position ", coordinates(position), '.');
    require(normal.allFinite(), name, "Point ", index, " has the non-finite normal ", coordinates(normal), '.');
    const double size = normal.cwiseAbs().maxCoeff();
    require(size > 0, name, "Point ", index, " has the normal (0, 0, 0); normals can be estimated with "
            "CGAL::jet_estimate_normals() and CGAL::mst_orient_normals().");
    normal /= size; // lengths near the limits of the number type are as good as any other
    input.points.push_back(position, normal.normalized());
    input.index.push_back(index);
  }
  require(input.points.size() >= minimum_number_of_points(), name, "There are ", input.points.size(),
          " points; at least ", minimum_number_of_points(), " are needed.");
  input.frame = center_points(input.points.position, precision<FT>(), name);
  return input;
}

/// Reads and checks a point set with the maps of the named parameters, or with its own maps if it is a `Point_set_3`.
template <typename PointRange, typename NamedParameters>
Converted_input convert_input(const PointRange& points, const NamedParameters& np, const std::string& name)
{
  typedef Point_set_processing_3_np_helper<PointRange, NamedParameters> Helper;

  const char* hint = "normals can be estimated with CGAL::jet_estimate_normals() and CGAL::mst_orient_normals().";
  const bool has_parameter =
    !parameters::is_default_parameter<NamedParameters, CGAL::internal_np::normal_t>::value;
  if constexpr(Point_set_type<PointRange>::is_point_set)
  {
    require(has_parameter || points.has_normal_map(), name, "The point set has no normals; ", hint);
    require(has_parameter || (points.normal_map() ? true : false), name, "The point set has a property \"normal\" "
            "which it does not know as its normals; call add_normal_map().");
  }
  else
    require(has_parameter, name, "The points have no normals, as the named parameter normal_map is missing; ", hint);
  return convert_input<typename Helper::FT>(points, Helper::get_const_point_map(points, np),
                                            Helper::get_normal_map(points, np), name);
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_INPUT_CONVERSION_H
