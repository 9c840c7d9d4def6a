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

// The default policy as a whole, against surfaces whose missing part is known.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Hole_match.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace test_default_policy {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef std::function<double(const Vector&)> Distance;   // to the true surface

// A surface with a part cut out.
struct Cut
{
  std::string name;
  samples::Samples rest, removed;
  Distance distance;
  double largest_error;   // mean, in spacings
  bool is_copied;
};

const double k = 2 * samples::pi / 8.;

double egg_box_distance(const Vector& p)
{
  const double height = std::sin(k * p.x()) * std::sin(k * p.y());
  const double dx = k * std::cos(k * p.x()) * std::sin(k * p.y()), dy = k * std::sin(k * p.x()) * std::cos(k * p.y());
  return std::abs(p.z() - height) / std::sqrt(1 + dx * dx + dy * dy);
}

Cut bumpy_sheet()
{
  Cut cut = { "bumpy_sheet", {}, {}, egg_box_distance, 0.1, true };
  cut.rest = samples::without_ball(samples::bumpy_plane(48, 1., 8., 1.), samples::Point(25, 23, 0), 4., &cut.removed);
  return cut;
}

// the relief repeats in the octants
Cut bumpy_sphere()
{
  const double radius = 22., bump = 1., f = 9.;
  Cut cut = { "bumpy_sphere", {}, {}, Distance(), 0.1, true };
  cut.distance = [=](const Vector& p)
  {
    const Vector d = p.normalized();
    const double cx = std::cos(f * d.x()), cy = std::cos(f * d.y()), cz = std::cos(f * d.z());
    const Vector change = -bump * f * Vector(std::sin(f * d.x()) * cy * cz, cx * std::sin(f * d.y()) * cz,
                                             cx * cy * std::sin(f * d.z()));
    const double r = p.norm();
    return std::abs(r - radius - bump * cx * cy * cz) / (d - (change - change.dot(d) * d) / r).norm();
  };
  const samples::Vector middle = samples::unit(samples::Vector(1., 0.8, 0.6));
  cut.rest = samples::without_ball(samples::bumpy_sphere(7000, radius, bump, f), CGAL::ORIGIN + radius * middle, 4.,
                                   &cut.removed);
  return cut;
}

Cut plane()
{
  Cut cut = { "plane", {}, {}, [](const Vector& p) { return std::abs(p.z()); }, 0.02, false };
  cut.rest = samples::without_ball(samples::plane(32), samples::Point(16, 16, 0), 4., &cut.removed);
  return cut;
}

Cut smooth_sphere()
{
  const double radius = 15.5;
  Cut cut = { "smooth_sphere", {}, {}, [=](const Vector& p) { return std::abs(p.norm() - radius); }, 0.1, false };
  cut.rest = samples::without_ball(samples::sphere(3000, radius), samples::Point(radius, 0, 0), 4., &cut.removed);
  return cut;
}

struct Completion
{
  double spacing = 0;
  std::vector<Hole_data> holes;
  std::vector<std::size_t> chosen;
  std::vector<Added_point> added;
  std::vector<Hole_outcome> outcomes;
};

template <typename ConcurrencyTag>
Completion run(const samples::Samples& surface, const Engine_parameters& parameters = Engine_parameters())
{
  const Surface_points points = samples::engine_points(surface);
  Completion_engine<ConcurrencyTag> engine(points, parameters);
  Completion result;
  EXPECT_TRUE(engine.detect(typename Completion_engine<ConcurrencyTag>::Callback()));
  for(std::size_t h = 0; h < engine.holes().size(); ++h)
    if(engine.holes()[h].state == Hole_state::hole)
      result.chosen.push_back(h);
  EXPECT_TRUE(engine.complete(result.chosen, typename Completion_engine<ConcurrencyTag>::Callback()));
  result.spacing = engine.spacing();
  result.holes = engine.holes();
  result.added = engine.added();
  result.outcomes = engine.outcomes();
  return result;
}

Completion sequential(const samples::Samples& surface, const Engine_parameters& parameters = Engine_parameters())
{
  return run<CGAL::Sequential_tag>(surface, parameters);
}

double mean_error(const Completion& result, const Distance& distance)
{
  double sum = 0;
  for(const Added_point& p : result.added)
    sum += distance(p.position);
  return sum / double(result.added.size());
}

void expect_same(const Completion& a, const Completion& b)
{
  ASSERT_EQ(a.added.size(), b.added.size());
  for(std::size_t i = 0; i < a.added.size(); ++i)
  {
    EXPECT_TRUE(a.added[i].position == b.added[i].position);
    EXPECT_TRUE(a.added[i].normal == b.added[i].normal);
    EXPECT_EQ(a.added[i].source, b.added[i].source);
    EXPECT_EQ(a.added[i].hole, b.added[i].hole);
    EXPECT_EQ(a.added[i].confidence, b.added[i].confidence);
  }
  ASSERT_EQ(a.outcomes.size(), b.outcomes.size());
  for(std::size_t i = 0; i < a.outcomes.size(); ++i)
  {
    EXPECT_EQ(a.outcomes[i].filling, b.outcomes[i].filling);
    EXPECT_EQ(a.outcomes[i].expected_error, b.outcomes[i].expected_error);
    EXPECT_EQ(a.outcomes[i].reason, b.outcomes[i].reason);
  }
}

