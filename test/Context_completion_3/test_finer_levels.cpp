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

// The finer levels of the default policy: pieces of a hole.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace test_finer_levels {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef CGAL::Sequential_tag Tag;
typedef Example_source<Tag> Source;

// A hole, its base, and places around it.
struct Scene
{
  explicit Scene(const samples::Samples& surface)
  {
    sources.resize(1);
    sources[0].points = std::make_shared<Surface_points>(samples::engine_points(surface));
    sources[0].model = std::make_shared<Surface_model<Tag> >(*sources[0].points);
    std::vector<Detected_hole<Tag> > holes;
    EXPECT_TRUE(Hole_detection<Tag>(model()).run(holes, std::function<bool(double)>()));
    for(const Detected_hole<Tag>& h : holes)
      if(!h.is_outer_border)
        patch = h.patch;
    if(patch)
      sampler = std::make_shared<Relief_sampler<Tag> >(*patch, sources);
    else
      ADD_FAILURE() << "no hole";
  }

  const Surface_model<Tag>& model() const { return *sources[0].model; }

  std::vector<Source> sources;
  std::shared_ptr<const Smooth_patch<Tag> > patch;
  std::shared_ptr<const Relief_sampler<Tag> > sampler;
};

// The sheet z = 0 with a hole of radius 12.
Scene plane_scene()
{
  return Scene(samples::without_ball(samples::plane(60), samples::Point(30, 25, 0), 12.));
}

struct Result
{
  std::vector<Added_point> added;
  Hole_outcome outcome;
};

template <typename ConcurrencyTag>
Result completed(const samples::Samples& surface, const Engine_parameters& parameters)
{
  const Surface_points points = samples::engine_points(surface);
  Completion_engine<ConcurrencyTag> engine(points, parameters);
  EXPECT_TRUE(engine.detect(typename Completion_engine<ConcurrencyTag>::Callback()));
  std::vector<std::size_t> chosen;
  for(std::size_t h = 0; h < engine.holes().size(); ++h)
    if(engine.holes()[h].state == Hole_state::hole)
      chosen.push_back(h);
  EXPECT_EQ(chosen.size(), 1u);
  std::vector<double> progress;
  EXPECT_TRUE(engine.complete(chosen, [&](double fraction) { progress.push_back(fraction); return true; }));
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1.);
  Result result;
  result.added = engine.added();
  result.outcome = engine.outcomes()[chosen.front()];
  return result;
}

double mean_error(const Result& result)
{
  double sum = 0;
  for(const Added_point& p : result.added)
    sum += std::abs(p.position.z() - samples::four_patterns_height(p.position.x(), p.position.y()));
  return sum / double(result.added.size());
}

} // namespace

TEST(Hole_pieces, Cover_the_hole_and_keep_apart)
{
  const Scene scene = plane_scene();
  const std::vector<Base_sample>& base = scene.patch->samples();
  const Hole_pieces<Tag> pieces_of(*scene.patch, scene.sampler->search());
  for(const double radius : { 12., 6., 4.5 })
  {
    const std::vector<Hole_piece> pieces = pieces_of.of_radius(radius);
    ASSERT_FALSE(pieces.empty());
    std::vector<double> largest(base.size(), 0.);
    for(std::size_t p = 0; p < pieces.size(); ++p)
    {
      const Vector middle = base[pieces[p].middle].position;
      for(std::size_t q = 0; q < p; ++q)
        EXPECT_GT((base[pieces[q].middle].position - middle).norm(), 0.7 * radius);
      ASSERT_EQ(pieces[p].samples.size(), pieces[p].weights.size());
      std::vector<char> is_in(base.size(), 0);
      for(std::size_t i = 0; i < pieces[p].samples.size(); ++i)
      {
        const std::size_t s = pieces[p].samples[i];
        is_in[s] = 1;
        const double distance = (base[s].position - middle).norm(), weight = pieces[p].weights[i];
        EXPECT_EQ(weight > 0, distance < radius);
        EXPECT_EQ(weight == 1, distance <= 0.6 * radius);
        EXPECT_TRUE(weight >= 0 && weight <= 1);
        largest[s] = (std::max)(largest[s], weight);
      }
      for(std::size_t s = 0; s < base.size(); ++s)
        EXPECT_EQ(is_in[s] != 0, (base[s].position - middle).norm() <= radius + 2.5 * scene.patch->spacing());
    }
    for(std::size_t s = 0; s < base.size(); ++s)
    {
      // no farther than 0.7 radii from the next middle
      EXPECT_TRUE(!base[s].is_uncovered || largest[s] > 0.8);
    }
  }
}

