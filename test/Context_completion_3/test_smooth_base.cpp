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

// The stages of the default policy up to the smooth base: neighbours, bands, rims, holes, interpolation.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Base_family.h>
#include <CGAL/Context_completion_3/internal/Hole_detection.h>
#include <CGAL/Context_completion_3/internal/Neighbor_search.h>
#include <CGAL/Context_completion_3/internal/Place_relief.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>
#include <CGAL/Context_completion_3/internal/Polyharmonic_base.h>
#include <CGAL/Context_completion_3/internal/Rim_detection.h>
#include <CGAL/Context_completion_3/internal/Rim_membrane.h>
#include <CGAL/Context_completion_3/internal/Surface_band.h>
#include <CGAL/Context_completion_3/internal/Surface_model.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <unordered_set>
#include <vector>

namespace test_smooth_base {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef Surface_model<CGAL::Sequential_tag> Model;
typedef Detected_hole<CGAL::Sequential_tag> Detected;
typedef Base_family<CGAL::Sequential_tag> Family;

struct Engine_points_and_model
{
  Surface_points points;
  Model model;
  explicit Engine_points_and_model(const samples::Samples& surface)
    : points(samples::engine_points(surface)), model(points)
  {}
};

std::vector<Vector> random_points(std::size_t number, unsigned int seed, double size = 1)
{
  samples::Random_offsets offset(seed);
  std::vector<Vector> points;
  for(std::size_t i = 0; i < number; ++i)
  {
    const double x = offset(), y = offset(), z = offset();
    points.push_back(size * Vector(x, y, z));
  }
  return points;
}

// value and gradient of a field at each centre
Eigen::MatrixXd field_data(const std::vector<Vector>& centers, const std::function<double(const Vector&)>& value,
                           const std::function<Vector(const Vector&)>& gradient)
{
  Eigen::MatrixXd data(4 * Eigen::Index(centers.size()), 1);
  for(std::size_t i = 0; i < centers.size(); ++i)
  {
    data(4 * Eigen::Index(i), 0) = value(centers[i]);
    data.block<3, 1>(4 * Eigen::Index(i) + 1, 0) = gradient(centers[i]);
  }
  return data;
}

double wave(const Vector& p) { return std::sin(0.8 * p.x()) * std::cos(0.5 * p.y()) + 0.3 * p.z() * p.x(); }

Vector wave_gradient(const Vector& p)
{
  return Vector(0.8 * std::cos(0.8 * p.x()) * std::cos(0.5 * p.y()) + 0.3 * p.z(),
                -0.5 * std::sin(0.8 * p.x()) * std::sin(0.5 * p.y()), 0.3 * p.x());
}

// points on a lattice, many at equal distances, each third one twice
std::vector<Vector> lattice_with_duplicates(int n)
{
  std::vector<Vector> points;
  for(int x = 0; x < n; ++x)
    for(int y = 0; y < n; ++y)
      for(int z = 0; z < n; ++z)
        points.push_back(Vector(x, y, z));
  for(std::size_t i = 0; i < std::size_t(n * n * n); i += 3)
    points.push_back(points[i]);
  return points;
}

std::vector<Neighbor_search::Neighbor> sorted_neighbors(const std::vector<Vector>& points, const Vector& q)
{
  std::vector<Neighbor_search::Neighbor> all;
  for(std::size_t i = 0; i < points.size(); ++i)
    all.emplace_back(i, (points[i] - q).norm());
  std::stable_sort(all.begin(), all.end(), [](const Neighbor_search::Neighbor& a, const Neighbor_search::Neighbor& b)
    { return a.second < b.second; });
  return all;
}

std::vector<Detected> detected(const Model& model)
{
  std::vector<Detected> holes;
  EXPECT_TRUE(Hole_detection<CGAL::Sequential_tag>(model).run(holes, std::function<bool(double)>()));
  return holes;
}

/// The holes that are no outer borders.
std::vector<Detected> closed(std::vector<Detected> holes)
{
  holes.erase(std::remove_if(holes.begin(), holes.end(), [](const Detected& h) { return h.is_outer_border; }),
              holes.end());
  return holes;
}

std::size_t number_of_closed(const std::vector<Detected>& holes)
{
  return closed(holes).size();
}

} // namespace

TEST(Polyharmonic_base, Reproduces_affine_fields)
{
  const Vector slope(0.3, -0.7, 1.1);
  const auto value = [&](const Vector& p) { return 2. + slope.dot(p); };
  const auto gradient = [&](const Vector&) { return slope; };
  const std::vector<Vector> centers = random_points(40, 1, 10.), queries = random_points(50, 2, 15.);
  const Polyharmonic_base base(centers, 10.);
  const Eigen::VectorXd c = base.solve(field_data(centers, value, gradient)).col(0);
  for(const Vector& q : queries)
  {
    Vector g;
    EXPECT_NEAR(base.value(q, c, g), value(q), 1e-6);
    EXPECT_LT((g - slope).norm(), 1e-6);
  }
}

