// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "experiments/audit/hunting.hpp"
#include "experiments/audit/smallest_draw.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/survey/sweep.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kAtOnce = 64, kShrunkAtOnce = 8;  // draw calls, findings in work
constexpr double kComfortable = 2;                      // times what is allowed

// Adds up outcomes in the order of the draw calls.
class Gathering {
 public:
  explicit Gathering(Audit& audit) : audit_(audit) {}

  void add(const DrawCall& call, const CallOutcome& outcome) {
    if (const auto* failure = std::get_if<DrawFailure>(&outcome)) {
      add_failure(call, *failure);
    } else {
      add_judgement(call, std::get<Judgement>(outcome));
    }
  }

 private:
  struct Place {
    std::size_t finding;    // in Audit::findings
    std::size_t last_case;  // the last one counted, by Audit::cases
  };

  void add_failure(const DrawCall& call, const DrawFailure& failure) {
    const auto violation = violation_of(failure);
    if (!violation) {
      const bool is_refused = failure.kind == DrawFailure::Kind::refused;
      ++(is_refused ? audit_.refused : audit_.unable)[failure.reason];
      return;
    }
    ++audit_.cases;
    ++audit_.violating;
    add_example({call, *violation, failure.reason});
  }

  void add_judgement(const DrawCall& call, const Judgement& judgement) {
    ++audit_.cases;
    audit_.pixels += judgement.pixels;
    audit_.undecided += judgement.undecided;
    audit_.inexact += judgement.inexact;
    if (!judgement.apart.empty()) {
      ++audit_.apart[std::string(judgement.apart)];
      return;
    }
    for (std::size_t q = 0; q < kQuantities; ++q) {
      add_errors(call, judgement.errors[q], audit_.errors[q]);
    }
    if (!judgement.violations.empty()) ++audit_.violating;
    for (const Violation& violation : judgement.violations) add_example({call, violation});
  }

  static void add_errors(const DrawCall& call, const UlpErrors& errors, QuantityErrors& all) {
    if (errors.count() == 0) return;
    ++all.cases;
    if (all.cases == 1 || errors.greatest > all.errors.greatest) all.worst_case = call.name;
    all.errors.add(errors);
  }

  void add_example(const DrawExample& example) {
    const FindingKey key = key_of(example.call, example.violation);
    const auto [entry, is_new] = places_.try_emplace(key, Place{audit_.findings.size(), 0});
    auto& [number, last_case] = entry->second;
    if (is_new) {
      const Clause clause =
          clause_of(audit_.info.api, example.call.topology, key.kind, key.quantity);
      audit_.findings.push_back({.key = key, .clause = clause, .first = example, .worst = example});
    }
    DriverFinding& finding = audit_.findings[number];
    finding.pixels += static_cast<std::uint64_t>(example.violation.pixels);
    if (std::exchange(last_case, audit_.cases) != audit_.cases) ++finding.cases;
    if (is_worse(example.violation, finding.worst.violation)) finding.worst = example;
  }

  Audit& audit_;
  std::map<FindingKey, Place> places_;
};

// The finding of which this is the same with more in play; null if there is none.
DriverFinding* plainer_of(std::vector<DriverFinding>& findings, const FindingKey& key) {
  const Circumstances& c = key.circumstances;
  for (const auto& [clip_distances, depth_clamp] :
       {std::pair(false, false), std::pair(true, false), std::pair(false, true)}) {
    FindingKey plainer = key;
    plainer.circumstances.clip_distances = c.clip_distances && clip_distances;
    plainer.circumstances.depth_clamp = c.depth_clamp && depth_clamp;
    if (plainer == key) continue;
    const auto found = std::ranges::find(findings, plainer, &DriverFinding::key);
    if (found != findings.end()) return &*found;
  }
  return nullptr;
}

// A fault that shows without clip distances or depth clamp owes them nothing.
void merge_plainer(std::vector<DriverFinding>& findings) {
  std::vector<DriverFinding> kept;
  for (const DriverFinding& finding : findings) {
    if (plainer_of(findings, finding.key) == nullptr) kept.push_back(finding);
  }
  for (const DriverFinding& finding : findings) {
    DriverFinding* const plainer = plainer_of(kept, finding.key);
    if (plainer == nullptr) continue;
    plainer->cases += finding.cases;
    plainer->pixels += finding.pixels;
  }
  findings = std::move(kept);
}

// The worst one that is of this kind, in these circumstances.
std::optional<DrawExample> worst_of(const DrawCall& call, const CallOutcome& outcome,
                                    const FindingKey& key) {
  const auto* failure = std::get_if<DrawFailure>(&outcome);
  std::optional<DrawExample> worst;
  for (const Violation& violation : violations_of(outcome)) {
    if (key_of(call, violation) != key) continue;
    if (worst && !is_worse(violation, worst->violation)) continue;
    worst = {call, violation, failure == nullptr ? "" : failure->reason};
  }
  return worst;
}

// The finding's worst draw call, made as small as it gets in that time.
std::optional<DrawExample> smallest_of(DriverPool& drivers, const DriverFinding& finding,
                                       double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  const auto fails = [&](const DrawCall& call) {
    return Clock::now() < end && example_of(drivers, call, finding).has_value();
  };
  return example_of(drivers, smallest_draw(finding.worst.call, fails), finding);
}

void shrink_findings(DriverPool& drivers, double seconds, Audit& audit) {
  std::vector<DriverFinding>& findings = audit.findings;
  Progress progress("shrink the findings of " + audit.driver, findings.size());
  std::size_t next = 0;
  work_in_order(
      findings.size(), kShrunkAtOnce, progress,
      [&](std::size_t i) { return smallest_of(drivers, findings[i], seconds); },
      [&](std::optional<DrawExample>& smallest) {
        findings[next++].smallest = std::move(smallest);
      });
}

void draw_all(DriverPool& drivers, std::span<const DrawCall> calls, const std::string& title,
              Gathering& gathering) {
  Progress progress(title, calls.size());
  std::size_t next = 0;
  work_in_order(
      calls.size(), kAtOnce, progress, [&](std::size_t i) { return outcome_of(drivers, calls[i]); },
      [&](const CallOutcome& outcome) { gathering.add(calls[next++], outcome); });
}

}  // namespace

Audit audit_driver(const std::string& name, DriverPool& drivers, std::span<const DrawCall> calls,
                   const AuditLimits& limits) {
  Audit audit{.driver = name, .info = drivers.info()};
  Gathering gathering(audit);
  draw_all(drivers, calls, "audit " + name, gathering);
  if (limits.hunted > 0) {
    const std::vector<DrawCall> worse =
        hunted_calls(drivers, calls, audit, {.evaluations = limits.hunted, .seed = limits.seed});
    draw_all(drivers, worse, "audit what was hunted", gathering);
  }
  merge_plainer(audit.findings);
  if (limits.shrinks) shrink_findings(drivers, limits.seconds_each, audit);
  return audit;
}

std::optional<DrawExample> example_of(DriverPool& drivers, const DrawCall& call,
                                      const DriverFinding& finding) {
  const auto found = worst_of(call, outcome_of(drivers, call), finding.key);
  const double least = std::min(kComfortable, finding.worst.violation.size);
  return found && found->violation.size >= least ? found : std::nullopt;
}

}  // namespace clipscope::experiments
