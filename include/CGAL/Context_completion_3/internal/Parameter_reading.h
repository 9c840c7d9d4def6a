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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PARAMETER_READING_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PARAMETER_READING_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/Default_completion_visitor.h>
#include <CGAL/Context_completion_3/internal/Engine_types.h>
#include <CGAL/Context_completion_3/internal/Input_conversion.h>
#include <CGAL/Context_completion_3/internal/Message.h>
#include <CGAL/Context_completion_3/internal/named_parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

namespace own_np = Context_completions_3::internal_np;

template <typename T>
constexpr bool is_given() { return !std::is_same<std::decay_t<T>, CGAL::internal_np::Param_not_found>::value; }

/// The value of an integer parameter, `standard` if it is not given; it must lie in [`least`, `most`].
template <typename T>
std::size_t read_count(const T& value, const char* name, std::size_t standard, std::size_t least, std::size_t most)
{
  if constexpr(is_given<T>())
  {
    static_assert(std::is_integral<T>::value, "this named parameter takes an integer");
    bool is_negative = false;
    if constexpr(std::is_signed<T>::value)
      is_negative = value < 0;
    require(!is_negative && static_cast<std::size_t>(value) >= least && static_cast<std::size_t>(value) <= most,
            "The parameter ", name, " is ", +value, "; it must be an integer from ", least, " to ", most, '.');
    return static_cast<std::size_t>(value);
  }
  else
    return standard;
}

/// The value of a length in model units, 0 if it is not given; it must be positive and finite, with two exceptions.
template <typename T>
double read_length(const T& value, const char* name, bool may_be_zero, bool may_be_infinite)
{
  if constexpr(is_given<T>())
  {
    double length = 0;
    if constexpr(std::is_arithmetic<T>::value)
      length = static_cast<double>(value);
    else
      length = CGAL::to_double(value);
    require(length > 0 || (may_be_zero && length == 0), "The parameter ", name, " is ", length, "; it must be ",
            may_be_zero ? "0 or positive." : "positive.");
    require(may_be_infinite || std::isfinite(length), "The parameter ", name, " is ", length, "; it must be finite.");
    return length;
  }
  else
    return 0;
}

template <typename T>
bool read_flag(const T& value, bool standard)
{
  if constexpr(is_given<T>())
    return value;
  else
    return standard;
}

/// A range of angles in radians, `standard` if it is not given.
template <typename Angles>
std::vector<double> read_angles(const Angles& angles, const char* name, const std::vector<double>& standard)
{
  if constexpr(is_given<Angles>())
  {
    std::vector<double> result;
    for(const auto& angle : angles)
    {
      result.push_back(CGAL::to_double(angle));
      require(std::abs(result.back()) <= 2 * CGAL_PI, "Angle ", result.size() - 1, " of the parameter ", name, " is ",
              result.back(), "; it must lie between -2 pi and 2 pi.");
    }
    return result;
  }
  else
    return standard;
}

template <typename FT>
Vector corner(const FT& x, const FT& y, const FT& z)
{
  return Vector(CGAL::to_double(x), CGAL::to_double(y), CGAL::to_double(z));
}

/// A range of `Bbox_3` or `Iso_cuboid_3`, in the coordinates of the engine.
template <typename Regions>
std::vector<Bbox_3> read_regions(const Regions& regions, const char* name, const Frame& frame,
                                 bool may_be_empty = false)
{
  std::vector<Bbox_3> boxes;
  if constexpr(is_given<Regions>())
  {
    for(const auto& region : regions)
    {
      const Vector lower = corner(region.xmin(), region.ymin(), region.zmin());
      const Vector upper = corner(region.xmax(), region.ymax(), region.zmax());
      require(!lower.hasNaN() && !upper.hasNaN() && (lower.array() <= upper.array()).all(), "Box ", boxes.size(),
              " of the parameter ", name, " goes from ", coordinates(lower), " to ", coordinates(upper),
              "; its lower corner must not lie above its upper corner.");
      boxes.push_back(frame.box_to_engine(Bbox_3(lower.x(), lower.y(), lower.z(), upper.x(), upper.y(), upper.z())));
    }
    require(may_be_empty || !boxes.empty(), "The parameter ", name, " is given but contains no box.");
  }
  return boxes;
}

/*!
  A range of ranges of indices of points, in the indices of the engine.
  \param index what the caller calls the points
*/
template <typename Rims>
std::vector<std::vector<std::size_t> > read_rims(const Rims& rims, const char* name,
                                                 const std::vector<std::size_t>& index)
{
  std::vector<std::vector<std::size_t> > result;
  if constexpr(is_given<Rims>())
  {
    if(rims.begin() == rims.end())
      return result;
    std::unordered_map<std::size_t, std::size_t> engine_index;
    for(std::size_t i = 0; i < index.size(); ++i)
      engine_index[index[i]] = i;
    for(const auto& rim : rims)
    {
      std::vector<std::size_t> points;
      std::set<std::size_t> seen;
      for(const auto& point : rim)
      {
        const auto found = engine_index.find(static_cast<std::size_t>(point));
        require(found != engine_index.end(), "Rim ", result.size(), " of the parameter ", name, " names point ", +point,
                "; there is no such point.");
        require(seen.insert(found->second).second, "Rim ", result.size(), " of the parameter ", name,
                " names point ", +point, " twice.");
        points.push_back(found->second);
      }
      require(points.size() >= 3, "Rim ", result.size(), " of the parameter ", name, " has ", points.size(),
              " points; at least 3 are needed to go around a hole.");
      result.push_back(points);
    }
  }
  return result;
}

