// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/verdicts.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "experiments/catalogue/families.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kWindow = 32;  // cases in work at once

std::vector<CaseVerdict> judge(const HardCase& hard_case,
                               const std::vector<CaseContestant>& contestants) {
  const TruthPolygon truth = truth_polygon(hard_case);
  std::vector<CaseVerdict> verdicts;
  for (const CaseContestant& contestant : contestants) {
    CaseVerdict verdict{contestant.answer(hard_case, truth).comparison, {}};
    if (contestant.keeps_promise && verdict.comparison.outcome != Outcome::not_applicable) {
      verdict.promise = contestant.keeps_promise(hard_case);
    }
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

// Calls work(case) for all cases in parallel and take(result) in their order.
template <class Work, class Take>
void for_each_case(const CaseSet& set, Progress& progress, Work&& work, Take&& take) {
  for (std::size_t first = 0; first < set.cases.size(); first += kWindow) {
    const std::size_t count = std::min(kWindow, set.cases.size() - first);
    std::vector<decltype(work(*set.cases[0]))> results(count);
    tbb::parallel_for(std::size_t{0}, count,
                      [&](std::size_t i) { results[i] = work(*set.cases[first + i]); });
    for (auto& result : results) take(result);
    progress.advance(count);
  }
}

void count(const CaseVerdict& verdict, const std::string& name, FamilyTally& tally) {
  if (verdict.comparison.outcome == Outcome::not_applicable) return;
  ++tally.variants;
  tally.failures += is_failure(verdict.comparison.outcome);
  if (verdict.promise.verdict == PromiseVerdict::broken) {
    ++tally.broken;
    if (tally.offender.empty()) tally.offender = name + ": " + verdict.promise.reason;
  }
  if (verdict.promise.ulps > tally.largest_ulps) {
    tally.largest_ulps = verdict.promise.ulps;
    tally.worst = name;
  }
}

void merge(const FamilyTally& part, FamilyTally& whole) {
  whole.variants += part.variants;
  whole.failures += part.failures;
  whole.broken += part.broken;
  if (whole.offender.empty()) whole.offender = part.offender;
  if (part.largest_ulps > whole.largest_ulps) {
    whole.largest_ulps = part.largest_ulps;
    whole.worst = part.worst;
  }
}

void merge(const PolicyTally& part, PolicyTally& whole) {
  whole.inputs += part.inputs;
  whole.drawn += part.drawn;
  if (whole.offender.empty()) whole.offender = part.offender;
}

// Whether some coordinate of a position is NaN or infinite.
bool has_bad_position(const HardCase& hard_case) {
  return std::ranges::any_of(hard_case.vertices, [](const reference::InputVertex& v) {
    return std::ranges::any_of(v.position, [](double x) { return !std::isfinite(x); });
  });
}

template <class Tally>
void merge_all(const std::vector<Tally>& parts, std::vector<Tally>& whole) {
  for (std::size_t i = 0; i < whole.size(); ++i) merge(parts[i], whole[i]);
}

}  // namespace

std::vector<std::vector<CaseVerdict>> judge_cases(const CaseSet& set, Progress& progress) {
  std::vector<std::vector<CaseVerdict>> verdicts;
  for_each_case(
      set, progress, [&](const HardCase& c) { return judge(c, set.contestants); },
      [&](std::vector<CaseVerdict>& row) { verdicts.push_back(std::move(row)); });
  return verdicts;
}

std::vector<FamilyTally> judge_families(const CaseSet& set, Progress& progress) {
  std::vector<FamilyTally> total(set.contestants.size());
  const auto judge_family = [&](const HardCase& original) {
    std::vector<FamilyTally> tallies(set.contestants.size());
    std::vector<CaseVariant> variants = family(original);
    std::ranges::move(special_values(original), std::back_inserter(variants));
    for (const CaseVariant& variant : variants) {
      if (!is_finite(variant)) continue;
      const std::vector<CaseVerdict> verdicts = judge(variant.hard_case, set.contestants);
      for (std::size_t i = 0; i < tallies.size(); ++i) {
        count(verdicts[i], variant.hard_case.name, tallies[i]);
      }
    }
    return tallies;
  };
  for_each_case(set, progress, judge_family,
                [&](const std::vector<FamilyTally>& part) { merge_all(part, total); });
  return total;
}

std::vector<PolicyTally> judge_special_values(const CaseSet& set, Progress& progress) {
  std::vector<PolicyTally> total(set.contestants.size());
  const auto judge_case = [&](const HardCase& original) {
    std::vector<PolicyTally> tallies(set.contestants.size());
    for (const CaseVariant& variant : special_values(original)) {
      if (!has_bad_position(variant.hard_case)) continue;
      for (std::size_t i = 0; i < tallies.size(); ++i) {
        const CaseAnswer answer = set.contestants[i].polygon_of(variant.hard_case);
        if (answer.comparison.outcome == Outcome::not_applicable) continue;
        ++tallies[i].inputs;
        if (answer.polygon.empty()) continue;
        ++tallies[i].drawn;
        if (tallies[i].offender.empty()) tallies[i].offender = variant.hard_case.name;
      }
    }
    return tallies;
  };
  for_each_case(set, progress, judge_case,
                [&](const std::vector<PolicyTally>& part) { merge_all(part, total); });
  return total;
}

}  // namespace clipscope::experiments