TEST(Hole_pieces, More_is_known_near_the_rim_and_where_samples_are_settled)
{
  const Scene scene = plane_scene();
  const std::vector<Base_sample>& base = scene.patch->samples();
  const Hole_pieces<Tag> pieces_of(*scene.patch, scene.sampler->search());
  const Vector center(30, 25, 0);
  const Hole_piece* inner = nullptr;
  const Hole_piece* outer = nullptr;
  const std::vector<Hole_piece> pieces = pieces_of.of_radius(4.5);
  const auto distance = [&](const Hole_piece& p) { return (base[p.middle].position - center).norm(); };
  for(const Hole_piece& p : pieces)
  {
    if(inner == nullptr || distance(p) < distance(*inner))
      inner = &p;
    if(outer == nullptr || distance(p) > distance(*outer))
      outer = &p;
  }
  ASSERT_LT(distance(*inner), 4);
  ASSERT_GT(distance(*outer), 9);
  std::vector<std::size_t> settled_by(base.size(), no_index);
  EXPECT_EQ(pieces_of.controls(*inner, settled_by).known_share, 0.);
  EXPECT_TRUE(pieces_of.controls(*inner, settled_by).rim.empty());
  const Piece_controls at_rim = pieces_of.controls(*outer, settled_by);
  EXPECT_GT(at_rim.known_share, 0.25);
  EXPECT_LT(at_rim.known_share, 1.);
  EXPECT_TRUE(at_rim.settled.empty());
  const double farthest = 4.5 + Hole_pieces<Tag>::width(4.5, scene.patch->spacing());
  for(std::size_t i = 0; i < at_rim.centers.size(); ++i)
  {
    const double from_middle = (scene.patch->centers()[i].position - base[outer->middle].position).norm();
    EXPECT_EQ(at_rim.centers[i] > 0, from_middle <= farthest);
  }
  for(std::size_t s = 0; s < base.size(); ++s)
    if((base[s].position - center).norm() > 6)
      settled_by[s] = pieces.size();
  EXPECT_GT(pieces_of.controls(*outer, settled_by).known_share, at_rim.known_share);
  const Piece_controls around = pieces_of.controls(*inner, settled_by);
  EXPECT_GT(around.known_share, 0.3);
  for(std::size_t i = 0; i < around.settled.size(); ++i)
  {
    EXPECT_NE(settled_by[around.settled[i]], no_index);
    for(std::size_t j = 0; j < i; ++j)
      EXPECT_GT((base[around.settled[i]].position - base[around.settled[j]].position).norm(),
                1.5 * scene.patch->spacing());
  }
  // what it has filled itself is not known to a piece
  for(std::size_t& by : settled_by)
    by = by == no_index ? no_index : inner->number;
  EXPECT_TRUE(pieces_of.controls(*inner, settled_by).settled.empty());
  EXPECT_EQ(pieces_of.controls(*inner, settled_by).known_share, 0.);
}

Hole_relief flat_relief(const Scene& scene)
{
  const std::size_t n = scene.patch->samples().size();
  Hole_relief relief;
  relief.heights = Eigen::VectorXd::Zero(Eigen::Index(n));
  relief.errors = Eigen::VectorXd::Constant(Eigen::Index(n), scene.patch->spacing());
  relief.copy.assign(n, no_index);
  return relief;
}

Piece_filling raised(const Scene& scene, const Hole_piece& piece)
{
  Piece_filling filling;
  filling.heights = Eigen::VectorXd::Constant(Eigen::Index(piece.samples.size()), 0.5 * scene.patch->spacing());
  filling.error = scene.patch->spacing();
  filling.carried.displacement = filling.carried.surface =
    Eigen::VectorXd::Zero(Eigen::Index(scene.patch->samples().size()));
  return filling;
}

