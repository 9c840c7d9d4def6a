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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_FAMILY_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_FAMILY_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Smooth_patch.h>

#include <CGAL/for_each.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  Smooth continuations of what is known around a hole, from interpolating to strongly smoothing: as operators from data at
  the centres (value and gradient over the base of the patch, 4 numbers a centre) to heights at its samples.

  Each is a trend (polyharmonic, with more or less noise) plus what the trend misses at the centres, which either is made
  up close to the rim or goes on as a random field with a Matern covariance of some range (simple kriging).

  None is best everywhere: interpolation wins on clean smooth surfaces, and carries the slope of noise and relief far into
  the hole elsewhere. So they are weighted by what they reach on fake holes, or, where there are too few of those, by how
  well each predicts sectors of the surroundings from the others.
*/
template <typename ConcurrencyTag>
class Base_family
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

  struct Member
  {
    double value_noise = 0, gradient_noise = 0;   // of the trend: variances in units of the hole's radius
    double range = 0;                    // of the rest, in radii; 0: it fades out within a few spacings of the rim
    Polyharmonic_base trend;
    Eigen::MatrixXd basis;               // samples x coefficients
    Eigen::MatrixXd center_basis;        // centres of the rest x coefficients
    Eigen::MatrixXd rest;                // samples x centres of the rest
    Eigen::VectorXd offset;              // height of this base over that of the patch
    Eigen::VectorXd missed;              // known surface over the trend, at the centres of the rest
    double sector_error = 0;
  };

public:
  explicit Base_family(const Patch& patch) : m_patch(patch)
  {
    for(std::size_t i = 0; i < patch.centers().size(); ++i)
    {
      m_all.push_back(i);
      if(patch.centers()[i].distance < 1.6 * patch.spacing())
        m_rim.push_back(i);
    }
    prepare_correction();
    prepare_membrane();
    const double settings[][3] = {{0, 0, 0}, {0.01, 10, 0}, {0.1, 100, 0}, {1, 300, 0},
                                  {1, 300, 0.1}, {1, 300, 0.2}, {1, 300, 0.4}, {10, 3000, 0.4}};
    std::vector<std::size_t> indices;
    for(const double* setting : settings)
    {
      Member member;
      member.value_noise = setting[0];
      member.gradient_noise = setting[1];
      member.range = setting[2];
      indices.push_back(m_members.size());
      m_members.push_back(member);
    }
    const std::vector<std::vector<std::size_t> > groups = sectors();
    CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t m) -> bool
    {
      prepare(m_members[m], groups);
      return true;
    });
  }

  std::size_t size() const { return m_members.size(); }

  bool is_kriging(std::size_t m) const { return m_members[m].range > 0; }

  /// Heights that member `m` continues the known surface with, displaced by each column of `data`.
  Eigen::MatrixXd heights(std::size_t m, const Eigen::MatrixXd& data) const
  {
    const Member& member = m_members[m];
    const Eigen::MatrixXd coefficients = member.trend.solve(data);
    const Eigen::MatrixXd rest = values_at(rest_centers(member), data) - member.center_basis * coefficients;
    return (member.basis * coefficients + member.rest * rest).colwise() + member.offset;
  }

  /// Weights for `combine()` from an error of each member.
  static std::vector<double> weights(const std::vector<double>& errors, double floor, double power)
  {
    std::vector<double> result;
    const double least = *std::min_element(errors.begin(), errors.end());
    double total = 0;
    for(double e : errors)
    {
      result.push_back(std::pow((e + floor) / (least + floor), -power));
      total += result.back();
    }
    for(double& w : result)
      w /= total;
    return result;
  }

  /// The weighted median of the members, sample by sample, so that a single one cannot run away.
  static Eigen::MatrixXd combine(const std::vector<Eigen::MatrixXd>& heights, const std::vector<double>& weights)
  {
    Eigen::MatrixXd result(heights[0].rows(), heights[0].cols());
    std::vector<std::pair<double, double> > sorted(heights.size());
    for(Eigen::Index c = 0; c < result.cols(); ++c)
      for(Eigen::Index r = 0; r < result.rows(); ++r)
      {
        for(std::size_t m = 0; m < heights.size(); ++m)
          sorted[m] = std::make_pair(heights[m](r, c), weights[m]);
        result(r, c) = weighted_median(sorted);
      }
    return result;
  }

  /// Mean error of each member in the prediction of sectors of the surroundings; kriging inherits that of its trend.
  std::vector<double> sector_errors() const
  {
    std::vector<double> result;
    for(const Member& m : m_members)
      result.push_back(m.sector_error);
    return result;
  }

  /// Continues the values of each column of `data` as a membrane; linear.
  Eigen::MatrixXd membrane(const Eigen::MatrixXd& data) const
  {
    return m_membrane * values_at(m_rim, data);
  }

  /// Root mean square of what a smoothed base misses at the rim, for the known surface displaced by each column of
  /// `data`: how rough the surroundings are.
  Eigen::VectorXd roughness(const Eigen::MatrixXd& data) const
  {
    const Member& m = m_members[2];
    const Eigen::MatrixXd left = values_at(m_rim, data) - m.center_basis * m.trend.solve(data);
    Eigen::VectorXd result(data.cols());
    for(Eigen::Index k = 0; k < data.cols(); ++k)
      result[k] = std::sqrt((m.missed + left.col(k)).squaredNorm() / double(m.missed.size()));
    return result;
  }

