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

#include <CGAL/Context_completion_3/internal/Box_quadric_intersection.h>
#include <CGAL/Context_completion_3/internal/Box_quadric_subdivision.h>

#include <gtest/gtest.h>

#include <random>

namespace test_box_quadric {

using namespace CGAL::Context_completions_3::internal;

namespace {

typedef CGAL::Exact_rational FT;

// An independent judge: extremes over the box by exact recursion over its faces. The restriction of q to a face is
// fixed variable by variable; critical points come from Gaussian elimination, not from Cramer's rule, and neither
// definiteness nor the signs of the corners are used.
class Judge
{
public:
  Judge(const Quadric& q, const CGAL::Bbox_3& box) : m_quadric(q), m_box(box) {}

  bool operator()()
  {
    for(int code = 0; code < 27; ++code)
      visit(code);
    return m_least <= 0 && m_greatest >= 0;
  }

private:
  void visit(int code)
  {
    FT x[3];
    int free[3], n = 0;
    for(int d = 0, rest = code; d < 3; ++d, rest /= 3)
    {
      x[d] = rest % 3 == 0 ? FT((m_box.min)(d)) : rest % 3 == 1 ? FT((m_box.max)(d)) : FT(0);
      if(rest % 3 == 2)
        free[n++] = d;
    }
    FT rows[3][4];
    for(int i = 0; i < n; ++i)
    {
      for(int j = 0; j < n; ++j)
        rows[i][j] = second(free[i], free[j]);
      rows[i][n] = -first(free[i], x);
    }
    for(int i = 0; i < n; ++i)
    {
      int pivot = i;
      while(pivot < n && rows[pivot][i] == 0)
        ++pivot;
      if(pivot == n)
        return;
      for(int j = 0; j <= n; ++j)
        std::swap(rows[i][j], rows[pivot][j]);
      for(int k = 0; k < n; ++k)
      {
        if(k == i)
          continue;
        const FT factor = rows[k][i] / rows[i][i];
        for(int j = 0; j <= n; ++j)
          rows[k][j] -= factor * rows[i][j];
      }
    }
    for(int i = 0; i < n; ++i)
    {
      x[free[i]] = rows[i][n] / rows[i][i];
      if(x[free[i]] < FT((m_box.min)(free[i])) || x[free[i]] > FT((m_box.max)(free[i])))
        return;
    }
    Quadric_3<FT> q;
    for(std::size_t i = 0; i < 10; ++i)
      q.c[i] = FT(m_quadric.c[i]);
    const FT f = q(x[0], x[1], x[2]);
    m_least = m_any ? (std::min)(m_least, f) : f;
    m_greatest = m_any ? (std::max)(m_greatest, f) : f;
    m_any = true;
  }

  FT second(int i, int j) const
  {
    static const int index[3][3] = { { 0, 3, 4 }, { 3, 1, 5 }, { 4, 5, 2 } };
    return (i == j ? 2 : 1) * FT(m_quadric.c[std::size_t(index[i][j])]);
  }

  FT first(int i, const FT* x) const // derivative with the free variables at 0
  {
    FT result(m_quadric.c[std::size_t(6 + i)]);
    for(int j = 0; j < 3; ++j)
      result += second(i, j) * x[j];
    return result;
  }

  Quadric m_quadric;
  CGAL::Bbox_3 m_box;
  FT m_least, m_greatest;
  bool m_any = false;
};

Quadric squared_plane(double a, double b, double c, double d) // (ax + by + cz + d)^2
{
  Quadric q;
  q.c = {{ a * a, b * b, c * c, 2 * a * b, 2 * a * c, 2 * b * c, 2 * a * d, 2 * b * d, 2 * c * d, d * d }};
  return q;
}

Quadric sphere(const Vector& o, double squared_radius)
{
  Quadric q;
  q.c = {{ 1, 1, 1, 0, 0, 0, -2 * o.x(), -2 * o.y(), -2 * o.z(), o.squaredNorm() - squared_radius }};
  return q;
}

Quadric raised(Quadric q) // by the least possible amount
{
  q.c[9] = std::nextafter(q.c[9], 1e300);
  return q;
}

const CGAL::Bbox_3 unit_box(0, 0, 0, 1, 1, 1);

} // namespace

TEST(Box_quadric, random_quadrics_agree_with_the_judge)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::size_t met = 0;
  for(int i = 0; i < 10000; ++i)
  {
    Quadric q;
    for(double& c : q.c)
      c = normal(random);
    q.c[9] *= i % 4;
    const Vector l(normal(random), normal(random), normal(random));
    const double s = std::abs(normal(random)) * (i % 2 == 0 ? 1 : 0.1);
    const CGAL::Bbox_3 box(l.x(), l.y(), l.z(), l.x() + s, l.y() + 2 * s, l.z() + s);
    const bool expected = Judge(q, box)();
    ASSERT_EQ(do_intersect_exactly(q, box), expected) << "quadric " << i;
    met += expected ? 1 : 0;
  }
  EXPECT_GT(met, 1000u);
  EXPECT_LT(met, 9000u);
}

