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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_WEIGHTED_QUANTILE_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_WEIGHTED_QUANTILE_H

#include <CGAL/license/Context_completion_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The value below which lies the given share of the weight; linear between the values, each of which stands in the
  middle of its weight, so that it is continuous in values and weights.

  \param values pairs of value and weight, at least one, weights of sum 1; sorted by the function
  \param share 0 to 1; 0.5: the weighted median
*/
inline double weighted_quantile(std::vector<std::pair<double, double> >& values, double share)
{
  std::sort(values.begin(), values.end());
  double below = 0;
  for(std::size_t i = 0; i < values.size(); ++i)
  {
    const double middle = below + values[i].second / 2;
    if(middle >= share)
    {
      if(i == 0)
        return values[0].first;
      const double previous = below - values[i - 1].second / 2;
      const double t = (share - previous) / (middle - previous);
      return values[i - 1].first + t * (values[i].first - values[i - 1].first);
    }
    below += values[i].second;
  }
  return values.back().first;
}

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_WEIGHTED_QUANTILE_H