std::vector<Hole_data> detected(const samples::Samples& surface, const Engine_parameters& parameters)
{
  const Surface_points points = samples::engine_points(surface);
  Completion_engine<CGAL::Sequential_tag> engine(points, parameters);
  EXPECT_TRUE(engine.detect(Completion_engine<CGAL::Sequential_tag>::Callback()));
  return engine.holes();
}

std::size_t number_of_holes(const std::vector<Hole_data>& detected)
{
  return std::size_t(std::count_if(detected.begin(), detected.end(),
                                   [](const Hole_data& h) { return h.state == Hole_state::hole; }));
}

// The hole that is no outer border next to `center`.
Hole_state state_at(const std::vector<Hole_data>& holes, const Vector& center)
{
  for(const Hole_data& h : holes)
    if(h.state != Hole_state::outer_border && (h.center - center).norm() < 2)
      return h.state;
  ADD_FAILURE() << "no hole at " << center.transpose();
  return Hole_state::outer_border;
}

class Known_surface : public ::testing::TestWithParam<Cut> {};

} // namespace

TEST_P(Known_surface, Is_restored)
{
  const Cut& cut = GetParam();
  const Completion result = sequential(cut.rest);
  ASSERT_EQ(result.chosen.size(), 1u);
  ASSERT_FALSE(result.added.empty());
  const Hole_outcome& outcome = result.outcomes[result.chosen.front()];
  const double error = mean_error(result, cut.distance);
  RecordProperty("mean_error_in_spacings", std::to_string(error / result.spacing));
  EXPECT_LT(error, cut.largest_error * result.spacing) << outcome.reason;
  if(cut.is_copied)
  {
    EXPECT_EQ(outcome.filling, Filling::copied) << outcome.reason;
  }
  EXPECT_EQ(outcome.added, result.added.size());
  EXPECT_NEAR(double(result.added.size()), double(cut.removed.size()), 0.35 * double(cut.removed.size()));

  std::vector<Vector> added;
  for(const Added_point& p : result.added)
  {
    EXPECT_TRUE(p.position.allFinite());
    EXPECT_NEAR(p.normal.norm(), 1., 1e-6);
    EXPECT_GE(p.confidence, 0.);
    EXPECT_LE(p.confidence, 1.);
    EXPECT_EQ(p.hole, result.chosen.front());
    added.push_back(p.position);
  }
  for(const samples::Oriented_point& s : cut.removed)
    EXPECT_LT(samples::nearest_distance(samples::engine_vector(s.first), added), 2 * result.spacing);

  // a promise that is far too good would mislead
  EXPECT_GE(outcome.expected_error, 0.5 * error) << outcome.reason;
}

TEST_P(Known_surface, Normals_of_the_new_points_follow_the_surface)
{
  const Cut& cut = GetParam();
  const Completion result = sequential(cut.rest);
  ASSERT_FALSE(result.added.empty());
  double sum = 0;
  for(const Added_point& p : result.added)
  {
    std::size_t nearest = 0;
    for(std::size_t i = 0; i < cut.removed.size(); ++i)
      if((samples::engine_vector(cut.removed[i].first) - p.position).norm() <
         (samples::engine_vector(cut.removed[nearest].first) - p.position).norm())
        nearest = i;
    sum += p.normal.dot(samples::engine_vector(cut.removed[nearest].second));
  }
  EXPECT_GT(sum / double(result.added.size()), 0.9);
}

TEST_P(Known_surface, Two_runs_give_the_same_bits)
{
  const Completion a = sequential(GetParam().rest), b = sequential(GetParam().rest);
  expect_same(a, b);
#ifdef CGAL_LINKED_WITH_TBB
  expect_same(a, run<CGAL::Parallel_tag>(GetParam().rest));
#endif
}

INSTANTIATE_TEST_SUITE_P(Cuts, Known_surface,
                         ::testing::Values(bumpy_sheet(), bumpy_sphere(), plane(), smooth_sphere()),
                         [](const ::testing::TestParamInfo<Cut>& info) { return info.param.name; });

// Blocks in rows, whose walls places at slightly different offsets would smear.
double blocks_height(double x, double y)
{
  const auto step = [](double t) { return 0.5 + 0.5 * std::tanh(8 * (std::cos(2 * samples::pi * t / 9) + 0.2)); };
  return 3 * step(x) * step(y);
}