TEST(Hole_refinement, Known_shares_are_those_of_the_samples_settled_so_far)
{
  const Scene scene = plane_scene();
  const Place_search<Tag> search(scene.sources, Search_settings());
  Hole_refinement<Tag> refinement(scene.model(), search, scene.patch, scene.sampler, {}, flat_relief(scene),
                                  Ingredients());
  const Hole_pieces<Tag> pieces_of(*scene.patch, scene.sampler->search());
  for(std::size_t level : {1, 2})
  {
    refinement.begin_level(level);
    const std::vector<Hole_piece>& pieces = refinement.pieces();
    ASSERT_GT(pieces.size(), 6u);
    std::vector<std::size_t> settled_by(scene.patch->samples().size(), no_index);
    std::size_t changed = 0;
    for(std::size_t k = 0; k < pieces.size(); k += 3)
    {
      std::vector<double> before;
      for(const Hole_piece& p : pieces)
        before.push_back(refinement.known_share(p));
      refinement.insert(pieces[k], raised(scene, pieces[k]));
      for(std::size_t i = 0; i < pieces[k].samples.size(); ++i)
        if(pieces[k].weights[i] > 0.5)
          settled_by[pieces[k].samples[i]] = pieces[k].number;
      for(const Hole_piece& p : pieces)
      {
        EXPECT_EQ(refinement.known_share(p), pieces_of.controls(p, settled_by).known_share);
        changed += refinement.known_share(p) != before[p.number];
      }
    }
    EXPECT_GT(changed, 3u);
  }
}

TEST(Hole_refinement, A_piece_is_tried_again_when_its_surroundings_have_been_filled)
{
  const Scene scene = plane_scene();
  const Hole_relief relief = flat_relief(scene);
  const Place_search<Tag> search(scene.sources, Search_settings());
  Hole_refinement<Tag> refinement(scene.model(), search, scene.patch, scene.sampler, {}, relief, Ingredients());
  refinement.begin_level(1);
  const std::vector<Hole_piece>& pieces = refinement.pieces();
  const Hole_piece* tried = nullptr;
  for(const Hole_piece& p : pieces)
    if(refinement.is_open(p))
      tried = &p;
  ASSERT_NE(tried, nullptr);
  refinement.find(*tried);
  EXPECT_FALSE(refinement.is_open(*tried));
  const auto fill = [&](const Hole_piece& p) { EXPECT_TRUE(refinement.insert(p, raised(scene, p))); };
  fill(*tried);
  EXPECT_FALSE(refinement.is_open(*tried)) << "its own filling is no news";
  const auto distance = [&](const Hole_piece& p)
  {
    return (scene.patch->samples()[p.middle].position - scene.patch->samples()[tried->middle].position).norm();
  };
  const Hole_piece* nearest = nullptr;
  for(const Hole_piece& p : pieces)
    if(&p != tried && (nearest == nullptr || distance(p) < distance(*nearest)))
      nearest = &p;
  ASSERT_NE(nearest, nullptr);
  fill(*nearest);
  EXPECT_TRUE(refinement.is_open(*tried));
  EXPECT_EQ(refinement.number_of_replaced(), 2u);
  EXPECT_EQ(refinement.relief().copies.size(), 2u);
}

TEST(Hole_refinement, A_piece_does_not_flatten_what_a_believed_copy_of_the_whole_has)
{
  const Scene scene = plane_scene();
  const Place_search<Tag> search(scene.sources, Search_settings());
  const double h = scene.patch->spacing();
  // all places around are flat, and pieces at the rim cannot know of a step inside
  for(double step : { 0.5, 3. })
    for(bool is_whole : { false, true })
    {
      Hole_relief relief = flat_relief(scene);
      relief.errors *= 0.3;
      for(std::size_t s = 0; s < scene.patch->samples().size(); ++s)
        if((scene.patch->samples()[s].position - Vector(30, 25, 0)).norm() < 9)
          relief.heights[Eigen::Index(s)] = step * h;
      relief.copies.emplace_back();
      relief.copies.back().displacement = relief.copies.back().surface = Eigen::VectorXd::Zero(relief.heights.size());
      relief.copies.back().is_whole = is_whole;
      relief.copies.back().tolerance = h;
      relief.copy.assign(relief.copy.size(), 0);
      Hole_refinement<Tag> refinement(scene.model(), search, scene.patch, scene.sampler, {}, relief, Ingredients());
      refinement.begin_level(1);
      std::size_t tried = 0, found = 0;
      for(const Hole_piece& piece : refinement.pieces())
      {
        double change = 0, total = 0;
        for(std::size_t i = 0; i < piece.samples.size(); ++i)
        {
          change += piece.weights[i] * relief.heights[Eigen::Index(piece.samples[i])] / h;
          total += piece.weights[i];
        }
        if(!refinement.is_open(piece) || change < 0.4 * step * total)
          continue;
        ++tried;
        found += refinement.find(piece).is_found;
      }
      EXPECT_GT(tried, 3u);
      if(is_whole && step == 3)
        EXPECT_EQ(found, 0u);
      else
        EXPECT_GT(2 * found, tried) << step << ' ' << is_whole;
    }
}

