// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture of one hard case: the primitive in view space, clip space and NDC, its exact result, and
// what a clipper makes of it.
//
// View space is seen from above and from the side (only for cases that start there). Clip space is
// seen as half-planes (x, w), (y, w) and, for cases that start there, (z, w), with the lines on which
// the planes of the volume lie: there, vertices with w <= 0 are points like any other. NDC is seen
// from the front, and beneath it magnified where exact result and answer are farthest apart.
//
// Panels show the surroundings of the volume and of the exact result; vertices too far off for that
// are arrows at the frame, with their coordinates beneath. Shapes are cut to the panels in exact
// arithmetic, so edges towards vertices at 1e37 are where they should be.
// Does not show: z and 1/w of the answer, and attributes; the line above the panels has their errors.
//
// Colours: Okabe and Ito, "Color Universal Design", 2008; what matters differs in lightness, dashes
// or shape too, for print in grey.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/hard_cases/judge.hpp"
#include "experiments/measure/compare.hpp"

namespace clipscope::experiments {

// What is drawn; what the references refer to must outlive it.
struct CasePicture {
  const HardCase& hard_case;  // its numbers are finite
  const TruthPolygon& truth;  // of that case
  const CaseAnswer& answer;   // to that case
  std::string clipper, scalar;
};

// Errors: UsageError unless the extension is .svg, .pdf or .png.
void check_picture_path(const std::filesystem::path& path);

// By the path's extension an SVG, a PDF or a PNG file, which appears complete or not at all; a folder
// that is missing is made. Errors: UsageError for another extension, OutputError if it can't be
// written; both name the path.
void write_case_picture(const std::filesystem::path& path, const CasePicture& picture);

}  // namespace clipscope::experiments
