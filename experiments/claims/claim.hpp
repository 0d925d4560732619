// SPDX-License-Identifier: GPL-3.0-or-later
//
// Claims about clipping, as textbooks and papers make them, and the verdict that the results give on
// each.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/report/results.hpp"

namespace clipscope::experiments {

enum class ClaimVerdict : std::uint8_t {
  confirmed,    // in everything that was measured
  conditional,  // true only when ...
  refuted,      // in everything that was measured, or by a counterexample
  undecided     // a figure that it needs is not among the results
};

constexpr std::string_view verdict_text(ClaimVerdict verdict) {
  constexpr std::array<std::string_view, 4> kTexts = {"confirmed", "true only when", "refuted",
                                                      "undecided"};
  return kTexts[static_cast<std::size_t>(verdict)];
}

// What the figures say.
struct Finding {
  ClaimVerdict verdict = ClaimVerdict::undecided;
  std::string because;  // one or two sentences with the figures that decide it
};

struct Claim {
  int number = 0;
  std::string_view statement;
  std::string_view experiment;  // where the figures come from
  Finding (*judge)(const Results&);
};

// All claims, by number.
const std::vector<Claim>& all_claims();

// The claim's finding; undecided, naming what is missing, where a figure is not among the results.
Finding judge(const Claim& claim, const Results& results);

}  // namespace clipscope::experiments