TEST(Polyharmonic_base, Plane_around_a_hole_gives_the_plane)
{
  const Vector normal = Vector(1, 2, 3).normalized(), u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vector> centers;
  for(int i = 0; i < 40; ++i)
  {
    const double angle = 2 * samples::pi * i / 20., radius = i < 20 ? 5. : 6.5;
    centers.push_back(Vector(100, -50, 20) + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  const Polyharmonic_base base(centers, 5.);
  const Eigen::VectorXd c = base.solve(field_data(centers, [](const Vector&) { return 0.; },
                                                  [&](const Vector&) { return normal; })).col(0);
  for(const Vector& offset : random_points(50, 5, 5.))
  {
    const Vector q = Vector(100, -50, 20) + offset;
    Vector g;
    EXPECT_NEAR(base.value(q, c, g), normal.dot(offset), 1e-6);
    EXPECT_LT((g - normal).norm(), 1e-6);
  }
}

TEST(Polyharmonic_base, Interpolates_values_and_gradients_at_its_centers)
{
  const std::vector<Vector> centers = random_points(60, 6, 4.);
  const Polyharmonic_base base(centers, 4.);
  const Eigen::VectorXd c = base.solve(field_data(centers, wave, wave_gradient)).col(0);
  for(const Vector& p : centers)
  {
    Vector g;
    EXPECT_NEAR(base.value(p, c, g), wave(p), 1e-7);
    EXPECT_LT((g - wave_gradient(p)).norm(), 1e-6);
  }
}

TEST(Polyharmonic_base, Gradient_and_basis_agree_with_the_value)
{
  const std::vector<Vector> centers = random_points(30, 7, 4.);
  const Polyharmonic_base base(centers, 4.);
  const Eigen::VectorXd c = base.solve(field_data(centers, wave, wave_gradient)).col(0);
  for(const Vector& q : random_points(20, 8, 4.))
  {
    Vector g;
    const double value = base.value(q, c, g), step = 1e-4;
    Eigen::RowVectorXd row;
    base.basis(q, row);
    EXPECT_NEAR(row * c, value, 1e-9);
    for(int k = 0; k < 3; ++k)
    {
      const double above = base.value(q + step * Vector::Unit(k), c), below = base.value(q - step * Vector::Unit(k), c);
      EXPECT_NEAR((above - below) / (2 * step), g[k], 1e-5);
    }
  }
}

TEST(Polyharmonic_base, Left_out_equals_a_base_without_the_group)
{
  const std::vector<Vector> centers = random_points(40, 9, 3.);
  const Eigen::MatrixXd data = field_data(centers, wave, wave_gradient);
  Eigen::MatrixXd two(data.rows(), 2);
  two << data, -2 * data;
  const std::vector<std::vector<std::size_t> > groups =
    { {7}, {1, 2, 3, 20}, {0, 39}, {10, 11, 12, 13, 14, 15, 16, 17} };
  for(const double noise : { 0., 0.01 })
  {
    const Polyharmonic_base base(centers, 3., noise, noise);
    const std::vector<Eigen::MatrixXd> residuals = base.left_out(groups, two);
    ASSERT_EQ(residuals.size(), groups.size());
    for(std::size_t k = 0; k < groups.size(); ++k)
    {
      std::vector<Vector> others;
      for(std::size_t i = 0; i < centers.size(); ++i)
        if(std::find(groups[k].begin(), groups[k].end(), i) == groups[k].end())
          others.push_back(centers[i]);
      const Polyharmonic_base rest(others, 3., noise, noise);
      const Eigen::VectorXd c = rest.solve(field_data(others, wave, wave_gradient)).col(0);
      ASSERT_EQ(residuals[k].rows(), Eigen::Index(4 * groups[k].size()));
      ASSERT_EQ(residuals[k].cols(), 2);
      EXPECT_LT((2 * residuals[k].col(0) + residuals[k].col(1)).norm(), 1e-9 * (1 + residuals[k].norm()));
      for(std::size_t a = 0; a < groups[k].size(); ++a)
      {
        const Vector& p = centers[groups[k][a]];
        Vector g;
        const double value = rest.value(p, c, g);
        EXPECT_NEAR(residuals[k](4 * Eigen::Index(a), 0), wave(p) - value, 1e-6);
        EXPECT_LT((residuals[k].col(0).segment<3>(4 * Eigen::Index(a) + 1) - (wave_gradient(p) - g)).norm(), 1e-5);
      }
    }
  }
}

TEST(Membrane, Interpolates_and_keeps_constants)
{
  const std::vector<Vector> centers = random_points(50, 10, 2.);
  const Membrane membrane(centers, 2.);
  Eigen::MatrixXd values(50, 2);
  for(Eigen::Index i = 0; i < 50; ++i)
  {
    values(i, 0) = wave(centers[std::size_t(i)]);
    values(i, 1) = 3.5;
  }
  const Eigen::MatrixXd c = membrane.solve(values);
  Eigen::RowVectorXd row;
  for(Eigen::Index i = 0; i < 50; ++i)
  {
    membrane.basis(centers[std::size_t(i)], row);
    EXPECT_NEAR(row * c.col(0), values(i, 0), 1e-10);
  }
  for(const Vector& q : random_points(20, 11, 3.))
  {
    membrane.basis(q, row);
    EXPECT_NEAR(row * c.col(1), 3.5, 1e-10);
  }
}

namespace {

// A rim of radius 10 with a place every 1.2, and samples inside.
struct Round_rim
{
  static constexpr double spacing = 1, reach = 3;
  std::vector<Vector> rim, inside;
  Rim_membrane membrane;

  Round_rim()
  {
    for(int i = 0; i < 52; ++i)
      rim.emplace_back(10 * std::cos(i * 0.12083), 10 * std::sin(i * 0.12083), 0);
    for(int x = -6; x <= 6; x += 2)
      for(int y = -6; y <= 6; y += 2)
        inside.emplace_back(x, y, 0);
    membrane = Rim_membrane(rim, inside, spacing, reach);
  }

  Eigen::VectorXd values(const std::function<double(const Vector&)>& f) const
  {
    Eigen::VectorXd result(Eigen::Index(rim.size()));
    for(std::size_t i = 0; i < rim.size(); ++i)
      result[Eigen::Index(i)] = f(rim[i]);
    return result;
  }

  Eigen::VectorXd noise(unsigned int seed) const
  {
    samples::Random_offsets offset(seed);
    return values([&](const Vector&) { return offset(); });
  }

  // At `at`, by a membrane through some places of the rim, whose values have a noise of variance `nugget`.
  double fitted(const std::vector<std::size_t>& used, const Eigen::VectorXd& v, double nugget, const Vector& at) const
  {
    const Eigen::Index n = Eigen::Index(used.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Ones(n + 1, n + 1);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1), row = Eigen::VectorXd::Ones(n + 1);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const Vector& p = rim[used[std::size_t(i)]];
      for(Eigen::Index k = 0; k < n; ++k)
        a(i, k) = (i == k ? nugget : 0.) - (p - rim[used[std::size_t(k)]]).norm() / spacing;
      right[i] = v[Eigen::Index(used[std::size_t(i)])];
      row[i] = -(at - p).norm() / spacing;
    }
    a(n, n) = 0;
    return row.dot(a.fullPivLu().solve(right));
  }
};

} // namespace

TEST(Rim_membrane, Noise_at_the_rim_hardly_bends_it)
{
  const Round_rim round;
  double interpolated = 0, smoothed = 0;
  for(unsigned int seed = 1; seed <= 20; ++seed)
  {
    const Eigen::VectorXd noise = round.noise(seed);
    interpolated += round.membrane.interpolated(noise).cwiseAbs().mean();
    smoothed += round.membrane.smoothed(noise).cwiseAbs().mean();
  }
  EXPECT_GT(interpolated, 0.2);
  EXPECT_LT(smoothed, 0.6 * interpolated);
}

TEST(Rim_membrane, A_tilt_at_the_rim_bends_it_even_under_noise)
{
  const Round_rim round;
  const Eigen::VectorXd tilt = round.values([](const Vector& p) { return 0.1 * p.x(); });
  const Eigen::VectorXd exact = round.membrane.interpolated(tilt);
  EXPECT_LT((round.membrane.smoothed(tilt) - exact).cwiseAbs().maxCoeff(), 0.05);
  const Eigen::VectorXd noisy = tilt + 0.3 * round.noise(3);
  EXPECT_LT((round.membrane.smoothed(noisy) - exact).cwiseAbs().mean(), 0.1 * exact.cwiseAbs().maxCoeff());
}

TEST(Rim_membrane, Is_as_stiff_as_a_search_with_fits_without_each_place_finds)
{
  const Round_rim round;
  std::set<double> chosen;
  for(unsigned int seed = 1; seed <= 8; ++seed)
  {
    const double share = 0.1 * seed;
    const Eigen::VectorXd v = share * round.noise(seed) +
      round.values([&](const Vector& p) { return (1 - share) * std::sin(0.2 * seed * p.x() + 0.1 * p.y()); });
    double best = -1, least = v.cwiseAbs().mean();
    std::vector<std::size_t> all;
    for(std::size_t i = 0; i < round.rim.size(); ++i)
      all.push_back(i);
    for(double nugget : {0., 1., 4., 16., 64.})
    {
      double error = 0;
      for(std::size_t i = 0; i < round.rim.size(); ++i)
      {
        std::vector<std::size_t> others;
        for(std::size_t k : all)
          if((round.rim[k] - round.rim[i]).norm() >= Round_rim::reach)
            others.push_back(k);
        error += std::abs(v[Eigen::Index(i)] - round.fitted(others, v, nugget, round.rim[i]));
      }
      error /= double(round.rim.size());
      if(error < least)
      {
        least = error;
        best = nugget;
      }
    }
    chosen.insert(best);
    const Eigen::VectorXd smoothed = round.membrane.smoothed(v);
    for(std::size_t s = 0; s < round.inside.size(); ++s)
      ASSERT_NEAR(smoothed[Eigen::Index(s)], best < 0 ? 0. : round.fitted(all, v, best, round.inside[s]), 1e-8)
        << "nugget " << best << " sample " << s;
  }
  EXPECT_GT(chosen.size(), 2u) << "the values do not tell stiffnesses apart";
}

TEST(Rim_membrane, A_rim_of_few_places_is_interpolated)
{
  const std::vector<Vector> rim = random_points(8, 3, 4.), inside = random_points(30, 4, 2.);
  const Rim_membrane membrane(rim, inside, 1., 3.);
  const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(8, -1, 1).cwiseAbs2();
  EXPECT_EQ(membrane.smoothed(values), membrane.interpolated(values));
}

TEST(Base_family, Weights_sum_to_one_and_prefer_small_errors)
{
  const std::vector<double> weights = Family::weights({ 0.5, 0.25, 1. }, 0., 4.);
  ASSERT_EQ(weights.size(), 3u);
  EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1., 1e-12);
  EXPECT_NEAR(weights[1] / weights[0], 16., 1e-9);
  EXPECT_NEAR(weights[1] / weights[2], 256., 1e-9);
}

