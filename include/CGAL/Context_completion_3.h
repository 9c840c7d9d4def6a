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

#ifndef CGAL_CONTEXT_COMPLETION_3_H
#define CGAL_CONTEXT_COMPLETION_3_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Context_completion_3/Default_completion_visitor.h>
#include <CGAL/Context_completion_3/Hole_3.h>
#include <CGAL/Context_completion_3/Hole_report_3.h>
#include <CGAL/Context_completion_3/Invalid_input.h>
#include <CGAL/Context_completion_3/New_point_3.h>
#include <CGAL/Context_completion_3/internal/Completion_session.h>
#include <CGAL/Context_completion_3/internal/Input_conversion.h>
#include <CGAL/Context_completion_3/internal/Message.h>
#include <CGAL/Context_completion_3/internal/Parameter_reading.h>
#include <CGAL/Context_completion_3/internal/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
  \ingroup PkgContextCompletion3Ref

  \brief The class `Context_completion_3` completes a point-sampled surface step by step: the holes are detected,
  looked at, chosen and filled.

  The point set is read in the constructor and not needed afterwards. Detection and the preparation of the search are
  paid once, and `complete()` can be called for one choice of holes after the other. `CGAL::context_complete()` is the
  same in one call.

  An object can be moved but not copied. Different objects can be used from different threads.

  \tparam GeomTraits a model of `Kernel`, with the point and vector types of the point set
  \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
                         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
*/
template <typename GeomTraits, typename ConcurrencyTag = Sequential_tag>
class Context_completion_3
{
  typedef Context_completions_3::internal::Completion_session<ConcurrencyTag> Session;

public:
  /// \name Types
  /// @{
  typedef GeomTraits Geom_traits;                               ///< the geometric traits class
  typedef typename GeomTraits::FT FT;                           ///< number type
  typedef Context_completions_3::Hole_3<GeomTraits> Hole;       ///< description of a hole
  typedef Context_completions_3::Hole_report_3 Hole_report;     ///< what became of a hole
  typedef Context_completions_3::New_point_3<GeomTraits> New_point; ///< a new point, with its history
  /// @}

  /// \name Construction
  /// @{

  /*!
    \brief reads and checks the points and all parameters.

    \tparam PointRange is a model of `ConstRange`. The value type of its iterator is the key type of the named
                       parameter `point_map`.
    \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

    \param points the points, a `CGAL::Point_set_3` or any other range
    \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
              `CGAL::context_complete()` that say what is to be computed and how (`geom_traits`, the hole diameters,
              `hole_indices`, the regions, `user_holes`, `known_rims`, the examples, the cell tree, the search, the
              policies, `random_seed`), and the ones listed below; see also `Context_completions_3::combine()`

    \cgalNamedParamsBegin
      \cgalParamNBegin{point_map}
        \cgalParamDescription{a property map associating points to the elements of the point set `points`}
        \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the iterator of
                       `PointRange` and whose value type is `geom_traits::Point_3`}
        \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`, or the point map of a
                          `CGAL::Point_set_3`}
      \cgalParamNEnd

      \cgalParamNBegin{normal_map}
        \cgalParamDescription{a property map associating normals to the elements of the point set `points`}
        \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the iterator of
                       `PointRange` and whose value type is `geom_traits::Vector_3`}
        \cgalParamDefault{the normal map of a `CGAL::Point_set_3`; it must be given for any other range}
        \cgalParamExtra{Normals need not have length 1.}
      \cgalParamNEnd
    \cgalNamedParamsEnd

    \exception Context_completions_3::Invalid_input if there are no normals, if a position or normal is not finite or a
               normal is zero, if there are fewer than 15 points or all of them are equal or lie on a line, or if a
               parameter is out of its range. Points in a plane are fine.
  */
  template <typename PointRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
  explicit Context_completion_3(const PointRange& points, const CGAL_NP_CLASS& np = parameters::default_values())
    : m_traits(parameters::choose_parameter<GeomTraits>(
                 parameters::get_parameter(np, CGAL::internal_np::geom_traits)))
  {
    namespace internal = Context_completions_3::internal;
    internal::Converted_input input = internal::convert_input(points, np, std::string());
    const internal::Engine_parameters settings =
      internal::read_parameters(points, np, input.frame, input.index, m_example_indices);
    const auto& indices = parameters::get_parameter_reference(np, internal::own_np::hole_indices);
    if constexpr(internal::is_given<decltype(indices)>())
    {
      m_is_chosen_by_index = true;
      m_chosen = internal::read_hole_indices(indices);
    }
    m_frame = input.frame;
    m_indices = std::move(input.index);
    m_session = std::make_unique<Session>(std::move(input.points), settings);
  }

