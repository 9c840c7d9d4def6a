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

  None is best everywhere: interpolation wins on clean smooth surfaces, and carries the slope of noise and relief far into
  the hole elsewhere. So each predicts sectors of the surroundings from the others, and is weighted by what it reached.
*/
template <typename ConcurrencyTag>
class Base_family
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

  struct Member
  {
    double value_noise = 0, gradient_noise = 0;
    bool is_membrane = false;            // what the base misses at the rim is spread as a membrane, else it fades out
    Polyharmonic_base base;
    Eigen::MatrixXd basis;               // samples x coefficients
    Eigen::MatrixXd rim_basis;           // rim centres x coefficients
    Eigen::VectorXd offset;              // height of this base over that of the patch
    Eigen::VectorXd missed;              // known surface over this base, at the rim
    double error = 0;                    // of the prediction of sectors
    double weight = 0;
  };

public:
  explicit Base_family(const Patch& patch) : m_patch(patch)
  {
    for(std::size_t i = 0; i < patch.centers().size(); ++i)
      if(patch.centers()[i].distance < 1.6 * patch.spacing())
        m_rim.push_back(i);
    prepare_correction();
    prepare_membrane();
    // variances of values and slopes, in units of the hole's radius; whether a membrane takes up the rest
    const double noise[][3] = {{0, 0, 0}, {0.01, 10, 0}, {0.1, 100, 0}, {1, 300, 0}, {1, 300, 1}, {10, 3000, 1}};
    m_members.resize(6);
    std::vector<std::size_t> indices;
    for(std::size_t m = 0; m < m_members.size(); ++m)
    {
      m_members[m].value_noise = noise[m][0];
      m_members[m].gradient_noise = noise[m][1];
      m_members[m].is_membrane = noise[m][2] > 0;
      indices.push_back(m);
    }
    const std::vector<std::vector<std::size_t> > groups = sectors();
    CGAL::for_each<ConcurrencyTag>(indices, [&](std::size_t m) -> bool
    {
      prepare(m_members[m], groups);
      return true;
    });
    weigh();
  }

  /// Heights of the smooth continuation, for the known surface displaced by each column of `data`: the weighted median of
  /// the members, so that a single one cannot run away.
  Eigen::MatrixXd smooth(const Eigen::MatrixXd& data) const
  {
    std::vector<Eigen::MatrixXd> heights;
    for(const Member& m : m_members)
      heights.push_back(spread(m, data).colwise() + m.offset);
    Eigen::MatrixXd result(heights[0].rows(), heights[0].cols());
    std::vector<std::pair<double, double> > sorted(m_members.size());
    for(Eigen::Index c = 0; c < result.cols(); ++c)
      for(Eigen::Index r = 0; r < result.rows(); ++r)
      {
        for(std::size_t m = 0; m < m_members.size(); ++m)
          sorted[m] = std::make_pair(heights[m](r, c), m_members[m].weight);
        result(r, c) = weighted_median(sorted);
      }
    return result;
  }

  /// Continues the values of each column of `data` as a membrane; linear.
  Eigen::MatrixXd membrane(const Eigen::MatrixXd& data) const
  {
    return m_membrane * values_at(m_rim, data);
  }

  /// Mean error of the prediction of sectors of the surroundings.
  double sector_error() const { return m_sector_error; }

  /// Root mean square of what a smoothed base misses at the rim, for the known surface displaced by each column of
  /// `data`: how rough the surroundings are.
  Eigen::VectorXd roughness(const Eigen::MatrixXd& data) const
  {
    const Member& m = m_members[2];
    const Eigen::MatrixXd left = values_at(m_rim, data) - m.rim_basis * m.base.solve(data);
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

  Eigen::MatrixXd spread(const Member& m, const Eigen::MatrixXd& data) const
  {
    const Eigen::MatrixXd coefficients = m.base.solve(data);
    return m.basis * coefficients + correction(m) * (values_at(m_rim, data) - m.rim_basis * coefficients);
  }

  const Eigen::MatrixXd& correction(const Member& m) const { return m.is_membrane ? m_membrane : m_correction; }

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

  void prepare(Member& m, const std::vector<std::vector<std::size_t> >& groups) const
  {
    std::vector<Vector> positions;
    for(const Base_center& c : m_patch.centers())
      positions.push_back(c.position);
    m.base = Polyharmonic_base(positions, Polyharmonic_base::cubic, m_patch.scale(), m.value_noise, m.gradient_noise);
    const Eigen::MatrixXd data = m_patch.normal_data();
    const Eigen::VectorXd coefficients = m.base.solve(data).col(0);
    const Eigen::Index n = Eigen::Index(m_patch.samples().size()), r = Eigen::Index(m_rim.size());
    Eigen::RowVectorXd row;
    m.basis.resize(n, coefficients.size());
    m.offset.resize(n);
    for(Eigen::Index s = 0; s < n; ++s)
    {
      const Base_sample& sample = m_patch.samples()[std::size_t(s)];
      m.base.basis(sample.position, row);
      m.basis.row(s) = row;
      m.offset[s] = height(m.base, coefficients, sample.position, sample.normal);
    }
    m.rim_basis.resize(r, coefficients.size());
    m.missed.resize(r);
    for(Eigen::Index i = 0; i < r; ++i)
    {
      const Base_center& c = m_patch.centers()[m_rim[std::size_t(i)]];
      m.base.basis(c.position, row);
      m.rim_basis.row(i) = row;
      m.missed[i] = -height(m.base, coefficients, c.position, c.normal);
    }
    m.offset += correction(m) * m.missed;
    m.error = prediction_error(m, groups, data.col(0));
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
    const std::vector<Eigen::VectorXd> residuals = m.base.left_out(groups, data);
    const double limit = 0.3 * m_patch.scale();
    double sum = 0;
    std::size_t count = 0;
    for(std::size_t g = 0; g < groups.size(); ++g)
    {
      Eigen::VectorXd rest = Eigen::VectorXd::Zero(Eigen::Index(groups[g].size()));
      if(m.is_membrane)
        rest = membrane_without(groups[g], m.missed);
      for(std::size_t i = 0; i < groups[g].size(); ++i)
        if(m_patch.centers()[groups[g][i]].distance < 0.35 * m_patch.scale())
        {
          // a datum of value 0 below its prediction lies above the zero set
          const double d = std::abs(-residuals[g][4 * Eigen::Index(i)] - rest[Eigen::Index(i)]);
          sum += d < limit ? d : limit;
          ++count;
        }
    }
    return count > 0 ? sum / double(count) : limit;
  }

  // The membrane through what is missed at the rim outside the group, at the centres of the group.
  Eigen::VectorXd membrane_without(const std::vector<std::size_t>& group, const Eigen::VectorXd& missed) const
  {
    std::vector<Vector> positions;
    std::vector<double> values;
    for(std::size_t i = 0; i < m_rim.size(); ++i)
      if(std::find(group.begin(), group.end(), m_rim[i]) == group.end())
      {
        positions.push_back(m_patch.centers()[m_rim[i]].position);
        values.push_back(missed[Eigen::Index(i)]);
      }
    Eigen::VectorXd result = Eigen::VectorXd::Zero(Eigen::Index(group.size()));
    if(positions.size() < 3)
      return result;
    const Membrane membrane(positions, m_patch.scale());
    const Eigen::VectorXd weights =
      membrane.solve(Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(values.size()))).col(0);
    Eigen::RowVectorXd row;
    for(std::size_t i = 0; i < group.size(); ++i)
    {
      membrane.basis(m_patch.centers()[group[i]].position, row);
      result[Eigen::Index(i)] = row.dot(weights);
    }
    return result;
  }

  void weigh()
  {
    double total = 0;
    for(Member& m : m_members)
    {
      m.weight = std::pow(m.error + 1e-3 * m_patch.spacing(), -4.);
      total += m.weight;
    }
    m_sector_error = 0;
    for(Member& m : m_members)
    {
      m.weight /= total;
      m_sector_error += m.weight * m.error;
    }
  }

  const Patch& m_patch;
  std::vector<std::size_t> m_rim;
  Eigen::MatrixXd m_correction;         // samples x rim: fades out within a few spacings
  Eigen::MatrixXd m_membrane;
  std::vector<Member> m_members;
  double m_sector_error = 0;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_FAMILY_H