Vector blocks_normal(double x, double y)
{
  const double d = 1e-4;
  return Vector(blocks_height(x - d, y) - blocks_height(x + d, y), blocks_height(x, y - d) - blocks_height(x, y + d),
                2 * d).normalized();
}

TEST(Default_policy, Walls_of_a_whole_copy_stay_steep)
{
  samples::Samples surface;
  samples::Random_offsets offset(4);
  Point_grid grid(1.);
  for(double x = 0; x < 54; x += 0.21)
    for(double y = 0; y < 54; y += 0.21)
    {
      const double u = x + 0.1 * offset(), v = y + 0.1 * offset();
      const Vector p(u, v, blocks_height(u, v)), n = blocks_normal(u, v);
      bool is_free = true;
      grid.for_each_in_ball(p, 0.82, [&](std::size_t, double) { return is_free = false; });
      if(!is_free)
        continue;
      grid.insert(p);
      surface.emplace_back(samples::Point(p.x(), p.y(), p.z()), samples::Vector(n.x(), n.y(), n.z()));
    }
  const Completion result = sequential(samples::without_ball(surface, samples::Point(29, 25, 1.5), 7.));
  ASSERT_EQ(result.chosen.size(), 1u);
  ASSERT_GT(result.added.size(), 100u);
  double sum = 0;
  for(const Added_point& p : result.added)
  {
    double nearest = 1e9;
    for(double du = -1; du <= 1; du += 0.05)
      for(double dv = -1; dv <= 1; dv += 0.05)
      {
        const double u = p.position.x() + du, v = p.position.y() + dv;
        nearest = (std::min)(nearest, (Vector(u, v, blocks_height(u, v)) - p.position).norm());
      }
    sum += nearest;
  }
  EXPECT_LT(sum / double(result.added.size()), 0.027) << result.outcomes[result.chosen.front()].reason;
}

// An egg box whose right half is sampled differently, and alone may serve as an example, and with a hole in the left one.
class Other_density : public testing::TestWithParam<double>
{
};

TEST_P(Other_density, Copies_are_as_dense_as_the_surroundings_of_the_hole)
{
  samples::Samples surface, removed;
  for(const samples::Oriented_point& s :
      samples::thinning_plane(64, [](double x, double) { return x < 32 ? 0.9 : GetParam(); }))
  {
    const double x = s.first.x(), y = s.first.y();
    surface.emplace_back(samples::Point(x, y, std::sin(k * x) * std::sin(k * y)),
      samples::unit(samples::Vector(-k * std::cos(k * x) * std::sin(k * y), -k * std::sin(k * x) * std::cos(k * y), 1)));
  }
  const samples::Samples rest = samples::without_ball(surface, samples::Point(17, 33, 0), 5., &removed);
  Engine_parameters parameters;
  for(const samples::Oriented_point& s : rest)
    parameters.is_example.push_back(s.first.x() > 32);
  const Completion result = sequential(rest, parameters);
  ASSERT_EQ(result.chosen.size(), 1u);
  EXPECT_EQ(result.outcomes[result.chosen.front()].filling, Filling::copied);
  EXPECT_LT(mean_error(result, egg_box_distance), 0.1);
  EXPECT_NEAR(double(result.added.size()), double(removed.size()), (GetParam() < 0.9 ? 0.2 : 0.25) * double(removed.size()));
}

INSTANTIATE_TEST_SUITE_P(Examples, Other_density, testing::Values(0.63, 1.3),
                         [](const testing::TestParamInfo<double>& info)
                         { return info.param < 0.9 ? std::string("twice_as_dense") : std::string("half_as_dense"); });

// Three faces that meet in a corner, of which there is no other: nothing foresees the edges in the hole, and there is
// nothing to learn from how wrong that is. The report must say so.
TEST(Default_policy, A_hole_that_is_like_no_other_place_is_not_promised_much)
{
  samples::Samples corner;
  const double width = 24;
  samples::Random_offsets offset(2);
  const samples::Vector axes[] = { samples::Vector(1, 0, 0), samples::Vector(0, 1, 0), samples::Vector(0, 0, 1) };
  for(int face = 0; face < 3; ++face)
    for(double u = 0.5; u < width; u += 1)
      for(double v = 0.5; v < width; v += 1)
        corner.emplace_back(CGAL::ORIGIN - (u + 0.15 * offset()) * axes[(face + 1) % 3]
                            - (v + 0.15 * offset()) * axes[(face + 2) % 3], axes[face]);
  const Distance distance = [](const Vector& p) { return p.cwiseAbs().minCoeff(); };
  for(double radius : { 6., 10. })
  {
    const Completion result = sequential(samples::without_ball(corner, samples::Point(-1, -1, 0), radius));
    ASSERT_EQ(result.chosen.size(), 1u);
    ASSERT_FALSE(result.added.empty());
    const Hole_outcome& outcome = result.outcomes[result.chosen.front()];
    EXPECT_NE(outcome.reason.find("too few places resemble the hole"), std::string::npos) << outcome.reason;
    EXPECT_GE(outcome.expected_error, 2 * mean_error(result, distance));
    EXPECT_GE(outcome.expected_error, result.spacing);
  }
}

