// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program is told of a batch, in environment variables. None of them is left unset but those
// of the other space.
//
//   CLIPSCOPE_SPACE           clip (x y z w) or view (x y z)
//   CLIPSCOPE_PRIMITIVE       triangle, segment, point or polygon
//   CLIPSCOPE_SCALAR          float or double: what numbers are rounded to, and how it is judged
//   CLIPSCOPE_DEPTH           gl (-w <= z <= w), zero_to_one (0 <= z <= w) or reversed (the same,
//                             near at 1)
//   CLIPSCOPE_ATTRIBUTES      how many each vertex has
//   CLIPSCOPE_CLIP_DISTANCES  the first so many of them clip: inside is >= 0
//   CLIPSCOPE_DEPTH_CLAMP     which planes do not clip: near, far, "near,far" or nothing
//   CLIPSCOPE_HALF_OPEN       which sides do not own their points: some of left,right,bottom,top
//   CLIPSCOPE_POINT_SIZE, CLIPSCOPE_VIEWPORT  of points with a size: px, and "WxH"
//
// In view space:
//   CLIPSCOPE_FRUSTUM or CLIPSCOPE_ORTHO  left,right,bottom,top,near,far; far may be inf
//   CLIPSCOPE_SHEAR           x,y of an oblique parallel projection; 0,0 of others
//   CLIPSCOPE_MATRIX          the same to clip space: 16 numbers, row by row
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/contestants/batch.hpp"
#include "experiments/guests/program_text.hpp"

namespace clipscope::experiments {

inline constexpr std::string_view kProgramVariables = "CLIPSCOPE_";

// "NAME=value" of each. input: the batch as the program gets it.
std::vector<std::string> program_environment(const Batch& batch, const GuestInput& input,
                                             const ProgramForm& form);

}  // namespace clipscope::experiments
