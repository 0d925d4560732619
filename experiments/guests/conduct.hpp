// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the answers of a guest depend on beside its input: earlier calls, what lies beside a
// primitive, threads, what was in memory before. Nothing is what they should depend on.
//
// A lower bound: what is found is there, what is not found may be.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

struct Misconduct {
  std::size_t primitive = 0;  // of the batch
  std::string reason;         // a sentence without its full stop
};

// Asks about the whole batch: again, and in reversed order; of a plug-in also in a fresh process,
// with other numbers where its output goes and, if it says that it is safe there, in two threads at
// once. By primitive, the first of these whose answer has other bits. given: what it answered.
// Pre-condition: the contestant takes the batch, and computes in float or double.
std::vector<Misconduct> conduct(const Contestant& contestant, const Batch& batch,
                                const Answers& given);

// The numbers of a batch from its last primitive to its first.
std::vector<double> reversed_numbers(const Batch& batch);

}  // namespace clipscope::experiments
