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

#include <CGAL/Context_completion_3/internal/For_each_index.h>
#include <CGAL/Context_completion_3/internal/Linear_systems.h>
#include <CGAL/Context_completion_3/internal/Matrix_operations.h>
#include <CGAL/Context_completion_3/internal/Rim_membrane.h>
#include <CGAL/Context_completion_3/internal/Smooth_patch.h>
#include <CGAL/Context_completion_3/internal/Weighted_quantile.h>

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
  Smooth continuations of what is known around a hole, from interpolating to strongly smoothing: as operators from data
  at the centres (value and gradient over the base of the patch, 4 numbers a centre) to heights at its samples. All are
  led through the guides of the patch.

  Each is a trend (polyharmonic, with more or less noise) plus what the trend misses at the centres, which either is
  made up close to the rim or goes on as a random field with a Matern covariance of some range (simple kriging).

  The data are those of local fits to positions, or of fits that use the normals of points as well, which go on better
  from a rim where the normals are right.

  None is best everywhere: interpolation wins on clean smooth surfaces, and carries the slope of noise and relief far
  into the hole elsewhere. So they are weighted by what they reach on fake holes, or, where there are too few of those,
  by how well each predicts sectors of the surroundings from the others.
*/
template <typename ConcurrencyTag>
class Base_family
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

  struct Trend
  {
    double value_noise = 0, gradient_noise = 0;   // variances in units of the hole's radius
    Polyharmonic_base base;
    Eigen::VectorXd coefficients;        // of the known surface
    Eigen::MatrixXd basis;               // samples x coefficients
    Eigen::MatrixXd center_basis;        // centres x coefficients
    Eigen::VectorXd offset;              // height over that of the patch, at the samples
    Eigen::VectorXd missed;              // known surface over it, at the centres
    Eigen::VectorXd sector_error;        // of the surface by positions, and by normals, too
  };

  struct Member
  {
    std::size_t trend = 0;
    bool uses_normals = false;
    double range = 0;                    // of the rest, in radii; 0: it fades out within a few spacings of the rim
    Eigen::MatrixXd rest;                // samples x centres: spreads what the trend misses
  };

public:
  explicit Base_family(const Patch& patch) : m_patch(patch)
  {
    for(std::size_t i = 0; i < patch.centers().size(); ++i)
      if(patch.centers()[i].distance < 1.6 * patch.spacing())
        m_rim.push_back(i);
    prepare_membrane();
    const double noise[][2] = {{0, 0}, {0.01, 10}, {0.1, 100}, {1, 300}, {10, 3000}};
    for(const double* variances : noise)
    {
      m_trends.emplace_back();
      m_trends.back().value_noise = variances[0];
      m_trends.back().gradient_noise = variances[1];
    }
    const std::pair<std::size_t, double> settings[] = {{0, 0.}, {1, 0.}, {2, 0.}, {3, 0.},
                                                       {3, 0.1}, {3, 0.2}, {3, 0.4}, {4, 0.4}};
    for(bool uses_normals : {false, true})
      for(const std::pair<std::size_t, double>& setting : settings)
      {
        m_members.emplace_back();
        m_members.back().trend = setting.first;
        m_members.back().range = setting.second;
        m_members.back().uses_normals = uses_normals;
      }
    const std::vector<std::vector<std::size_t> > groups = sectors();
    const Eigen::MatrixXd fading = fading_rest();
    for_each_index<ConcurrencyTag>(m_trends.size() + m_members.size(), [&](std::size_t i)
    {
      if(i < m_trends.size())
        prepare(m_trends[i], groups);
      else
      {
        Member& member = m_members[i - m_trends.size()];
        member.rest = member.range > 0 ? kriging(member.range) : fading;
      }
    });
  }

  std::size_t size() const { return m_members.size(); }

  bool is_kriging(std::size_t m) const { return m_members[m].range > 0; }

  /// Whether the data of member `m` are to be from fits that use normals.
  bool uses_normals(std::size_t m) const { return m_members[m].uses_normals; }

  /// Data of the known surface by fits that use normals: it is displaced from what fits to positions tell.
  Eigen::VectorXd known_by_normals() const
  {
    Eigen::VectorXd data(4 * Eigen::Index(m_patch.centers().size()));
    for(std::size_t i = 0; i < m_patch.centers().size(); ++i)
      for(std::size_t k = 0; k < 4; ++k)
        data[Eigen::Index(4 * i + k)] = m_patch.centers()[i].by_normals[k];
    return data;
  }

  /// Heights that member `m` continues the known surface with, displaced by each column of `data`.
  Eigen::MatrixXd heights(std::size_t m, const Eigen::MatrixXd& data) const
  {
    const Member& member = m_members[m];
    const Trend& trend = m_trends[member.trend];
    const Eigen::MatrixXd coefficients = trend.base.solve(with_guides(data));
    Eigen::MatrixXd result = matrix_product(trend.basis, coefficients);
    result += matrix_product(member.rest, missed(trend, data, coefficients));
    add_to_columns(result, trend.offset);
    return result;
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
        result(r, c) = weighted_quantile(sorted, 0.5);
      }
    return result;
  }

  /// Mean error of each member in the prediction of sectors of the surroundings; kriging inherits that of its trend.
  std::vector<double> sector_errors() const
  {
    std::vector<double> result;
    for(const Member& m : m_members)
      result.push_back(m_trends[m.trend].sector_error[m.uses_normals ? 1 : 0]);
    return result;
  }

  /// Values of each column of `data` at the rim.
  Eigen::MatrixXd rim_values(const Eigen::MatrixXd& data) const { return at_rim(values(data)); }

  /// Spreads values at the rim over the samples.
  const Rim_membrane& membrane() const { return m_membrane; }

  /// Root mean square of what a smoothed base misses at the rim, for the known surface displaced by each column of
  /// `data`: how rough the surroundings are.
  Eigen::VectorXd roughness(const Eigen::MatrixXd& data) const
  {
    const Trend& trend = m_trends[2];
    const Eigen::MatrixXd at_the_rim = at_rim(missed(trend, data, trend.base.solve(with_guides(data))));
    Eigen::VectorXd result(data.cols());
    for(Eigen::Index c = 0; c < data.cols(); ++c)
    {
      const Eigen::VectorXd column = at_the_rim.col(c);
      result[c] = std::sqrt(column.squaredNorm() / double(column.size()));
    }
    return result;
  }

  /// By how much fits that use normals are inclined, at the rim, against those that do not: means, for each column.
  Eigen::VectorXd inclination(const Eigen::MatrixXd& data, const Eigen::MatrixXd& data_by_normals) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(data.cols());
    for(Eigen::Index c = 0; c < data.cols(); ++c)
      for(std::size_t i : m_rim)
      {
        Vector difference;
        for(Eigen::Index k = 0; k < 3; ++k)
          difference[k] = data_by_normals(4 * Eigen::Index(i) + 1 + k, c) - data(4 * Eigen::Index(i) + 1 + k, c);
        result[c] += difference.norm() / double(m_rim.size());
      }
    return result;
  }

