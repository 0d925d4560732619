// SPDX-License-Identifier: GPL-3.0-or-later
//
// Published rankings: who is said to be faster than whom, by how much, in what field.
//
// A ranking is judged on every mix of its field: the paper's kind of input, random segments in a
// box, and ours, segments of one kind. It holds on a mix if the method is that much faster than
// each of the others, beyond the intervals of both.
#pragma once

#include <string_view>
#include <vector>

#include "experiments/claims/claim.hpp"

namespace clipscope::experiments::claims {

// Where methods are timed: segments in the plane, against convex polygons of the plane, from view
// space to NDC; triangles from view space to NDC, and in the stage of a renderer, by copy.
enum class Field { plane, convex_windows, segments, triangles, stage };

struct Ranking {
  int number = 0;
  std::string_view statement;  // with the source
  Field field = Field::plane;
  std::string_view method;
  std::vector<std::string_view> others;
  double times_as_fast = 1;  // at least; 1: any faster
};

// By number.
std::vector<Ranking> published_rankings();

// Throws MissingFigure where a time is not among the results.
Judgement judge(const Ranking& ranking, const Results& results);

// The claims of the literature on clippers: the rankings, and what is said of divisions and steps.
std::vector<Claim> claims_of_the_literature();

// What the verdicts say together.
std::string finding_text(const std::vector<Row>& claims);

}  // namespace clipscope::experiments::claims
