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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

/*
  The package's own named parameters. Names that CGAL has in one version and not in another (`maximum_depth` came
  after 6.0) must not be declared twice, hence each macro line asks whether CGAL's parameters can be chained with
  that name: if so, CGAL's tag and free function are used, otherwise an own tag and an own free function.
*/
namespace CGAL {
namespace Context_completions_3 {
namespace internal_np {

template <typename NamedParameters> struct Tag_of;
template <typename T, typename Tag, typename Base>
struct Tag_of<Named_function_parameters<T, Tag, Base> > { typedef Tag type; };

} // namespace internal_np
} // namespace Context_completions_3

#define CGAL_CC3_NAMED_PARAMETER(NAME)                                                                       \
  namespace Context_completions_3 { namespace internal_np {                                                  \
  enum NAME##_own_t { NAME##_own };                                                                          \
  template <typename NP, typename = void>                                                                    \
  struct NAME##_lookup { typedef NAME##_own_t type; static constexpr bool is_own = true; };                  \
  template <typename NP>                                                                                     \
  struct NAME##_lookup<NP, std::void_t<decltype(std::declval<NP>().NAME(0))> >                               \
  {                                                                                                          \
    typedef typename Tag_of<decltype(std::declval<NP>().NAME(0))>::type type;                                \
    static constexpr bool is_own = false;                                                                    \
  };                                                                                                         \
  typedef typename NAME##_lookup<parameters::Default_named_parameters>::type NAME##_t;                       \
  inline constexpr NAME##_t NAME = NAME##_t();                                                               \
  } }                                                                                                        \
  namespace parameters {                                                                                     \
  template <typename T, typename NP = Default_named_parameters,                                              \
            std::enable_if_t<Context_completions_3::internal_np::NAME##_lookup<NP>::is_own, int> = 0>        \
  Named_function_parameters<T, Context_completions_3::internal_np::NAME##_own_t>                             \
  NAME(const T& t) { return { t }; }                                                                         \
  }

CGAL_CC3_NAMED_PARAMETER(minimum_hole_diameter)
CGAL_CC3_NAMED_PARAMETER(maximum_hole_diameter)
CGAL_CC3_NAMED_PARAMETER(hole_indices)
CGAL_CC3_NAMED_PARAMETER(regions)
CGAL_CC3_NAMED_PARAMETER(excluded_regions)
CGAL_CC3_NAMED_PARAMETER(user_holes)
CGAL_CC3_NAMED_PARAMETER(known_rims)
CGAL_CC3_NAMED_PARAMETER(example_mask)
CGAL_CC3_NAMED_PARAMETER(example_point_sets)
CGAL_CC3_NAMED_PARAMETER(maximum_depth)
CGAL_CC3_NAMED_PARAMETER(minimum_cell_points)
CGAL_CC3_NAMED_PARAMETER(tolerance)
CGAL_CC3_NAMED_PARAMETER(number_of_turns)
CGAL_CC3_NAMED_PARAMETER(use_mirrors)
CGAL_CC3_NAMED_PARAMETER(number_of_candidates)
CGAL_CC3_NAMED_PARAMETER(use_paper_policies)
CGAL_CC3_NAMED_PARAMETER(rotation_angles)
CGAL_CC3_NAMED_PARAMETER(use_cube_symmetries)
CGAL_CC3_NAMED_PARAMETER(use_support_balls)
CGAL_CC3_NAMED_PARAMETER(use_box_subdivision)
CGAL_CC3_NAMED_PARAMETER(keep_texture)
CGAL_CC3_NAMED_PARAMETER(source_map)
CGAL_CC3_NAMED_PARAMETER(source_set_map)
CGAL_CC3_NAMED_PARAMETER(hole_map)
CGAL_CC3_NAMED_PARAMETER(confidence_map)
CGAL_CC3_NAMED_PARAMETER(hole_reports)

#undef CGAL_CC3_NAMED_PARAMETER

namespace Context_completions_3 {

/// \cond SKIP_IN_MANUAL
template <typename T, typename Tag, typename Base>
Named_function_parameters<T, Tag, Base> combine(const Named_function_parameters<T, Tag, Base>& np)
{
  return np;
}
/// \endcond

/*!
  \ingroup PkgContextCompletion3Ref

  \brief joins named parameters of this package with each other and with those of \cgal.

  Only a parameter of \cgal can follow another one with a dot, as in
  `parameters::maximum_hole_diameter(2.).callback(f)`. Everything else is joined by this function, as in
  `combine(parameters::point_map(m).normal_map(n), parameters::tolerance(.1), parameters::keep_texture(false))`.

  \param np a sequence of \ref bgl_namedparameters "Named Parameters"
  \param parameter a single named parameter that is appended to it
  \param others further single named parameters

  \return a sequence of \ref bgl_namedparameters "Named Parameters" with all of them
*/
template <typename T, typename Tag, typename Base, typename V, typename VTag, typename... Others>
auto combine(const Named_function_parameters<T, Tag, Base>& np,
             const Named_function_parameters<V, VTag>& parameter,
             const Others&... others)
{
  typedef Named_function_parameters<T, Tag, Base> Previous;
  return combine(Named_function_parameters<V, VTag, Previous>(parameter.v, np), others...);
}

} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_NAMED_PARAMETERS_H