  /// @}

  /// \name Detection
  /// @{

  /// returns the median distance of a point to its nearest neighbor, in units of the input; of points at random, on scan
  /// lines or in several scans the one of an even sampling of as many points.
  FT spacing() const { return static_cast<FT>(m_session->spacing()); }

  /*!
    \brief finds the under-sampled places (section 5 of the paper).

    All holes to be filled are chosen, or those that the named parameter `hole_indices` of the constructor lists. Once
    the holes are known, further calls only return them.

    \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

    \cgalNamedParamsBegin
      \cgalParamNBegin{callback}
        \cgalParamDescription{a function that receives the fraction of the step that is done, from 0 to 1, and
                              cancels it by returning `false`}
        \cgalParamType{an instance of `std::function<bool(double)>`}
        \cgalParamDefault{unused}
        \cgalParamExtra{A later call goes on.}
      \cgalParamNEnd

      \cgalParamNBegin{visitor}
        \cgalParamDescription{a visitor that is told of the events}
        \cgalParamType{a model of `CompletionVisitor`}
        \cgalParamDefault{`Context_completions_3::Default_completion_visitor`}
        \cgalParamExtra{Give it with `std::ref()` to have the calls made on it and not on a copy.}
      \cgalParamNEnd
    \cgalNamedParamsEnd

    \return `holes()`

    \exception Context_completions_3::Invalid_input if `hole_indices` contains an unknown index; the holes are then
               known, but none is chosen; or if a box of `user_holes` holds nothing that is open; the holes are then
               not known
  */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  const std::vector<Hole>& detect_holes(const CGAL_NP_CLASS& np = parameters::default_values())
  {
    namespace internal = Context_completions_3::internal;
    if(is_detected())
      return m_holes;
    m_is_cancelled = !internal::with_visitor(np, [&](auto& visitor)
      { return m_session->detect(internal::read_callback(np), visitor); });
    if(m_is_cancelled)
      return m_holes;
    describe_holes();
    if(m_is_chosen_by_index)
    {
      const std::vector<std::size_t> named = std::exchange(m_chosen, std::vector<std::size_t>());
      check_hole_indices(named);
      m_chosen = named;
    }
    else
      choose_all();
    return m_holes;
  }

  /// returns whether the holes are known.
  bool is_detected() const { return m_session->is_detected(); }

  /// returns all under-sampled places, also those that are not to be filled; an empty list before they are detected.
  const std::vector<Hole>& holes() const { return m_holes; }

  /// @}

  /// \name Choice
  /// All functions replace the earlier choice. Holes that are completed already are not filled a second time.
  /// \pre `is_detected()`
  /// @{

  /*!
    \brief chooses holes by their indices, or by a predicate.

    Whoever names a hole gets it filled, whatever its state; only an outer border that no surface closes stays open, and
    its report says so.

    \tparam IndicesOrPredicate a model of `ConstRange` with an integer value type, or a unary function from `Hole`
                               to `bool`

    \exception Context_completions_3::Invalid_input if an index is unknown; the choice is then as it was
  */
  template <typename IndicesOrPredicate>
  void choose(const IndicesOrPredicate& indices_or_predicate)
  {
    CGAL_precondition_msg(is_detected(), "the holes must be detected before they are chosen");
    std::vector<std::size_t> chosen;
    if constexpr(std::is_invocable_r<bool, const IndicesOrPredicate&, const Hole&>::value)
    {
      for(const Hole& hole : m_holes)
        if(indices_or_predicate(hole))
          chosen.push_back(hole.id);
    }
    else
    {
      chosen = Context_completions_3::internal::read_hole_indices(indices_or_predicate);
      check_hole_indices(chosen);
    }
    m_chosen = std::move(chosen);
  }

  /// chooses all holes with the state `Hole_state::hole`.
  void choose_all() { choose([](const Hole& hole) { return hole.is_to_be_filled(); }); }

  /// returns the indices of the chosen holes, in increasing order.
  const std::vector<std::size_t>& chosen() const { return m_chosen; }

  /// @}

  /// \name Completion
  /// @{