TEST(Base_family, A_single_member_cannot_run_away_with_the_median)
{
  std::vector<Eigen::MatrixXd> heights(3, Eigen::MatrixXd::Constant(4, 2, 1.));
  heights[2].setConstant(1e9);
  const Eigen::MatrixXd combined = Family::combine(heights, { 0.35, 0.35, 0.3 });
  EXPECT_LT(combined.maxCoeff(), 1e9 * 0.51);
  EXPECT_NEAR(Family::combine(heights, { 0.5, 0.45, 0.05 }).maxCoeff(), 1., 1e-9);
}

TEST(Base_family, All_members_continue_a_plane_as_the_plane)
{
  const Engine_points_and_model plane(samples::plane_with_hole());
  const std::vector<Detected> holes = detected(plane.model);
  const auto hole = std::find_if(holes.begin(), holes.end(), [](const Detected& h) { return !h.is_outer_border; });
  ASSERT_NE(hole, holes.end());
  const Family family(*hole->patch);
  const Eigen::MatrixXd nothing = Eigen::MatrixXd::Zero(4 * Eigen::Index(hole->patch->centers().size()), 1);
  // the known surface lifted by a tenth: the plane is lifted, too
  Eigen::MatrixXd lifted = nothing;
  for(Eigen::Index i = 0; i < lifted.rows(); i += 4)
    lifted(i, 0) = 0.1;
  ASSERT_EQ(family.size(), family.sector_errors().size());
  for(std::size_t m = 0; m < family.size(); ++m)
  {
    EXPECT_LT(family.heights(m, nothing).cwiseAbs().maxCoeff(), 1e-3) << "member " << m;
    const Eigen::MatrixXd h = family.heights(m, lifted);
    for(Eigen::Index s = 0; s < h.rows(); ++s)
      EXPECT_NEAR(h(s, 0), 0.1, 1e-3) << "member " << m;
    EXPECT_LT(family.sector_errors()[m], 1e-3) << "member " << m;
  }
}

