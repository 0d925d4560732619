// SPDX-License-Identifier: GPL-3.0-or-later
//
// The panels of the picture of a hard case; see case_picture.hpp.
//
// Colours: Okabe and Ito, "Color Universal Design", 2008; what matters differs in lightness, dashes
// or shape too, for print in grey.
#pragma once

#include "experiments/draw/panel.hpp"
#include "experiments/hard_cases/case_geometry.hpp"
#include "experiments/hard_cases/case_picture.hpp"

namespace clipscope::experiments::hard_cases {

inline constexpr double kSmallPanel = 270, kLargePanel = 400;  // sides
inline constexpr double kTickRoom = 50, kUnderPanel = 80;      // left of and beneath a panel

inline constexpr Colour kBlack = {0x000000}, kGrey = {0x555555}, kVolumeFill = {0xf0f0f0},
                        kHatch = {0xb0b0b0}, kPlane = {0x707070}, kExactFill = {0x9fd3f2},
                        kExactEdge = {0x0072b2}, kAnswer = {0xd55e00}, kGrid = {0xc8c8c8};
inline constexpr Pen kPlanePen = {kPlane, 1.2}, kInputPen = {kBlack, 1.3},
                     kDividedPen = {kBlack, 1, 3}, kExactPen = {kExactEdge, 1},
                     kExactThinPen = {kExactFill, 6}, kAnswerPen = {kAnswer, 2.2, 7};

struct CaseSketch {
  const CasePicture& picture;
  VectorPage& page;
  CaseGeometry geometry;

  bool in_view_space() const { return has_frustum(picture.hard_case); }
};

// Two panels, one above the other, with the top left corner of the first frame.
void draw_view_space(CaseSketch& sketch, Spot corner);
// One panel: the coordinate (0 to 2) and w.
void draw_clip_space(CaseSketch& sketch, Spot corner, std::size_t coordinate);
// A panel of kLargePanel, and beneath it the largest error on the screen magnified, or in words; as
// high as two small panels.
void draw_ndc(CaseSketch& sketch, Spot corner);

void draw_eye(VectorPage& page, Spot at);

}  // namespace clipscope::experiments::hard_cases
