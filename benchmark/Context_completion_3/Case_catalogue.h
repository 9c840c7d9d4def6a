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
#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_CATALOGUE_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_CATALOGUE_H

#include "Hole_cutter.h"
#include "Synthetic_surfaces.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Completion_benchmark {

/// How the samples are spread over the surface.
enum class Density { even, ramp, blotches, dropout };

/// All that determines a case.
struct Case_description
{
  std::string name;
  std::string surface;                 ///< of `synthetic_kinds()`, or a file below CGAL's data folder
  std::string kind;
  std::size_t variant = 0;             ///< of the synthetic surface
  std::size_t number_of_points = 20000;
  Hole_shape shape = Hole_shape::round;
  double radius = 12;                  ///< in spacings
  std::size_t number_of_holes = 1;
  double noise = 0;                    ///< in spacings
  Density density = Density::even;
  bool is_moved = false;               ///< rotated, scaled and far from the origin
  std::uint64_t seed = 1;

  Case_description(const std::string& name_, const std::string& surface_, const std::string& kind_, std::size_t points,
                   double radius_, Hole_shape shape_ = Hole_shape::round)
    : name(name_), surface(surface_), kind(kind_), number_of_points(points), shape(shape_), radius(radius_)
  {}

  Case_description& holes(std::size_t n) { number_of_holes = n; return *this; }
  Case_description& noisy(double n) { noise = n; return *this; }
  Case_description& uneven(Density d) { density = d; return *this; }
  Case_description& moved() { is_moved = true; return *this; }
  Case_description& repeats(std::size_t v) { variant = v; return *this; }
};

/// Models of CGAL's data and what their surface is like.
struct Model_kind { const char* file; const char* kind; };

inline const std::vector<Model_kind>& model_kinds()
{
  static const std::vector<Model_kind> kinds = {
    { "meshes/bunny00.off", "stochastic" }, { "meshes/armadillo.off", "stochastic" }, { "meshes/femur.off", "smooth" },
    { "points_3/kitten.xyz", "smooth" }, { "meshes/refined_elephant.off", "smooth" },
    { "meshes/lion-head.off", "stochastic" }, { "meshes/mannequin-devil.off", "smooth" },
    { "meshes/nefertiti.off", "smooth" }, { "meshes/knot1.off", "smooth" }, { "meshes/knot2.off", "smooth" },
    { "meshes/bear.off", "smooth" }, { "meshes/camel.off", "smooth" }, { "meshes/homer.off", "smooth" },
    { "meshes/bull.off", "smooth" }, { "meshes/cow.off", "smooth" }, { "meshes/diplodocus.off", "smooth" },
    { "meshes/ChineseDragon-10kv.off", "stochastic" }, { "meshes/three_peaks.off", "smooth" },
    { "meshes/3torus.off", "cad" }, { "meshes/rotor.off", "cad" }, { "meshes/blade.off", "cad" },
    { "meshes/fandisk.off", "cad" }, { "meshes/anchor_dense.off", "cad" }, { "meshes/couplingdown.off", "cad" },
    { "meshes/pinion.off", "cad" }, { "meshes/joint.off", "cad" }, { "meshes/spool.off", "cad" },
    { "meshes/turbine.off", "cad" } };
  return kinds;
}

