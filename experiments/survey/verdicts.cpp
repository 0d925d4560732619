// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <optional>
#include <utility>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/contestants/plane_columns.hpp"
#include "experiments/judge/questions.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/case_batch.hpp"
#include "experiments/survey/guest_verdicts.hpp"
#include "experiments/survey/judged_once.hpp"
#include "experiments/survey/sweep.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kCasesAtOnce = 32;  // cases in work at once

// Checks of one triangle's answers: those that have the same bits and the same bound once.
class AnswerChecks {
 public:
  AnswerChecks(const HardCase& hard_case, const CaseBatch& input)
      : triangle_(triangle_of(hard_case)), checker_(input) {}

  PromiseCheck of(const Promise& promise, const PolygonView& answer) {
    auto known = std::ranges::find_if(
        by_bound_, [&](const auto& c) { return is_same_bound(c.first, promise); });
    if (known == by_bound_.end()) {
      known = by_bound_.emplace(known, promise, JudgedOnce<PromiseCheck>());
    }
    return known->second.of(answer, [&] { return checker_.check(promise, triangle_, answer); });
  }

 private:
  const reference::InputTriangle triangle_;
  const PromiseChecker checker_;
  std::vector<std::pair<Promise, JudgedOnce<PromiseCheck>>> by_bound_;
};

PromiseCheck check_answer(const Contestant& contestant, const CaseBatch& input,
                          AnswerChecks& checks, const PolygonView& answer) {
  PromiseCheck check = checks.of(contestant.promise, answer);
  const std::string reason = broken_bits(contestant, input);
  if (!reason.empty()) {
    check.verdict = PromiseVerdict::broken;
    check.reason = reason;
  }
  return check;
}

std::vector<CaseVerdict> judge(const HardCase& hard_case, const Contestants& contestants) {
  const TruthPolygon truth = truth_polygon(hard_case);
  const CaseBatch input(hard_case);
  std::optional<AnswerChecks> checks;
  if (hard_case.primitive == Primitive::triangle) checks.emplace(hard_case, input);
  std::vector<CaseVerdict> verdicts;
  std::deque<Answers> answers;  // polygons refer to them
  JudgedOnce<Comparison> comparisons;
  for (const Contestant* contestant : contestants) {
    CaseVerdict& verdict = verdicts.emplace_back();
    if (contestant->is_guest) continue;  // asked about all cases at once
    if (!contestant->takes(input)) {
      verdict.comparison.outcome = Outcome::not_applicable;
      continue;
    }
    const PolygonView polygon = answers.emplace_back(clip(*contestant, input))[0];
    verdict.comparison = comparisons.of(polygon, [&] { return compare(polygon, truth); });
    if (checks) verdict.promise = check_answer(*contestant, input, *checks, polygon);
  }
  return verdicts;
}

// A tally per contestant, over all cases. count(case, tallies) adds one case.
template <class T, class Count>
std::vector<T> tally_cases(const CaseSet& set, Progress& progress, Count&& count) {
  std::vector<T> whole(set.contestants.size());
  const auto tally_one = [&](std::size_t i) {
    std::vector<T> part(whole.size());
    count(*set.cases[i], part);
    return part;
  };
  work_in_order(set.cases.size(), kCasesAtOnce, progress, tally_one,
                [&](const std::vector<T>& part) {
                  for (std::size_t i = 0; i < whole.size(); ++i) whole[i] += part[i];
                });
  return whole;
}

// The variants of all cases that are wanted, case by case.
template <class Wanted>
std::vector<HardCase> variants_of(const CaseSet& set, const Wanted& wanted) {
  std::vector<HardCase> all;
  for (const HardCase* original : set.cases) {
    for (auto&& variants : {family(*original), special_values(*original)}) {
      std::ranges::copy_if(variants, std::back_inserter(all), wanted);
    }
  }
  return all;
}

std::vector<const HardCase*> pointers_to(const std::vector<HardCase>& cases) {
  std::vector<const HardCase*> pointers;
  for (const HardCase& c : cases) pointers.push_back(&c);
  return pointers;
}

bool has_guest(const CaseSet& set) {
  return std::ranges::any_of(set.contestants, [](const Contestant* c) { return c->is_guest; });
}

// Calls f(guest, place) for each guest of the set.
template <class F>
void for_each_guest(const CaseSet& set, const F& f) {
  for (std::size_t c = 0; c < set.contestants.size(); ++c) {
    if (set.contestants[c]->is_guest) f(*set.contestants[c], c);
  }
}

// Whether some coordinate of a position is NaN or infinite.
bool has_bad_position(const HardCase& hard_case) {
  return std::ranges::any_of(hard_case.vertices, [](const reference::InputVertex& v) {
    return std::ranges::any_of(v.position, [](double x) { return !std::isfinite(x); });
  });
}

}  // namespace

Contestants case_contestants(Primitive primitive, std::string_view clipper_pattern,
                             const std::vector<std::string>& scalars) {
  Selection selection;
  selection.clipper = clipper_pattern;
  return case_contestants(primitive, selection, scalars);
}

Contestants case_contestants(Primitive primitive, const Selection& selection,
                             const std::vector<std::string>& scalars) {
  Selection chosen = selection;
  if (primitive == Primitive::polygon) chosen.clipper = Selection{}.clipper;
  try {
    return select_contestants(chosen, scalars, static_cast<int>(vertices_of(primitive)));
  } catch (const UsageError&) {
    // The pattern names clippers of another primitive; what is wrong altogether was found before.
    return {};
  }
}

bool takes(const Contestant& contestant, const HardCase& hard_case) {
  return contestant.takes(CaseBatch(hard_case));
}

Answers clip_case(const Contestant& contestant, const HardCase& hard_case) {
  return clip_without_distances(contestant, CaseBatch(hard_case));
}

