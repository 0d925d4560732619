// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does a contestant of the stage contract answer as it promises?
//
// Every triangle looked at must go the way that its outcodes say (they are comparisons of
// floats, hence exact; the exact reference is asked as well where it clips anyway), numbers ascend,
// and a triangle that is inside comes out as it went in. Of those that are cut:
//
//   bits_of_scalar     the polygon is that of homogeneous/sutherland_hodgman before its divide, bit
//                      for bit, up to the vertex that it begins with
//   correctly_rounded  the exact polygon, each coordinate x_ndc / (1/w) and attribute rounded once;
//                      vertices that round to the same floats as the one before count once, and
//                      triangles without area in NDC are not compared
//   float_chain, rounded_once
//                      the backward error in clip space (experiments/judge/promise.hpp) is within
//                      the bound
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments {

struct StageCheckOptions {
  std::size_t triangles = 1 << 16;  // at most, spread over the input in blocks
  std::size_t exact = 256;          // cut triangles at most that are compared with exact arithmetic
};

// What was found to be wrong first; empty if nothing was. Pre-condition: the runner is the
// contestant's on this input.
std::string first_broken_promise(const Contestant& contestant, Runner& runner,
                                 const StageInput& input, const StageCheckOptions& options);

// A clip-space polygon divided in double.
Answers divided(const PolygonView& polygon);

// An exact vertex in clip coordinates, x_ndc / (1/w) and so on, each the nearest float.
std::array<float, 4> nearest_in_clip(const reference::ExactVertex& vertex);

// The exact polygon, every clip coordinate and attribute the nearest float: 4 + K floats per
// vertex. Empty if it has fewer than three vertices. Pre-condition: finite.
using FloatPolygon = std::vector<std::vector<float>>;
FloatPolygon rounded_clip_polygon(const reference::Truth& truth,
                                  const reference::InputTriangle& triangle);

// Whether a clip-space triangle is seen as a line or a point from everywhere: its vertices lie in a
// plane through (0, 0, 0, 0). Its exact polygon has no area in NDC, and how many vertices stand for
// it is no matter.
bool has_no_area(const reference::InputTriangle& triangle);

// A triangle of the input in that layout, as the reference takes it.
reference::InputTriangle input_triangle(const StageInput& input, Contract contract,
                                        std::size_t triangle);

}  // namespace clipscope::experiments