TEST(Relief_sampler, A_window_shows_what_the_whole_relief_has_there)
{
  const Scene scene(samples::four_patterns_with_hole());
  Place place;
  place.motion.translation = Vector(16, 8, 0);
  const Place_relief whole = scene.sampler->relief(place);
  Relief_window window;
  window.middle = scene.patch->samples()[scene.patch->samples().size() / 3].position;
  window.reach = 6;
  for(const Base_center& c : scene.patch->centers())
    window.is_center_needed.push_back((c.position - window.middle).norm() < 7);
  const Place_relief part = scene.sampler->relief(place, window);
  std::size_t inside = 0, found = 0;
  for(std::size_t s = 0; s < scene.patch->samples().size(); ++s)
    if((scene.patch->samples()[s].position - window.middle).norm() < window.reach)
    {
      ++inside;
      EXPECT_EQ(part.is_covered[s], whole.is_covered[s]);
      EXPECT_EQ(part.height[Eigen::Index(s)], whole.height[Eigen::Index(s)]);
    }
  for(std::size_t c = 0; c < window.is_center_needed.size(); ++c)
  {
    EXPECT_EQ(part.is_found[c], window.is_center_needed[c] ? whole.is_found[c] : 0);
    found += part.is_found[c] != 0;
    const Eigen::Index i = 4 * Eigen::Index(c);
    EXPECT_TRUE(!window.is_center_needed[c] || part.rim.segment<4>(i) == whole.rim.segment<4>(i));
  }
  EXPECT_GT(inside, 50u);
  EXPECT_GT(found, 3u);
}

TEST(Fake_hole_statistics, Ranks_as_sorting_does_and_leaves_out_what_overlaps)
{
  const std::size_t n = 9;
  samples::Random_offsets offset(5);
  std::vector<Place> places(n);
  for(std::size_t i = 0; i < n; ++i)
    places[i].origin = Vector(3. * double(i), 0, 0);
  Eigen::MatrixXd mismatch(n + 1, n);
  for(Eigen::Index k = 0; k <= Eigen::Index(n); ++k)
    for(Eigen::Index j = 0; j < Eigen::Index(n); ++j)
      mismatch(k, j) = 0.5 + 0.49 * offset();
  std::vector<double> coverage(n, 1.);
  coverage[4] = 0.5;
  const auto between = [&](std::size_t k, std::size_t j)
    { return mismatch(k == Fake_hole_statistics::target ? Eigen::Index(n) : Eigen::Index(k), Eigen::Index(j)); };
  const Fake_hole_statistics statistics(places, coverage, between, 5., 1.);
  mismatch.col(4).array() += 2 * (0.97 - 0.5);   // does not cover the hole
  for(std::size_t k = 0; k <= n; ++k)
  {
    const std::size_t place = k == n ? Fake_hole_statistics::target : k;
    const std::vector<std::size_t>& ranking = statistics.ranking(place);
    double previous = 0;
    for(std::size_t j : ranking)
    {
      EXPECT_EQ(statistics.mismatch(place, j), mismatch(Eigen::Index(k), Eigen::Index(j)));
      EXPECT_LE(previous, statistics.mismatch(place, j));
      previous = statistics.mismatch(place, j);
      EXPECT_TRUE(k == n || std::abs(int(j) - int(k)) >= 2);
    }
    EXPECT_EQ(ranking.size(), k == n ? n : n - (k == 0 || k == n - 1 ? 2 : 3));
    const double harmonic =
      2 / (1 / statistics.mismatch(place, ranking[0]) + 1 / statistics.mismatch(place, ranking[1]));
    EXPECT_NEAR(statistics.joint_mismatch(2, place), harmonic, 2e-6);
  }
  double total = 0;
  for(double w : statistics.weights())
    total += w;
  EXPECT_NEAR(total, 1., 1e-12);
  EXPECT_EQ(statistics.judges().size(), n - 1);
  EXPECT_EQ(std::count(statistics.judges().begin(), statistics.judges().end(), 4u), 0);
}