private:
  static Eigen::MatrixXd values_at(const std::vector<std::size_t>& centers, const Eigen::MatrixXd& data)
  {
    Eigen::MatrixXd values(Eigen::Index(centers.size()), data.cols());
    for(std::size_t i = 0; i < centers.size(); ++i)
      values.row(Eigen::Index(i)) = data.row(4 * Eigen::Index(centers[i]));
    return values;
  }

  static double weighted_median(std::vector<std::pair<double, double> >& values)
  {
    std::sort(values.begin(), values.end());
    // linear between the members, so that the median is continuous from sample to sample
    double below = 0;
    for(std::size_t i = 0; i < values.size(); ++i)
    {
      const double middle = below + values[i].second / 2;
      if(middle >= 0.5)
      {
        if(i == 0)
          return values[0].first;
        const double previous = below - values[i - 1].second / 2;
        const double t = (0.5 - previous) / (middle - previous);
        return values[i - 1].first + t * (values[i].first - values[i - 1].first);
      }
      below += values[i].second;
    }
    return values.back().first;
  }

  const std::vector<std::size_t>& rest_centers(const Member& m) const { return m.range > 0 ? m_all : m_rim; }

  // A smoothed base misses the rim; what it misses is made up within a few spacings.
  void prepare_correction()
  {
    const double range = 4 * m_patch.spacing();
    const Eigen::Index n = Eigen::Index(m_rim.size()), j = Eigen::Index(m_patch.samples().size());
    Eigen::MatrixXd a(n, n), b(j, n);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const Vector c = m_patch.centers()[m_rim[std::size_t(i)]].position;
      for(Eigen::Index k = 0; k < n; ++k)
        a(i, k) = std::exp(-(c - m_patch.centers()[m_rim[std::size_t(k)]].position).norm() / range);
      for(Eigen::Index s = 0; s < j; ++s)
        b(s, i) = std::exp(-(c - m_patch.samples()[std::size_t(s)].position).norm() / range);
    }
    a.diagonal().array() += 1e-3;
    m_correction = a.ldlt().solve(b.transpose()).transpose();
  }

  void prepare_membrane()
  {
    std::vector<Vector> positions;
    for(std::size_t i : m_rim)
      positions.push_back(m_patch.centers()[i].position);
    const Membrane membrane(positions, m_patch.scale());
    const Eigen::Index n = Eigen::Index(m_rim.size());
    const Eigen::MatrixXd weights = membrane.solve(Eigen::MatrixXd::Identity(n, n));
    Eigen::RowVectorXd row;
    m_membrane.resize(Eigen::Index(m_patch.samples().size()), n);
    for(std::size_t s = 0; s < m_patch.samples().size(); ++s)
    {
      membrane.basis(m_patch.samples()[s].position, row);
      m_membrane.row(Eigen::Index(s)) = row * weights;
    }
  }

  // Simple kriging: what is missed at all centres, as a random field of Matern 3/2 covariance with a small nugget.
  Eigen::MatrixXd kriging(double range) const
  {
    const auto covariance = [&](const Vector& p, const Vector& q) {
      const double r = (p - q).norm() / (range * m_patch.scale());
      return (1 + r) * std::exp(-r); };
    const Eigen::Index n = Eigen::Index(m_patch.centers().size()), j = Eigen::Index(m_patch.samples().size());
    Eigen::MatrixXd a(n, n), b(j, n);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const Vector& c = m_patch.centers()[std::size_t(i)].position;
      for(Eigen::Index k = 0; k < n; ++k)
        a(i, k) = covariance(c, m_patch.centers()[std::size_t(k)].position);
      a(i, i) += 0.02;
      for(Eigen::Index s = 0; s < j; ++s)
        b(s, i) = covariance(c, m_patch.samples()[std::size_t(s)].position);
    }
    return a.ldlt().solve(b.transpose()).transpose();
  }

  void prepare(Member& m, const std::vector<std::vector<std::size_t> >& groups) const
  {
    std::vector<Vector> positions;
    for(const Base_center& c : m_patch.centers())
      positions.push_back(c.position);
    m.trend = Polyharmonic_base(positions, m_patch.scale(), m.value_noise, m.gradient_noise);
    m.rest = m.range > 0 ? kriging(m.range) : m_correction;
    const Eigen::MatrixXd data = m_patch.normal_data();
    const Eigen::VectorXd coefficients = m.trend.solve(data).col(0);
    const std::vector<std::size_t>& centers = rest_centers(m);
    const Eigen::Index n = Eigen::Index(m_patch.samples().size()), r = Eigen::Index(centers.size());
    Eigen::RowVectorXd row;
    m.basis.resize(n, coefficients.size());
    m.offset.resize(n);
    for(Eigen::Index s = 0; s < n; ++s)
    {
      const Base_sample& sample = m_patch.samples()[std::size_t(s)];
      m.trend.basis(sample.position, row);
      m.basis.row(s) = row;
      m.offset[s] = height(m.trend, coefficients, sample.position, sample.normal);
    }
    m.center_basis.resize(r, coefficients.size());
    m.missed.resize(r);
    for(Eigen::Index i = 0; i < r; ++i)
    {
      const Base_center& c = m_patch.centers()[centers[std::size_t(i)]];
      m.trend.basis(c.position, row);
      m.center_basis.row(i) = row;
      m.missed[i] = -height(m.trend, coefficients, c.position, c.normal);
    }
    m.offset += m.rest * m.missed;
    m.sector_error = prediction_error(m, groups, data.col(0));
  }

  // Height of the zero set over `x` along `normal`, by Newton's method on the line.
  double height(const Polyharmonic_base& base, const Eigen::VectorXd& coefficients, const Vector& x,
                const Vector& normal) const
  {
    const double limit = 0.3 * m_patch.scale();
    double t = 0;
    for(int step = 0; step < 4; ++step)
    {
      Vector gradient;
      const double f = base.value(x + t * normal, coefficients, gradient);
      const double slope = gradient.dot(normal);
      if(!(slope > 0.2))
        break;
      t = (std::max)(-limit, (std::min)(limit, t - f / slope));
    }
    return t;
  }

  // Six sectors of the surroundings around the axis of the hole.
  std::vector<std::vector<std::size_t> > sectors() const
  {
    Vector middle = Vector::Zero(), axis = Vector::Zero();
    for(const Base_sample& s : m_patch.samples())
    {
      middle += s.position;
      axis += s.normal;
    }
    middle /= double(m_patch.samples().size());
    axis = axis.norm() > 0 ? axis.normalized() : Vector(Vector::UnitZ());
    const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
    std::vector<std::vector<std::size_t> > groups(6);
    for(std::size_t i = 0; i < m_patch.centers().size(); ++i)
    {
      const Vector d = m_patch.centers()[i].position - middle;
      const double angle = std::atan2(d.dot(v), d.dot(u)) / (2 * 3.14159265358979323846) + 0.5;
      groups[(std::min)(std::size_t(5), std::size_t(6 * angle))].push_back(i);
    }
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                                [](const std::vector<std::size_t>& g) { return g.empty(); }), groups.end());
    return groups;
  }

  double prediction_error(const Member& m, const std::vector<std::vector<std::size_t> >& groups,
                          const Eigen::VectorXd& data) const
  {
    const std::vector<Eigen::VectorXd> residuals = m.trend.left_out(groups, data);
    const double limit = 0.3 * m_patch.scale();
    double sum = 0;
    std::size_t count = 0;
    for(std::size_t g = 0; g < groups.size(); ++g)
    {
      for(std::size_t i = 0; i < groups[g].size(); ++i)
        if(m_patch.centers()[groups[g][i]].distance < 0.35 * m_patch.scale())
        {
          const double d = std::abs(residuals[g][4 * Eigen::Index(i)]);
          sum += d < limit ? d : limit;
          ++count;
        }
    }
    return count > 0 ? sum / double(count) : limit;
  }

  const Patch& m_patch;
  std::vector<std::size_t> m_all, m_rim;   // indices of centres
  Eigen::MatrixXd m_correction;         // samples x rim: fades out within a few spacings
  Eigen::MatrixXd m_membrane;
  std::vector<Member> m_members;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_FAMILY_H
