// SPDX-License-Identifier: GPL-3.0-or-later
//
// Claims about clipping, as textbooks and papers make them, and how the tables of a run judge them.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/claims/rows.hpp"
#include "experiments/table/results.hpp"

namespace clipscope::experiments::claims {

struct Judgement {
  Verdict verdict = Verdict::undecided;
  std::string because;  // one or two sentences with the figures that decide it
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

// Each claim with its judge, a source for each of the two.
std::vector<Claim> claims_about_cost();
std::vector<Claim> claims_about_geometry();  // and about rounding, w and depth

// What judges share. First the clipper that stands for each of the three spaces: the same method,
// with the least it needs to be right.
inline constexpr std::string_view kViewSpace = "view/sutherland_hodgman";
inline constexpr std::string_view kClipSpace = "homogeneous/sutherland_hodgman";
inline constexpr std::string_view kCvv = "cvv/near_first";

// `figures`: the format of the figures that follow.
template <class... Args>
Judgement confirmed_if(bool holds, fmt::format_string<Args...> figures, Args&&... args) {
  return {holds ? Verdict::confirmed : Verdict::refuted,
          fmt::format(figures, std::forward<Args>(args)...)};
}

// Else true only when the condition holds: a sentence that is put before the figures.
template <class... Args>
Judgement true_only_when(std::string_view condition, bool under_it, bool always,
                         fmt::format_string<Args...> figures, Args&&... args) {
  Judgement judgement = confirmed_if(always, figures, std::forward<Args>(args)...);
  if (under_it && !always) {
    judgement = {Verdict::conditional, std::string(condition) + judgement.because};
  }
  return judgement;
}

// In which of several cases (mixes, scenes) a claim holds, and the figures of each.
class Cases {
 public:
  void add(const std::string& name, bool holds, const std::string& figures = "") {
    ++all_;
    if (holds) holds_.push_back(name);
    figures_.push_back(figures);
  }
  std::string figures(std::string_view separator) const {
    return fmt::format("{}", fmt::join(figures_, separator));
  }
  // True only in the cases where it holds, which stand for the {} in `condition`: "The mix is {}.
  // ".
  template <class... Args>
  Judgement judge(std::string_view condition, fmt::format_string<Args...> figures,
                  Args&&... args) const {
    return true_only_when(fmt::format(fmt::runtime(condition), fmt::join(holds_, ", ")),
                          !holds_.empty(), holds_.size() == all_, figures,
                          std::forward<Args>(args)...);
  }

 private:
  std::size_t all_ = 0;
  std::vector<std::string> holds_, figures_;
};

inline double sum(const std::vector<double>& figures) {
  return std::accumulate(figures.begin(), figures.end(), 0.0);
}

}  // namespace clipscope::experiments::claims