namespace {

// A plane with a hole whose heights are noisy; its normals stay right, or are turned at random.
samples::Samples noisy_plane_with_hole(double turn)
{
  samples::Samples noisy = samples::plane_with_hole();
  samples::Random_offsets offset(5);
  for(samples::Oriented_point& s : noisy)
  {
    const double x = offset(), y = offset(), z = offset();
    s.first = s.first + 0.2 * z * samples::Vector(0, 0, 1);
    const samples::Vector n(turn * x, turn * y, 1);
    s.second = n / std::sqrt(n.squared_length());
  }
  return noisy;
}

} // namespace

TEST(Surface_model, Right_normals_steady_a_fit_to_points_on_one_side)
{
  samples::Samples half = noisy_plane_with_hole(0);
  const Engine_points_and_model whole(half);
  std::vector<std::size_t> buffer;
  double by_positions = 0, by_normals = 0;
  std::size_t number = 0;
  for(std::size_t i = 0; i < whole.model.size(); ++i)
  {
    std::vector<std::size_t> around;
    whole.model.search().in_ball(whole.model.position(i), 4., around);
    std::unordered_set<std::size_t> ahead;
    for(std::size_t j : around)
      if(whole.model.position(j).x() >= whole.model.position(i).x())
        ahead.insert(j);
    Surface_element positions, normals;
    if(around.size() - ahead.size() < 15 ||
       !whole.model.quadratic_fits(whole.model.position(i), Vector(0, 0, 1), 4., positions, normals, buffer, ahead))
      continue;
    by_positions += std::abs(positions.position.z());
    by_normals += std::abs(normals.position.z());
    ++number;
    Surface_element alone;
    ASSERT_TRUE(whole.model.quadratic_fit(whole.model.position(i), Vector(0, 0, 1), 4., alone, buffer, ahead));
    ASSERT_EQ(alone.position, positions.position);
    ASSERT_EQ(alone.normal, positions.normal);
  }
  ASSERT_GT(number, 500u);
  EXPECT_LT(by_normals, 0.6 * by_positions);
}

TEST(Surface_model, Both_fits_are_exact_on_a_paraboloid)
{
  samples::Samples bowl = samples::plane(20);
  const auto height = [](double x, double y) { return 0.02 * x * x - 0.03 * x * y + 0.01 * y * y + 0.1 * x; };
  for(samples::Oriented_point& s : bowl)
  {
    const double x = s.first.x() - 10, y = s.first.y() - 10;
    s.first = samples::Point(x, y, height(x, y));
    const samples::Vector n(-(0.04 * x - 0.03 * y + 0.1), -(-0.03 * x + 0.02 * y), 1);
    s.second = n / std::sqrt(n.squared_length());
  }
  const Engine_points_and_model surface(bowl);
  std::vector<std::size_t> buffer;
  Surface_element positions, normals;
  ASSERT_TRUE(surface.model.quadratic_fits(Vector(0.3, 0.2, 0), Vector(0, 0, 1), 4., positions, normals, buffer));
  for(const Surface_element& e : {positions, normals})
  {
    EXPECT_NEAR(e.position.z(), height(0.3, 0.2), 1e-6);
    EXPECT_LT((e.normal - Vector(-(0.012 - 0.006 + 0.1), 0.009 - 0.004, 1).normalized()).norm(), 1e-6);
  }
}

TEST(Base_family, Normals_are_believed_where_they_are_right_and_not_where_they_are_turned)
{
  for(const double turn : { 0., 2. })
  {
    const Engine_points_and_model plane(noisy_plane_with_hole(turn));
    const std::vector<Detected> holes = closed(detected(plane.model));
    ASSERT_EQ(holes.size(), 1u);
    const Family family(*holes[0].patch);
    const std::vector<double> errors = family.sector_errors();
    double by_positions = 1e300, by_normals = 1e300;
    for(std::size_t m = 0; m < family.size(); ++m)
      (family.uses_normals(m) ? by_normals : by_positions) =
        (std::min)(family.uses_normals(m) ? by_normals : by_positions, errors[m]);
    if(turn == 0)
    {
      EXPECT_LT(by_normals, by_positions);
    }
    else
    {
      EXPECT_GT(by_normals, 1.1 * by_positions);
    }
  }
}