template <typename Indices>
std::vector<std::size_t> read_hole_indices(const Indices& indices)
{
  std::vector<std::size_t> chosen;
  for(const auto& index : indices)
    chosen.push_back(read_count(index, "hole_indices", 0, 0, (std::numeric_limits<std::size_t>::max)()));
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

template <typename PointRange, typename Mask>
std::vector<char> read_mask(const PointRange& points, const Mask& mask)
{
  std::vector<char> is_example;
  if constexpr(is_given<Mask>())
    for(auto it = points.begin(); it != points.end(); ++it)
      is_example.push_back(get(mask, *it) ? 1 : 0);
  return is_example;
}

/*!
  The settings of a run; example point sets are added to `examples`.
  \param index what the caller calls the points
  \param example_indices receives the same for each of the example point sets
*/
template <typename PointRange, typename NamedParameters>
Engine_parameters read_parameters(const PointRange& points, const NamedParameters& np, const Frame& frame,
                                  const std::vector<std::size_t>& index,
                                  std::vector<std::vector<std::size_t> >& example_indices)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;

  Engine_parameters result;
  result.paper = read_flag(get_parameter(np, own_np::use_paper_policies), result.paper);
  result.mirror = read_flag(get_parameter(np, own_np::use_mirrors), result.mirror);
  result.keep_texture = read_flag(get_parameter(np, own_np::keep_texture), result.keep_texture);
  result.cube_symmetries = read_flag(get_parameter(np, own_np::use_cube_symmetries), result.cube_symmetries);
  result.support_balls = read_flag(get_parameter(np, own_np::use_support_balls), result.support_balls);
  result.box_subdivision = read_flag(get_parameter(np, own_np::use_box_subdivision), result.box_subdivision);
  result.rotation_angles =
    read_angles(get_parameter_reference(np, own_np::rotation_angles), "rotation_angles", result.rotation_angles);
  result.random_seed =
    static_cast<unsigned int>(choose_parameter(get_parameter(np, CGAL::internal_np::random_seed), 0u));

  result.minimum_hole_diameter =
    read_length(get_parameter(np, own_np::minimum_hole_diameter), "minimum_hole_diameter", true, false);
  const double maximum =
    read_length(get_parameter(np, own_np::maximum_hole_diameter), "maximum_hole_diameter", false, true);
  require(maximum == 0 || result.minimum_hole_diameter <= maximum, "The parameter minimum_hole_diameter is ",
          result.minimum_hole_diameter, ", above maximum_hole_diameter, which is ", maximum, '.');
  result.maximum_hole_diameter = std::isfinite(maximum) ? maximum : 0;
  result.tolerance = read_length(get_parameter(np, own_np::tolerance), "tolerance", false, false);

  result.maximum_depth = read_count(get_parameter(np, own_np::maximum_depth), "maximum_depth",
                                    result.maximum_depth, 1, 20);
  // six points determine a bivariate quadratic polynomial, the least of the local approximations
  result.minimum_cell_points = read_count(get_parameter(np, own_np::minimum_cell_points), "minimum_cell_points",
                                          result.minimum_cell_points, 6, 100000);
  result.number_of_turns = read_count(get_parameter(np, own_np::number_of_turns), "number_of_turns",
                                      result.number_of_turns, 1, 360);
  result.number_of_candidates = read_count(get_parameter(np, own_np::number_of_candidates), "number_of_candidates",
                                           result.number_of_candidates, 1, 10000000);

  result.regions = read_regions(get_parameter_reference(np, own_np::regions), "regions", frame);
  result.excluded_regions =
    read_regions(get_parameter_reference(np, own_np::excluded_regions), "excluded_regions", frame);

  result.user_holes = read_regions(get_parameter_reference(np, own_np::user_holes), "user_holes", frame, true);
  result.known_rims = read_rims(get_parameter_reference(np, own_np::known_rims), "known_rims", index);

  const auto& example_sets = get_parameter_reference(np, own_np::example_point_sets);
  if constexpr(is_given<decltype(example_sets)>())
    for(const auto& set : example_sets)
    {
      const std::string name = message("Example point set ", result.examples.size() + 1, ": ");
      Converted_input input;
      // the maps of the named parameters may belong to the completed Point_set_3, so a further one uses its own
      if constexpr(Point_set_type<std::decay_t<decltype(set)> >::is_point_set)
        input = convert_input(set, parameters::default_values(), name);
      else
        input = convert_input(set, np, name);
      result.examples.push_back(std::move(input.points));
      example_indices.push_back(std::move(input.index));
    }

  result.is_example = read_mask(points, get_parameter(np, own_np::example_mask));
  require(result.is_example.empty() || !result.examples.empty() ||
          std::find(result.is_example.begin(), result.is_example.end(), 1) != result.is_example.end(),
          "The parameter example_mask bars all points and there are no example_point_sets; there is nothing to copy.");
  return result;
}

template <typename NamedParameters>
std::function<bool(double)> read_callback(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, CGAL::internal_np::callback),
                                      std::function<bool(double)>());
}

/// Calls `function` with the visitor of the named parameters, by reference, or with the default one.
template <typename NamedParameters, typename Function>
auto with_visitor(const NamedParameters& np, const Function& function)
{
  typedef typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::visitor_t, NamedParameters,
                                                             Default_completion_visitor>::reference Visitor;
  Default_completion_visitor standard;
  Visitor visitor = parameters::choose_parameter(
    parameters::get_parameter_reference(np, CGAL::internal_np::visitor), standard);
  return function(visitor);
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PARAMETER_READING_H
