// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture of a finding: what the driver drew around the worst pixel, what is right, where the two
// differ, and the violated primitive in clip space, x and y over w, where a vertex behind the eye
// is a point like any other.
//
// What is right is drawn by our own rasteriser, with the driver's sub-pixel bits; colours can't
// tell it from the exact values, which the violation was judged by.
#pragma once

#include <filesystem>

#include "experiments/audit/audit.hpp"

namespace clipscope::experiments {

// pixels: what the driver made of the finding's example. Writes an SVG, a PDF or a PNG file as the
// extension says, complete or not at all. Errors: UsageError for another one; OutputError.
void write_finding_picture(const std::filesystem::path& path, const Audit& audit,
                           const DriverFinding& finding, const Pixels& pixels);

}  // namespace clipscope::experiments
