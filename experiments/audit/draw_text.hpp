// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draw calls, violations and drivers in words.
#pragma once

#include <string>

#include "experiments/audit/audit.hpp"

namespace clipscope::experiments {

// "triangles (0,0,0.5,1) (4,0,0.5,1) (0,4,1,2), 32 x 32 px": topology, clip coordinates, target,
// and whatever is unusual. So many vertices at most; the rest are counted.
std::string draw_text(const DrawCall& call, std::size_t most_vertices = 6);

// "pixel (3, 4) is NaN, exact 0.25".
std::string pixel_text(const Violation& violation);

// "OpenGL 4.6 core, section 14.6.1".
std::string section_text(const Clause& clause);

// "OpenGL 4.5 core".
std::string api_text(const DriverInfo& info);

// "llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6, OpenGL 4.5 core, 8 sub-pixel bits".
std::string driver_text(const DriverInfo& info);

// "smooth not_finite: triangle, clipped".
std::string finding_text(const FindingKey& key);

// The same for names of files and cases: "smooth_not_finite_triangle_clipped".
std::string file_stem(std::string finding_text);

}  // namespace clipscope::experiments