TEST(Box_quadric, degenerate_integer_quadrics_agree_with_the_judge)
{
  std::mt19937 random(8);
  std::uniform_int_distribution<int> small(-2, 2), shift(-6, 6);
  std::size_t met = 0;
  for(int i = 0; i < 20000; ++i)
  {
    Quadric q;
    for(double& c : q.c)
      c = small(random);
    if(i % 3 == 0) // double planes
      q = squared_plane(small(random), small(random), small(random), shift(random));
    if(i % 3 == 1)
      q.c[9] = shift(random);
    const CGAL::Bbox_3 box(small(random), small(random), small(random), 3, 3 + small(random), 4);
    const CGAL::Bbox_3 ordered(box.xmin(), (std::min)(box.ymin(), box.ymax()), box.zmin(),
                               box.xmax(), (std::max)(box.ymin(), box.ymax()), box.zmax());
    const bool expected = Judge(q, ordered)();
    ASSERT_EQ(do_intersect_exactly(q, ordered), expected) << "quadric " << i;
    met += expected ? 1 : 0;
  }
  EXPECT_GT(met, 2000u);
  EXPECT_LT(met, 19000u);
}

TEST(Box_quadric, tangency_counts_and_one_ulp_away_does_not)
{
  // sphere inside the box, around it, touching a face, an edge and a corner from outside
  EXPECT_TRUE(do_intersect_exactly(sphere(Vector(0.5, 0.5, 0.5), 0.01), unit_box));
  EXPECT_FALSE(do_intersect_exactly(sphere(Vector(0.5, 0.5, 0.5), 4), unit_box));
  EXPECT_TRUE(do_intersect_exactly(sphere(Vector(0.5, 0.5, 3), 4), unit_box));
  EXPECT_FALSE(do_intersect_exactly(raised(sphere(Vector(0.5, 0.5, 3), 4)), unit_box));
  EXPECT_TRUE(do_intersect_exactly(sphere(Vector(0.5, 4, 5), 25), unit_box));
  EXPECT_FALSE(do_intersect_exactly(raised(sphere(Vector(0.5, 4, 5), 25)), unit_box));
  EXPECT_TRUE(do_intersect_exactly(sphere(Vector(0.5, 0.5, 0.5), 0), unit_box)); // a single point
  // the double plane x + y + z = 3 touches the corner (1, 1, 1)
  EXPECT_TRUE(do_intersect_exactly(squared_plane(1, 1, 1, -3), unit_box));
  EXPECT_FALSE(do_intersect_exactly(squared_plane(1, 1, 1, -3.0000001), unit_box));
  EXPECT_TRUE(do_intersect_exactly(squared_plane(1, 1, 1, -1.5), unit_box));
}

TEST(Box_quadric, constants_and_flat_boxes)
{
  Quadric q;
  EXPECT_TRUE(do_intersect_exactly(q, unit_box)); // 0 = 0 everywhere
  q.c[9] = -1;
  EXPECT_FALSE(do_intersect_exactly(q, unit_box));
  const CGAL::Bbox_3 point(1, 1, 1, 1, 1, 1);
  EXPECT_TRUE(do_intersect_exactly(sphere(Vector(0, 1, 1), 1), point));
  EXPECT_FALSE(do_intersect_exactly(sphere(Vector(0, 1, 1), 0.99), point));
}

TEST(Box_quadric, tiny_boxes_far_from_the_origin)
{
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for(int i = 0; i < 2000; ++i)
  {
    const Vector n = Vector(normal(random), normal(random), normal(random)).normalized(), o(1000, -2000, 3000);
    Matrix a = Matrix::Random() * 0.3;
    a = (a + a.transpose()).eval();
    const Quadric q = make_quadric(a, n, normal(random) * 0.5, o, 1e-3);
    const CGAL::Bbox_3 box(o.x(), o.y(), o.z(), o.x() + 1e-3, o.y() + 1e-3, o.z() + 1e-3);
    ASSERT_EQ(do_intersect_exactly(q, box), Judge(q, box)());
  }
}

TEST(Box_quadric, subdivision_of_the_paper_errs_on_the_safe_side_only)
{
  const Box_quadric_subdivision subdivision(8);
  std::mt19937 random(10);
  std::normal_distribution<double> normal;
  std::size_t different = 0;
  for(int i = 0; i < 5000; ++i)
  {
    Quadric q;
    for(double& c : q.c)
      c = normal(random);
    const Vector l(normal(random), normal(random), normal(random));
    const CGAL::Bbox_3 box(l.x(), l.y(), l.z(), l.x() + 0.5, l.y() + 0.5, l.z() + 0.5);
    const bool exact = do_intersect_exactly(q, box), found = subdivision(q, box);
    ASSERT_TRUE(found || !exact) << "quadric " << i; // a surface that is there is never missed
    different += exact != found ? 1 : 0;
  }
  EXPECT_LE(different, 5u); // all but near tangency
  EXPECT_FALSE(subdivision(sphere(Vector(0.5, 0.5, 0.5), 4), unit_box));
  EXPECT_TRUE(subdivision(sphere(Vector(0.5, 0.5, 0.5), 0.01), unit_box));
  EXPECT_TRUE(subdivision(sphere(Vector(0.3, 0.3, 3), 4 - 1e-9), unit_box)); // ends at its limit: "meets"
}

} // namespace test_box_quadric
