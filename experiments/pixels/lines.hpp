// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of width 1, by the rules that all drivers keep that keep any.
//
// The ideal is the diamond-exit rule, but what may be drawn instead is wide (OpenGL 4.6 core,
// 14.5.1, rules 1 to 3; OpenGL ES 3.2, 13.6.1; Vulkan 1.3 without strictLines: a parallelogram or
// Bresenham's lines). Here a line must
//
//   - have no fragment more than 3/2 px away from it in x or in y: half a px has the diamond, one
//     px the rule that lets fragments deviate (extra);
//   - have at most one fragment fewer than the ideal one in the part of the view volume (missing,
//     or primitive_lost if there is none);
//   - have no two fragments in one column if it is x-major, or one row if it is y-major (extra).
//
// The last two are asked of lines that are alone in their draw call. Vulkan's lines are polygons a
// px wide whose corners are snapped each on its own, so that a column may have two fragments, and
// must have one only where a centre is that much inside. Values may be those at any point within
// 3/2 px, or between those of the ends of the clipped line where it is clipped.
//
// OpenGL clips lines to the view volume; OpenGL ES to near and far, so that there fragments beside
// the viewport are open. In Vulkan a line whose vertices lie outside "may" be clipped, but nothing
// is drawn outside of the clip volume: there fragments beside the viewport are open, too, and
// beyond the depths, as long as both ends have w > 0.
#pragma once

#include "experiments/pixels/coverage.hpp"

namespace clipscope::experiments {

// Whether a line of OpenGL ES has an end that is divided by 0. It is clipped to near and far alone
// (3.2, 12.5), which leaves an end with w = 0 = z, and what a division by 0 gives is unspecified
// (2.3.4.6). OpenGL clips it to the sides first.
bool is_divided_by_zero(const DrawCall& call, std::span<const std::uint32_t> vertices,
                        const DriverInfo& info);

// Covers nothing for certain. If rounding could move an end by more than 1/4 px, all is open.
Region line_region(const DrawCall& call, std::span<const std::uint32_t> vertices,
                   const DriverInfo& info);

// The rules about numbers of fragments. Of missing ones the worst pixel's values are the least
// number that the whole line must have and the one that it has; of several in a column (or, its
// channel 1, in a row) 1 and their number.
void judge_lines(const DrawCall& call, const std::vector<JudgedPrimitive>& primitives,
                 const Pixels& pixels, const DriverInfo& info, Accusations& accusations);

}  // namespace clipscope::experiments
