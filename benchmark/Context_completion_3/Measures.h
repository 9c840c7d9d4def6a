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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MEASURES_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MEASURES_H

#include "Benchmark_case.h"
#include "Blue_noise.h"
#include "Local_statistics.h"
#include "Surface_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Completion_benchmark {

/*!
  The scores of a completion. With h = spacing and r = radius of the hole:

  - `coverage`: share of the removed points with a point of result or input within 2 h; `hole_max`: the largest
    distance / h;
  - `acc_rms`, `acc_p95`, `acc_max`: distance of the result to the true surface / r, `acc_mean` / h: point to plane,
    Euclidean where it is farther than 2 h;
  - `comp_mean`: distance of the removed points to the planes of result and input / h;
    `cham`: mean of that and of `acc_mean`;
  - `hole_distance`: the same distance, of a surface the distance to its triangles, in thousandths of the diagonal of
    the model's bounding box, as mesh inpainting is measured;
  - `spurious`: share of the result farther than 3 h from the true surface; `outside`: nearer to the input than to what
    was removed;
  - `normal_deg`, `normal_p95`, `normal_flip`: angle to the nearest true normal, mean, 95th percentile, share above
    90 degrees;
  - `detail_ratio`: median roughness (residual of a local quadratic fit) of the result over that of the truth,
    `detail_w1`: Wasserstein distance of the two distributions / median of the truth, `detail_true`: that median / h;
  - `density`, `nn_p5`: median and 5th percentile of the distance of neighbours in the result / h;
  - `seam_med`, `seam_p95`: residual of a plane fit at the rim, with the result over with what was removed;
  - `elsewhere`: points at holes that the model itself has, which are not scored.

  What does not exist (no result, too few samples) is NaN.
*/
struct Measures
{
  double n_removed = 0, n_added = 0, count_ratio = 0, n_nonfinite = 0, coverage, hole_max, comp_mean, hole_distance,
         acc_mean, acc_rms, acc_p95, acc_max, cham, spurious, outside, normal_deg, normal_p95, normal_flip, density,
         nn_p5, detail_ratio, detail_w1, detail_true, detail_n = 0, seam_med, seam_p95, n_rim = 0, elsewhere = 0;

  Measures()
  {
    coverage = hole_max = comp_mean = hole_distance = acc_mean = acc_rms = acc_p95 = acc_max = cham = spurious
      = outside = normal_deg = normal_p95 = normal_flip = density = nn_p5 = detail_ratio = detail_w1 = detail_true
      = seam_med = seam_p95 = std::numeric_limits<double>::quiet_NaN();
  }

  struct Column { const char* name; double Measures::*value; };

  static const std::vector<Column>& columns()
  {
    typedef Measures M;
    static const std::vector<Column> all = {
      { "n_removed", &M::n_removed }, { "n_added", &M::n_added }, { "count_ratio", &M::count_ratio },
      { "n_nonfinite", &M::n_nonfinite }, { "coverage", &M::coverage }, { "hole_max", &M::hole_max },
      { "comp_mean", &M::comp_mean }, { "hole_distance", &M::hole_distance }, { "acc_mean", &M::acc_mean },
      { "acc_rms", &M::acc_rms }, { "acc_p95", &M::acc_p95 }, { "acc_max", &M::acc_max }, { "cham", &M::cham },
      { "spurious", &M::spurious }, { "outside", &M::outside }, { "normal_deg", &M::normal_deg },
      { "normal_p95", &M::normal_p95 }, { "normal_flip", &M::normal_flip }, { "density", &M::density },
      { "nn_p5", &M::nn_p5 }, { "detail_ratio", &M::detail_ratio }, { "detail_w1", &M::detail_w1 },
      { "detail_true", &M::detail_true }, { "detail_n", &M::detail_n }, { "seam_med", &M::seam_med },
      { "seam_p95", &M::seam_p95 }, { "n_rim", &M::n_rim }, { "elsewhere", &M::elsewhere } };
    return all;
  }
};

/// Scores completions of one case; the trees of the truth are built once.
class Scorer
{
  static constexpr double flat = 0.01;         // residuals in flat regions are counted from this on, in spacings

public:
  explicit Scorer(const Benchmark_case& c)
    : m_case(c), h(c.spacing), r(c.hole_radius), m_true(joined({ &c.truth, &c.input, &c.removed })),
      m_true_search(m_true.position), m_input_search(c.input.position), m_removed_search(c.removed.position)
  {
    // only the input near the hole is looked at closely
    const double reach = (std::max)(8 * h, 0.6 * r) + 4 * h;
    for(std::size_t i = 0; i < c.input.size(); ++i)
      if(distance(m_removed_search, c.input.position[i]) < reach)
        m_near.push_back(c.input.position[i], c.input.normal[i]);
    m_whole = joined({ &c.removed, &m_near });
  }

  /// Scores added points. Normals of length 0 are no normals.
  Measures operator()(const Surface_points& added) const
  {
    Measures m;
    if(!m_case.natural_holes)
      return score(added, m);
    Surface_points here;
    for(std::size_t i = 0; i < added.size(); ++i)
    {
      const Vector& p = added.position[i];
      if(p.allFinite() && distance(m_removed_search, p) > 0.6 * r)
        ++m.elsewhere;
      else
        here.push_back(p, added.normal[i]);
    }
    return score(here, m);
  }