/// Forty cases with names, for development and for the table of the manual.
inline std::vector<Case_description> development_cases()
{
  const Hole_shape round = Hole_shape::round, ragged = Hole_shape::ragged, longish = Hole_shape::elongated,
                   through = Hole_shape::two_rims, island = Hole_shape::island;
  std::vector<Case_description> cases = {
    // repeats
    { "block_torus", "block_torus", "structured", 30000, 14, round },
    { "ribbed_torus", "ribbed_torus", "structured", 30000, 16, ragged },
    { "knurled_torus", "knurled_torus", "structured", 40000, 18, round },
    { "bumpy_sphere", "bumpy_sphere", "structured", 20000, 12, round },
    { "studded_sphere", "studded_sphere", "structured", 45000, 16, longish },
    { "woven_sheet", "woven_sheet", "structured", 40000, 17, round },
    { "honeycomb", "honeycomb", "structured", 30000, 14, island },
    { "egg_crate", "egg_crate", "structured", 20000, 13, round },
    { "brick_wall", "brick_wall", "structured", 40000, 20, round },
    { "roof_tiles", "roof_tiles", "structured", 35000, 15, ragged },
    { "chevron_cylinder", "chevron_cylinder", "structured", 40000, 15, round },
    { "fluted_cylinder", "fluted_cylinder", "structured", 30000, 24, longish },
    // models
    { "bunny", "meshes/bunny00.off", "stochastic", 34000, 14, round },
    { "armadillo", "meshes/armadillo.off", "stochastic", 45000, 13, round },
    { "femur", "meshes/femur.off", "smooth", 20000, 10, round },
    { "kitten", "points_3/kitten.xyz", "smooth", 5200, 8, round },
    { "elephant", "meshes/refined_elephant.off", "smooth", 20000, 9, ragged },
    { "lion_head", "meshes/lion-head.off", "stochastic", 30000, 12, round },
    { "mannequin_devil", "meshes/mannequin-devil.off", "smooth", 20000, 16, round },
    { "nefertiti", "meshes/nefertiti.off", "smooth", 15000, 10, round },
    { "knot_one", "meshes/knot1.off", "smooth", 20000, 7, round },
    { "rotor", "meshes/rotor.off", "cad", 20000, 9, round },
    { "blade", "meshes/blade.off", "cad", 30000, 12, round },
    { "armadillo_three_holes", "meshes/armadillo.off", "stochastic", 30000, 9, round },
    // CAD
    { "staircase", "staircase", "cad", 15000, 11, round },
    { "comb", "comb", "cad", 25000, 13, round },
    { "pegs", "pegs", "cad", 40000, 16, round },
    { "notched_frame", "notched_frame", "cad", 25000, 12, round },
    { "fandisk", "meshes/fandisk.off", "cad", 25000, 12, round },
    { "three_torus", "meshes/3torus.off", "cad", 15000, 12, round },
    // cut through
    { "torus_cut", "plain_torus", "topology", 15000, 15, through },
    { "rope_cut", "rope_knot", "topology", 60000, 24, through },
    { "beads_cut", "beaded_ring", "topology", 20000, 22, through },
    { "knot_cut", "meshes/knot2.off", "topology", 30000, 20, through },
    // noise
    { "elephant_noise", "meshes/refined_elephant.off", "smooth", 20000, 11, round },
    { "studded_noise", "studded_sphere", "structured", 45000, 14, round },
    { "rough_torus_noise", "rough_torus", "stochastic", 25000, 14, round },
    // uneven density
    { "femur_ramp", "meshes/femur.off", "smooth", 20000, 12, round },
    { "blocks_dropout", "block_torus", "structured", 30000, 14, round },
    { "rough_sphere_blotches", "rough_sphere", "stochastic", 25000, 14, round } };
  for(std::size_t i = 0; i < cases.size(); ++i)
  {
    cases[i].seed = 100 + i;
    cases[i].is_moved = i % 4 == 1;
    cases[i].variant = i;
  }
  const auto find = [&cases](const std::string& name) -> Case_description&
  {
    for(Case_description& c : cases)
      if(c.name == name)
        return c;
    return cases.front();
  };
  find("armadillo_three_holes").holes(3);
  find("egg_crate").holes(2);
  find("elephant_noise").noisy(0.35);
  find("studded_noise").noisy(0.2);
  find("rough_torus_noise").noisy(0.5);
  find("femur_ramp").uneven(Density::ramp);
  find("blocks_dropout").uneven(Density::dropout);
  find("rough_sphere_blotches").uneven(Density::blotches);
  return cases;
}

enum class Case_set { all, synthetic, models };

/// `number` random cases; the i-th depends on `seed` and i only.
inline std::vector<Case_description> random_cases(std::size_t number, std::uint64_t seed, Case_set set)
{
  std::vector<Case_description> cases;
  for(std::size_t i = 0; i < number; ++i)
  {
    Random_source random(seed * 1000003 + i);
    const bool is_model = set == Case_set::models || (set == Case_set::all && i % 2 == 1);
    // every surface is met before one is met again
    const std::size_t turn = set == Case_set::all ? i / 2 : i;
    const Synthetic_kind& synthetic = synthetic_kinds()[(turn * 7 + seed) % synthetic_kinds().size()];
    const Model_kind& model = model_kinds()[(turn * 5 + seed) % model_kinds().size()];
    std::string base = is_model ? model.file : synthetic.name;
    base = base.substr(base.find('/') == std::string::npos ? 0 : base.find('/') + 1);
    base = base.substr(0, base.find('.'));
    Case_description c(std::to_string(i) + "_" + base, is_model ? model.file : synthetic.name,
                       is_model ? model.kind : synthetic.kind, 8000 + random.index(32000), random.uniform(7, 18));
    const double dice = random.uniform();
    c.shape = dice < 0.5 ? Hole_shape::round : dice < 0.7 ? Hole_shape::ragged : dice < 0.85 ? Hole_shape::elongated
            : dice < 0.93 ? Hole_shape::two_rims : Hole_shape::island;
    if(c.shape == Hole_shape::elongated)
      c.radius *= 1.5;
    if(random.uniform() < 0.15)
      c.holes(2 + random.index(2));
    if(random.uniform() < 0.2)
      c.noisy(random.uniform(0.05, 0.5));
    const double spread = random.uniform();
    c.density = spread < 0.76 ? Density::even : spread < 0.84 ? Density::ramp : spread < 0.92 ? Density::blotches
              : Density::dropout;
    c.is_moved = random.uniform() < 0.5;
    c.variant = random.index(1000);
    c.seed = random.seed();
    cases.push_back(c);
  }
  return cases;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_CASE_CATALOGUE_H