  /*!
    \brief fills the chosen holes (sections 4, 6 and 7 of the paper).

    If the callback cancels, nothing is written; a later call goes on, and writes the points of the holes that had been
    finished, too. Points are written once.

    \tparam OutputIterator a model of `OutputIterator` to which a `New_point` can be assigned

    \param new_points receives the new points
    \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

    \cgalNamedParamsBegin
      \cgalParamNBegin{callback}
        \cgalParamDescription{a function that receives the fraction of the step that is done, from 0 to 1, and
                              cancels it by returning `false`}
        \cgalParamType{an instance of `std::function<bool(double)>`}
        \cgalParamDefault{unused}
        \cgalParamExtra{A later call goes on.}
      \cgalParamNEnd

      \cgalParamNBegin{visitor}
        \cgalParamDescription{a visitor that is told of the events}
        \cgalParamType{a model of `CompletionVisitor`}
        \cgalParamDefault{`Context_completions_3::Default_completion_visitor`}
        \cgalParamExtra{Give it with `std::ref()` to have the calls made on it and not on a copy.}
      \cgalParamNEnd
    \cgalNamedParamsEnd

    \pre `is_detected()`

    \return `new_points`, past the last new point
  */
  template <typename OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
  OutputIterator complete(OutputIterator new_points, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    namespace internal = Context_completions_3::internal;
    CGAL_precondition_msg(is_detected(), "the holes must be detected before they are filled");
    if(!is_detected())
      return new_points;
    m_is_cancelled = !internal::with_visitor(np, [&](auto& visitor)
      { return m_session->complete(m_chosen, internal::read_callback(np), visitor); });
    describe_outcomes();
    if(!m_is_cancelled)
      for(const internal::Added_point& point : m_session->hand_out())
        *new_points++ = new_point(point);
    return new_points;
  }

  /// returns whether the callback cancelled the last call of `detect_holes()` or `complete()`.
  bool is_cancelled() const { return m_is_cancelled; }

  /// returns a report for each of the `holes()`; an empty list before the first call of `complete()`.
  const std::vector<Hole_report>& report() const { return m_reports; }

  /// @}

private:
  void check_hole_indices(const std::vector<std::size_t>& indices) const
  {
    for(std::size_t index : indices)
      Context_completions_3::internal::require(index < m_holes.size(), "There is no hole ", index,
                                               "; the number of holes is ", m_holes.size(), '.');
  }

  std::vector<std::vector<std::size_t> > caller_indices(const std::vector<std::vector<std::size_t> >& loops) const
  {
    std::vector<std::vector<std::size_t> > result = loops;
    for(std::vector<std::size_t>& loop : result)
      for(std::size_t& index : loop)
        index = m_indices[index];
    return result;
  }

  void describe_holes()
  {
    m_holes.clear();
    for(const Context_completions_3::internal::Hole_data& data : m_session->holes())
    {
      Hole hole;
      hole.id = m_holes.size();
      hole.center = m_frame.point(data.center, m_traits);
      hole.diameter = static_cast<FT>(data.diameter);
      hole.spacing = static_cast<FT>(data.spacing);
      hole.state = data.state;
      hole.loops = caller_indices(data.loops);
      for(const Bbox_3& cell : data.cells)
        hole.cells.push_back(m_frame.box(cell));
      m_holes.push_back(hole);
    }
  }

  void describe_outcomes()
  {
    m_reports.clear();
    for(const Hole& hole : m_holes)
    {
      const Context_completions_3::internal::Hole_outcome& outcome = m_session->outcomes()[hole.id];
      Hole_report report;
      report.hole = hole.id;
      report.state = hole.state;
      report.diameter = CGAL::to_double(hole.diameter);
      report.loops = hole.loops;
      report.filling = outcome.filling;
      report.reason = outcome.reason;
      report.expected_error = outcome.expected_error;
      report.match = outcome.match;
      report.level = outcome.level;
      report.number_of_points = outcome.added;
      m_reports.push_back(report);
    }
  }

  New_point new_point(const Context_completions_3::internal::Added_point& added) const
  {
    New_point result;
    result.point = m_frame.point(added.position, m_traits);
    result.normal = m_frame.vector(added.normal, m_traits);
    if(added.source != Context_completions_3::internal::no_index)
    {
      result.source = added.source_set == 0 ? m_indices[added.source]
                                            : m_example_indices[added.source_set - 1][added.source];
      result.source_set = added.source_set;
    }
    result.hole = added.hole;
    result.confidence = added.confidence;
    return result;
  }

  GeomTraits m_traits;
  Context_completions_3::internal::Frame m_frame;
  std::vector<std::size_t> m_indices;                        // what the caller calls the i-th point
  std::vector<std::vector<std::size_t> > m_example_indices;  // the same for the example point sets
  std::unique_ptr<Session> m_session;
  std::vector<Hole> m_holes;
  std::vector<Hole_report> m_reports;
  std::vector<std::size_t> m_chosen;
  bool m_is_chosen_by_index = false;
  bool m_is_cancelled = false;
};

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_CONTEXT_COMPLETION_3_H
