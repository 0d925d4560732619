// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/guest_verdicts.hpp"

#include <tbb/parallel_for.h>

#include <map>

#include "experiments/contestants/plane_columns.hpp"
#include "experiments/judge/questions.hpp"
#include "experiments/survey/case_batch.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kInBatch = 4096;  // cases

PromiseCheck check_of(const Examined& examined) {
  PromiseCheck check;
  check.ulps = examined.ulps;
  if (!examined.in_domain) check.verdict = PromiseVerdict::outside_domain;
  if (examined.violations.empty()) return check;
  check.verdict = PromiseVerdict::broken;
  check.reason = examined.violations.front().reason;
  return check;
}

std::vector<CaseVerdict> judge_alike(const Contestant& guest, const CaseBatch& batch) {
  std::vector<CaseVerdict> verdicts(batch.size());
  if (!guest.takes(batch)) {
    for (CaseVerdict& v : verdicts) v.comparison.outcome = Outcome::not_applicable;
    return verdicts;
  }
  const Answers answers = clip_without_distances(guest, batch);
  const reference::Truth truth = reference::truth_of(batch);
  tbb::parallel_for(std::size_t{0}, verdicts.size(), [&](std::size_t i) {
    verdicts[i].comparison =
        compare(answers[i], truth_polygon(truth, input_vertices(batch, i), batch.attributes));
  });
  if (batch.vertices != 3 || !batch.planes.empty()) return verdicts;
  const std::vector<Examined> examined = examine(guest, batch, usually_asked(guest), answers);
  for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i].promise = check_of(examined[i]);
  return verdicts;
}

}  // namespace

std::vector<CaseVerdict> judge_in_batches(const Contestant& guest,
                                          std::span<const HardCase* const> cases) {
  std::map<const HardCase*, CaseVerdict> verdicts;
  for (const auto& group : alike(cases, kInBatch)) {
    const std::vector<CaseVerdict> of_group = judge_alike(guest, CaseBatch(group));
    for (std::size_t i = 0; i < group.size(); ++i) verdicts.emplace(group[i], of_group[i]);
  }
  std::vector<CaseVerdict> in_order;
  for (const HardCase* c : cases) in_order.push_back(verdicts.at(c));
  return in_order;
}

DrawnCases drawn_in_batches(const Contestant& guest, std::span<const HardCase* const> cases) {
  std::map<const HardCase*, bool> is_drawn;
  for (const auto& group : alike(cases, kInBatch)) {
    const CaseBatch batch(group);
    if (!guest.takes(batch)) continue;
    const Answers answers = clip(guest, batch);
    for (std::size_t i = 0; i < group.size(); ++i) {
      is_drawn[group[i]] = !answers[i].empty() || answers[i].failure() != nullptr;
    }
  }
  DrawnCases drawn{is_drawn.size(), {}};
  for (const HardCase* c : cases) {
    const auto found = is_drawn.find(c);
    if (found != is_drawn.end() && found->second) drawn.names.push_back(c->name);
  }
  return drawn;
}

}  // namespace clipscope::experiments
