// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/claim.hpp"

#include <fmt/format.h>

#include "experiments/claims/judges.hpp"

namespace clipscope::experiments {

const std::vector<Claim>& all_claims() {
  static const std::vector<Claim> all = {
      {1, "View-space clipping needs the most computation.", "cost", judge_view_needs_most},
      {2, "Clip-space clipping needs the least and is the most efficient.", "cost",
       judge_clip_needs_least},
      {3, "CVV clipping is less efficient than clip-space clipping.", "cost",
       judge_cvv_less_efficient},
      {4, "CVV clipping must account for perspective correction.", "perspective",
       judge_perspective},
      {5, "Inside is -w <= x, y, z <= w.", "claims", judge_inside},
      {6,
       "Cutting edges in order and fanning keeps the winding, so back-face culling is unaffected.",
       "claims", judge_winding},
      {7, "Dropping whole triangles is cheap but leaves visible holes at the border.", "pictures",
       judge_dropping_whole},
      {8, "A triangle with one vertex outside one plane becomes two triangles.", "claims",
       judge_two_triangles},
      {9, "Attributes are interpolated with the same t as positions.", "claims", judge_same_t},
      {10,
       "The side planes of the frustum have normals (-+cos(a/2), 0, sin(a/2)) with the vertical "
       "angle a of top and bottom.",
       "claims", judge_side_normals},
      {11, "An extra plane w = 1e-5 in front of the six prevents division by zero.", "w_sign",
       judge_w_plane_prevents},
      {12, "Clipping plane after plane, each output the next input, is enough.", "claims",
       judge_plane_after_plane},
      {13,
       "Cohen-Sutherland rejects most segments without any intersection when the window is small; "
       "it "
       "repeats work when a segment must be shortened several times.",
       "segments", judge_line_outcodes},
      {14, "Liang-Barsky accepts and rejects as cheaply, and divides only when it shortens.",
       "segments", judge_liang_barsky},
      {15, "A pipeline of independent plane clippers adds little latency.", "cost", judge_pipeline},
      {16, "A convex polygon clips to at most one convex polygon; a concave one may yield several.",
       "claims", judge_parts},
      {17, "Bounding volumes settle most objects without touching their polygons.", "bounds",
       judge_bounds},
      {18,
       "A general plane-segment intersection costs 6 multiplications and 1 division; in a "
       "normalised "
       "(also oblique) volume 1 division.",
       "segments", judge_plane_segment},
      {19, "Clipping before the divide spares divisions for vertices outside.", "cost",
       judge_divisions_spared},
      {20, "w <= 0 must be dealt with first, and cutting the near plane first does it.",
       "plane_order", judge_near_first},
      {21,
       "Any order gives the same result: points wrongly accepted by five planes fall at the near "
       "plane.",
       "plane_order", judge_any_order},
      {22,
       "For points only near and far are tested; for triangles and segments x and y may be left to "
       "the rasteriser.",
       "guard_band", judge_sides_left},
      {23,
       "z' = ((f+n)/(f-n) z + 2fn/(n-f)) is linear in z and monotone after the divide, so it "
       "serves "
       "for depth; a z' quadratic in z does not.",
       "depth", judge_linear_depth},
      {24,
       "A straight line stays straight in clip space with the same t, so attributes cut there "
       "equal "
       "those cut in camera space.",
       "claims", judge_straight_lines},
      {25,
       "With the accept rule x + w >= 0 the denominator of t never vanishes, though x/w = -1 may "
       "have "
       "no solution.",
       "claims", judge_denominator},
      {26, "Six planes leave at most 9 vertices, 7 triangles.", "claims", judge_nine_vertices},
      {27, "Clip-space and view-space clipping give the same result.", "claims", judge_same_result},
      {28,
       "A point with z_view = 0, such as (1, 1, 0) with l = b = -1, r = t = 1, n = 1, f = 10, has "
       "clip coordinates (1, 1, -2.2222, 0) and can't be divided.",
       "claims", judge_point_at_eye},
      {29,
       "Geometric clipping can be avoided by 2D homogeneous rasterisation, 33 % faster (Olano and "
       "Greer 1997).",
       "claims", judge_clipless},
      {30,
       "Reversed depth with a float buffer is the more precise choice (Upchurch and Desbrun 2012).",
       "depth", judge_reversed_depth},
      {31,
       "Floating-point filters make exact decisions at most about twice as slow, near free in "
       "practice (Shewchuk 1997; Bronnimann, Burnikel and Pion 2001).",
       "cost", judge_filters},
      {32, "Correct rounding is expensive (experience with mathematical libraries).", "frontier",
       judge_correct_rounding},
      {33, "A plane w >= 1/16384 or w >= 1e-5 is harmless.", "hard_cases", judge_w_plane_harmless}};
  return all;
}

Finding judge(const Claim& claim, const Results& results) {
  try {
    return claim.judge(results);
  } catch (const MissingFigure& missing) {
    return {ClaimVerdict::undecided, fmt::format("{}.", missing.what())};
  }
}

}  // namespace clipscope::experiments
