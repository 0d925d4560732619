// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the attributes of a clipped triangle are in truth, at its vertices and at points inside, by mode of
// interpolation.
//
// smooth         linear over the triangle: a/w and 1/w are linear on the screen
// noperspective  linear on the screen: a' = (sum lambda_i w_i a_i) / (sum lambda_i w_i) at the weights lambda of the
//                triangle. Hence a' w is linear over the triangle: a' is what a smooth attribute a w gives,
//                times 1/w.
// flat           the first vertex's value everywhere (the convention of Direct3D and Vulkan; OpenGL's default
//                is the last)
//
// OpenGL 4.6 specification, section 13.7 "Clipping of shader outputs" and 14.6.1; Heckbert and Moreton,
// "Interpolation for Polygon Texture Mapping and Shading", 1991. Everything here is exact.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/attributes/crossing.hpp"

namespace clipscope::experiments {

enum class Mode : std::uint8_t { smooth, noperspective, flat };
inline constexpr int kModes = 3;

// A point inside the visible part and the exact values there, by Mode.
struct SamplePoint {
  std::array<double, 2> ndc{};
  std::array<Exact, kModes> value;
};

struct Wanted {
  TruthPolygon polygon;
  std::vector<std::array<reference::Fraction, kModes>> vertices;  // one for each of the polygon
  std::vector<SamplePoint> points;
};

// With `points` points inside, the same for the same seed.
Wanted wanted_values(const reference::Truth& truth, const AttributeTriangle& triangle, int points,
                     std::uint64_t seed);

// The exact values at a point of the screen within the triangle. Pre-condition: w > 0 at all vertices, and the
// triangle has an area on the screen.
std::array<Exact, kModes> values_at(const reference::Truth& truth,
                                    const AttributeTriangle& triangle,
                                    const std::array<double, 2>& ndc);

}  // namespace clipscope::experiments
