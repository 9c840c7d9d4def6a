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

#ifndef CGAL_CONTEXT_COMPLETE_H
#define CGAL_CONTEXT_COMPLETE_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Context_completion_3.h>
#include <CGAL/Context_completion_3/internal/One_shot_completion.h>
#include <CGAL/Context_completion_3/internal/Property_transfer.h>
#include <CGAL/Context_completion_3/internal/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
  \ingroup PkgContextCompletion3Ref

  \brief finds the holes of a point-sampled surface and fills them with points copied from similar places.

  The new points are appended to the point set. All points that it holds keep their index, their order, and their
  properties bit for bit, also those that are marked as removed and can still be recovered. A new point has

  - a position and a normal of length 1;
  - in all other properties, whatever their types, the values of its source point. If the source is in one of the
    `example_point_sets`, these are the values of the properties of the same name and type there, provided that it is a
    `CGAL::Point_set_3` of the same type, and default values otherwise. A point without source, on the smooth base,
    takes the values of the nearest point.

  If an exception is thrown or the callback cancels, the point set is as it was before, the list of its properties
  included.

  \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
                         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
  \tparam Point the point type of the point set
  \tparam Vector_ the vector type of the point set
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param points the point set, with normals
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, see also
            `Context_completions_3::combine()`

  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{a property map associating points to the elements of the point set `points`}
      \cgalParamType{a model of `ReadWritePropertyMap` whose key type is `CGAL::Point_set_3::Index` and whose value
                     type is `geom_traits::Point_3`}
      \cgalParamDefault{`points.point_map()`}
      \cgalParamExtra{It is also written, at the new points.}
    \cgalParamNEnd

    \cgalParamNBegin{normal_map}
      \cgalParamDescription{a property map associating normals to the elements of the point set `points`}
      \cgalParamType{a model of `ReadWritePropertyMap` whose key type is `CGAL::Point_set_3::Index` and whose value
                     type is `geom_traits::Vector_3`}
      \cgalParamDefault{`points.normal_map()`}
      \cgalParamExtra{Normals need not have length 1. It is also written, at the new points, with normals of length
                      1.}
    \cgalParamNEnd

    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{a model of `Kernel`}
      \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
      \cgalParamExtra{The computation runs in `double` relative to the centre of the bounding box, whatever the
                      number type.}
    \cgalParamNEnd

    \cgalParamNBegin{minimum_hole_diameter}
      \cgalParamDescription{holes of a smaller diameter are left as they are; in the unit of the point set (section
                            5)}
      \cgalParamType{a number that is not negative}
      \cgalParamDefault{`0`, which stands for 4.5 times the local spacing of the points}
    \cgalParamNEnd

    \cgalParamNBegin{maximum_hole_diameter}
      \cgalParamDescription{holes of a larger diameter are left as they are; in the unit of the point set (section
                            5)}
      \cgalParamType{a positive number, infinity included}
      \cgalParamDefault{infinity}
      \cgalParamExtra{It must not be below `minimum_hole_diameter`.}
    \cgalParamNEnd

    \cgalParamNBegin{hole_indices}
      \cgalParamDescription{the holes to fill, as numbered by `Context_completions_3::Hole_3::id`}
      \cgalParamType{a model of `Range` with an integer value type}
      \cgalParamDefault{all holes with the state `Hole_state::hole`}
      \cgalParamExtra{Whoever names a hole gets it filled, whatever its state; only an outer border that no surface
                       closes stays open, and its report says so. An unknown index is an error.}
    \cgalParamNEnd

    \cgalParamNBegin{regions}
      \cgalParamDescription{boxes; a hole whose centre lies in none of them is left as it is (section 5)}
      \cgalParamType{a model of `ConstRange` with the value type `Bbox_3` or `geom_traits::Iso_cuboid_3`}
      \cgalParamDefault{no restriction}
      \cgalParamExtra{Bounds may be infinite.}
    \cgalParamNEnd

    \cgalParamNBegin{excluded_regions}
      \cgalParamDescription{boxes; a hole whose centre lies in one of them is left as it is (section 5)}
      \cgalParamType{a model of `ConstRange` with the value type `Bbox_3` or `geom_traits::Iso_cuboid_3`}
      \cgalParamDefault{no restriction}
      \cgalParamExtra{Bounds may be infinite.}
    \cgalParamNEnd

    \cgalParamNBegin{user_holes}
      \cgalParamDescription{boxes, each of which bounds one hole (section 5: the user defines invalid cells). The
                            hole whose centre lies in a box is filled, whatever its size; if none was found there,
                            the rim points in the box, also those of an outer border, bound a new hole, and its
                            surface ends at the box.}
      \cgalParamType{a model of `ConstRange` with the value type `Bbox_3` or `geom_traits::Iso_cuboid_3`}
      \cgalParamDefault{no box}
      \cgalParamExtra{A box without any rim point is an error. With the policies of the paper, the under-sampled cells
                       whose centres lie in a box are one hole. Bounds may be infinite.}
    \cgalParamNEnd

    \cgalParamNBegin{known_rims}
      \cgalParamDescription{rims of holes that are known, as the border cycles of a mesh of the points: each the
                            points around one hole, one after the other in either direction (section 5: the user
                            defines invalid cells). Each bounds a hole, whether it was found or not, unless nothing is
                            open within it.}
      \cgalParamType{a model of `ConstRange` whose value type is a model of `ConstRange` with an integer value type:
                     indices of the points as in `Context_completions_3::Hole_3::loops`}
      \cgalParamDefault{no rim}
      \cgalParamExtra{A diameter out of bounds and regions leave such a hole open as they do others. Less than three
                      points, an unknown one and one that is named twice are errors. The policies of the paper do not
                      look at it.}
    \cgalParamNEnd

    \cgalParamNBegin{example_mask}
      \cgalParamDescription{a property map that tells which points of `points` may be copied (paper, section 8)}
      \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the iterator of the point
                     set and whose value type is `bool`}
      \cgalParamDefault{all points may be copied}
      \cgalParamExtra{Barred points take part in detection and in the smooth base.}
    \cgalParamNEnd

    \cgalParamNBegin{example_point_sets}
      \cgalParamDescription{further surfaces to copy from, in the same unit as `points` (paper, section 8)}
      \cgalParamType{a model of `ForwardRange` whose value type is a `CGAL::Point_set_3` with normals or, if not, a
                     point range that `point_map` and `normal_map` can read}
      \cgalParamDefault{none}
      \cgalParamExtra{Give it with `std::cref()` to save a copy of the sets.}
    \cgalParamNEnd

    \cgalParamNBegin{maximum_depth}
      \cgalParamDescription{the depth of the cell tree, the finest level of the completion (section 3)}
      \cgalParamType{an integer from 1 to 20}
      \cgalParamDefault{as deep as the spacing of the points allows}
    \cgalParamNEnd

    \cgalParamNBegin{minimum_cell_points}
      \cgalParamDescription{the number m of points below which a cell cannot be approximated (sections 3 and 5)}
      \cgalParamType{an integer from 6 to 100000}
      \cgalParamDefault{`15`}
    \cgalParamNEnd

    \cgalParamNBegin{tolerance}
      \cgalParamDescription{the error epsilon of a local approximation above which its cell is subdivided; in the
                            unit of the point set (section 3)}
      \cgalParamType{a positive number}
      \cgalParamDefault{half of the median spacing of the points}
      \cgalParamExtra{It bounds the cells of the paper's policies; the improved defaults fit at the radius that
                      predicts the points best.}
    \cgalParamNEnd

    \cgalParamNBegin{number_of_turns}
      \cgalParamDescription{in how many turns about its normal each place is compared (section 6.3)}
      \cgalParamType{an integer from 1 to 360}
      \cgalParamDefault{`24`}
      \cgalParamExtra{The policies of the paper do not look at it; see `rotation_angles`.}
    \cgalParamNEnd

    \cgalParamNBegin{use_mirrors}
      \cgalParamDescription{whether mirror images of places are compared, too (section 6.3)}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd

    \cgalParamNBegin{number_of_candidates}
      \cgalParamDescription{how many places pass the short descriptor and are compared in full (section 6.3)}
      \cgalParamType{an integer from 1 to 10000000}
      \cgalParamDefault{`2000`}
      \cgalParamExtra{The policies of the paper do not look at it; they compare up to 1000 cells in full.}
    \cgalParamNEnd

    \cgalParamNBegin{use_paper_policies}
      \cgalParamDescription{whether every stage follows the paper to the letter instead of the improved defaults}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
    \cgalParamNEnd

    \cgalParamNBegin{rotation_angles}
      \cgalParamDescription{the angles by which copies of the point sets are rotated about the x, y and z axes before
                            they are cut into cells (sections 6.3 and 8), in radians}
      \cgalParamType{a model of `ConstRange` whose value type is a number type}
      \cgalParamDefault{one angle, a quarter of \f$ \pi \f$}
      \cgalParamExtra{It is for the policies of the paper. An empty range means that no copies are made. The memory
                       grows with three trees for each angle.}
    \cgalParamNEnd

    \cgalParamNBegin{use_cube_symmetries}
      \cgalParamDescription{whether cells are compared under all 48 symmetries of the cube instead of the 8 of section
                            6.3, rotations by \f$ \pi \f$ about the axes and reflections}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
      \cgalParamExtra{It is for the policies of the paper. Without `use_mirrors` half of them are left.}
    \cgalParamNEnd

    \cgalParamNBegin{use_support_balls}
      \cgalParamDescription{whether the approximation of a cell is fitted to the points in a ball around it, which
                            overlaps its neighbours, instead of those in the cell alone (section 4)}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
      \cgalParamExtra{It is for the policies of the paper, whose time it nearly doubles; on some models the
                       fillings become better, on others worse.}
    \cgalParamNEnd

    \cgalParamNBegin{use_box_subdivision}
      \cgalParamDescription{whether a quadric is tested against the box of a cell by the subdivision of section 5
                            instead of exactly}
      \cgalParamType{Boolean}
      \cgalParamDefault{`false`}
      \cgalParamExtra{It is for the policies of the paper. Where six subdivisions decide nothing it takes the cell for
                       one that is met.}
    \cgalParamNEnd

    \cgalParamNBegin{keep_texture}
      \cgalParamDescription{whether roughness is continued in the hole (`true`) or the expected distance to the true
                            surface is made as small as possible (`false`), where a surface is rough without
                            repeating itself}
      \cgalParamType{Boolean}
      \cgalParamDefault{`true`}
    \cgalParamNEnd

    \cgalParamNBegin{random_seed}
      \cgalParamDescription{the seed of everything random}
      \cgalParamType{an unsigned integer}
      \cgalParamDefault{`0`}
      \cgalParamExtra{No stage draws random numbers at present: all seeds give the same result, bit for bit, for any
                      number of threads.}
    \cgalParamNEnd

    \cgalParamNBegin{callback}
      \cgalParamDescription{a function that receives the fraction of the computation that is done, from 0 to 1, and
                            cancels it by returning `false`}
      \cgalParamType{an instance of `std::function<bool(double)>`}
      \cgalParamDefault{unused}
      \cgalParamExtra{A cancelled computation changes nothing.}
    \cgalParamNEnd

    \cgalParamNBegin{visitor}
      \cgalParamDescription{a visitor that is told of the events}
      \cgalParamType{a model of `CompletionVisitor`}
      \cgalParamDefault{`Context_completions_3::Default_completion_visitor`}
      \cgalParamExtra{Give it with `std::ref()` to have the calls made on it and not on a copy.}
    \cgalParamNEnd

    \cgalParamNBegin{source_map}
      \cgalParamDescription{receives for each new point the index of the point it was copied from, -1 if there is
                            none}
      \cgalParamType{a model of `WritablePropertyMap` whose key type is `CGAL::Point_set_3::Index` and whose value
                     type `std::size_t` can be converted to}
      \cgalParamDefault{unused}
      \cgalParamExtra{The index counts in the set that `source_set_map` tells.}
    \cgalParamNEnd

    \cgalParamNBegin{source_set_map}
      \cgalParamDescription{receives for each new point 0 if it was copied from `points`, and i if it was copied
                            from the i-th of the `example_point_sets`, counted from 1}
      \cgalParamType{a model of `WritablePropertyMap` whose key type is `CGAL::Point_set_3::Index` and whose value
                     type `std::size_t` can be converted to}
      \cgalParamDefault{unused}
    \cgalParamNEnd

    \cgalParamNBegin{hole_map}
      \cgalParamDescription{receives for each new point the index of the hole it fills}
      \cgalParamType{a model of `WritablePropertyMap` whose key type is `CGAL::Point_set_3::Index` and whose value
                     type `std::size_t` can be converted to}
      \cgalParamDefault{unused}
    \cgalParamNEnd

    \cgalParamNBegin{confidence_map}
      \cgalParamDescription{receives for each new point a confidence from 0 (a guess) to 1 (certain)}
      \cgalParamType{a model of `WritablePropertyMap` whose key type is `CGAL::Point_set_3::Index` and whose value
                     type `double` can be converted to}
      \cgalParamDefault{unused}
    \cgalParamNEnd

    \cgalParamNBegin{hole_reports}
      \cgalParamDescription{receives a report for each hole, by increasing index}
      \cgalParamType{a model of `OutputIterator` to which a `Context_completions_3::Hole_report_3` can be assigned,
                     such as `std::back_inserter(reports)`}
      \cgalParamDefault{unused}
      \cgalParamExtra{Nothing is written if the computation is cancelled.}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of new points, 0 if there is no hole or the callback cancelled

  \exception Context_completions_3::Invalid_input if there are no normals, if a position or normal is not finite or a
             normal is zero, if there are fewer than 15 points or all of them are equal or lie on a line, or if a
             parameter is out of its range. Points in a plane are fine.

  \sa `CGAL::Context_completion_3`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Point, typename Vector_,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t context_complete(Point_set_3<Point, Vector_>& points,
                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef Point_set_processing_3_np_helper<Point_set_3<Point, Vector_>, CGAL_NP_CLASS> Helper;
  typedef typename Helper::Geom_traits Geom_traits;
  using namespace Context_completions_3::internal;

  // a property that was added by its name is not yet known to the set as its normals
  if(points.has_normal_map())
    points.add_normal_map();

  Context_completion_3<Geom_traits, ConcurrencyTag> completion(points, np);
  std::vector<Context_completions_3::New_point_3<Geom_traits> > new_points;
  if(!complete_at_once(completion, new_points, np))
    return 0;

  Property_transfer<Point, Vector_> transfer(points);
  transfer.read_examples(new_points, np);
  write_reports(completion.report(), np);
  transfer.append(new_points, np);
  return new_points.size();
}

