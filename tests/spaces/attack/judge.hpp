// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contestants against the exact answer, every bit of every float.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/spaces/attack/contestants.hpp"
#include "tests/spaces/attack/facts.hpp"

namespace clipscope::attack {

// A triangle that a contestant has other bits of.
struct Failure {
  std::string contestant;
  Batch batch;
  std::size_t triangle;
  std::vector<float> computed, exact;
};

struct Tally {
  Facts facts;
  std::int64_t triangles = 0;
  std::int64_t floats = 0;   // of exact polygons, once for each contestant
  std::int64_t answers = 0;  // polygons, empty ones as well, once for each contestant

  Tally& operator+=(const Tally& other);
};

// Whether both are the same polygon, bit for bit, from whichever vertex on. stride: floats of a
// vertex.
bool is_same_polygon(std::span<const float> a, std::span<const float> b, std::size_t stride);

// The first failure, if any. Adds what was compared.
std::optional<Failure> judge(const Batch& batch, std::span<const Contestant> contestants,
                             Tally& tally);

// The same failure of a triangle alone with simpler floats; as it is if it takes the others of its
// batch.
Failure shrunk(const Failure& failure, std::span<const Contestant> contestants);

// In the words of the catalogue of hard cases (tests/corpus), with both polygons.
std::string describe(const Failure& failure);

}  // namespace clipscope::attack
