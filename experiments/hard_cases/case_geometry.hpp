// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a hard case, its exact result and a clipper's answer lie in each space, in exact numbers.
//
// Everything is rational, so that shapes with vertices at 1e37 and at 1e-40 can be cut to a window of
// any size without losing an edge.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/hard_cases/judge.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments {

// (x, y, z, 1) in view space, (x, y, z, w) in clip space, (x, y, z, 1/w) in NDC.
using ExactPosition = std::array<reference::Rational, 4>;
using ExactShape = std::vector<ExactPosition>;

struct CaseGeometry {
  ExactShape input_view, input_clip;  // the primitive; no view space if the case is in clip space
  ExactShape visible_view, visible_clip, visible_ndc;  // the exact result
  ExactShape answer_ndc;                               // the finite vertices of the answer
  std::size_t answer_not_finite = 0;                   // how many are not

  // By vertex of the primitive.
  std::vector<bool> behind;         // w <= 0
  std::vector<std::string> places;  // "inside", "outside left near", "outside clip distance 0"
};

// Pre-condition: the case's numbers are finite.
CaseGeometry case_geometry(const HardCase& hard_case, const TruthPolygon& truth,
                           const CaseAnswer& answer);

// The vertices that are farthest apart on the screen, each taken with the nearest of the other polygon.
struct ScreenError {
  ExactPosition exact, answer;
  double px = 0;  // on a screen of 3840 x 2160
};

// None if one of the two has no vertices, or if each vertex of one is a vertex of the other.
std::optional<ScreenError> largest_screen_error(const CaseGeometry& geometry);

// An offset in NDC as px of the screen.
std::array<reference::Rational, 2> to_screen(const ExactPosition& from, const ExactPosition& to);

// The view volume as outlines over x z and over y z: the edge in front, then the far one. Ends at
// infinity, or beyond it, are put at the distance given; with depth clamp both ends are off.
ExactShape frustum_from_above(const HardCase& hard_case, double farthest);
ExactShape frustum_from_the_side(const HardCase& hard_case, double farthest);

}  // namespace clipscope::experiments
