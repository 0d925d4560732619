// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the attributes of a clipped triangle are in truth, by mode of interpolation, and what
// clippers make of them, by treatment.
//
//   smooth         linear over the triangle: a/w and 1/w are linear on the screen
//   noperspective  linear on the screen: a' = (sum l_i w_i a_i) / (sum l_i w_i) at the weights l of
//                  the triangle. Hence a' w is linear over the triangle: a' is what a smooth
//                  attribute a w gives, times 1/w.
//   flat           the first vertex's value everywhere (the convention of Direct3D and Vulkan;
//                  OpenGL's default is the last)
//
// The truth is exact. The contestants interpolate attributes as smooth ones; the treatments are the
// ways in which a pipeline gets the other modes out of such a clipper, right or wrong. Only
// triangles with the right vertices are judged: those are matched in order, at the rotation that
// brings them closest. At points inside, the clipper's polygon is drawn as a fan: its values there
// are computed without rounding from its vertices, so that what is measured is the clipper's error
// alone.
//
// OpenGL 4.6 specification, section 13.7 "Clipping of shader outputs" and 14.6.1; Heckbert and
// Moreton, "Interpolation for Polygon Texture Mapping and Shading", 1991.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/survey/crossing.hpp"
#include "experiments/table/statistics.hpp"

namespace clipscope::experiments::attributes {

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

// One for each triangle, with `points` points inside, the same for the same seed.
std::vector<Wanted> wanted_values(std::span<const AttributeTriangle> triangles, int points,
                                  std::uint64_t seed);

// The exact values at a point of the screen within the triangle. Pre-condition: w > 0 at all
// vertices, and the triangle has an area on the screen.
std::array<Exact, kModes> values_at(const reference::Truth& truth,
                                    const AttributeTriangle& triangle,
                                    const std::array<double, 2>& ndc);

enum class Treatment : std::uint8_t {
  smooth,         // as it is; wanted and drawn: smooth
  times_w,        // a w through the clipper, times 1/w; wanted and drawn: noperspective
  noperspective,  // as it is, though wanted and drawn is noperspective
  flat            // the provoking vertex's value at all vertices; wanted and drawn: smooth
};
inline constexpr int kTreatments = 4;
constexpr std::array<std::string_view, kTreatments> names_of(Treatment) {
  return {"smooth", "a*w", "as is", "flat"};
}

// The errors of one treatment; `absolute` and `ulp` have one value for each vertex.
struct TreatmentErrors {
  LogHistogram absolute, ulp;
  double inside = 0;  // the largest at points inside, absolute
};

struct Tally {
  std::int64_t triangles = 0;  // with the right vertices
  std::int64_t wrong = 0;      // without
  std::array<TreatmentErrors, kTreatments> errors;

  // Triangles by what becomes of flat values that differ from vertex to vertex: the polygon's first
  // vertex carries another one than the triangle's; the last vertex of some triangle of its fan
  // does.
  std::int64_t first_changed = 0, last_changed = 0;
  // Triangles in which one value given to all vertices changed a bit.
  std::int64_t constant_changed = 0;

  double worst = 0;          // the largest absolute error of smooth attributes at a vertex
  std::size_t worst_at = 0;  // the triangle that it is on

  const TreatmentErrors& operator[](Treatment treatment) const {
    return errors[static_cast<std::size_t>(treatment)];
  }
};

// Clips the triangles and judges them in parallel; the result does not depend on the number of
// threads. Pre-condition: one Wanted for each triangle.
Tally measure_errors(const Contestant& contestant, std::span<const AttributeTriangle> triangles,
                     std::span<const Wanted> wanted);

}  // namespace clipscope::experiments::attributes
