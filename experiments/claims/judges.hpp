// SPDX-License-Identifier: GPL-3.0-or-later
//
// How each claim is judged: one function per claim, from the tables of a run alone. The functions throw
// MissingFigure where a figure is not there.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/claims/claim.hpp"

namespace clipscope::experiments {

// The clipper that stands for each of the three spaces: the same method, with the least it needs to be
// right.
inline const std::string kViewSpace = "view/sutherland_hodgman";
inline const std::string kClipSpace = "homogeneous/sutherland_hodgman";
inline const std::string kCvv = "cvv/near_first";
inline const std::string kBarycentric = "barycentric/distance_matrix";  // a fourth, beside them

inline const std::string kCountsTable = "claims_counts";

// Confirmed if it holds in all of them, refuted if in none, else true only when it holds.
ClaimVerdict verdict_of(std::size_t holds, std::size_t of);

// In which of several cases (mixes, scenes) a claim holds, and the figures of each.
class Cases {
 public:
  void note(const std::string& name, bool holds, const std::string& figures);

  // The figures, comma-separated or with another separator.
  std::string figures(std::string_view separator = ", ") const;
  // The verdict, with `because`; where it holds in some cases only, these are named in front of it, in
  // place of the {} in `condition`: "The mix is {}. "
  Finding finding(std::string_view condition, const std::string& because) const;

 private:
  std::size_t all_ = 0;
  std::vector<std::string> holds_, figures_;
};

// Claims about time and operations.
Finding judge_view_needs_most(const Results& results);     // 1
Finding judge_clip_needs_least(const Results& results);    // 2
Finding judge_cvv_less_efficient(const Results& results);  // 3
Finding judge_dropping_whole(const Results& results);      // 7
Finding judge_line_outcodes(const Results& results);       // 13
Finding judge_liang_barsky(const Results& results);        // 14
Finding judge_pipeline(const Results& results);            // 15
Finding judge_bounds(const Results& results);              // 17
Finding judge_plane_segment(const Results& results);       // 18
Finding judge_divisions_spared(const Results& results);    // 19
Finding judge_clipless(const Results& results);            // 29
Finding judge_filters(const Results& results);             // 31
Finding judge_correct_rounding(const Results& results);    // 32

// Claims about geometry.
Finding judge_perspective(const Results& results);        // 4
Finding judge_inside(const Results& results);             // 5
Finding judge_winding(const Results& results);            // 6
Finding judge_two_triangles(const Results& results);      // 8
Finding judge_same_t(const Results& results);             // 9
Finding judge_side_normals(const Results& results);       // 10
Finding judge_plane_after_plane(const Results& results);  // 12
Finding judge_parts(const Results& results);              // 16
Finding judge_sides_left(const Results& results);         // 22
Finding judge_straight_lines(const Results& results);     // 24
Finding judge_denominator(const Results& results);        // 25
Finding judge_nine_vertices(const Results& results);      // 26
Finding judge_same_result(const Results& results);        // 27
Finding judge_point_at_eye(const Results& results);       // 28

// Claims about w, depth and rounding.
Finding judge_w_plane_prevents(const Results& results);  // 11
Finding judge_near_first(const Results& results);        // 20
Finding judge_any_order(const Results& results);         // 21
Finding judge_linear_depth(const Results& results);      // 23
Finding judge_reversed_depth(const Results& results);    // 30
Finding judge_w_plane_harmless(const Results& results);  // 33

}  // namespace clipscope::experiments
