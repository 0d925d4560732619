// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/examination.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "experiments/judge/compare.hpp"
#include "experiments/survey/case_batch.hpp"
#include "experiments/table/hex_float.hpp"

namespace clipscope::experiments {
namespace {

std::string hex_lines(const PolygonView& polygon) {
  std::string text;
  for (const VertexView& v : polygon) {
    for (std::size_t i = 0; i < v.size(); ++i) text += (i > 0 ? " " : "") + hex_float(v[i].value);
    text += '\n';
  }
  return text;
}

template <class T>
void keep_first(std::optional<T>& first, const std::optional<T>& next) {
  if (!first) first = next;
}

}  // namespace

QuestionTally& QuestionTally::operator+=(const QuestionTally& next) {
  judged += next.judged;
  broken += next.broken;
  keep_first(first, next.first);
  return *this;
}

void Examination::add(const Batch& batch, const std::function<std::string(std::size_t)>& name_of) {
  if (!contestant_->takes(batch)) return add_untaken(batch.size());
  triangles += batch.size();
  const Answers given = clip(*contestant_, batch);
  const std::vector<Examined> found = examine(*contestant_, batch, examined_, given);
  for (std::size_t i = 0; i < found.size(); ++i) {
    add_one(
        batch, i, [&] { return name_of(i); }, given[i], found[i]);
  }
  add_outside(batch, given, found);
}

void Examination::add_untaken(std::size_t count) {
  triangles += count;
  not_taken += count;
}

void Examination::add_one(const Batch& batch, std::size_t i, const Name& name,
                          const PolygonView& given, const Examined& found) {
  const bool is_unanswered = given.failure() != nullptr;
  unanswered += is_unanswered;
  outside_domain += !found.in_domain;
  judged += found.in_domain && (is_unanswered || found.judged.has_any(asked_));
  if (found.ulps > largest_ulps) {
    largest_ulps = found.ulps;
    farthest = case_of(batch, i, name());
  }
  for (const Question q : found.judged.list()) ++tallies_[static_cast<std::size_t>(q)].judged;
  bool breaks_asked = false;
  for (const BrokenPromise& violation : found.violations) {
    QuestionTally& tally = tallies_[static_cast<std::size_t>(violation.question)];
    ++tally.broken;
    const bool is_asked = asked_.contains(violation.question) || is_unanswered;
    const bool is_worst = is_asked && (!worst || found.ulps > worst_ulps_);
    breaks_asked = breaks_asked || is_asked;
    if (tally.first && !is_worst) continue;
    const Counterexample counterexample{case_of(batch, i, name()), violation, hex_lines(given)};
    keep_first(tally.first, std::optional(counterexample));
    if (!is_worst) continue;
    worst = counterexample;
    worst_ulps_ = found.ulps;
  }
  broken += breaks_asked;
}

// Compares answers that the bounds don't speak of with the exact ones.
void Examination::add_outside(const Batch& batch, const Answers& given,
                              const std::vector<Examined>& found) {
  std::vector<std::size_t> outside;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i].in_domain) outside.push_back(i);
  }
  if (outside.empty()) return;
  const reference::Truth truth = reference::truth_of(batch);
  std::vector<Comparison> comparisons(outside.size());
  tbb::parallel_for(std::size_t{0}, outside.size(), [&](std::size_t k) {
    const std::size_t i = outside[k];
    comparisons[k] =
        compare(given[i], truth_polygon(truth, input_vertices(batch, i), batch.attributes));
  });
  for (const Comparison& comparison : comparisons) {
    if (!comparison.visible || !is_failure(comparison.outcome)) continue;
    ++wrong_outside[static_cast<std::size_t>(comparison.outcome)];
  }
}

Examination& Examination::operator+=(const Examination& next) {
  triangles += next.triangles;
  not_taken += next.not_taken;
  outside_domain += next.outside_domain;
  unanswered += next.unanswered;
  judged += next.judged;
  broken += next.broken;
  for (std::size_t i = 0; i < wrong_outside.size(); ++i) wrong_outside[i] += next.wrong_outside[i];
  for (std::size_t i = 0; i < kQuestions; ++i) tallies_[i] += next.tallies_[i];
  if (next.largest_ulps > largest_ulps) {
    largest_ulps = next.largest_ulps;
    farthest = next.farthest;
  }
  if (next.worst && (!worst || next.worst_ulps_ > worst_ulps_)) {
    worst = next.worst;
    worst_ulps_ = next.worst_ulps_;
  }
  return *this;
}

Questions Examination::kept() const {
  Questions kept;
  for (const Question q : examined_.list()) {
    if (of(q).is_kept()) kept.add(q);
  }
  return kept;
}

const Counterexample* Examination::first_broken() const {
  Questions counted = asked_;
  if (unanswered > 0) counted.add(Question::total);
  for (const Question q : counted.list()) {
    if (of(q).first) return &*of(q).first;
  }
  return nullptr;
}

}  // namespace clipscope::experiments
