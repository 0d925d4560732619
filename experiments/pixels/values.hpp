// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of the pixels of triangles, points and lines, against the exact ones.
//
// What is legal, in this order:
//
//   1. the exact value, up to kInterpolation operations of 1 part in 10^5 on values of that size;
//   2. the exact value at a point that is no farther from the centre than a vertex may be displaced
//      (accuracy.hpp);
//   3. of a triangle that is clipped any convex combination of the clipped polygon's vertices
//      (OpenGL 4.6 core, 14.6.1: of a polygon with more than three edges "we require only" that).
//
// A number beyond all of them is outside_hull if it isn't between the values of the polygon's
// vertices either, and wrong_value otherwise. What is legal has its error counted in ulp.
//
// What specifications leave open is legal:
//
//   - gl_ClipDistance in a fragment shader is "linearly interpolated": with perspective or without;
//   - a depth outside of 0 to 1 may have been clamped; in the depth buffer it must have been where
//     depth clamp is on, in gl_FragCoord.z it may;
//   - facing follows the area "clipped or unclipped": of a triangle with one vertex, or three, at
//     w <= 0 the two differ, so neither is wrong; also where snapping could have turned a sliver;
//   - a vertex at w = 0 has no place in the window, so that nothing can "vary linearly" from there:
//     noperspective values of its primitive are any numbers;
//   - a flat value may lose precision in OpenGL ES (3.2, 13.7.1), where it is interpolated;
//   - numbers below the normal range may have become 0, numbers beyond 2^32 anything.
#pragma once

#include "experiments/pixels/coverage.hpp"

namespace clipscope::experiments {

// Everything that judging values needs to know and to write to.
struct ValueJudge {
  const DrawCall& call;
  const DriverInfo& info;
  const Pixels& pixels;
  Accusations& accusations;
  Judgement& judgement;
};

// Triangles and points. Of a pixel with several primitives the values are those of the last one;
// pixels where it isn't certain which one that is are left out.
void judge_values(const ValueJudge& judge, const std::vector<JudgedPrimitive>& primitives,
                  const CoverageMap& map);

}  // namespace clipscope::experiments