TEST(Default_policy, Diameters_set_the_state)
{
  const samples::Samples sheet = samples::plane_with_two_holes();   // diameters about 9 and 12
  const Vector small(14, 14, 0), large(29, 30, 0);
  Engine_parameters parameters;
  EXPECT_EQ(state_at(detected(sheet, parameters), small), Hole_state::hole);
  EXPECT_EQ(state_at(detected(sheet, parameters), large), Hole_state::hole);
  parameters.minimum_hole_diameter = 10.5;
  EXPECT_EQ(state_at(detected(sheet, parameters), small), Hole_state::too_small);
  EXPECT_EQ(state_at(detected(sheet, parameters), large), Hole_state::hole);
  parameters.minimum_hole_diameter = 0;
  parameters.maximum_hole_diameter = 10.5;
  EXPECT_EQ(state_at(detected(sheet, parameters), small), Hole_state::hole);
  EXPECT_EQ(state_at(detected(sheet, parameters), large), Hole_state::too_large);
}

TEST(Default_policy, A_sampling_that_thins_out_is_no_hole)
{
  for(const double slope : { 0.2, 0.4 })
    for(const unsigned int seed : { 1u, 2u })
    {
      // towards the middle the distance of points grows from 1 to 5 or 7
      const samples::Samples sheet = samples::thinning_plane(60., [=](double x, double y) {
        return (std::min)(7., 1 + (std::max)(0., slope * (21 - std::hypot(x - 30, y - 30)))); }, seed);
      EXPECT_EQ(number_of_holes(detected(sheet, Engine_parameters())), 0u) << slope << ", " << seed;
      if(slope > 0.3)
        continue;
      // what is cut out of the sparse part is one
      for(const double radius : { 12., 14., 16. })
      {
        const samples::Samples cut = samples::without_ball(sheet, samples::Point(30, 30, 0), radius);
        EXPECT_EQ(number_of_holes(detected(cut, Engine_parameters())), 1u) << radius << ", " << seed;
      }
    }
}

TEST(Default_policy, Stray_points_do_not_hide_a_hole)
{
  samples::Samples sheet = samples::without_ball(samples::plane(48), samples::Point(24, 24, 0), 9.);
  for(int i = 0; i < 5; ++i)
    sheet.emplace_back(samples::Point(24 + 4 * std::cos(1.3 * i), 24 + 4 * std::sin(1.3 * i), 0),
                       samples::Vector(0, 0, 1));
  EXPECT_EQ(number_of_holes(detected(sheet, Engine_parameters())), 1u);
}

TEST(Default_policy, Regions_set_the_state)
{
  const samples::Samples sheet = samples::plane_with_two_holes();
  const Vector small(14, 14, 0), large(29, 30, 0);
  const CGAL::Bbox_3 around_small(10, 10, -1, 18, 18, 1);
  Engine_parameters parameters;
  parameters.regions.push_back(around_small);
  EXPECT_EQ(state_at(detected(sheet, parameters), small), Hole_state::hole);
  EXPECT_EQ(state_at(detected(sheet, parameters), large), Hole_state::excluded);
  parameters.regions.clear();
  parameters.excluded_regions.push_back(around_small);
  EXPECT_EQ(state_at(detected(sheet, parameters), small), Hole_state::excluded);
  EXPECT_EQ(state_at(detected(sheet, parameters), large), Hole_state::hole);
}

TEST(Default_policy, Copies_nothing_that_the_mask_bars)
{
  const Cut cut = bumpy_sheet();
  Engine_parameters parameters;
  for(const samples::Oriented_point& s : cut.rest)
    parameters.is_example.push_back(s.first.x() < 24);
  const Completion result = sequential(cut.rest, parameters);
  ASSERT_FALSE(result.added.empty());
  std::size_t with_source = 0;
  for(const Added_point& p : result.added)
    if(p.source != no_index)
    {
      ++with_source;
      ASSERT_LT(p.source, cut.rest.size());
      EXPECT_EQ(p.source_set, 0u);
      EXPECT_TRUE(parameters.is_example[p.source] != 0);
    }
  EXPECT_GT(with_source, 0u);
}

TEST(Default_policy, Copies_from_a_further_example)
{
  const Cut cut = bumpy_sheet();
  Engine_parameters parameters;
  parameters.is_example.assign(cut.rest.size(), 0);
  parameters.examples.push_back(samples::engine_points(samples::bumpy_plane(40, 1., 8., 1., 0.15, 7)));
  const Completion result = sequential(cut.rest, parameters);
  ASSERT_FALSE(result.added.empty());
  EXPECT_LT(mean_error(result, cut.distance), 0.1 * result.spacing);
  std::size_t with_source = 0;
  for(const Added_point& p : result.added)
    if(p.source != no_index)
    {
      ++with_source;
      EXPECT_EQ(p.source_set, 1u);
      EXPECT_LT(p.source, parameters.examples.front().size());
    }
  EXPECT_GT(with_source, 0u);
}

