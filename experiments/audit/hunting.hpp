// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hunting through an audit's eyes: draw calls that the driver gets more wrong than those met so
// far, or wrong in a way not met yet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "experiments/audit/audit.hpp"

namespace clipscope::experiments {

struct HuntingOptions {
  std::size_t evaluations = 1000;  // draw calls drawn and judged
  std::uint64_t seed = 1;
};

// Begins with the worst of each finding, those whose legal values are farthest off, and some of
// the others (hunted_draws in experiments/workloads/hunted.hpp, several hunts at once); `calls` are
// those that the audit has seen. Returns what became worse and what is violated in a way that no
// finding has, for the audit to draw like any other,
// each called "beginning (hunted 3)". Deterministic as far as the driver is.
// Errors: those of the pool.
std::vector<DrawCall> hunted_calls(DriverPool& drivers, std::span<const DrawCall> calls,
                                   const Audit& audit, const HuntingOptions& options);

}  // namespace clipscope::experiments
