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

#ifndef CGAL_CONTEXT_COMPLETION_3_INTERNAL_ENGINE_TYPES_H
#define CGAL_CONTEXT_COMPLETION_3_INTERNAL_ENGINE_TYPES_H

#include <CGAL/license/Context_completion_3.h>

#include <CGAL/Context_completion_3/internal/Surface_points.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Context_completions_3 {
namespace internal {

static const std::size_t no_index = static_cast<std::size_t>(-1);

/// What detection says of an under-sampled place.
enum class Hole_state
{
  hole,          ///< to be filled
  outer_border,  ///< a border of the surface itself
  too_small,     ///< below the minimum diameter
  too_large,     ///< above the maximum diameter
  excluded       ///< outside the regions that the user named, or inside those he barred
};

/// An under-sampled place, in the coordinates of the engine.
struct Hole_data
{
  Vector center = Vector::Zero();
  double diameter = 0;                            ///< largest distance of two rim points
  double spacing = 0;                             ///< local spacing of the surroundings
  Hole_state state = Hole_state::hole;
  std::vector<std::vector<std::size_t> > loops;   ///< rim points, indices of input points, one list per rim
  std::vector<Bbox_3> cells;                      ///< the invalid cells that were joined (leaf size)
};

/// Where the points of a hole came from.
enum class Filling { none, copied, smooth, learned };

/// What completion did with one hole.
struct Hole_outcome
{
  Filling filling = Filling::none;
  std::string reason;          ///< a sentence: why copied, smooth or not filled
  double expected_error = 0;   ///< mean distance to the true surface, model units
  double match = 0;            ///< score of the best source place, 0 is perfect (eq. 1)
  std::size_t level = 0;       ///< finest level of the tree that contributed
  std::size_t added = 0;       ///< number of points added
};

/// A new point.
struct Added_point
{
  Vector position = Vector::Zero();
  Vector normal = Vector::Zero();
  std::size_t source = no_index;      ///< index in the point set that it was copied from
  std::size_t source_set = 0;         ///< 0: the completed set itself, i: the i-th further example set
  std::size_t hole = 0;               ///< index of the hole
  double confidence = 0;              ///< 0 to 1
};

/// Parts of the default policy that an ablation leaves out one by one.
struct Ingredients
{
  bool copies = true;        ///< anything is copied at all; otherwise each hole gets its smooth base
  bool signature = true;     ///< the search compares the signatures of cells in the frames of places
  bool probes = true;        ///< the search compares probes around the hole
  bool alignment = true;     ///< places are aligned to the surroundings of the hole
  bool warp = true;          ///< copies are warped to the rim
  bool averaging = true;     ///< several places may be averaged
  bool fake_holes = true;    ///< fake holes decide; otherwise the best place is always copied
  bool levels = true;        ///< pieces of the hole are matched anew at finer levels
  bool coherence = true;     ///< pieces try the places of the whole hole and of their neighbours
  bool passes = true;        ///< pieces are matched again when others around them have been filled
  bool facets = true;        ///< where sharp edges go into the hole, facets may go on until they meet
  bool open_ends = true;     ///< the end of a tube is a hole where a matching place or facets close it
  bool learning = true;      ///< relief may go on as many places teach
  bool kriging = true;       ///< smooth bases may continue what their trend misses as a random field
};

/// All settings of a run, lengths in model units, 0 meaning "chosen by the engine".
struct Engine_parameters
{
  bool paper = false;                         ///< the paper's own policy at every stage
  double minimum_hole_diameter = 0;
  double maximum_hole_diameter = 0;           ///< 0: no limit
  std::vector<Bbox_3> regions;                ///< fill only here (empty: everywhere)
  std::vector<Bbox_3> excluded_regions;       ///< never fill here
  std::vector<Bbox_3> user_holes;             ///< what is open in each is one hole, found or not
  std::vector<std::vector<std::size_t> > known_rims;   ///< of holes, whether found or not, in order
  std::vector<char> is_example;               ///< per input point (empty: all may serve)
  std::vector<Surface_points> examples;       ///< further example point sets
  std::size_t maximum_depth = 0;              ///< 0: from the spacing
  std::size_t minimum_cell_points = 15;       ///< m of the paper
  double tolerance = 0;                       ///< epsilon of the paper; 0: half the spacing
  std::size_t number_of_turns = 24;           ///< in-plane rotations of a surface frame
  bool mirror = true;                         ///< mirrored copies, too
  std::size_t number_of_candidates = 2000;    ///< size of the shortlist of places
  std::vector<double> rotation_angles = { CGAL_PI / 4 };   ///< of rotated copies about X, Y and Z (paper, section 8)
  bool cube_symmetries = false;               ///< cells are compared under all 48 instead of the paper's 8
  bool support_balls = false;                 ///< cells are fitted to more points than their own
  bool box_subdivision = false;               ///< the paper's own test of a quadric against a box, not the exact one
  bool keep_texture = true;                   ///< true in texture rather than nearest in distance
  unsigned int random_seed = 0;
  Ingredients ingredients;
};

} // namespace internal
} // namespace Context_completions_3
} // namespace CGAL

#endif // CGAL_CONTEXT_COMPLETION_3_INTERNAL_ENGINE_TYPES_H