/*!
  \ingroup PkgContextCompletion3Ref

  \brief finds the holes of a point-sampled surface and writes points that fill them, copied from similar places.

  Nothing is written if an exception is thrown before the computation has ended, or if the callback cancels.

  \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
                         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
  \tparam PointRange is a model of `ConstRange`. The value type of its iterator is the key type of the named
                     parameter `point_map`.
  \tparam OutputIterator a model of `OutputIterator` to which a `std::pair<geom_traits::Point_3, geom_traits::Vector_3>`
                         can be assigned
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param points the points, not changed; a `CGAL::Point_set_3` is possible, too
  \param output receives the position and the normal, of length 1, of each new point
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of the overload for a
            `CGAL::Point_set_3`, the ones listed below with the difference that a range makes; see also
            `Context_completions_3::combine()`

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

    \cgalParamNBegin{callback}
      \cgalParamDescription{a function that receives the fraction of the computation that is done, from 0 to 1, and
                            cancels it by returning `false`}
      \cgalParamType{an instance of `std::function<bool(double)>`}
      \cgalParamDefault{unused}
      \cgalParamExtra{A cancelled computation writes nothing.}
    \cgalParamNEnd

    \cgalParamNBegin{source_map}
      \cgalParamDescription{receives for each new point the index of the point it was copied from, -1 if there is
                            none}
      \cgalParamType{a model of `WritablePropertyMap` whose key type is `std::size_t` and whose value type
                     `std::size_t` can be converted to}
      \cgalParamDefault{unused}
      \cgalParamExtra{The key is the number of the new point, 0 being the first one written. The index counts in the
                      set that `source_set_map` tells.}
    \cgalParamNEnd

    \cgalParamNBegin{source_set_map}
      \cgalParamDescription{receives for each new point 0 if it was copied from `points`, and i if it was copied
                            from the i-th of the `example_point_sets`, counted from 1}
      \cgalParamType{a model of `WritablePropertyMap` whose key type is `std::size_t` and whose value type
                     `std::size_t` can be converted to}
      \cgalParamDefault{unused}
      \cgalParamExtra{The key is the number of the new point, 0 being the first one written.}
    \cgalParamNEnd

    \cgalParamNBegin{hole_map}
      \cgalParamDescription{receives for each new point the index of the hole it fills}
      \cgalParamType{a model of `WritablePropertyMap` whose key type is `std::size_t` and whose value type
                     `std::size_t` can be converted to}
      \cgalParamDefault{unused}
      \cgalParamExtra{The key is the number of the new point, 0 being the first one written.}
    \cgalParamNEnd

    \cgalParamNBegin{confidence_map}
      \cgalParamDescription{receives for each new point a confidence from 0 (a guess) to 1 (certain)}
      \cgalParamType{a model of `WritablePropertyMap` whose key type is `std::size_t` and whose value type `double`
                     can be converted to}
      \cgalParamDefault{unused}
      \cgalParamExtra{The key is the number of the new point, 0 being the first one written.}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return `output`, past the last new point

  \exception Context_completions_3::Invalid_input if there are no normals, if a position or normal is not finite or a
             normal is zero, if there are fewer than 15 points or all of them are equal or lie on a line, or if a
             parameter is out of its range. Points in a plane are fine.

  \sa `CGAL::Context_completion_3`
*/
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<!Context_completions_3::internal::Is_named_parameters<OutputIterator>::value, int> = 0
#endif
          >
OutputIterator context_complete(const PointRange& points,
                                OutputIterator output,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef Point_set_processing_3_np_helper<PointRange, CGAL_NP_CLASS> Helper;
  typedef typename Helper::Geom_traits Geom_traits;
  using namespace Context_completions_3::internal;

  Context_completion_3<Geom_traits, ConcurrencyTag> completion(points, np);
  std::vector<Context_completions_3::New_point_3<Geom_traits> > new_points;
  if(!complete_at_once(completion, new_points, np))
    return output;

  write_reports(completion.report(), np);
  for(std::size_t i = 0; i < new_points.size(); ++i)
  {
    put_history(i, new_points[i], np);
    *output++ = std::make_pair(new_points[i].point, new_points[i].normal);
  }
  return output;
}

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_CONTEXT_COMPLETE_H
