// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a driver drew, against the exact value at the centre of each pixel.
//
// A violation says which sentence of which specification it breaks, and is one only beyond all that
// the specification leaves open; everything else is legal, and its error is measured.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

enum class ViolationKind : std::uint8_t {
  not_finite,      // NaN or infinity where the exact value is a number
  outside_hull,    // beyond the values of the vertices
  wrong_value,     // of a triangle all inside of the volume: not what the formula gives there
  missing,         // no fragment well inside of the primitive
  extra,           // a fragment well outside of it
  zero_area,       // fragments of a triangle without area
  shared_edge,     // a pixel at an edge of two triangles hit by neither or by both
  flat_value,      // not the value of the provoking vertex
  facing,          // the wrong side of a triangle
  primitive_id,    // the number of another primitive
  primitive_lost,  // nothing at all of a primitive that covers pixels
  crashed,
  timed_out
};
constexpr std::array<std::string_view, 13> names_of(ViolationKind) {
  return {"not_finite",     "outside_hull", "wrong_value", "missing", "extra",
          "zero_area",      "shared_edge",  "flat_value",  "facing",  "primitive_id",
          "primitive_lost", "crashed",      "timed_out"};
}

// The sentence that is broken, in our words.
struct Clause {
  std::string_view document;  // "OpenGL 4.6 core"
  std::string_view section;   // "14.6.1"
  std::string_view meaning;
};
Clause clause_of(GraphicsApi api, Topology topology, ViolationKind kind, Quantity quantity);

struct WorstPixel {
  int x = 0, y = 0;
  std::size_t channel = 0;
  double exact = 0;  // the nearest double to what is right there; of coverage 0 or 1
  float returned = 0;
};

// All pixels of one primitive with one kind of violation in one quantity.
struct Violation {
  std::size_t primitive = 0;  // its number in the draw call
  Quantity quantity = Quantity::covered;
  ViolationKind kind = ViolationKind::missing;
  int pixels = 0;
  WorstPixel worst;
  // How far beyond what is allowed, in multiples of that; infinity for what allows nothing.
  double size = 0;
};

// Of legal values: how far from the exact one, in ulp of float at the greatest magnitude that the
// vertices of the primitive, or of what clipping leaves of it, have there (of a depth: at 1, if
// that is more). An ulp at the exact value would say nothing where a varying goes through 0.
struct UlpErrors {
  static constexpr std::size_t kBins = 34;
  // Bin 0: at most 1/2 ulp (correctly rounded); bin k: at most 2^(k-1); the last one all beyond.
  std::array<std::uint64_t, kBins> bins = {};
  double greatest = 0;  // ulp
  WorstPixel worst = {};

  std::uint64_t count() const;
  // An upper bound of the error that so much of the values (0 to 1) do not exceed, in ulp.
  double quantile(double share) const;
  void add(double ulps, const WorstPixel& pixel);
  void add(const UlpErrors& other);
};

struct Judgement {
  std::vector<Violation> violations;
  std::array<UlpErrors, kQuantities> errors;  // by Quantity
  std::uint64_t pixels = 0;                   // judged: values and coverage
  std::uint64_t undecided = 0;  // within the margin of an edge, where both answers are right
  // Coverage that the sub-pixel bits don't account for, but the accuracy of the specification's own
  // arithmetic does: legal, but inexact.
  std::uint64_t inexact = 0;
  // Why the case is scored apart, beyond the guarantees of the specification (coordinates beyond
  // 2^32, subnormals, relaxed rules of lines): violations of such a case accuse nobody. Empty
  // otherwise.
  std::string_view apart = {};
};

// Pre-conditions: the pixels are those of the call; coordinates and varyings are finite.
Judgement judge_pixels(const DrawCall& call, const Pixels& pixels, const DriverInfo& info);

}  // namespace clipscope::experiments
