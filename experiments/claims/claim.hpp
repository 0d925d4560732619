// SPDX-License-Identifier: GPL-3.0-or-later
//
// Claims about clipping, as textbooks and papers make them, and how the tables of a run judge them.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/claims/evidence.hpp"
#include "experiments/claims/rows.hpp"
#include "experiments/claims/words.hpp"
#include "experiments/machine/measuring.hpp"
#include "experiments/table/results.hpp"

namespace clipscope::experiments::claims {

// Where a verdict was reached there is evidence.
struct Judgement {
  Verdict verdict = Verdict::undecided;
  // One sentence with at most two figures; of a claim that is true only under a condition, first
  // the condition.
  std::string because;
  std::vector<Evidence> evidence = {};
};

struct Claim {
  int number = 0;
  std::string_view statement;
  std::string_view experiment;  // where the figures come from
  // From the tables of a run alone; throws MissingFigure where a figure is not there.
  std::function<Judgement(const Results&)> judge;
};

// All claims, by number.
std::vector<Claim> all_claims();

// Undecided, naming what is missing, where a figure is not among the results.
Judgement judge(const Claim& claim, const Results& results);

// Runs under the clock behind a table of that name.
using RunsBehind = std::function<Interruptions(const std::string&)>;

// The same, and not settled where a table that it asks for has times, and the machine was busy when
// these were taken. The figures are kept.
Judgement judge(const Claim& claim, const Results::Source& tables, const RunsBehind& runs);

// Each claim with its judge, a source for each list.
std::vector<Claim> claims_about_cost();
std::vector<Claim> claims_about_segments();
std::vector<Claim> claims_about_geometry();
std::vector<Claim> claims_about_rounding();  // and about w and depth

// What judges share. First the clipper that stands for each of the three spaces: the same method,
// with the least it needs to be right.
inline constexpr std::string_view kViewSpace = "view/sutherland_hodgman";
inline constexpr std::string_view kClipSpace = "homogeneous/sutherland_hodgman";
inline constexpr std::string_view kCvv = "cvv/near_first";

// What is said with each verdict that a claim may get.
struct Sentences {
  std::string confirmed, conditional, refuted;
};

// Confirmed if all of the evidence holds; else true under a condition if that is met, or refuted.
Judgement judged(std::vector<Evidence> evidence, bool under_condition, const Sentences& sentences);

// In which of several cases (mixes, scenes) a claim holds.
class Cases {
 public:
  explicit Cases(Speak speak = spoken_triangles) : speak_(speak) {}

  // Pre-condition: the evidence is decided, and no other has its case.
  void add(Evidence evidence);

  // In words, see where_text; empty where the claim holds in all cases, or in none.
  std::string where() const;
  // Of the figures; and of those of the cases in which the claim holds, or fails: minus infinity
  // where there are none. Pre-condition: there is a case.
  double least() const;
  double most() const;
  double most_holding() const;
  double most_failing() const;
  // The case of the greatest figure, in words.
  std::string best() const;
  const std::vector<Evidence>& evidence() const { return evidence_; }

  // Confirmed if it holds in all cases, true only under a condition if in some. `also`: what is
  // told beside them.
  Judgement judge(const Sentences& sentences, const std::vector<Evidence>& also = {}) const;

 private:
  Speak speak_;
  std::vector<Evidence> evidence_;
  std::vector<std::string> holding_, failing_;  // cases by name
};

inline double sum(const std::vector<double>& figures) {
  return std::accumulate(figures.begin(), figures.end(), 0.0);
}

}  // namespace clipscope::experiments::claims
