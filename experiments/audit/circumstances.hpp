// SPDX-License-Identifier: GPL-3.0-or-later
//
// In which circumstances a driver fails: what kind of primitive, how it gets to the window, and
// what beside the six planes is in play. Violations in the same circumstances are one finding.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

enum class Passage : std::uint8_t {
  inside,         // all vertices in the closed volume: nothing is cut
  clipped,        // in front of the eye, and some vertex is outside
  behind_the_eye  // some vertex has w <= 0
};
constexpr std::array<std::string_view, 3> names_of(Passage) {
  return {"inside", "clipped", "behind the eye"};
}

struct Circumstances {
  Primitive primitive = Primitive::triangle;  // never a polygon
  Passage passage = Passage::inside;
  bool clip_distances = false, depth_clamp = false;

  friend auto operator<=>(const Circumstances&, const Circumstances&) = default;
};

Primitive primitive_of(Topology topology);

// Of a primitive of the call, by its number. Pre-condition: there is one of that number.
Circumstances circumstances_of(const DrawCall& call, std::size_t primitive);

// "triangle, behind the eye, clip distances".
std::string to_string(const Circumstances& circumstances);

}  // namespace clipscope::experiments
