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

// Complete models of CGAL's data: nothing may be added to them, and what is cut out of them comes back.

#include "include/engine_samples.h"

#include <CGAL/Context_completion_3/internal/Completion_engine.h>
#include <CGAL/Context_completion_3/internal/Point_grid.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_complete_models {

using namespace CGAL::Context_completions_3::internal;
namespace samples = Test_surfaces;

namespace {

typedef Completion_engine<CGAL::Sequential_tag> Engine;

struct Triangle_soup
{
  std::vector<Vector> vertices;
  std::vector<std::array<std::size_t, 3> > triangles;
};

Triangle_soup read_soup(const std::string& file)
{
  std::vector<samples::Point> vertices;
  std::vector<std::vector<std::size_t> > faces;
  EXPECT_TRUE(CGAL::IO::read_OFF(CGAL::data_file_path(file), vertices, faces)) << file;
  Triangle_soup soup;
  for(const samples::Point& p : vertices)
    soup.vertices.push_back(samples::engine_vector(p));
  for(const std::vector<std::size_t>& face : faces)
    for(std::size_t k = 1; k + 1 < face.size(); ++k)
      soup.triangles.push_back({ { face[0], face[k], face[k + 1] } });
  return soup;
}

// twice the area, along the normal
Vector area_vector(const Triangle_soup& soup, const std::array<std::size_t, 3>& t)
{
  return (soup.vertices[t[1]] - soup.vertices[t[0]]).cross(Vector(soup.vertices[t[2]] - soup.vertices[t[0]]));
}

// Vertices of a mesh with the mean of the normals of their faces, weighted by area; each position once.
Surface_points mesh_vertices(const std::string& file)
{
  const Triangle_soup soup = read_soup(file);
  std::vector<Vector> normals(soup.vertices.size(), Vector::Zero());
  for(const std::array<std::size_t, 3>& t : soup.triangles)
    for(std::size_t v : t)
      normals[v] += area_vector(soup, t);
  Surface_points points;
  std::set<std::tuple<double, double, double> > seen;
  for(std::size_t i = 0; i < soup.vertices.size(); ++i)
  {
    const Vector& p = soup.vertices[i];
    if(normals[i].norm() > 0 && seen.insert(std::make_tuple(p.x(), p.y(), p.z())).second)
      points.push_back(p, normals[i].normalized());
  }
  return points;
}

// The surface of a mesh as a scanner would see it: random points, thinned to an even spacing.
Surface_points mesh_samples(const std::string& file, std::size_t number)
{
  const Triangle_soup soup = read_soup(file);
  if(soup.triangles.empty())
    return Surface_points();
  std::vector<double> areas;
  double total = 0;
  for(const std::array<std::size_t, 3>& t : soup.triangles)
    areas.push_back(total += area_vector(soup, t).norm() / 2);
  // darts thrown until nearly none finds room fill about 0.7 of the area with discs of half the distance
  const double distance = std::sqrt(total / double(number) / 1.25);
  Point_grid grid(distance);
  Surface_points points;
  std::mt19937 random(7);
  const auto uniform = [&]() { return double(random()) / 4294967296.; };
  for(std::size_t dart = 0; dart < 12 * number; ++dart)
  {
    const std::size_t t = std::size_t(std::upper_bound(areas.begin(), areas.end(), total * uniform()) - areas.begin());
    const std::array<std::size_t, 3>& triangle = soup.triangles[(std::min)(t, areas.size() - 1)];
    const double root = std::sqrt(uniform()), v = uniform();
    const Vector p = (1 - root) * soup.vertices[triangle[0]] + root * (1 - v) * soup.vertices[triangle[1]] +
                     root * v * soup.vertices[triangle[2]];
    const Vector normal = area_vector(soup, triangle).normalized();
    bool is_free = true;
    grid.for_each_in_ball(p, distance, [&](std::size_t k, double) {
      is_free = points.normal[k].dot(normal) < -0.3;
      return is_free; });
    if(!is_free)
      continue;
    grid.insert(p);
    points.push_back(p, normal);
  }
  return points;
}

Surface_points oriented_points(const std::string& file)
{
  samples::Samples read;
  EXPECT_TRUE(CGAL::IO::read_points(CGAL::data_file_path(file), std::back_inserter(read),
    CGAL::parameters::point_map(CGAL::First_of_pair_property_map<samples::Oriented_point>())
                     .normal_map(CGAL::Second_of_pair_property_map<samples::Oriented_point>()))) << file;
  for(samples::Oriented_point& s : read)
    s.second = samples::unit(s.second);
  return samples::engine_points(read);
}

std::vector<std::size_t> fillable(const Engine& engine)
{
  std::vector<std::size_t> chosen;
  for(std::size_t h = 0; h < engine.holes().size(); ++h)
    if(engine.holes()[h].state == Hole_state::hole)
      chosen.push_back(h);
  return chosen;
}

void expect_no_hole(const Surface_points& points)
{
  ASSERT_GT(points.size(), 1000u);
  Engine engine(points, Engine_parameters());
  ASSERT_TRUE(engine.detect(Engine::Callback()));
  const std::vector<std::size_t> chosen = fillable(engine);
  for(std::size_t h : chosen)
    ADD_FAILURE() << "hole at " << engine.holes()[h].center.transpose() << ", diameter "
                  << engine.holes()[h].diameter / engine.spacing() << " spacings, rims "
                  << engine.holes()[h].loops.size() << ", rim points of the first "
                  << engine.holes()[h].loops.front().size()
                  << ", local spacing " << engine.holes()[h].spacing / engine.spacing();
  ASSERT_TRUE(engine.complete(chosen, Engine::Callback()));
  EXPECT_TRUE(engine.added().empty()) << engine.added().size() << " points added";
}

class Complete_model : public ::testing::TestWithParam<const char*> {};
class Complete_mesh : public ::testing::TestWithParam<const char*> {};

} // namespace

