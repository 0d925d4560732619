// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of one draw call: it is judged, or there are no pixels.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "experiments/audit/circumstances.hpp"
#include "experiments/audit/driver_pool.hpp"
#include "experiments/pixels/judgement.hpp"

namespace clipscope::experiments {

using CallOutcome = std::variant<Judgement, DrawFailure>;

// Draws and judges; a driver of that kind is not asked for what it can't do. For any thread.
// Errors: those of the pool.
CallOutcome outcome_of(DriverPool& drivers, const DrawCall& call);

// A crash or a time-out as a violation of the whole draw call; nothing for the others.
std::optional<Violation> violation_of(const DrawFailure& failure);

// All violations of the draw call; none of a case that is scored apart.
std::vector<Violation> violations_of(const CallOutcome& outcome);

// What makes violations one finding: it is violated in this way, in these circumstances.
struct FindingKey {
  ViolationKind kind = ViolationKind::missing;
  Quantity quantity = Quantity::covered;
  Circumstances circumstances = {};

  friend auto operator<=>(const FindingKey&, const FindingKey&) = default;
};
FindingKey key_of(const DrawCall& call, const Violation& violation);

// Farther beyond what is allowed, or as far in more pixels.
bool is_worse(const Violation& a, const Violation& b);

}  // namespace clipscope::experiments
