// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture of a crack: two clipped neighbours on the screen, and the place where they part, magnified.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/watertight/measure.hpp"

namespace clipscope::experiments {

struct CrackPicture {
  ClippedPair pair;
  std::string title;  // whose crack, and where: one line
};

// By the path's extension an SVG, a PDF or a PNG file, which appears complete or not at all.
// Pre-condition: the crack is wider than 0. Errors: UsageError for another extension, OutputError.
void write_crack_picture(const std::filesystem::path& path, const CrackPicture& picture);

}  // namespace clipscope::experiments
