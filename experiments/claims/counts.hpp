// SPDX-License-Identifier: GPL-3.0-or-later
//
// What claims of geometry are decided by: how many of so many exact cases are against them.
//
// All in rational numbers made from the bits of random input, against the exact reference: a count of 0
// is evidence, any other count holds counterexamples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clipscope::experiments {

// Of `cases` inputs `count` have the quality that `quantity` names.
struct ExactCount {
  std::string quantity;
  std::int64_t cases = 0, count = 0;
};

struct CountingTask {
  int claim = 0;
  std::string_view title;
  // `size`: about how many random inputs. The same seed and size give the same counts.
  std::vector<ExactCount> (*run)(std::uint64_t seed, std::size_t size);
};

const std::vector<CountingTask>& counting_tasks();

}  // namespace clipscope::experiments
