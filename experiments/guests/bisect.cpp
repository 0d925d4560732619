// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/bisect.hpp"

#include <fmt/format.h>

#include <utility>

namespace clipscope::experiments {

void fail_all(std::size_t count, const Failure& failure, Answers& answers) {
  const Failure of_all{
      failure.kind,
      fmt::format("{}, in a batch of {} that was not looked into further", failure.reason, count)};
  for (std::size_t i = 0; i < count; ++i) answers.fail(of_all);
}

Bisection::Bisection(Ask ask, Keep keep, Answers& answers, Retries& retries)
    : ask_(std::move(ask)), keep_(std::move(keep)), answers_(answers), retries_(retries) {}

void Bisection::operator()(const Range& range) {
  if (range.count == 0) return;
  if (const auto failure = ask_(range)) {
    look_into(range, *failure);
  } else {
    keep_(range);
  }
}

void Bisection::look_into(const Range& range, const Failure& failure) {
  if (range.count == 1) return answers_.fail(failure);
  if (!may_ask(2, failure)) return fail_all(range.count, failure, answers_);
  const Range left{range.first, range.count / 2};
  const Range right{range.first + left.count, range.count - left.count};
  if (const auto of_left = ask_(left)) {
    look_into(left, *of_left);
    return (*this)(right);
  }
  keep_(left);
  if (const auto of_right = ask_(right)) return look_into(right, *of_right);
  blame_last_of_shortest(range, left.count, failure);
}

bool Bisection::may_ask(int times, const Failure& failure) {
  const bool is_endless = failure.kind == Failure::Kind::timed_out;
  const int price = times * (is_endless ? retries_.endless_price : 1);
  if (retries_.left < price) {
    retries_.left = 0;
    return false;
  }
  retries_.left -= price;
  return true;
}

// Both halves are answered by themselves; the answers to the first so many are kept.
void Bisection::blame_last_of_shortest(const Range& range, std::size_t kept, Failure failure) {
  std::size_t answered = kept, fails = range.count;
  while (fails - answered > 1 && may_ask(1, failure)) {
    const std::size_t middle = answered + (fails - answered) / 2;
    if (const auto found = ask_({range.first, middle})) {
      fails = middle;
      failure = *found;
    } else {
      answered = middle;
    }
  }
  const std::size_t blamed = fails - 1;
  (*this)({range.first + kept, blamed - kept});
  failure.reason += fmt::format(" after the {} before it, not alone", blamed);
  answers_.fail(failure);
  (*this)({range.first + fails, range.count - fails});
}

}  // namespace clipscope::experiments