TEST_P(Complete_model, Has_no_hole)
{
  const std::string file = GetParam();
  expect_no_hole(file.find("points_3") == 0 ? oriented_points(file) : mesh_vertices(file));
}

TEST_P(Complete_mesh, Sampled_evenly_has_no_hole)
{
  expect_no_hole(mesh_samples(GetParam(), 30000));
}

// The vertices of the bunny thin out on its underside, up to ten times the spacing elsewhere.
INSTANTIATE_TEST_SUITE_P(Data, Complete_model,
                         ::testing::Values("points_3/kitten.xyz", "meshes/bunny00.off", "meshes/femur.off",
                                           "meshes/armadillo.off"));

INSTANTIATE_TEST_SUITE_P(Data, Complete_mesh,
                         ::testing::Values("meshes/bunny00.off", "meshes/femur.off", "meshes/armadillo.off"));

TEST(Cut_model, Kitten_gets_its_back_again)
{
  const Surface_points whole = oriented_points("points_3/kitten.xyz");
  ASSERT_GT(whole.size(), 1000u);
  const Surface_model<CGAL::Sequential_tag> model(whole);
  const double h = model.spacing();
  // around the first, a middle and a last point
  for(const std::size_t middle : { std::size_t(0), whole.size() / 2, whole.size() - 1 })
  {
    Surface_points rest;
    std::vector<Vector> removed, added;
    for(std::size_t i = 0; i < whole.size(); ++i)
      if((whole.position[i] - whole.position[middle]).norm() > 5 * h ||
         !is_same_side(whole.normal[i], whole.normal[middle]))
        rest.push_back(whole.position[i], whole.normal[i]);
      else
        removed.push_back(whole.position[i]);
    Engine engine(rest, Engine_parameters());
    ASSERT_TRUE(engine.detect(Engine::Callback()));
    const std::vector<std::size_t> chosen = fillable(engine);
    EXPECT_EQ(chosen.size(), 1u) << "around point " << middle;
    ASSERT_TRUE(engine.complete(chosen, Engine::Callback()));
    for(const Added_point& p : engine.added())
      added.push_back(p.position);
    std::size_t covered = 0;
    for(const Vector& p : removed)
      covered += samples::nearest_distance(p, added) < 2 * h;
    EXPECT_GE(double(covered), 0.98 * double(removed.size())) << "around point " << middle;
    double farthest = 0;
    for(const Vector& p : added)
      farthest = (std::max)(farthest, samples::nearest_distance(p, whole.position));
    EXPECT_LT(farthest, 3 * h) << "around point " << middle;
  }
}

} // namespace test_complete_models
