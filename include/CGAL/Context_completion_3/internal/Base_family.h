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

#include <Eigen/Dense>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

/*!
  The ways to continue what is known around a hole smoothly into it, as linear operators from data at the centres (value
  and gradient over the base of the patch) to heights at its samples. None is best everywhere, so the example places vote
  (see `Forecast`).
*/
template <typename ConcurrencyTag>
class Base_family
{
  typedef Smooth_patch<ConcurrencyTag> Patch;

  struct Member
  {
    std::string name;
    bool is_base = true;                 // the membrane only spreads differences
    Polyharmonic_base polyharmonic;
    bool is_own = true;                  // false: the base of the patch itself
    double noise = 0;
    Eigen::MatrixXd basis;               // samples x coefficients
    Eigen::MatrixXd center_basis;        // rim centres x coefficients, where the rim is not interpolated
    Eigen::VectorXd offset;              // height of this base over that of the patch
  };

public:
  explicit Base_family(const Patch& patch) : m_patch(patch)
  {
    for(std::size_t i = 0; i < patch.centers().size(); ++i)
      if(patch.centers()[i].distance < 1.6 * patch.spacing())
        m_rim.push_back(i);
    prepare_correction();
    add("cubic", Polyharmonic_base::cubic, 0, 0);
    add("cubic, smoothed", Polyharmonic_base::cubic, 0.003, 0.3);
    add("quintic", Polyharmonic_base::quintic, 0, 0);
    add_membrane();
  }

  std::size_t size() const { return m_members.size(); }
  const std::string& name(std::size_t m) const { return m_members[m].name; }
  bool is_base(std::size_t m) const { return m_members[m].is_base; }

  /// Height of base `m` over the base of the patch, per sample.
  const Eigen::VectorXd& offset(std::size_t m) const { return m_members[m].offset; }

  /// Continues each column of `data` (4 numbers a centre) into the hole.
  Eigen::MatrixXd spread(std::size_t m, const Eigen::MatrixXd& data) const
  {
    const Member& member = m_members[m];
    if(!member.is_base)
      return m_membrane_basis * m_membrane.solve(values_at(m_rim, data));
    const Eigen::MatrixXd coefficients = (member.is_own ? member.polyharmonic : m_patch.base()).solve(data);
    Eigen::MatrixXd result = member.basis * coefficients;
    if(member.noise > 0)
      result += m_correction * (values_at(m_rim, data) - member.center_basis * coefficients);
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

  void add(const std::string& name, Polyharmonic_base::Kernel kernel, double value_noise, double gradient_noise)
  {
    Member member;
    member.name = name;
    member.noise = value_noise + gradient_noise;
    std::vector<Vector> positions;
    for(const Base_center& c : m_patch.centers())
      positions.push_back(c.position);
    member.is_own = kernel != Polyharmonic_base::cubic || member.noise > 0;
    if(member.is_own)
      member.polyharmonic = Polyharmonic_base(positions, kernel, m_patch.scale(), value_noise, gradient_noise);
    const Polyharmonic_base& base = member.is_own ? member.polyharmonic : m_patch.base();
    const Eigen::Index n = Eigen::Index(m_patch.samples().size());
    Eigen::RowVectorXd row;
    member.offset = Eigen::VectorXd::Zero(n);
    const Eigen::VectorXd coefficients = base.solve(m_patch.normal_data()).col(0);
    for(Eigen::Index s = 0; s < n; ++s)
    {
      const Base_sample& sample = m_patch.samples()[std::size_t(s)];
      base.basis(sample.position, row);
      if(s == 0)
        member.basis.resize(n, row.size());
      member.basis.row(s) = row;
      if(member.is_own)
        member.offset[s] = height(base, coefficients, sample.position, sample.normal);
    }
    if(member.noise > 0)
    {
      Eigen::VectorXd missed(Eigen::Index(m_rim.size()));
      member.center_basis.resize(Eigen::Index(m_rim.size()), row.size());
      for(std::size_t i = 0; i < m_rim.size(); ++i)
      {
        const Base_center& c = m_patch.centers()[m_rim[i]];
        base.basis(c.position, row);
        member.center_basis.row(Eigen::Index(i)) = row;
        missed[Eigen::Index(i)] = -height(base, coefficients, c.position, c.normal);
      }
      member.offset += m_correction * missed;
    }
    m_members.push_back(member);
  }

  // Height of the zero set over `x` along `normal`, by Newton's method on the line.
  double height(const Polyharmonic_base& base, const Eigen::VectorXd& coefficients, const Vector& x,
                const Vector& normal) const
  {
    double t = 0;
    for(int step = 0; step < 4; ++step)
    {
      Vector gradient;
      const double f = base.value(x + t * normal, coefficients, gradient);
      const double slope = gradient.dot(normal);
      if(!(slope > 0.2))
        break;
      const double limit = 0.3 * m_patch.scale();
      t = (std::max)(-limit, (std::min)(limit, t - f / slope));
    }
    return t;
  }

  void add_membrane()
  {
    Member member;
    member.name = "membrane";
    member.is_base = false;
    member.offset = Eigen::VectorXd::Zero(Eigen::Index(m_patch.samples().size()));
    std::vector<Vector> positions;
    for(std::size_t i : m_rim)
      positions.push_back(m_patch.centers()[i].position);
    m_membrane = Membrane(positions, m_patch.scale());
    Eigen::RowVectorXd row;
    m_membrane_basis.resize(Eigen::Index(m_patch.samples().size()), Eigen::Index(m_rim.size()) + 1);
    for(std::size_t s = 0; s < m_patch.samples().size(); ++s)
    {
      m_membrane.basis(m_patch.samples()[s].position, row);
      m_membrane_basis.row(Eigen::Index(s)) = row;
    }
    m_members.push_back(member);
  }

  const Patch& m_patch;
  std::vector<std::size_t> m_rim;
  Eigen::MatrixXd m_correction;
  Membrane m_membrane;
  Eigen::MatrixXd m_membrane_basis;
  std::vector<Member> m_members;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_BASE_FAMILY_H
