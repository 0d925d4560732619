// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture of the volume that a matrix encloses, in the axes of its camera: from above and from
// the side, with the eye, the planes and their distances.
//
// Does not show: skew, oblique depth planes and roundings; a far plane that is much farther than
// near is left out of the window and named beneath.
#pragma once

#include <filesystem>

#include "experiments/camera/matrix_meaning.hpp"

namespace clipscope::experiments {

// Writes an SVG, a PDF or a PNG file as the path's extension says. Errors: UsageError for another
// extension, and where the matrix encloses no volume; OutputError.
void write_frustum_picture(const std::filesystem::path& path, const MatrixMeaning& meaning);

}  // namespace clipscope::experiments
