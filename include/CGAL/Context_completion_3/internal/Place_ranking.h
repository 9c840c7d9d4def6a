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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_RANKING_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_RANKING_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Cell_signature.h>
#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Match_target.h>
#include <CGAL/Context_completion_3/internal/Motion.h>
#include <CGAL/Context_completion_3/internal/Nearest_point_grid.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Overlap_alignment.h>
#include <CGAL/Context_completion_3/internal/Place_index.h>
#include <CGAL/Context_completion_3/internal/Place_signature.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/// A motion that may carry a source place into a hole, the best being that of the lowest score.
struct Place_hypothesis
{
  Motion motion;
  double score = 0;
};

/*!
  The first round of a search: all turns of all candidates, the three best of each (paper, section 6.3). There are two
  judges, whose scores cannot be compared:
  - the signature of the cell in the frame of the place (sections 6.1 and 6.2) sees the shape of the surroundings at
    large, and is not distracted by their detail;
  - probes in a ring around the hole see the detail.
*/
template <typename ConcurrencyTag>
class Place_ranking
{
  typedef Surface_model<ConcurrencyTag> Model;

public:
  /*!
    \param model the source \param index its places; it keeps the signatures that are made
    \param number_of_turns about the normal \param mirror whether reflected places are tried, too
  */
  Place_ranking(const Model& model, Place_index<ConcurrencyTag>& index, const Match_target& target,
                std::size_t number_of_turns, bool mirror)
    : m_model(model), m_index(index), m_target(target), m_mirror(mirror),
      m_candidates(index.candidates(target.frame, target.around))
  {
    const double step = 2 * 3.14159265358979323846 / double(number_of_turns);
    for(std::size_t t = 0; t < number_of_turns; ++t)
      m_turned.push_back(target.frame.turned(step * double(t)));
  }

  std::vector<Place_hypothesis> by_signature() const
  {
    const Neighbor_search search(m_target.surface.position);
    Place_signatures around(m_target.surface, search, m_target.surface, m_target.radius, m_target.spacing);
    // a place reflected, compared with the target, is the place compared with the target reflected
    std::vector<Cell_signature> wanted = around.template signatures<ConcurrencyTag>(m_turned);
    for(std::size_t t = 0; t < m_turned.size() && m_mirror; ++t)
      wanted.push_back(wanted[t].transformed(Place_signatures::mirror()));
    m_index.sign(m_candidates);
    const Signature_weights weights = m_index.weights();
    return best_turns([&](std::size_t candidate, std::size_t turn, bool mirrored)
      { return signature_distance(wanted[mirrored ? m_turned.size() + turn : turn], m_index.signature(candidate),
                                  weights); });
  }

  std::vector<Place_hypothesis> by_probes() const
  {
    const std::vector<Match_probe> probes = thinned(m_target.overlap, 56);
    return best_turns([&](std::size_t candidate, std::size_t turn, bool mirrored)
      { return coarse_score(probes, motion(candidate, turn, mirrored)); });
  }

private:
  Motion motion(std::size_t candidate, std::size_t turn, bool mirrored) const
  {
    return m_turned[turn].motion_from(m_index.frame(candidate), mirrored);
  }

  template <typename Score>
  std::vector<Place_hypothesis> best_turns(const Score& score) const
  {
    const std::size_t kept = 3;
    std::vector<Place_hypothesis> all(m_candidates.size() * kept);
    for_each_index<ConcurrencyTag>(m_candidates.size(), [&](std::size_t i)
    {
      const std::size_t turns = m_turned.size();
      std::vector<std::pair<double, std::size_t> > here;
      for(std::size_t t = 0; t < (m_mirror ? 2 : 1) * turns; ++t)
        here.emplace_back(score(m_candidates[i], t % turns, t >= turns), t);
      std::sort(here.begin(), here.end());
      for(std::size_t k = 0; k < kept; ++k)
      {
        const std::pair<double, std::size_t>& best = here[(std::min)(k, here.size() - 1)];
        all[i * kept + k].motion = motion(m_candidates[i], best.second % turns, best.second >= turns);
        all[i * kept + k].score = best.first;
      }
    });
    return all;
  }

  // Score up to a shift along the normal and a tilt of the patch, which the alignment will find.
  double coarse_score(const std::vector<Match_probe>& probes, const Motion& motion) const
  {
    const double kappa = 0.5, tau = m_index.tau();
    const Nearest_point_grid& grid = m_index.grid();
    double distance[64], agreement[64], along[64][3];
    const std::size_t n = (std::min)(probes.size(), std::size_t(64));
    const Vector u = m_target.frame.axis, v = m_target.frame.normal.cross(u);
    Matrix a = Matrix::Zero();
    Vector b = Vector::Zero();
    double total = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Match_probe& p = probes[i];
      total += p.weight;
      distance[i] = 2 * tau;
      const Vector y = motion.inverse(p.position);
      const std::uint32_t s = grid(y);
      if(s == Nearest_point_grid::none)
        continue;
      const Vector& normal = m_model.normal(s);
      const double d = normal.dot(y - m_model.position(s));
      if(std::abs(d) > tau)
        continue;
      distance[i] = d;
      agreement[i] = normal.dot(motion.inverse_normal(p.normal));
      const Vector q = (p.position - m_target.frame.origin) / m_target.radius;
      along[i][0] = 1; along[i][1] = q.dot(u); along[i][2] = q.dot(v);
      const Vector row(along[i][0], along[i][1], along[i][2]);
      const double w = p.weight * (std::max)(0., agreement[i]);
      a.noalias() += w * row * row.transpose();
      b += w * d * row;
    }
    a.diagonal().array() += 0.05 * total;
    const Vector c = solve_damped_system(a, b);
    double sum = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double w = probes[i].weight;
      if(distance[i] > tau)
      {
        sum += w * (1 + kappa);
        continue;
      }
      const double d = (distance[i] - c[0] - c[1] * along[i][1] - c[2] * along[i][2]) / tau;
      sum += w * ((std::min)(1., d * d) + kappa * (std::min)(1., 1 - agreement[i]));
    }
    return total > 0 ? sum / total : 1 + kappa;
  }

  const Model& m_model;
  Place_index<ConcurrencyTag>& m_index;
  const Match_target& m_target;
  bool m_mirror;
  std::vector<std::size_t> m_candidates;
  std::vector<Surface_frame> m_turned;           // those of the hole, instead of the places
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_PLACE_RANKING_H