  /// Scores a surface: samples of the spacing of the case, of which those count that belong to the hole.
  Measures score_surface(const Benchmark_surface& surface) const
  {
    Measures m;
    score(crop(surface), m);
    m.hole_distance = in_diagonals(mean(distances_to_surface(m_case.removed.position, surface)));
    return m;
  }

  /// The samples of a surface that are nearer to a removed point than to a point of the input.
  Surface_points crop(const Benchmark_surface& surface) const
  {
    Random_source random(1);
    Benchmark_surface here;
    here.vertices = surface.vertices;
    for(std::size_t f = 0; f < surface.faces.size(); ++f)
    {
      const Benchmark_surface::Face& v = surface.faces[f];
      const Vector middle = (surface.vertices[v[0]] + surface.vertices[v[1]] + surface.vertices[v[2]]) / 3;
      double extent = 0;
      for(std::size_t i : v)
        extent = (std::max)(extent, (surface.vertices[i] - middle).norm());
      if(distance(m_removed_search, middle) - extent < distance(m_input_search, middle) + extent)
        here.faces.push_back(v);
    }
    set_smooth_normals(here);
    std::vector<std::size_t> all(here.faces.size());
    for(std::size_t f = 0; f < all.size(); ++f)
      all[f] = f;
    const std::size_t number = std::size_t((std::min)(8 * here.area() / (h * h), 3e6)) + 1;
    const Surface_points drawn = draw_samples(here, all, number, random);
    Surface_points cropped;
    for(std::size_t i = 0; i < drawn.size(); ++i)
      if(distance(m_removed_search, drawn.position[i]) < distance(m_input_search, drawn.position[i]))
        cropped.push_back(drawn.position[i], drawn.normal[i]);
    const std::vector<double> radii(cropped.size(), 0.93 * h);
    return subset(cropped, thin_to_blue_noise(cropped, radii, random));
  }

private:
  static Surface_points joined(const std::vector<const Surface_points*>& sets)
  {
    Surface_points all;
    for(const Surface_points* set : sets)
      for(std::size_t i = 0; i < set->size(); ++i)
        all.push_back(set->position[i], set->normal[i].normalized());
    return all;
  }

  // the normals of the vertices, and of the face itself at corners where they differ much: sharp edges stay sharp
  static void set_smooth_normals(Benchmark_surface& surface)
  {
    const std::vector<Vector> normals = vertex_normals(surface);
    for(std::size_t f = 0; f < surface.faces.size(); ++f)
    {
      const Vector own = surface.face_vector(f).normalized();
      surface.corners.push_back({ own, own, own });
      for(int i = 0; i < 3; ++i)
      {
        const Vector& n = normals[surface.faces[f][i]];
        if(n.dot(own) > 0.8)
          surface.corners.back()[i] = n;
      }
    }
  }

  double in_diagonals(double distance) const { return 1000 * distance / m_case.diagonal; }

  static double distance(const Neighbor_search& search, const Vector& p) { return search.nearest(p).second; }

  Measures& score(const Surface_points& added, Measures& m) const
  {
    const Surface_points& removed = m_case.removed;
    m.n_removed = double(removed.size());
    m.n_added = double(added.size());
    m.count_ratio = m.n_added / m.n_removed;
    Surface_points result;
    bool has_normals = false;
    for(std::size_t i = 0; i < added.size(); ++i)
      if(added.position[i].allFinite())
      {
        const Vector n = added.normal[i].allFinite() ? added.normal[i] : Vector(Vector::Zero());
        has_normals = has_normals || n.norm() > 1e-12;
        result.push_back(added.position[i], n);
      }
    m.n_nonfinite = m.n_added - double(result.size());

    // the result with the true normals, which tell sides apart, and the input around it
    Surface_points sided;
    if(result.size() > 0)
      score_accuracy(result, has_normals, sided, m);
    for(std::size_t i = 0; i < m_near.size(); ++i)
      sided.push_back(m_near.position[i], m_near.normal[i]);
    const Neighbor_search search(sided.position);
    score_completeness(sided, search, m);
    if(result.size() > 0)
      m.cham = 0.5 * (m.acc_mean + m.comp_mean);
    const Neighbor_search whole_search(m_whole.position);
    score_detail(sided, search, whole_search, m);
    score_seam(sided, search, whole_search, m);
    return m;
  }