TEST(Base_family, The_known_surface_by_normals_is_what_a_place_on_itself_shows)
{
  const samples::Samples surface = noisy_plane_with_hole(0.3);
  std::vector<Example_source<CGAL::Sequential_tag> > sources(1);
  sources[0].points = std::make_shared<Surface_points>(samples::engine_points(surface));
  sources[0].model = std::make_shared<Model>(*sources[0].points);
  const std::vector<Detected> holes = closed(detected(*sources[0].model));
  ASSERT_EQ(holes.size(), 1u);
  const Family family(*holes[0].patch);
  const Relief_sampler<CGAL::Sequential_tag> sampler(*holes[0].patch, sources);
  const Place_relief relief = sampler.relief(Place());
  const Eigen::VectorXd known = family.known_by_normals();
  ASSERT_EQ(known.size(), relief.rim_by_normals.size());
  // the place looks from the centres, which its fits to positions give back but for what moves with the foot
  EXPECT_GT(known.cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT((known - relief.rim_by_normals).cwiseAbs().mean(), 0.15 * known.cwiseAbs().mean());
}

TEST(Smooth_patch, Noise_asks_for_a_larger_radius_of_the_fits)
{
  samples::Samples noisy = samples::plane_with_hole();
  samples::Random_offsets offset(3);
  for(samples::Oriented_point& s : noisy)
    s.first = s.first + 0.4 * offset() * samples::Vector(0, 0, 1);
  double radius[2];
  int k = 0;
  for(const samples::Samples& surface : { samples::bumpy_plane_with_hole(), noisy })
  {
    const Engine_points_and_model points(surface);
    const std::vector<Detected> holes = detected(points.model);
    const auto hole = std::find_if(holes.begin(), holes.end(), [](const Detected& h) { return !h.is_outer_border; });
    ASSERT_NE(hole, holes.end());
    radius[k++] = hole->patch->fit_radius() / hole->patch->area_spacing();
  }
  EXPECT_EQ(radius[0], 3.);
  EXPECT_GT(radius[1], 3.);
}

TEST(Smooth_patch, Beside_an_outer_border_it_runs_off_before_it_is_sampled)
{
  for(const samples::Samples& sheet : { samples::plane_with_hole(), samples::bumpy_plane_with_hole() })
  {
    const Surface_points points = samples::engine_points(sheet);
    const Model model(points);
    std::size_t closed = 0;
    for(const Rim_loop& loop : Rim_detection<CGAL::Sequential_tag>(model).loops())
    {
      const auto surroundings =
        std::make_shared<const Rim_surroundings<CGAL::Sequential_tag> >(model, std::vector<Rim_loop>(1, loop));
      const Smooth_patch<CGAL::Sequential_tag> patch(surroundings);
      closed += patch.is_closed();
      if(patch.is_closed())
      {
        EXPECT_LT(loop.diameter, 15.);
      }
      else
      {
        EXPECT_GT(loop.diameter, 30.);
        EXPECT_TRUE(patch.samples().empty());
      }
    }
    EXPECT_EQ(closed, 1u);
  }
}

TEST(Smooth_patch, Is_given_up_where_more_of_it_is_covered_than_is_asked_for)
{
  const Surface_points points = samples::engine_points(samples::plane_with_hole());
  const Model model(points);
  const Detected* hole = nullptr;
  const std::vector<Detected> holes = detected(model);
  for(const Detected& h : holes)
    if(!h.is_outer_border)
      hole = &h;
  ASSERT_TRUE(hole != nullptr);
  const double covered = double(hole->patch->samples().size() - hole->patch->number_of_uncovered()),
               share = covered / double(hole->patch->rim().size());
  ASSERT_GT(share, 0.3);
  const auto is_closed = [&](double most_covered)
  {
    return Smooth_patch<CGAL::Sequential_tag>(hole->patch->surroundings(), false, std::nullopt, std::vector<Base_center>(),
                                              most_covered).is_closed();
  };
  EXPECT_TRUE(is_closed(share + 0.01));
  EXPECT_FALSE(is_closed(share / 2));
}

TEST(Point_grid, Equals_brute_force)
{
  std::vector<Vector> points = random_points(400, 12, 3.);
  points.insert(points.end(), points.begin(), points.begin() + 20);
  Point_grid grid(0.7);
  for(const Vector& p : points)
    grid.insert(p);
  ASSERT_EQ(grid.number_of_points(), points.size());
  for(const Vector& q : random_points(50, 13, 3.5))
    for(const double radius : { 0., 0.3, 0.7, 2.5 })
    {
      std::set<std::size_t> found, expected;
      grid.for_each_in_ball(q, radius, [&](std::size_t i, double distance) {
        EXPECT_EQ(distance, (points[i] - q).norm());
        EXPECT_TRUE(found.insert(i).second);
        return true; });
      for(std::size_t i = 0; i < points.size(); ++i)
        if((points[i] - q).norm() <= radius)
          expected.insert(i);
      EXPECT_EQ(found, expected);
    }
  std::size_t visited = 0;
  grid.for_each_in_ball(Vector::Zero(), 100., [&](std::size_t, double) { return ++visited < 5; });
  EXPECT_EQ(visited, 5u);
}

TEST(Neighbor_search, Equals_brute_force_on_scattered_points)
{
  const std::vector<Vector> points = random_points(500, 14, 3.);
  const Neighbor_search search(points);
  for(const Vector& q : random_points(60, 15, 3.5))
  {
    const std::vector<Neighbor_search::Neighbor> expected = sorted_neighbors(points, q);
    std::vector<Neighbor_search::Neighbor> found;
    for(const std::size_t k : { 1u, 2u, 13u, 500u, 700u })
    {
      search.k_nearest(q, k, found);
      ASSERT_EQ(found.size(), (std::min)(k, points.size()));
      for(std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_EQ(found[i].first, expected[i].first);
        EXPECT_NEAR(found[i].second, expected[i].second, 1e-12);
      }
    }
    EXPECT_EQ(search.nearest(q).first, expected[0].first);
    std::vector<std::size_t> ball, in_ball;
    search.in_ball(q, 1.2, ball);
    for(std::size_t i = 0; i < points.size(); ++i)
      if((points[i] - q).norm() <= 1.2)
        in_ball.push_back(i);
    EXPECT_EQ(ball, in_ball);
  }
}

TEST(Neighbor_search, Finds_duplicates_and_points_at_equal_distances)
{
  const std::vector<Vector> points = lattice_with_duplicates(7);
  const Neighbor_search search(points);
  for(const Vector& q : { Vector(3, 3, 3), Vector(0, 0, 0), Vector(2.5, 2.5, 2.5), Vector(1, 2.5, 4) })
  {
    const std::vector<Neighbor_search::Neighbor> expected = sorted_neighbors(points, q);
    std::vector<Neighbor_search::Neighbor> found;
    for(const std::size_t k : { 1u, 2u, 5u, 9u, 20u, 60u })
    {
      search.k_nearest(q, k, found);
      ASSERT_EQ(found.size(), k);
      std::set<std::size_t> indices;
      for(std::size_t i = 0; i < k; ++i)
      {
        EXPECT_EQ(found[i].second, expected[i].second);
        EXPECT_EQ(found[i].second, (points[found[i].first] - q).norm());
        EXPECT_TRUE(indices.insert(found[i].first).second);
        if(i > 0 && found[i - 1].second == found[i].second)
        {
          EXPECT_LT(found[i - 1].first, found[i].first);
        }
      }
      // nearer than the last one all are determined
      for(std::size_t i = 0; i < k && expected[i].second < found.back().second; ++i)
        EXPECT_EQ(found[i].first, expected[i].first);
    }
  }
}

TEST(Neighbor_search, Balls_hold_duplicates_and_their_boundary)
{
  const std::vector<Vector> points = lattice_with_duplicates(7);
  const Neighbor_search search(points);
  for(const double radius : { 0., 1., 2. })
  {
    std::vector<std::size_t> ball, expected;
    search.in_ball(Vector(3, 3, 3), radius, ball);
    for(std::size_t i = 0; i < points.size(); ++i)
      if((points[i] - Vector(3, 3, 3)).norm() <= radius)
        expected.push_back(i);
    EXPECT_EQ(ball, expected) << "radius " << radius;
  }
}

TEST(Neighbor_search, Knows_that_there_is_nothing)
{
  const Neighbor_search search((std::vector<Vector>()));
  EXPECT_EQ(search.nearest(Vector::Zero()).first, 0u);
  std::vector<std::size_t> ball(3, 1);
  search.in_ball(Vector::Zero(), 10., ball);
  EXPECT_TRUE(ball.empty());
}

TEST(Surface_band, Leaves_out_the_far_side_of_a_thin_slab)
{
  const samples::Samples upper = samples::plane(24);
  samples::Samples slab = upper;
  for(const samples::Oriented_point& s : samples::plane(24, 1., 0.15, 2))
    slab.emplace_back(s.first - samples::Vector(0, 0, 0.4), -s.second);
  const Surface_points points = samples::engine_points(slab);
  const Model model(points);
  std::vector<std::size_t> rim;
  for(std::size_t i = 0; i < upper.size(); ++i)
    if(points.position[i].x() < 1)
      rim.push_back(i);
  const double width = 8;
  const std::vector<Band_point> band = surface_band(model, rim, width);
  std::set<std::size_t> inside;
  for(std::size_t k = 0; k < band.size(); ++k)
  {
    EXPECT_LT(band[k].index, upper.size());
    EXPECT_LE(band[k].distance, width);
    if(k > 0)
    {
      EXPECT_LE(band[k - 1].distance, band[k].distance);
    }
    EXPECT_TRUE(inside.insert(band[k].index).second);
  }
  // paths over links are at most a sixth longer than straight ones on a triangular lattice, plus the jitter
  for(std::size_t i = 0; i < upper.size(); ++i)
    if(points.position[i].x() < 0.7 * width)
    {
      EXPECT_EQ(inside.count(i), 1u) << points.position[i].transpose();
    }
}

TEST(Rim_detection, Closed_sphere_has_no_rim)
{
  for(const std::size_t n : { 500u, 3000u, 10000u })
  {
    const Surface_points points = samples::engine_points(samples::sphere(n, 10.));
    const Model model(points);
    EXPECT_TRUE(Rim_detection<CGAL::Sequential_tag>(model).loops().empty()) << n << " points";
  }
}

TEST(Rim_detection, Sheet_with_hole_has_two_loops)
{
  const Surface_points points = samples::engine_points(samples::plane_with_hole());
  const Model model(points);
  const std::vector<Rim_loop> loops = Rim_detection<CGAL::Sequential_tag>(model).loops();
  ASSERT_EQ(loops.size(), 2u);
  const std::size_t inner = loops[0].diameter < loops[1].diameter ? 0 : 1;
  const Rim_loop& hole = loops[inner], &border = loops[1 - inner];
  const Vector center(16, 16, 0);
  EXPECT_LT((hole.center - center).norm(), 1.);
  EXPECT_NEAR(hole.diameter, 9., 1.5);
  EXPECT_GT(hole.opening(points, center), 0.7);
  for(const Rim_point& p : hole.points)
  {
    EXPECT_LT((points.position[p.index] - center).norm(), 4. + 1.5);
    EXPECT_NEAR(p.outward.norm(), 1., 1e-9);
  }
  EXPECT_GT(hole.points.size(), 18u);
  EXPECT_GT(border.diameter, 40.);
  EXPECT_LT(border.opening(points, border.center), -0.5);
}

TEST(Hole_detection, Sheet_with_hole_has_one_hole)
{
  for(const samples::Samples& sheet : { samples::plane_with_hole(), samples::bumpy_plane_with_hole() })
  {
    const Surface_points points = samples::engine_points(sheet);
    const Model model(points);
    const std::vector<Detected> holes = detected(model);
    ASSERT_EQ(number_of_closed(holes), 1u);
    for(const Detected& h : holes)
      if(h.is_outer_border)
      {
        EXPECT_GT(h.loops.front().diameter, 30.);
      }
      else
      {
        ASSERT_TRUE(h.patch != nullptr);
        EXPECT_TRUE(h.patch->is_closed());
        EXPECT_EQ(h.loops.size(), 1u);
        EXPECT_NEAR(h.patch->diameter(), 9., 2.);
        EXPECT_GT(h.patch->number_of_uncovered(), 15u);
      }
  }
}

/// The base of the only hole of a surface, and the stiff one beside it.
struct Two_bases
{
  explicit Two_bases(const samples::Samples& surface) : points(samples::engine_points(surface)), model(points)
  {
    const std::vector<Detected> holes = closed(detected(model));
    EXPECT_EQ(holes.size(), 1u);
    if(holes.size() == 1)
    {
      patch = holes.front().patch;
      stiff = holes.front().stiff;
    }
  }

  Surface_points points;
  Model model;
  decltype(Detected::patch) patch, stiff;
};

TEST(Hole_detection, A_base_that_bulges_has_a_stiff_one_beside_it)
{
  const Two_bases bases(samples::without_ball(samples::steep_graph(80, 60, 0.8, samples::tiles_height),
                                              samples::Point(40, 30, 1.5), 10.));
  ASSERT_TRUE(bases.stiff != nullptr);
  EXPECT_EQ(bases.stiff->surroundings(), bases.patch->surroundings());
  EXPECT_TRUE(is_bulge(*bases.patch, *bases.stiff));
  EXPECT_LT(1.15 * double(bases.stiff->samples().size()), double(bases.patch->samples().size()));
  for(const Base_sample& s : bases.stiff->samples())
    EXPECT_GT(s.normal.z(), 0.7);
}

TEST(Hole_detection, A_base_that_relief_leads_away_has_a_stiff_one_beside_it)
{
  const Two_bases bases(samples::without_ball(samples::steep_graph(84, 72, 1., samples::bricks_height),
                                              samples::Point(38, 30, 1), 11.));
  ASSERT_TRUE(bases.stiff != nullptr);
  EXPECT_FALSE(is_bulge(*bases.patch, *bases.stiff));
  EXPECT_TRUE(lies_elsewhere(*bases.patch, *bases.stiff));
  EXPECT_FALSE(lies_elsewhere(*bases.patch, *bases.patch));
  // the joints are at 0, the bricks at 2
  for(const Base_sample& s : bases.stiff->samples())
    EXPECT_NEAR(s.position.z(), 1., 1.5);
}

TEST(Hole_detection, A_base_that_a_stiff_one_follows_is_alone)
{
  for(const samples::Samples& surface : { samples::plane_with_hole(), samples::bumpy_plane_with_hole(),
        samples::without_ball(samples::sphere(3000, 15.5), samples::Point(0, 0, 15.5), 6.) })
  {
    const Surface_points points = samples::engine_points(surface);
    const Model model(points);
    for(const Detected& h : detected(model))
      EXPECT_TRUE(h.stiff == nullptr);
  }
}

TEST(Hole_detection, Intact_surfaces_have_no_hole)
{
  for(const samples::Samples& surface : { samples::plane(32), samples::bumpy_plane(48, 1., 8., 1.),
                                          samples::sphere(3000, 15.5), samples::bumpy_sphere(5000, 20., 1., 8.) })
  {
    const Surface_points points = samples::engine_points(surface);
    const Model model(points);
    EXPECT_EQ(number_of_closed(detected(model)), 0u);
  }
}

TEST(Hole_detection, Acute_edges_have_no_rim)
{
  // a wedge of 40 degrees: both faces end at a common edge, with normals that differ by 140 degrees
  Surface_points wedge;
  samples::Random_offsets offset(11);
  const double slope = std::tan(20. / 180. * samples::pi);
  for(int side = -1; side <= 1; side += 2)
    for(int i = 0; i < 60; ++i)
      for(int j = 0; j < 60; ++j)
      {
        const double x = i + 0.25 + 0.3 * offset(), y = j + 0.3 * offset();
        wedge.push_back(Vector(x, y, side * slope * x), Vector(-slope, 0, side).normalized());
      }
  const Model model(wedge);
  for(const Rim_loop& loop : Rim_detection<CGAL::Sequential_tag>(model).loops())
    for(const Rim_point& p : loop.points)
      EXPECT_GT(wedge.position[p.index].x() + std::abs(wedge.position[p.index].y() - 29.5), 26.)
        << wedge.position[p.index].transpose();
}

TEST(Hole_detection, A_hole_in_one_side_of_a_thin_plate_is_found)
{
  // thinner than the spacing: the other side is as near as at an acute edge
  for(const double thickness : { 0.5, 0.8, 1.5 })
  {
    samples::Samples plate = samples::plane_with_hole();
    for(const samples::Oriented_point& s : samples::plane(32, 1., 0.15, 2))
      plate.emplace_back(s.first - samples::Vector(0, 0, thickness), -s.second);
    const Surface_points points = samples::engine_points(plate);
    const Model model(points);
    const std::vector<Detected> holes = closed(detected(model));
    ASSERT_EQ(holes.size(), 1u) << "thickness " << thickness;
    EXPECT_LT((holes[0].center() - Vector(16, 16, 0)).norm(), 1.);
    for(const Base_sample& s : holes[0].patch->samples())
      EXPECT_NEAR(s.position.z(), 0., 0.05);
  }
}

TEST(Hole_detection, A_slot_in_which_every_sample_is_near_to_a_rim_is_found)
{
  for(const double jitter : { 0.15, 0.3 })
    for(unsigned int seed = 1; seed <= 4; ++seed)
    {
      // three rows of twelve points
      samples::Samples rest;
      for(const samples::Oriented_point& s : samples::plane(32, 1., jitter, seed))
        if(std::abs(s.first.x() - 16) > 6 || std::abs(s.first.y() - 16) > 1.2)
          rest.push_back(s);
      const Surface_points points = samples::engine_points(rest);
      const Model model(points);
      const std::vector<Detected> holes = closed(detected(model));
      ASSERT_EQ(holes.size(), 1u) << "jitter " << jitter << ", seed " << seed;
      EXPECT_LT((holes[0].center() - Vector(16, 16, 0)).norm(), 1.);
      EXPECT_GE(holes[0].patch->number_of_uncovered(), 4u);
    }
}

TEST(Hole_detection, A_slot_of_two_rows_is_found_if_it_is_too_long_for_chance)
{
  for(unsigned int seed = 1; seed <= 6; ++seed)
    for(const bool is_long : { true, false })
    {
      samples::Samples rest;
      for(const samples::Oriented_point& s : samples::plane(32, 1., 0.1, seed))
        if(std::abs(s.first.x() - 16) > (is_long ? 6 : 1) || std::abs(s.first.y() - 16) > 0.9)
          rest.push_back(s);
      const Surface_points points = samples::engine_points(rest);
      const Model model(points);
      const std::vector<Detected> holes = closed(detected(model));
      ASSERT_EQ(holes.size(), is_long ? 1u : 0u) << "seed " << seed;
      if(is_long)
      {
        EXPECT_LT((holes[0].center() - Vector(16, 16, 0)).norm(), 3.) << "seed " << seed;
      }
    }
}

TEST(Hole_detection, Points_at_random_have_no_hole)
{
  for(unsigned int seed = 1; seed <= 4; ++seed)
  {
    samples::Random_offsets offset(seed);
    samples::Samples plane;
    for(int i = 0; i < 4000; ++i)
    {
      const double x = 32 + 64 * offset(), y = 32 + 64 * offset();
      plane.push_back(samples::Oriented_point(samples::Point(x, y, 0), samples::Vector(0, 0, 1)));
    }
    const Surface_points points = samples::engine_points(plane);
    const Model model(points);
    EXPECT_EQ(closed(detected(model)).size(), 0u) << "seed " << seed;
  }
}

TEST(Hole_detection, A_narrow_slot_around_most_of_a_limb_is_found)
{
  // its rims open to each other, hardly to their centre, which is deep inside
  const double radius = 72. / (2 * samples::pi), middle = 24 * std::sqrt(0.75);
  for(unsigned int seed = 1; seed <= 2; ++seed)
  {
    samples::Samples rest;
    for(const samples::Oriented_point& s : samples::cylinder(72, 48, radius, 0.15, seed))
      if(s.first.x() < radius * std::cos(125. / 180. * samples::pi) || std::abs(s.first.z() - middle) > 1.2)
        rest.push_back(s);
    const Surface_points points = samples::engine_points(rest);
    const Model model(points);
    std::size_t number = 0;
    for(const Detected& h : detected(model))
    {
      if(std::abs(h.center().z() - middle) > 4)
        continue;
      ++number;
      ASSERT_FALSE(h.is_outer_border) << "seed " << seed;
      for(const Base_sample& s : h.patch->samples())
        EXPECT_NEAR(s.position.head<2>().norm(), radius, 0.5);
    }
    EXPECT_EQ(number, 1u) << "seed " << seed;
  }
}

TEST(Hole_detection, Cap_at_the_pole_of_a_sphere_is_one_hole)
{
  const double radius = 15.5;   // spacing about 1
  for(const double cut : { 3., 4., 6., 9. })
  {
    const Surface_points points = samples::engine_points(
      samples::without_ball(samples::sphere(3000, radius), samples::Point(0, 0, radius), cut));
    const Model model(points);
    const std::vector<Detected> holes = detected(model);
    ASSERT_EQ(holes.size(), 1u) << "cut " << cut;
    EXPECT_FALSE(holes[0].is_outer_border) << "cut " << cut;
    ASSERT_TRUE(holes[0].patch != nullptr);
    EXPECT_EQ(holes[0].loops.size(), 1u) << "cut " << cut;
    EXPECT_GE(holes[0].patch->number_of_uncovered(), 4u) << "cut " << cut;
    for(const Base_sample& s : holes[0].patch->samples())
      EXPECT_NEAR(s.position.norm(), radius, 0.2) << "cut " << cut;
  }
}

TEST(Hole_detection, Tube_cut_through_is_one_hole_with_two_rims)
{
  const double radius = 48. / (2 * samples::pi);   // spacing 1
  const samples::Samples tube = samples::cylinder(48, 60, radius);
  const double middle = 30 * std::sqrt(0.75);
  samples::Samples rest;
  for(const samples::Oriented_point& s : tube)
    if(std::abs(s.first.z() - middle) > 4)
      rest.push_back(s);
  const Surface_points points = samples::engine_points(rest);
  const Model model(points);
  std::size_t number_of_cuts = 0;
  for(const Detected& h : detected(model))
  {
    bool is_at_cut = false;
    for(const Rim_loop& loop : h.loops)
      is_at_cut = is_at_cut || std::abs(loop.center.z() - middle) < 8;
    if(!is_at_cut)
      continue;
    ++number_of_cuts;
    EXPECT_FALSE(h.is_outer_border);
    ASSERT_EQ(h.loops.size(), 2u);
    EXPECT_LT((h.loops[0].center.z() - middle) * (h.loops[1].center.z() - middle), 0.);
    ASSERT_TRUE(h.patch != nullptr);
    for(const Base_sample& s : h.patch->samples())
    {
      EXPECT_LT(std::abs(s.position.z() - middle), 5.5);
      EXPECT_NEAR(s.position.head<2>().norm(), radius, 0.5);
    }
  }
  EXPECT_EQ(number_of_cuts, 1u);
}

} // namespace test_smooth_base
