// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `clipscope explain` says of one primitive: where it is in each space and what each cut
// leaves, and the answer of a clipper beside the exact one.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/compare.hpp"

namespace clipscope::experiments::commands {

// The vertices in view space, in clip space and divided, as the format computes them, and for a
// triangle each cut in each space. Goes to standard output.
void print_spaces(const HardCase& hard_case, const Format& format);

// Of each vertex: as given, in clip space as the format computes it, and the planes it is outside
// of.
nlohmann::json spaces_json(const HardCase& hard_case, const Format& format);

// A clipper's answer beside the exact one.
struct Explanation {
  const Contestant& contestant;
  PolygonView answer;
  const TruthPolygon& truth;
  Comparison comparison;
};

// What became of it, in one sentence; then a line for each coordinate of each vertex: the digits
// that are right, the exact value, the error. Of an empty answer the exact vertices. At most 100
// columns wide. Goes to standard output.
void print_answer(const Explanation& explanation);

nlohmann::json answer_json(const Explanation& explanation);

}  // namespace clipscope::experiments::commands