TEST(Default_policy, Noise_of_the_fits_at_the_rim_does_not_bend_an_exact_counterpart)
{
  const samples::Samples sheet = samples::bumpy_plane(64, 1., 8., 1.);
  Engine_parameters rigid;
  rigid.ingredients.warp = false;
  const samples::Samples rest = samples::without_ball(sheet, samples::Point(33, 30, 0), 9.);
  const double warped = mean_error(sequential(rest), egg_box_distance),
               unwarped = mean_error(sequential(rest, rigid), egg_box_distance);
  EXPECT_LT(warped, 1.2 * unwarped);
}

TEST(Default_policy, Without_copies_a_hole_gets_its_smooth_base)
{
  const Cut cut = bumpy_sheet();
  Engine_parameters parameters;
  parameters.ingredients.copies = false;
  const Completion smooth = sequential(cut.rest, parameters), copied = sequential(cut.rest);
  ASSERT_EQ(smooth.chosen.size(), 1u);
  EXPECT_EQ(smooth.outcomes[smooth.chosen.front()].filling, Filling::smooth);
  ASSERT_FALSE(smooth.added.empty());
  for(const Added_point& p : smooth.added)
    EXPECT_EQ(p.source, no_index);
  EXPECT_GT(mean_error(smooth, cut.distance), 2 * mean_error(copied, cut.distance));
}

TEST(Default_policy, Normals_that_lean_at_the_rim_of_the_hole_alone_are_doubted)
{
  // rough enough that right normals help; in the second run they are bent at the rim, as an estimation there may do
  const double radius = 22., lean = 0.25;
  samples::Random_offsets offset(3);
  const samples::Vector pole(0, 0, 1);
  samples::Samples right = samples::without_ball(samples::sphere(6000, radius), CGAL::ORIGIN + radius * pole, 5.);
  for(samples::Oriented_point& s : right)
    s.first = s.first + 0.1 * offset() * s.second;
  samples::Samples leaning = right;
  for(samples::Oriented_point& s : leaning)
    if((s.first - CGAL::ORIGIN - radius * pole).squared_length() < 8. * 8.)
      s.second = samples::unit(s.second + lean * samples::unit(pole - (pole * s.second) * s.second));
  Engine_parameters parameters;
  parameters.ingredients.copies = parameters.keep_texture = false;
  const Distance distance = [=](const Vector& p) { return std::abs(p.norm() - radius); };
  const Completion with_right = sequential(right, parameters), with_leaning = sequential(leaning, parameters);
  ASSERT_EQ(with_right.chosen.size(), 1u);
  ASSERT_EQ(with_leaning.chosen.size(), 1u);
  EXPECT_LT(mean_error(with_right, distance), 0.04);
  EXPECT_LT(mean_error(with_leaning, distance), 0.04);
}

TEST(Default_policy, A_lonely_feature_is_filled_from_its_only_twin)
{
  // two craters with a peak in a gently waved sheet; the hole takes the peak of one, and its rim shows the crater only
  const auto height = [](double x, double y)
  {
    double z = 0.4 * std::sin(0.11 * x + 0.3) * std::cos(0.07 * y);
    for(double middle : { 22., 68. })
    {
      const double r2 = (x - middle) * (x - middle) + (y - 25) * (y - 25);
      z += 3 * std::exp(-r2 / 18) - 2 * std::exp(-r2 / 128);
    }
    return z;
  };
  samples::Samples sheet;
  samples::Random_offsets offset(5);
  const double step = 1e-4;
  for(int i = 0; i < 90; ++i)
    for(int j = 0; j < 50; ++j)
    {
      const double x = i + 0.15 * offset(), y = j + 0.15 * offset(), z = height(x, y);
      const samples::Vector normal(-(height(x + step, y) - z) / step, -(height(x, y + step) - z) / step, 1);
      sheet.push_back(samples::Oriented_point(samples::Point(x, y, z), samples::unit(normal)));
    }
  const Completion result = sequential(samples::without_ball(sheet, samples::Point(22, 25, 1), 7.));
  ASSERT_FALSE(result.added.empty());
  ASSERT_EQ(result.chosen.size(), 1u);
  EXPECT_EQ(result.outcomes[result.chosen.front()].filling, Filling::copied);
  double error = 0;
  for(const Added_point& p : result.added)
    error += std::abs(p.position.z() - height(p.position.x(), p.position.y()));
  // a smooth fill is off by 0.8 in the mean
  EXPECT_LT(error / double(result.added.size()), 0.15);
}

