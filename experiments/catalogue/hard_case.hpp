// SPDX-License-Identifier: GPL-3.0-or-later
//
// HardCase: one primitive that clippers are known to get wrong, the volume it is clipped against,
// and what comes out in exact arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/exact_clip.hpp"
#include "spaces/projection.hpp"
#include "spaces/vertex.hpp"
#include "spaces/volume.hpp"

namespace clipscope::experiments {

enum class Primitive { point, segment, triangle, polygon };
constexpr std::array<std::string_view, 4> names_of(Primitive) {
  return {"point", "segment", "triangle", "polygon"};
}

// 1, 2 and 3; 0 for polygons, which have any number from 3.
constexpr std::size_t vertices_of(Primitive primitive) {
  return primitive == Primitive::polygon ? 0 : static_cast<std::size_t>(primitive) + 1;
}

// A depth range as files of cases name it, by DepthRange.
inline constexpr std::array<std::string_view, 3> kDepthNames = {"gl", "zero_to_one", "reversed"};

// The side of that name: left, right, bottom or top; else none.
inline bool* find_side(OpenSides& sides, std::string_view name) {
  if (name == "left") return &sides.left;
  if (name == "right") return &sides.right;
  if (name == "bottom") return &sides.bottom;
  return name == "top" ? &sides.top : nullptr;
}

struct ExactOutcome {
  reference::Verdict verdict = reference::Verdict::rejected;
  std::size_t vertices = 0;  // of the exact polygon

  friend bool operator==(const ExactOutcome&, const ExactOutcome&) = default;
};

struct HardCase {
  std::string name;    // "theme/name", unique in a catalogue; the theme is the stem of the file
  std::string source;  // where it was met
  std::string why;     // what makes it hard
  Primitive primitive = Primitive::triangle;

  // Space::view or Space::clip. The frustum is of use in view space only and its numbers are
  // floats; frustum.depth is volume.depth in both spaces.
  // A matrix, where there is one, takes the place of the frustum; further planes count beside the
  // volume. A case of a catalogue has neither.
  Space space = Space::clip;
  Frustum<double> frustum;
  std::optional<MatrixRows<double>> matrix = {};
  ClipVolume volume;
  std::vector<std::array<double, 4>> planes = {};

  // Coordinates and attributes are floats. In view space position[3] is 1.
  // Attributes given in the file come first, the clip distances leading. Fewer than
  // kSceneAttributes are filled up to that number from l0, l1, l2, 1, where l is the barycentric
  // coordinate (1 at the vertex of that index, else 0); those of a polygon must be affine over it
  // and are filled up from x, y, z, w.
  std::vector<reference::InputVertex> vertices;
  int attribute_count = 0;

  ExactOutcome expected;  // what the exact reference says

  // Vertices of the exact result (x, y, z, 1/w) found by hand, in any order; empty if not done.
  std::vector<std::array<reference::Rational, 4>> by_hand;

  std::string file;      // where the case is written
  std::size_t line = 0;  // of its first line
};

// Whether the case starts in view space in front of a frustum.
inline bool has_frustum(const HardCase& c) { return c.space == Space::view && !c.matrix; }

// Gives the attributes from `given` on up to kSceneAttributes the values described above.
void fill_attributes(HardCase& hard_case, int given);

// What the case is clipped against, in exact numbers.
reference::Truth truth_of(const HardCase& hard_case);

reference::ExactPolygon exact_polygon(const HardCase& hard_case);

// Pre-condition: the case's coordinates and attributes are finite.
ExactOutcome exact_outcome(const HardCase& hard_case);

// The vertices as a triangle. Pre-condition: the case is a triangle.
reference::InputTriangle triangle_of(const HardCase& hard_case);

// "clipped 5", "accepted 3", "rejected".
std::string to_string(const ExactOutcome& outcome);
inline std::string to_string(Primitive primitive) {
  return std::string(names_of(primitive)[static_cast<std::size_t>(primitive)]);
}

}  // namespace clipscope::experiments
