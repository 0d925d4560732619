// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which primitives of a batch does a guest fail on? Halves are asked again until the primitives
// that fail are alone, or were asked about often enough. What only a batch brings about is blamed
// on the primitive that ends the shortest batch which does.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "experiments/contestants/answers.hpp"

namespace clipscope::experiments {

struct Range {
  std::size_t first = 0, count = 0;
};

// How often a guest is asked again. It does not depend on time itself, so that the same input gives
// the same outcomes.
struct Retries {
  int left = 0;
  int endless_price = 1;  // as so many counts a question that follows one not answered in time

  bool are_spent() const { return left <= 0; }
};

// Of each primitive in the range: no answer, since all of it failed and was not narrowed down.
void fail_all(std::size_t count, const Failure& failure, Answers& answers);

class Bisection {
 public:
  // Asks about all of the range at once; nothing where it was answered.
  using Ask = std::function<std::optional<Failure>(const Range&)>;
  // Adds the answers to the range, which was asked about last.
  using Keep = std::function<void(const Range&)>;

  Bisection(Ask ask, Keep keep, Answers& answers, Retries& retries);

  // Adds the answer or the failure of each primitive, in order.
  void operator()(const Range& range);
  // The same of a range that was asked about, and failed.
  void look_into(const Range& range, const Failure& failure);

 private:
  bool may_ask(int times, const Failure& failure);
  void blame_last_of_shortest(const Range& range, std::size_t kept, Failure failure);

  Ask ask_;
  Keep keep_;
  Answers& answers_;
  Retries& retries_;
};

}  // namespace clipscope::experiments
