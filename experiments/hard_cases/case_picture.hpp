// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture of one hard case: the primitive in view space, clip space and NDC, its exact result,
// and what a clipper makes of it.
//
// View space is seen from above and from the side (only for cases that start there). Clip space is
// seen as half-planes (x, w), (y, w) and, for cases that start there, (z, w), with the lines on
// which the planes of the volume lie: there, vertices with w <= 0 are points like any other. NDC is
// seen from the front, and beneath it magnified where exact result and answer are farthest apart.
//
// Panels show the surroundings of the volume and of the exact result; vertices too far off for that
// are arrows at the frame, with their coordinates beneath. Shapes are cut to the panels in exact
// arithmetic, so edges towards vertices at 1e37 are where they should be.
// Does not show: z and 1/w of the answer, and attributes; the line above the panels has their
// errors.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/compare.hpp"

namespace clipscope::experiments::hard_cases {

// What is drawn; the case must outlive it, and its numbers are finite.
struct CasePicture {
  const HardCase& hard_case;
  TruthPolygon truth;
  Comparison comparison;                      // of the answer with the truth
  std::vector<std::array<double, 4>> answer;  // x y z 1/w of each vertex
  std::string clipper;
  const Format& format;  // that the clipper computes in
};

// What the contestant makes of the case.
CasePicture picture_of(const HardCase& hard_case, const Contestant& contestant);

// Writes an SVG, a PDF or a PNG file as the path's extension says. It appears complete or not at
// all; a folder that is missing is made. Errors: UsageError for another extension (see
// page_format), OutputError if it can't be written; both name the path.
void write_case_picture(const std::filesystem::path& path, const CasePicture& picture);

}  // namespace clipscope::experiments::hard_cases