Comparison judge_case(const Contestant& contestant, const HardCase& hard_case,
                      const TruthPolygon& truth) {
  const CaseBatch input(hard_case);
  if (!contestant.takes(input)) return {.outcome = Outcome::not_applicable};
  return compare(clip_without_distances(contestant, input)[0], truth);
}

PromiseCheck check_case(const Contestant& contestant, const HardCase& hard_case) {
  const CaseBatch input(hard_case);
  if (!contestant.takes(input)) return {PromiseVerdict::outside_domain, 0, ""};
  const Answers answers = clip(contestant, input);
  AnswerChecks checks(hard_case, input);
  return check_answer(contestant, input, checks, answers[0]);
}

TruthPolygon truth_polygon(const HardCase& hard_case) {
  return truth_polygon(truth_of(hard_case), hard_case.vertices, hard_case.attribute_count);
}

std::vector<std::array<double, 4>> positions_of(const PolygonView& polygon) {
  std::vector<std::array<double, 4>> positions;
  for (const VertexView& v : polygon) {
    positions.push_back({v[0].value, v[1].value, v[2].value, v[3].value});
  }
  return positions;
}

void FamilyTally::add(const CaseVerdict& verdict, const HardCase& variant) {
  const auto& [comparison, promise] = verdict;
  if (comparison.outcome == Outcome::not_applicable) return;
  const bool is_promised = variant.primitive == Primitive::triangle;
  *this += {.variants = 1,
            .failures = is_failure(comparison.outcome),
            .broken = promise.verdict == PromiseVerdict::broken,
            .largest_ulps = is_promised ? std::optional(promise.ulps) : std::nullopt,
            .worst = variant.name,
            .offender = promise.reason.empty() ? "" : variant.name + ": " + promise.reason};
}

FamilyTally& FamilyTally::operator+=(const FamilyTally& next) {
  variants += next.variants;
  failures += next.failures;
  broken += next.broken;
  if (offender.empty()) offender = next.offender;
  if (next.largest_ulps.value_or(0) > largest_ulps.value_or(0)) worst = next.worst;
  largest_ulps = std::max(largest_ulps, next.largest_ulps);
  return *this;
}

PolicyTally& PolicyTally::operator+=(const PolicyTally& next) {
  inputs += next.inputs;
  drawn += next.drawn;
  if (offender.empty()) offender = next.offender;
  return *this;
}

std::vector<std::vector<CaseVerdict>> judge_cases(const CaseSet& set, Progress& progress) {
  std::vector<std::vector<CaseVerdict>> verdicts;
  work_in_order(
      set.cases.size(), kCasesAtOnce, progress,
      [&](std::size_t i) { return judge(*set.cases[i], set.contestants); },
      [&](std::vector<CaseVerdict>& row) { verdicts.push_back(std::move(row)); });
  for_each_guest(set, [&](const Contestant& guest, std::size_t place) {
    const std::vector<CaseVerdict> column = judge_in_batches(guest, set.cases);
    for (std::size_t i = 0; i < column.size(); ++i) verdicts[i][place] = column[i];
  });
  return verdicts;
}

std::vector<FamilyTally> judge_families(const CaseSet& set, Progress& progress) {
  const auto count = [&](const HardCase& original, std::vector<FamilyTally>& tallies) {
    std::vector<HardCase> variants = family(original);
    std::ranges::move(special_values(original), std::back_inserter(variants));
    for (const HardCase& variant : variants) {
      if (!is_finite(variant)) continue;
      const std::vector<CaseVerdict> verdicts = judge(variant, set.contestants);
      for (std::size_t i = 0; i < tallies.size(); ++i) {
        if (!set.contestants[i]->is_guest) tallies[i].add(verdicts[i], variant);
      }
    }
  };
  std::vector<FamilyTally> tallies = tally_cases<FamilyTally>(set, progress, count);
  if (!has_guest(set)) return tallies;
  const auto variants = variants_of(set, [](const HardCase& c) { return is_finite(c); });
  for_each_guest(set, [&](const Contestant& guest, std::size_t place) {
    const std::vector<CaseVerdict> verdicts = judge_in_batches(guest, pointers_to(variants));
    for (std::size_t i = 0; i < variants.size(); ++i) tallies[place].add(verdicts[i], variants[i]);
  });
  return tallies;
}

std::vector<PolicyTally> judge_special_values(const CaseSet& set, Progress& progress) {
  const auto count = [&](const HardCase& original, std::vector<PolicyTally>& tallies) {
    for (const HardCase& variant : special_values(original)) {
      if (!has_bad_position(variant)) continue;
      const CaseBatch input(variant);
      for (std::size_t i = 0; i < tallies.size(); ++i) {
        if (set.contestants[i]->is_guest || !set.contestants[i]->takes(input)) continue;
        const bool is_drawn = !clip(*set.contestants[i], input)[0].empty();
        tallies[i] += {.inputs = 1, .drawn = is_drawn, .offender = is_drawn ? variant.name : ""};
      }
    }
  };
  std::vector<PolicyTally> tallies = tally_cases<PolicyTally>(set, progress, count);
  if (!has_guest(set)) return tallies;
  const std::vector<HardCase> variants = variants_of(set, has_bad_position);
  for_each_guest(set, [&](const Contestant& guest, std::size_t place) {
    const DrawnCases drawn = drawn_in_batches(guest, pointers_to(variants));
    tallies[place] = {.inputs = static_cast<std::int64_t>(drawn.inputs),
                      .drawn = static_cast<std::int64_t>(drawn.names.size()),
                      .offender = drawn.names.empty() ? "" : drawn.names.front()};
  });
  return tallies;
}

}  // namespace clipscope::experiments