// The only hole is filled with a copy, as near to what was removed as two samplings of the same surface are.
void expect_copy(const Completion& result, const samples::Samples& removed)
{
  ASSERT_EQ(result.chosen.size(), 1u);
  EXPECT_EQ(result.outcomes[result.chosen.front()].filling, Filling::copied);
  std::vector<Vector> truth, added;
  for(const samples::Oriented_point& p : removed)
    truth.push_back(samples::engine_vector(p.first));
  for(const Added_point& p : result.added)
    added.push_back(p.position);
  ASSERT_FALSE(added.empty());
  double sum = 0;
  for(const Vector& p : truth)
    sum += samples::nearest_distance(p, added);
  EXPECT_LT(sum / double(truth.size()), 0.6 * result.spacing);
  sum = 0;
  for(const Vector& p : added)
    sum += samples::nearest_distance(p, truth);
  EXPECT_LT(sum / double(added.size()), 0.6 * result.spacing);
}

// The flanks of the ridges look away from each other: an interpolating base over a hole across them runs off.
samples::Samples steep_ridges()
{
  const double amplitude = 4, k = 2 * samples::pi / 11;
  samples::Random_offsets offset(3);
  samples::Samples ridges;
  double x = 0, length = 0;
  for(int i = 0; i < 200; ++i)
  {
    // the next column is one spacing farther along the profile
    for(; length < i; x += 1e-3)
      length += 1e-3 * std::hypot(1., amplitude * k * std::cos(k * x));
    for(int j = 0; j < 44; ++j)
    {
      const double u = x + 0.05 * offset(), y = j + (i % 2 == 0 ? 0. : 0.5) + 0.15 * offset();
      ridges.push_back(samples::Oriented_point(samples::Point(u, y, amplitude * std::sin(k * u)),
        samples::unit(samples::Vector(-amplitude * k * std::cos(k * u), 0, 1))));
    }
  }
  return ridges;
}

TEST(Default_policy, A_hole_across_steep_ridges_is_found_and_filled_from_their_repeats)
{
  const samples::Samples ridges = steep_ridges();
  samples::Samples removed;
  const samples::Point center(45, 22, 0);
  const Completion result = sequential(samples::without_ball(ridges, center, 9., &removed));
  expect_copy(result, removed);
}

TEST(Default_policy, Tiles_whose_relief_leads_the_base_astray_are_filled_from_other_tiles)
{
  const samples::Samples tiles = samples::steep_graph(80, 60, 0.8, samples::tiles_height);
  samples::Samples removed;
  const Completion result = sequential(samples::without_ball(tiles, samples::Point(40, 30, 1.5), 10., &removed));
  expect_copy(result, removed);
}

TEST(Default_policy, Fragments_of_the_rim_beside_steep_tiles_do_not_keep_them_from_being_copied)
{
  // a seventh of the rim is cut off by the steps, and a stiff base does not reach it
  const samples::Samples tiles = samples::steep_graph(80, 60, 0.9, [](double x, double y)
    { return 1.3 * samples::tiles_height(x, y); });
  samples::Samples removed;
  const Completion result = sequential(samples::without_ball(tiles, samples::Point(37.5, 31, 1.5), 9., &removed));
  expect_copy(result, removed);
}

TEST(Default_policy, Bricks_over_which_the_base_rises_are_filled_from_other_bricks)
{
  const samples::Samples bricks = samples::steep_graph(84, 72, 1., samples::bricks_height);
  samples::Samples removed;
  const Completion result = sequential(samples::without_ball(bricks, samples::Point(38, 30, 1), 11., &removed));
  expect_copy(result, removed);
  // seen from the first base, which is no larger than a stiff one but higher, the best place lies ten times as badly
  EXPECT_LT(result.outcomes[result.chosen.front()].match, 0.03);
}

// A match whose chosen plan is smooth (no places), or a copy with some share.
Hole_match<CGAL::Sequential_tag> match_of(double error, std::size_t places, double share, bool has_fake_holes,
                                          bool continues_edges = false)
{
  Hole_match<CGAL::Sequential_tag> match;
  match.chosen.error = error;
  match.chosen.plan.places = places;
  match.chosen.plan.share = share;
  match.has_fake_holes = has_fake_holes;
  match.continues_edges = continues_edges;
  return match;
}

TEST(Hole_match, A_base_that_bulges_and_resembles_nothing_gives_way_to_a_stiff_one_that_does)
{
  const auto smooth = match_of(0.3, 0, 0, false), stiff = match_of(0.6, 0, 0, true);
  EXPECT_TRUE(is_better_over_stiff_base(stiff, smooth, true));
  EXPECT_FALSE(is_better_over_stiff_base(stiff, smooth, false)) << "it does not bulge";
  EXPECT_FALSE(is_better_over_stiff_base(stiff, match_of(0.7, 0, 0, true), true)) << "it resembles something";
  EXPECT_FALSE(is_better_over_stiff_base(stiff, match_of(0.3, 0, 0, false, true), true)) << "it has facets";
  EXPECT_FALSE(is_better_over_stiff_base(match_of(0.1, 0, 0, false), smooth, true)) << "neither resembles anything";
}

