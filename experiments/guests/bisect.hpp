// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which primitives of a batch does a guest fail on? Halves are asked again, depth first, until the
// primitives that fail are alone, or were asked about often enough.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "experiments/contestants/answers.hpp"

namespace clipscope::experiments {

struct Range {
  std::size_t first = 0, count = 0;
};

// Asks about all of the range at once. Null: its answers were added, in order; else nothing was.
using AskRange = std::function<std::optional<Failure>(const Range&)>;

// How often halves are asked at most: enough for five primitives far apart among 4,096. Where a
// question is not answered in time each half counts as four, which is enough for one. The count
// does not depend on time itself, so that the same input gives the same outcomes.
inline constexpr int kMostHalvesAsked = 128, kEndlessCount = 4;

// Asks about the range; each primitive gets its answer, or its failure in `answers`, in order. What
// is not narrowed down any more fails as a whole, and says so.
class Bisection {
 public:
  Bisection(AskRange ask, Answers& answers) : ask_(std::move(ask)), answers_(answers) {}

  void operator()(const Range& range) {
    std::optional<Failure> failure = ask_(range);
    if (!failure) return;
    if (range.count == 1) return answers_.fail(std::move(*failure));
    const int price = 2 * (failure->kind == Failure::Kind::timed_out ? kEndlessCount : 1);
    if (halves_left_ < price) return fail_all(range, *failure);
    halves_left_ -= price;
    const std::size_t half = range.count / 2;
    (*this)({range.first, half});
    (*this)({range.first + half, range.count - half});
  }

 private:
  void fail_all(const Range& range, const Failure& failure) {
    for (std::size_t i = 0; i < range.count; ++i) {
      answers_.fail({failure.kind, failure.reason + "; it was asked about " +
                                       std::to_string(range.count) +
                                       " primitives at once, and not which of them it fails on"});
    }
  }

  AskRange ask_;
  Answers& answers_;
  int halves_left_ = kMostHalvesAsked;
};

}  // namespace clipscope::experiments