TEST(Fake_hole_statistics, Believes_in_copies_as_far_as_they_fill_the_fake_holes)
{
  const std::size_t n = 8;
  std::vector<Place> places(n);
  for(std::size_t i = 0; i < n; ++i)
    places[i].origin = Vector(10. * double(i), 0, 0);
  const Fake_hole_statistics statistics(places, std::vector<double>(n, 1.),
                                        [](std::size_t, std::size_t) { return 0.05; }, 5., 1.);
  std::vector<double> errors;
  const Trust good = statistics.learn_trust(1, [](const Filling_plan& plan, std::size_t) { return 1 - plan.share; },
                                            errors);
  EXPECT_GT(good.share(0.05), 0.95);
  ASSERT_EQ(errors.size(), statistics.judges().size());
  for(double e : errors)
    EXPECT_NEAR(e, 1 - good.share(0.05), 1e-5);
  const Trust bad = statistics.learn_trust(1, [](const Filling_plan& plan, std::size_t) { return plan.share; }, errors);
  EXPECT_LT(bad.share(0.05), 0.05);
  // the same everywhere: the same is to be expected
  Plan_forecast forecast;
  statistics.extrapolate(std::vector<double>(errors.size(), 0.3), [](std::size_t) { return 0.; }, forecast);
  EXPECT_NEAR(forecast.error, 0.3, 1e-12);
  EXPECT_GT(forecast.upper, forecast.error);
  // where the predictor is larger by a factor of two, up to twice as much
  statistics.extrapolate(std::vector<double>(errors.size(), 0.3), [](std::size_t k) {
    return k == Fake_hole_statistics::target ? std::log(2.) : 0.; }, forecast);
  EXPECT_GT(forecast.error, 0.3);
  EXPECT_LE(forecast.error, 0.6 + 0.01 + 1e-12);
}

TEST(Rim_mismatch, Is_a_mean_of_truncated_terms)
{
  Place_relief a, b;
  a.rim = b.rim = Eigen::VectorXd::Zero(12);
  a.is_found = b.is_found = { 1, 1, 1 };
  const auto mismatch = [&](const std::vector<double>& weights)
  {
    Rim_mismatch result(0.5);            // heights count in units of one
    result.add_centers(&a, b, weights);
    return result.mean();
  };
  EXPECT_EQ(mismatch({ 1, 1, 1 }), 0.);
  b.rim[0] = 0.5;                        // a height
  b.rim[5] = 0.2;                        // a slope
  EXPECT_NEAR(mismatch({ 1, 1, 1 }), (0.25 + 0.5 * 0.02) / 3, 1e-12);
  EXPECT_NEAR(mismatch({ 0, 2, 1 }), 2 * 0.5 * 0.02 / 3, 1e-12);
  b.rim[0] = 100;
  EXPECT_NEAR(mismatch({ 1, 0, 0 }), 1., 1e-12);
  b.is_found[2] = 0;                     // a missing wall
  EXPECT_NEAR(mismatch({ 0, 0, 1 }), 1.5, 1e-12);
  a.is_found[2] = 0;                     // that both miss
  EXPECT_NEAR(mismatch({ 0, 1, 1 }), 0.5 * 0.02, 1e-12);
  Rim_mismatch nothing(0.5);
  EXPECT_EQ(nothing.mean(), 1.5);
  nothing.add_height(0.5, 2);
  EXPECT_EQ(nothing.mean(), 0.25);
}

TEST(Place_search, A_hint_is_tried)
{
  const Scene scene(samples::without_ball(samples::bumpy_plane(60, 1., 8., 1.), samples::Point(29, 31, 0), 4.));
  const Match_target target = Hole_completion<Tag>::match_target(scene.model(), *scene.patch);
  Search_settings settings;
  settings.number_of_places = 1;         // where nothing is found
  const Place_search<Tag> search(scene.sources, settings);
  Place hint;
  hint.motion.translation = Vector(16, 0, 0);   // two periods
  const std::vector<Place> without = search.search(target), with = search.search(target, { hint });
  ASSERT_FALSE(with.empty());
  EXPECT_LT(with.front().score, 0.1);
  EXPECT_LT((with.front().motion(Vector(20, 30, 0)) - Vector(36, 30, 0)).norm(), 0.3);
  EXPECT_TRUE(without.empty() || without.front().score > 2 * with.front().score);
}

TEST(Finer_levels, Parts_that_have_twins_are_copied_where_the_whole_has_none)
{
  const samples::Samples surface = samples::four_patterns_with_hole();
  Engine_parameters parameters;
  const Result with = completed<Tag>(surface, parameters);
  parameters.ingredients.levels = false;
  const Result without = completed<Tag>(surface, parameters);
  ASSERT_FALSE(with.added.empty());
  ASSERT_FALSE(without.added.empty());
  EXPECT_LT(mean_error(with), 0.9 * mean_error(without));
  EXPECT_EQ(with.outcome.filling, Filling::copied);
  EXPECT_NE(with.outcome.reason.find("finer levels copied"), std::string::npos);
  EXPECT_EQ(without.outcome.reason.find("finer levels copied"), std::string::npos);
  EXPECT_GT(with.outcome.level, without.outcome.level);
}

} // namespace test_finer_levels