TEST(Hole_match, A_copy_over_a_stiff_base_promises_clearly_less_unless_the_other_base_bulges)
{
  const auto copy = match_of(0.3, 4, 1, true);
  for(const auto& other : { match_of(0.5, 0, 0, true), match_of(0.5, 2, 0.85, true) })
  {
    EXPECT_FALSE(is_better_over_stiff_base(copy, other, false));
    EXPECT_TRUE(is_better_over_stiff_base(copy, other, true));
  }
  EXPECT_TRUE(is_better_over_stiff_base(copy, match_of(0.61, 0, 0, true), false));
  EXPECT_TRUE(is_better_over_stiff_base(copy, match_of(0.2, 0, 0, false), false)) << "of the other nothing is known";
  EXPECT_FALSE(is_better_over_stiff_base(match_of(0.3, 4, 0.8, true), match_of(0.9, 0, 0, true), false))
    << "a copy that is not believed";
}

TEST(Hole_match, Facets_over_a_stiff_base_need_a_bulge_and_the_better_forecast)
{
  const auto facets = match_of(0.3, 0, 0, true, true);
  EXPECT_TRUE(is_better_over_stiff_base(facets, match_of(0.4, 0, 0, true), true));
  EXPECT_FALSE(is_better_over_stiff_base(facets, match_of(0.2, 0, 0, true), true));
  EXPECT_FALSE(is_better_over_stiff_base(facets, match_of(0.4, 0, 0, false), true));
  EXPECT_FALSE(is_better_over_stiff_base(facets, match_of(0.9, 0, 0, true), false));
}

// The plan of the least error over a hole in a plane, for eight places whose rim is that plane, as far as can be told. So
// many of them have a hill in the middle. They match the hole a little better than the others, and each kind matches
// itself best. \return the height in the middle
double planned_height_on_plane(std::size_t with_hill)
{
  typedef CGAL::Sequential_tag Tag;
  const Surface_points points = samples::engine_points(samples::plane_with_hole());
  const Surface_model<Tag> model(points);
  std::vector<Detected_hole<Tag> > holes;
  EXPECT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
  std::shared_ptr<const Smooth_patch<Tag> > patch;
  Vector middle = Vector::Zero();
  for(const Detected_hole<Tag>& h : holes)
    if(!h.is_outer_border)
    {
      patch = h.patch;
      middle = h.center();
    }
  if(!patch)
    return 1e300;
  const double radius = patch->diameter() / 2;
  const Eigen::Index samples = Eigen::Index(patch->samples().size()), centers = Eigen::Index(patch->centers().size());
  std::vector<Place> places(8);
  std::vector<Place_relief> reliefs(8);
  for(std::size_t i = 0; i < places.size(); ++i)
  {
    places[i].origin = Vector(3 * radius * double(i), 0, 0);
    const bool is_hilly = i < with_hill;
    reliefs[i].rim = Eigen::VectorXd::Constant(4 * centers, (is_hilly ? 0. : 0.01) + 1e-4 * double(i));
    reliefs[i].rim_by_normals = reliefs[i].rim;
    reliefs[i].is_found.assign(std::size_t(centers), 1);
    reliefs[i].height = Eigen::VectorXd::Zero(samples);
    reliefs[i].is_covered.assign(std::size_t(samples), 1);
    reliefs[i].coverage = 1;
    for(Eigen::Index s = 0; is_hilly && s < samples; ++s)
      if((patch->samples()[std::size_t(s)].position - middle).norm() < 0.6 * radius)
        reliefs[i].height[s] = 2;
  }
  const Copy_forecast<Tag> forecast(*patch, Base_family<Tag>(*patch), places, reliefs, radius, Ingredients());
  Plan_forecast best;
  for(const Plan_forecast& f : forecast.forecasts())
    if(f.plan.places == 0 || f.error < best.error)
      best = f;
  return forecast.heights(best.plan).cwiseAbs().maxCoeff();
}

TEST(Copy_forecast, A_hill_that_all_places_of_the_same_rim_have_is_copied)
{
  EXPECT_NEAR(planned_height_on_plane(8), 2., 0.1);
}

TEST(Copy_forecast, A_hill_that_a_few_places_of_the_same_rim_have_is_not_copied)
{
  EXPECT_LT(planned_height_on_plane(2), 0.6);
}

TEST(Copy_forecast, A_copy_must_promise_the_more_the_less_it_is_believed)
{
  Plan_forecast copy;
  copy.plan = Filling_plan(1, 1);
  double last = copy.margin();
  EXPECT_LT(last, 1);
  EXPECT_GT(last, 0.9);
  copy.plan.share = 0.91;   // is carried as a whole, too
  EXPECT_EQ(copy.margin(), last);
  for(double share : { 0.88, 0.85, 0.82 })
  {
    copy.plan.share = share;
    EXPECT_LT(copy.margin(), last);
    last = copy.margin();
  }
  for(double share : { 0.8, 0.4, 0.2 })
  {
    copy.plan.share = share;
    EXPECT_EQ(copy.margin(), 0.75);
  }
}

