// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/outcome.hpp"

#include <limits>
#include <string>
#include <tuple>
#include <utility>

namespace clipscope::experiments {

CallOutcome outcome_of(DriverPool& drivers, const DrawCall& call) {
  if (std::string reason = inability(drivers.info(), call); !reason.empty()) {
    return DrawFailure{DrawFailure::Kind::unable, std::move(reason)};
  }
  const Drawn drawn = drivers.draw(call);
  if (const auto* failure = std::get_if<DrawFailure>(&drawn)) return *failure;
  return judge_pixels(call, std::get<Pixels>(drawn), drivers.info());
}

std::optional<Violation> violation_of(const DrawFailure& failure) {
  const bool is_crash = failure.kind == DrawFailure::Kind::crashed;
  if (!is_crash && failure.kind != DrawFailure::Kind::timed_out) return std::nullopt;
  Violation violation;
  violation.kind = is_crash ? ViolationKind::crashed : ViolationKind::timed_out;
  violation.size = std::numeric_limits<double>::infinity();
  return violation;
}

std::vector<Violation> violations_of(const CallOutcome& outcome) {
  if (const auto* failure = std::get_if<DrawFailure>(&outcome)) {
    const auto violation = violation_of(*failure);
    return violation ? std::vector{*violation} : std::vector<Violation>();
  }
  const Judgement& judgement = std::get<Judgement>(outcome);
  return judgement.apart.empty() ? judgement.violations : std::vector<Violation>();
}

FindingKey key_of(const DrawCall& call, const Violation& violation) {
  return {violation.kind, violation.quantity, circumstances_of(call, violation.primitive)};
}

bool is_worse(const Violation& a, const Violation& b) {
  return std::tie(a.size, a.pixels) > std::tie(b.size, b.pixels);
}

}  // namespace clipscope::experiments
