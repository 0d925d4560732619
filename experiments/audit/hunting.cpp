// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/hunting.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "experiments/machine/progress.hpp"
#include "experiments/survey/sweep.hpp"
#include "experiments/workloads/hunted.hpp"
#include "experiments/workloads/plain_call.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kHunts = 8;       // at once, each with beginnings and a seed of its own
constexpr std::size_t kOthers = 64;     // beginnings that nothing speaks for
constexpr std::size_t kMostHunted = 9;  // of a beginning: meshes are slow to judge

using Keys = std::set<FindingKey>;

std::vector<DrawCall> beginnings_of(std::span<const DrawCall> calls, const Audit& audit) {
  std::vector<DrawCall> beginnings;
  std::set<std::string> names;
  const auto add = [&](const DrawCall& call) {
    const bool is_small = !call.vertices.empty() && call.vertices.size() <= kMostHunted;
    if (is_small && names.insert(call.name).second) beginnings.push_back(call);
  };
  for (const DriverFinding& finding : audit.findings) add(finding.worst.call);
  for (const QuantityErrors& errors : audit.errors) {
    const auto worst = std::ranges::find(calls, errors.worst_case, &DrawCall::name);
    if (worst != calls.end()) add(*worst);
  }
  const std::size_t stride = std::max<std::size_t>(1, calls.size() / kOthers);
  for (std::size_t i = 0; i < calls.size(); i += stride) add(calls[i]);
  return beginnings;
}

// Of legal values far less than of any violation. One that allows nothing says nothing of how far
// it is off, so that it is no better to begin with than the least.
double error_of(const Judgement& judgement) {
  constexpr double kOfLegal = 0x1p-40;
  double error = 0;
  if (!judgement.apart.empty()) return error;
  for (const UlpErrors& errors : judgement.errors) {
    error = std::max(error, kOfLegal * std::min(errors.greatest, 0x1p+38));
  }
  for (const Violation& violation : judgement.violations) {
    error = std::max(error, std::isfinite(violation.size) ? violation.size : 1);
  }
  return error;
}

// The ways in which the call is violated.
Keys keys_of(const DrawCall& call, const CallOutcome& outcome) {
  Keys keys;
  for (const Violation& violation : violations_of(outcome)) keys.insert(key_of(call, violation));
  return keys;
}

// One hunt. `known`: how the driver is known to fail.
std::vector<DrawCall> hunt(DriverPool& drivers, std::span<const DrawCall> beginnings, Keys known,
                           const HuntedOptions& options) {
  std::vector<DrawCall> found;
  const auto error = [&](const DrawCall& call) {
    const CallOutcome outcome = outcome_of(drivers, call);
    const std::size_t before = known.size();
    known.merge(keys_of(call, outcome));
    if (known.size() > before) found.push_back(call);
    const auto* judgement = std::get_if<Judgement>(&outcome);
    return judgement != nullptr ? error_of(*judgement) : 0;
  };
  for (HuntedDraw& draw : hunted_draws(beginnings, error, options)) {
    if (!draw.is_beginning) found.push_back(std::move(draw.call));
  }
  return found;
}

// Every so many of them, from number `first` on.
std::vector<DrawCall> every(std::span<const DrawCall> calls, std::size_t first,
                            std::size_t stride) {
  std::vector<DrawCall> some;
  for (std::size_t i = first; i < calls.size(); i += stride) some.push_back(calls[i]);
  return some;
}

}  // namespace

std::vector<DrawCall> hunted_calls(DriverPool& drivers, std::span<const DrawCall> calls,
                                   const Audit& audit, const HuntingOptions& options) {
  const std::vector<DrawCall> beginnings = beginnings_of(calls, audit);
  Keys known;
  for (const DriverFinding& finding : audit.findings) known.insert(finding.key);
  std::vector<DrawCall> found;
  Progress progress("hunt for worse of " + audit.driver, kHunts);
  work_in_order(
      kHunts, kHunts, progress,
      [&](std::size_t i) {
        const HuntedOptions part{.evaluations = options.evaluations / kHunts,
                                 .seed = options.seed + i};
        return hunt(drivers, every(beginnings, i, kHunts), known, part);
      },
      [&](std::vector<DrawCall>& part) {
        for (const DrawCall& call : part) {
          found.push_back(labelled(call, "hunted " + std::to_string(found.size() + 1)));
        }
      });
  return found;
}

}  // namespace clipscope::experiments
