// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/claim.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/table/prose.hpp"

namespace clipscope::experiments::claims {
namespace {

// Evidence that decides nothing does not fail.
bool fails(const Evidence& evidence) { return !evidence.holds.value_or(true); }

double most_of(const std::vector<Evidence>& evidence, bool failing) {
  double most = -HUGE_VAL;
  for (const Evidence& e : evidence) {
    if (fails(e) == failing) most = std::max(most, e.figure.value);
  }
  return most;
}

// A figure in ns, or one that compares such figures.
bool has_times(const Table& table) {
  return std::ranges::any_of(table.columns(), [](const Column& column) {
    return column.key.starts_with("ns") || column.key.starts_with("speedup");
  });
}

}  // namespace

Judgement judge(const Claim& claim, const Results& results) {
  try {
    return claim.judge(results);
  } catch (const MissingFigure& missing) {
    return {Verdict::undecided, capitalised(fmt::format("{}.", missing.what()))};
  }
}

Judgement judge(const Claim& claim, const Results::Source& tables, const RunsBehind& runs) {
  Interruptions behind;
  const Results results([&](const std::string& name) {
    std::optional<Table> table = tables(name);
    if (table && has_times(*table)) behind = behind + runs(name);
    return table;
  });
  Judgement judgement = judge(claim, results);
  if (judgement.verdict == Verdict::undecided || !behind.is_busy()) return judgement;
  judgement.verdict = Verdict::unsettled;
  judgement.because = fmt::format(
      "The machine was busy when this was timed: {:.0f} % of the runs were interrupted, and other programs took {:.0f} % of the processors.",
      behind.percent(), behind.others_percent());
  return judgement;
}

Judgement judged(std::vector<Evidence> evidence, bool under_condition, const Sentences& sentences) {
  const bool always = std::ranges::none_of(evidence, fails);
  const Verdict verdict = always            ? Verdict::confirmed
                          : under_condition ? Verdict::conditional
                                            : Verdict::refuted;
  const std::string& because = always            ? sentences.confirmed
                               : under_condition ? sentences.conditional
                                                 : sentences.refuted;
  return {verdict, capitalised(because), std::move(evidence)};
}

void Cases::add(Evidence evidence) {
  (fails(evidence) ? failing_ : holding_).push_back(evidence.of);
  evidence_.push_back(std::move(evidence));
}

std::string Cases::where() const {
  if (holding_.empty() || failing_.empty()) return "";
  return where_text(holding_, failing_, speak_);
}

double Cases::least() const { return std::ranges::min(evidence_, {}, &Evidence::figure).figure; }

double Cases::most() const { return std::ranges::max(evidence_, {}, &Evidence::figure).figure; }

std::string Cases::best() const {
  return speak_(std::ranges::max(evidence_, {}, &Evidence::figure).of);
}

double Cases::most_holding() const { return most_of(evidence_, false); }

double Cases::most_failing() const { return most_of(evidence_, true); }

Judgement Cases::judge(const Sentences& sentences, const std::vector<Evidence>& also) const {
  std::vector<Evidence> all = evidence_;
  all.insert(all.end(), also.begin(), also.end());
  return judged(std::move(all), !holding_.empty(), sentences);
}

}  // namespace clipscope::experiments::claims
