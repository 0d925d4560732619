// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes far from the origin: what float loses of their detail, and how to keep it.
//
// Source: Thorne, "Using a Floating Origin to Improve Fidelity and Performance of Large,
// Distributed Virtual Worlds", 2005.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// What a mesh loses once its positions are floats.
struct LostDetail {
  std::size_t positions = 0;  // that differ in the file
  std::size_t fallen = 0;     // so many fewer differ in float
  std::size_t triangles = 0;
  std::size_t bent = 0;  // an edge of theirs changes by more than 1 % of its length
  double largest = 0;    // coordinate, in magnitude
  double ulp = 0;        // distance of floats there, in units of the mesh
};

LostDetail lost_detail(const Mesh& mesh);

// "12 of 16 positions fall together with others, 20 of 28 triangles have an edge that changes by
// more than 1 %: neighbouring floats are 1 apart at 12958095; …"; empty if there is neither. `mesh`
// names it.
std::string describe(const LostDetail& detail, const std::string& mesh);

// Subtracts an origin from all positions, in double, and rounds each difference to float once. The
// origin is the centre of the bounding box, rounded to a multiple of the largest power of two
// within half of the box's longest side. The difference is exact where a coordinate is within a
// factor of 2 of the origin's (Sterbenz' lemma). The views follow: each sees what it saw before.
// Yields the origin. Pre-condition: the mesh has a position.
glm::dvec3 recentre(Scene& scene);

}  // namespace clipscope::experiments
