// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a hard case, its exact result and a clipper's answer lie in each space, in exact numbers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/draw/panel.hpp"

namespace clipscope::experiments::hard_cases {

struct CaseGeometry {
  ExactShape input_view, input_clip;  // the primitive; no view space if the case is in clip space
  ExactShape visible_view, visible_clip, visible_ndc;  // the exact result
  ExactShape answer_ndc;                               // the finite vertices of the answer
  std::size_t answer_not_finite = 0;                   // how many are not

  // One entry for each vertex of the primitive.
  std::vector<bool> behind;         // w <= 0
  std::vector<std::string> places;  // "inside", "outside left near", "outside clip distance 0"
};

// exact: the case's result. answer: x y z 1/w of each vertex. Pre-condition: the case's numbers are
// finite.
CaseGeometry case_geometry(const HardCase& hard_case, const reference::ExactPolygon& exact,
                           const std::vector<std::array<double, 4>>& answer);

// An offset in NDC as px of a screen of 3840 x 2160.
std::array<reference::Rational, 2> to_screen(const ExactPosition& from, const ExactPosition& to);

// The vertices that are farthest apart on the screen, each taken with the nearest of the other
// polygon.
struct ScreenError {
  ExactPosition exact, answer;
  double px = 0;
};

// None if one of the two has no vertices, or if each vertex of one is a vertex of the other.
std::optional<ScreenError> largest_screen_error(const CaseGeometry& geometry);

// The view volume as an outline over x z, for the coordinate 0, or over y z, for 1: the edge in
// front, then the far one. Ends at infinity, or beyond it, are put at the distance given; with
// depth clamp both ends are off.
ExactShape frustum_outline(const HardCase& hard_case, double farthest, std::size_t coordinate);

}  // namespace clipscope::experiments::hard_cases