private:
  // displacements of the centres: the guides stay where they are
  Eigen::MatrixXd with_guides(const Eigen::MatrixXd& data) const
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(data.rows() + 4 * Eigen::Index(m_patch.guides().size()), data.cols());
    result.topRows(data.rows()) = data;
    return result;
  }

  // What a trend misses at the centres of the known surface as it is displaced by each column of `data`.
  static Eigen::MatrixXd missed(const Trend& trend, const Eigen::MatrixXd& data, const Eigen::MatrixXd& coefficients)
  {
    Eigen::MatrixXd result = values(data);
    result -= matrix_product(trend.center_basis, coefficients);
    add_to_columns(result, trend.missed);
    return result;
  }

  // of centres, from their 4 numbers each
  static Eigen::MatrixXd values(const Eigen::MatrixXd& data)
  {
    Eigen::MatrixXd result(data.rows() / 4, data.cols());
    for(Eigen::Index i = 0; i < result.rows(); ++i)
      result.row(i) = data.row(4 * i);
    return result;
  }

  Eigen::MatrixXd at_rim(const Eigen::MatrixXd& all) const
  {
    Eigen::MatrixXd result(Eigen::Index(m_rim.size()), all.cols());
    for(std::size_t i = 0; i < m_rim.size(); ++i)
      result.row(Eigen::Index(i)) = all.row(Eigen::Index(m_rim[i]));
    return result;
  }

  // A smoothed base misses the rim; what it misses there is made up within a few spacings.
  Eigen::MatrixXd fading_rest() const
  {
    const double range = 4 * m_patch.spacing();
    const Eigen::Index n = Eigen::Index(m_rim.size()), j = Eigen::Index(m_patch.samples().size());
    Eigen::MatrixXd a(n, n), b(n, j);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const Vector c = m_patch.centers()[m_rim[std::size_t(i)]].position;
      for(Eigen::Index k = 0; k < n; ++k)
        a(i, k) = std::exp(-(c - m_patch.centers()[m_rim[std::size_t(k)]].position).norm() / range);
      a(i, i) += 1e-3;
      for(Eigen::Index s = 0; s < j; ++s)
        b(i, s) = std::exp(-(c - m_patch.samples()[std::size_t(s)].position).norm() / range);
    }
    const Eigen::MatrixXd of_rim = solve_linear_systems(a, b).transpose();
    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(j, Eigen::Index(m_patch.centers().size()));
    for(Eigen::Index i = 0; i < n; ++i)
      rest.col(Eigen::Index(m_rim[std::size_t(i)])) = of_rim.col(i);
    return rest;
  }

  void prepare_membrane()
  {
    std::vector<Vector> rim, samples;
    for(std::size_t i : m_rim)
      rim.push_back(m_patch.centers()[i].position);
    for(const Base_sample& s : m_patch.samples())
      samples.push_back(s.position);
    m_membrane = Rim_membrane(rim, samples, m_patch.spacing(), m_patch.fit_radius());
  }

  // Simple kriging: what is missed at all centres, as a random field of Matern 3/2 covariance with a small nugget.
  Eigen::MatrixXd kriging(double range) const
  {
    const auto covariance = [&](const Vector& p, const Vector& q) {
      const double r = (p - q).norm() / (range * m_patch.scale());
      return (1 + r) * std::exp(-r); };
    const Eigen::Index n = Eigen::Index(m_patch.centers().size()), j = Eigen::Index(m_patch.samples().size());
    Eigen::MatrixXd a(n, n), b(n, j);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const Vector& c = m_patch.centers()[std::size_t(i)].position;
      for(Eigen::Index k = 0; k < n; ++k)
        a(i, k) = covariance(c, m_patch.centers()[std::size_t(k)].position);
      a(i, i) += 0.02;
      for(Eigen::Index s = 0; s < j; ++s)
        b(i, s) = covariance(c, m_patch.samples()[std::size_t(s)].position);
    }
    return solve_linear_systems(a, b).transpose();
  }

  void prepare(Trend& trend, const std::vector<std::vector<std::size_t> >& groups) const
  {
    std::vector<Vector> positions;
    for(const Base_center& c : m_patch.centers())
      positions.push_back(c.position);
    for(const Base_center& c : m_patch.guides())
      positions.push_back(c.position);
    trend.base = Polyharmonic_base(positions, m_patch.scale(), trend.value_noise, trend.gradient_noise);
    const Eigen::MatrixXd data = m_patch.normal_data();
    trend.coefficients = trend.base.solve(data).col(0);
    const Eigen::Index n = Eigen::Index(m_patch.samples().size()), r = Eigen::Index(m_patch.centers().size());
    Eigen::RowVectorXd row;
    trend.basis.resize(n, trend.coefficients.size());
    trend.offset.resize(n);
    for(Eigen::Index s = 0; s < n; ++s)
    {
      const Base_sample& sample = m_patch.samples()[std::size_t(s)];
      trend.base.basis(sample.position, row);
      trend.basis.row(s) = row;
      trend.offset[s] = height(trend, sample.position, sample.normal);
    }
    trend.center_basis.resize(r, trend.coefficients.size());
    trend.missed.resize(r);
    for(Eigen::Index i = 0; i < r; ++i)
    {
      const Base_center& c = m_patch.centers()[std::size_t(i)];
      trend.base.basis(c.position, row);
      trend.center_basis.row(i) = row;
      trend.missed[i] = -height(trend, c.position, c.normal);
    }
    Eigen::MatrixXd displacements = Eigen::MatrixXd::Zero(4 * r, 2);
    displacements.col(1) = known_by_normals();
    trend.sector_error = prediction_errors(trend, groups, data.col(0), displacements);
  }

  // Height of the zero set over `x` along `normal`, by Newton's method on the line.
  double height(const Trend& trend, const Vector& x, const Vector& normal) const
  {
    const double limit = 0.3 * m_patch.scale();
    double t = 0;
    for(int step = 0; step < 4; ++step)
    {
      Vector gradient;
      const double f = trend.base.value(x + t * normal, trend.coefficients, gradient);
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

  // Of the heights at the centres, as fits to positions tell them, from those of other sectors as a column of
  // `displacements` moves them: means, for each column.
  Eigen::VectorXd prediction_errors(const Trend& trend, const std::vector<std::vector<std::size_t> >& groups,
                                    const Eigen::VectorXd& data, const Eigen::MatrixXd& displacements) const
  {
    // a function grows where its zero set sinks
    Eigen::MatrixXd moved = with_guides(displacements);
    moved *= -1;
    add_to_columns(moved, data);
    const std::vector<Eigen::MatrixXd> residuals = trend.base.left_out(groups, moved);
    const double limit = 0.3 * m_patch.scale();
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(displacements.cols());
    std::size_t count = 0;
    for(std::size_t g = 0; g < groups.size(); ++g)
      for(std::size_t i = 0; i < groups[g].size(); ++i)
        if(m_patch.centers()[groups[g][i]].distance < 0.35 * m_patch.scale())
        {
          for(Eigen::Index c = 0; c < sum.size(); ++c)
            sum[c] += (std::min)(limit, std::abs(residuals[g](4 * Eigen::Index(i), c)
                                                 + displacements(4 * Eigen::Index(groups[g][i]), c)));
          ++count;
        }
    return count > 0 ? Eigen::VectorXd(sum / double(count)) : Eigen::VectorXd::Constant(sum.size(), limit);
  }

  const Patch& m_patch;
  std::vector<std::size_t> m_rim;       // indices of centres
  Rim_membrane m_membrane;
  std::vector<Trend> m_trends;
  std::vector<Member> m_members;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_FAMILY_H