TEST(Copy_forecast, A_place_without_a_wall_of_the_rim_does_not_match)
{
  typedef CGAL::Sequential_tag Tag;
  // a block with a hole at one of its edges: the rim is on top and on the wall
  const double length = 60, width = 24, height = 16;
  samples::Random_offsets offset(9);
  samples::Samples block;
  const auto add = [&](double x, double y, double z, const samples::Vector& normal)
  {
    if(std::hypot(std::hypot(x - length / 2, y - 1), z - height) > 6)
      block.push_back(samples::Oriented_point(samples::Point(x, y, z), normal));
  };
  for(int i = 0; i < length; ++i)
  {
    for(int j = 0; j < width; ++j)
    {
      const double x = i + 0.5 + 0.15 * offset(), y = j + 0.5 + 0.15 * offset();
      add(x, y, height, samples::Vector(0, 0, 1));
    }
    for(int k = 0; k < height; ++k)
    {
      const double x = i + 0.5 + 0.15 * offset(), z = k + 0.5 + 0.15 * offset();
      add(x, 0, z, samples::Vector(0, -1, 0));
    }
  }
  std::vector<Example_source<Tag> > sources(1);
  sources[0].points = std::make_shared<Surface_points>(samples::engine_points(block));
  sources[0].model = std::make_shared<Surface_model<Tag> >(*sources[0].points);
  const Surface_model<Tag>& model = *sources[0].model;
  std::vector<Detected_hole<Tag> > holes;
  ASSERT_TRUE(Hole_detection<Tag>(model).run(holes, std::function<bool(double)>()));
  std::shared_ptr<const Smooth_patch<Tag> > patch;
  for(const Detected_hole<Tag>& h : holes)
    if(!h.is_outer_border)
      patch = h.patch;
  ASSERT_TRUE(patch != nullptr);

  std::vector<Place> places(2);
  places[0].motion.translation = Vector(14, 0, 0);      // farther along the edge
  places[1].motion.translation = Vector(14, -12, 0);    // the middle of the top: flat, without the wall
  const Relief_sampler<Tag> sampler(*patch, sources);
  std::vector<Place_relief> reliefs;
  for(Place& p : places)
  {
    p.origin = p.motion.inverse(Vector(length / 2, 1, height));
    reliefs.push_back(sampler.relief(p));
  }
  EXPECT_EQ(std::count(reliefs[0].is_found.begin(), reliefs[0].is_found.end(), 0), 0);
  EXPECT_GT(std::count(reliefs[1].is_found.begin(), reliefs[1].is_found.end(), 0), 10);
  const Copy_forecast<Tag> forecast(*patch, Base_family<Tag>(*patch), places, reliefs, 6., Ingredients());
  EXPECT_LT(forecast.match(0), 0.02);
  EXPECT_GT(forecast.match(1), 0.3);
  EXPECT_EQ(forecast.ranking().front(), 0u);
}

TEST(Default_policy, What_lies_behind_the_surface_is_not_copied_with_it)
{
  // ribs under a bumpy plate, but none under the hole
  const samples::Point center(25, 23, 0);
  samples::Samples plate = samples::without_ball(samples::bumpy_plane(48, 1., 8., 1.), center, 6.);
  samples::Random_offsets offset(7);
  for(int i = 1; i < 47; i += 4)
    for(int y = 1; y < 41; ++y)
      for(int z = -8; z <= -4; ++z)
        if(std::hypot(i - center.x(), y - center.y()) > 11)
          for(const double side : { -1., 1. })
            plate.push_back(samples::Oriented_point(
              samples::Point(i + 0.6 * side, y + 0.15 * offset(), z + 0.15 * offset()), samples::Vector(side, 0, 0)));
  const Completion result = sequential(plate);
  std::size_t in_the_plate = 0;
  for(const Added_point& p : result.added)
    if((p.position - samples::engine_vector(center)).norm() < 9)
    {
      ++in_the_plate;
      EXPECT_GT(p.position.z(), -2.);
    }
  EXPECT_GT(in_the_plate, 50u);
}

TEST(Default_policy, A_callback_stops_it)
{
  const Cut cut = plane();
  const Surface_points points = samples::engine_points(cut.rest);
  Completion_engine<CGAL::Sequential_tag> engine(points, Engine_parameters());
  EXPECT_FALSE(engine.detect([](double) { return false; }));
  EXPECT_TRUE(engine.holes().empty());
  EXPECT_TRUE(engine.detect([](double) { return true; }));
  EXPECT_FALSE(engine.holes().empty());
}

} // namespace test_default_policy