  void score_accuracy(const Surface_points& result, bool has_normals, Surface_points& sided, Measures& m) const
  {
    const std::size_t n = result.size();
    std::vector<double> error, angle;
    double sum_of_squares = 0, spurious = 0, outside = 0, flipped = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Vector& p = result.position[i];
      const Neighbor_search::Neighbor nearest = m_true_search.nearest(p);
      const Vector& normal = m_true.normal[nearest.first];
      error.push_back(plane_distance(p, m_true.position[nearest.first], normal, nearest.second, h));
      sum_of_squares += error.back() * error.back();
      spurious += nearest.second > 3 * h;
      outside += distance(m_input_search, p) < distance(m_removed_search, p);
      sided.push_back(p, normal);
      if(has_normals)
      {
        const double length = result.normal[i].norm();
        const double cosine = length > 0 ? result.normal[i].dot(normal) / length : 0.;
        angle.push_back(std::acos((std::max)(-1., (std::min)(1., cosine))) * 360. / two_pi);
        flipped += angle.back() > 90;
      }
    }
    m.acc_mean = mean(error) / h;
    m.acc_rms = std::sqrt(sum_of_squares / double(n)) / r;
    m.acc_p95 = quantile(error, 0.95) / r;
    m.acc_max = *std::max_element(error.begin(), error.end()) / r;
    m.spurious = spurious / double(n);
    m.outside = outside / double(n);
    if(has_normals)
    {
      m.normal_deg = mean(angle);
      m.normal_p95 = quantile(angle, 0.95);
      m.normal_flip = flipped / double(n);
    }
    if(n > 1)
    {
      const std::vector<double> gap = neighbor_distances(result.position);
      m.density = quantile(gap, 0.5) / h;
      m.nn_p5 = quantile(gap, 0.05) / h;
    }
  }

  void score_completeness(const Surface_points& sided, const Neighbor_search& search, Measures& m) const
  {
    std::vector<double> error;
    double covered = 0;
    m.hole_max = 0;
    for(const Vector& p : m_case.removed.position)
    {
      const Neighbor_search::Neighbor nearest = search.nearest(p);
      covered += nearest.second < 2 * h;
      m.hole_max = (std::max)(m.hole_max, nearest.second / h);
      if(nearest.second > 2 * h)
        error.push_back(nearest.second);
      else
      {
        const Vector& q = sided.position[nearest.first];
        error.push_back(std::abs((p - q).dot(normal_of_neighbors(sided.position, search, q, 10))));
      }
    }
    m.coverage = covered / double(error.size());
    m.comp_mean = mean(error) / h;
    m.hole_distance = in_diagonals(mean(error));
  }

  void score_detail(const Surface_points& sided, const Neighbor_search& search, const Neighbor_search& whole_search,
                    Measures& m) const
  {
    const Surface_points& removed = m_case.removed;
    const double radius = (std::max)(6 * h, 0.25 * r);
    std::vector<double> truth, result;
    // where roughness has two levels, as at edges, other samples change the ratio of medians by a tenth
    for(std::size_t i : some_of(removed.size(), 200))
    {
      const Roughness a = roughness(m_whole, whole_search, removed.position[i], removed.normal[i], radius, 0);
      if(std::isnan(a.residual))
        continue;
      truth.push_back(a.residual);
      const Roughness b = roughness(sided, search, removed.position[i], removed.normal[i], radius,
                                    0.5 * double(a.number_of_neighbors));
      if(!std::isnan(b.residual))
        result.push_back(b.residual);
    }
    m.detail_n = double(result.size());
    if(truth.empty())
      return;
    const double median = quantile(truth, 0.5);
    m.detail_true = median / h;
    if(result.size() < 5)
      return;
    m.detail_ratio = (quantile(result, 0.5) + flat * h) / (median + flat * h);
    m.detail_w1 = wasserstein_distance(result, truth) / (median + flat * h);
  }

  void score_seam(const Surface_points& sided, const Neighbor_search& search, const Neighbor_search& whole_search,
                  Measures& m) const
  {
    std::vector<std::size_t> rim;
    for(std::size_t i = 0; i < m_near.size(); ++i)
      if(distance(m_removed_search, m_near.position[i]) < 2.5 * h)
        rim.push_back(i);
    std::vector<double> result, truth;
    const std::vector<std::size_t> chosen = some_of(rim.size(), 1000);
    m.n_rim = double(chosen.size());
    for(std::size_t i : chosen)
    {
      const Vector& p = m_near.position[rim[i]];
      const Vector& n = m_near.normal[rim[i]];
      const double a = plane_residual(sided, search, p, n, 4 * h);
      const double b = plane_residual(m_whole, whole_search, p, n, 4 * h);
      if(std::isnan(a) || std::isnan(b))
        continue;
      result.push_back(a);
      truth.push_back(b);
    }
    if(result.empty())
      return;
    m.seam_med = (quantile(result, 0.5) + flat * h) / (quantile(truth, 0.5) + flat * h);
    m.seam_p95 = (quantile(result, 0.95) + flat * h) / (quantile(truth, 0.95) + flat * h);
  }

  // all indices, or `number` of them by chance, increasing
  static std::vector<std::size_t> some_of(std::size_t size, std::size_t number)
  {
    std::vector<std::size_t> indices = Random_source(12345).permutation(size);
    indices.resize((std::min)(size, number));
    std::sort(indices.begin(), indices.end());
    return indices;
  }

  const Benchmark_case& m_case;
  const double h, r;
  const Surface_points m_true;
  const Neighbor_search m_true_search, m_input_search, m_removed_search;
  Surface_points m_near;
  Surface_points m_whole;                       // what was removed and the input around it
};

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_MEASURES_H
