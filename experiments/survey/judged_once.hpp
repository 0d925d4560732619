// SPDX-License-Identifier: GPL-3.0-or-later
//
// What contestants answer to the same primitives, each different answer judged once: many methods
// give the same bits for most primitives, and exact arithmetic is what judging spends its time in.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/cycle.hpp"

namespace clipscope::experiments {

// One for each contestant, in their order; clipped in parallel. Pre-condition: all take the batch.
inline std::vector<Answers> answers_of(const Contestants& contestants, const Batch& batch) {
  std::vector<Answers> answers(contestants.size(), Answers(kFormat<float>, 1));
  tbb::parallel_for(std::size_t{0}, contestants.size(),
                    [&](std::size_t c) { answers[c] = clip(*contestants[c], batch); });
  return answers;
}

// The judgements of one primitive's answers, as long as these live.
template <class Judgement>
class JudgedOnce {
 public:
  // judge(): called unless a polygon was judged before that has the same format and numbers, bit
  // for bit.
  template <class Judge>
  Judgement of(const PolygonView& polygon, const Judge& judge) {
    const auto known = std::ranges::find_if(
        judged_, [&](const auto& j) { return same_polygon(j.first, polygon); });
    if (known != judged_.end()) return known->second;
    judged_.emplace_back(polygon, judge());
    return judged_.back().second;
  }

 private:
  static bool same_polygon(const PolygonView& a, const PolygonView& b) {
    if (&a.format() != &b.format() || a.size() != b.size()) return false;
    if (a.failure() || b.failure()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!same_vertex(a[i], b[i], Likeness::by_bits)) return false;
    }
    return true;
  }

  std::vector<std::pair<PolygonView, Judgement>> judged_;
};

}  // namespace clipscope::experiments
