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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PROPERTY_TRANSFER_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PROPERTY_TRANSFER_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/New_point_3.h>
#include <CGAL/Context_completion_3/internal/Input_conversion.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Parameter_reading.h>
#include <CGAL/Context_completion_3/internal/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Point_set_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// Writes a value to a property map, if the map was given.
template <typename Map, typename Key, typename Value>
void put_if_given(const Map& map, const Key& key, const Value& value)
{
  if constexpr(is_given<Map>())
  {
    using boost::put;
    put(map, key, static_cast<typename boost::property_traits<Map>::value_type>(value));
  }
  else
  {
    CGAL_USE(map);
    CGAL_USE(key);
    CGAL_USE(value);
  }
}

/// Fills the maps `source_map`, `source_set_map`, `hole_map` and `confidence_map` for one new point.
template <typename Key, typename New_point, typename NamedParameters>
void put_history(const Key& key, const New_point& point, const NamedParameters& np)
{
  using parameters::get_parameter;
  put_if_given(get_parameter(np, own_np::source_map), key, point.source);
  put_if_given(get_parameter(np, own_np::source_set_map), key, point.source_set);
  put_if_given(get_parameter(np, own_np::hole_map), key, point.hole);
  put_if_given(get_parameter(np, own_np::confidence_map), key, point.confidence);
}

/*!
  Appends new points with all properties of their sources to a `Point_set_3`, whatever the types of the properties.

  `Point_set_3::insert()` does not serve: it puts points into the places of removed ones, which overwrites other
  entries of the index table, and there is no way back if a copy of a property throws. Here the arrays are made longer
  instead, the new entries of the index table are moved before those of the removed points, and an exception makes
  the arrays as short as they were.
*/
template <typename Point, typename Vector_>
class Property_transfer
{
  typedef Point_set_3<Point, Vector_> Point_set;
  typedef typename Point_set::Index Index;
  typedef typename Point_set::Base Container;
  typedef New_point_3<typename Kernel_traits<Point>::Kernel> New_point;

  // a point set hands out its container as const only, but the set is ours to change
  static Container& container(Point_set& points) { return const_cast<Container&>(points.base()); }

public:
  explicit Property_transfer(Point_set& points) : m_points(points) {}

  /// Prepares the properties of the further example sets that are in use. To be called before `append()`.
  template <typename New_points, typename NamedParameters>
  void read_examples(const New_points& new_points, const NamedParameters& np)
  {
    const auto& sets = parameters::get_parameter_reference(np, own_np::example_point_sets);
    if constexpr(is_given<decltype(sets)>())
    {
      std::vector<bool> is_used;
      is_used.resize(static_cast<std::size_t>(std::distance(sets.begin(), sets.end())) + 1, false);
      for(const auto& point : new_points)
        if(point.has_source())
          is_used[point.source_set] = true;
      m_examples.resize(is_used.size());
      std::size_t i = 1;
      for(auto it = sets.begin(); it != sets.end(); ++it, ++i)
        if(is_used[i])
          m_examples[i] = with_our_properties(*it);
    }
  }

  /// Appends all points, or none if an exception is thrown.
  template <typename New_points, typename NamedParameters>
  void append(const New_points& new_points, const NamedParameters& np)
  {
    if(new_points.empty())
      return;
    const std::vector<std::size_t> donors = nearest_points(new_points);
    Container& properties = container(m_points);
    const std::size_t number = m_points.number_of_points();
    const std::size_t first = properties.size();
    try
    {
      properties.reserve(first + new_points.size());
      properties.resize(first + new_points.size());
      for(std::size_t i = 0; i < new_points.size(); ++i)
        write(new_points[i], donors[i], first + i, np);
    }
    catch(...)
    {
      properties.resize(first);
      throw;
    }
    const auto begin = m_points.begin();
    for(std::size_t i = first; i < first + new_points.size(); ++i)
      *(begin + static_cast<std::ptrdiff_t>(i)) = Index(i);
    std::rotate(begin + static_cast<std::ptrdiff_t>(number), begin + static_cast<std::ptrdiff_t>(first),
                begin + static_cast<std::ptrdiff_t>(first + new_points.size()));
  }

private:
  template <typename Example>
  std::unique_ptr<Point_set> with_our_properties(const Example& example) const
  {
    if constexpr(std::is_same<Example, Point_set>::value)
    {
      // the same properties in the same order, which the transfer of single elements needs
      auto result = std::make_unique<Point_set>();
      result->copy_properties(m_points);
      container(*result).resize(example.base().size());
      container(*result).transfer(example.base());
      return result;
    }
    else
    {
      CGAL_USE(example);
      return nullptr;
    }
  }

  /// For points without source the point of the set whose properties they take: the nearest one.
  template <typename New_points>
  std::vector<std::size_t> nearest_points(const New_points& new_points) const
  {
    std::vector<std::size_t> donors(new_points.size(), New_point::no_source());
    std::unique_ptr<Neighbor_search> search;
    std::vector<std::size_t> indices;
    Vector origin = Vector::Zero();
    for(std::size_t i = 0; i < new_points.size(); ++i)
    {
      if(new_points[i].has_source())
        continue;
      if(!search)
      {
        std::vector<Vector> positions;
        origin = to_vector(m_points.point(*m_points.begin()));
        for(const Index& index : m_points)
        {
          positions.push_back(to_vector(m_points.point(index)) - origin);
          indices.push_back(index);
        }
        search = std::make_unique<Neighbor_search>(positions);
      }
      donors[i] = indices[search->nearest(to_vector(new_points[i].point) - origin).first];
    }
    return donors;
  }

  template <typename New_point_, typename NamedParameters>
  void write(const New_point_& point, std::size_t donor, std::size_t place, const NamedParameters& np)
  {
    Container& properties = container(m_points);
    if(!point.has_source())
      properties.transfer(properties, donor, place);
    else if(point.source_set == 0)
      properties.transfer(properties, point.source, place);
    else if(m_examples[point.source_set])
      properties.transfer(m_examples[point.source_set]->base(), point.source, place);

    const Index index(place);
    m_points.point(index) = point.point;
    if(m_points.has_normal_map())
      m_points.normal(index) = point.normal;
    put_if_given(parameters::get_parameter(np, CGAL::internal_np::point_map), index, point.point);
    put_if_given(parameters::get_parameter(np, CGAL::internal_np::normal_map), index, point.normal);
    put_history(index, point, np);
  }

  Point_set& m_points;
  std::vector<std::unique_ptr<Point_set> > m_examples;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PROPERTY_TRANSFER_H
