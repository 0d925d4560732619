// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/questions.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/contestants/fewer_attributes.hpp"
#include "experiments/judge/bit_promise.hpp"
#include "experiments/judge/exact_questions.hpp"
#include "experiments/judge/promise.hpp"
#include "experiments/judge/variants.hpp"

namespace clipscope::experiments {
namespace {

constexpr Questions kDistances = {Question::contained, Question::covers};
constexpr Questions kOfExactPolygon = {Question::winding, Question::faithful,
                                       Question::correctly_rounded};

// What distances are held to.
Promise distance_promise(const Contestant& contestant, const Questions& asked) {
  Promise promise = contestant.promise;
  promise.contained = asked.contains(Question::contained);
  promise.covers = asked.contains(Question::covers);
  promise.correctly_rounded = false;  // a question of its own
  if (contestant.is_guest) promise.attributes = true;
  if (std::isinf(promise.ulps)) promise.ulps = kChainUlps;
  return promise;
}

// What was asked about a batch, and one triangle after the other what came of it.
class BatchExamination {
 public:
  BatchExamination(const Contestant& contestant, const Batch& batch, const Questions& asked,
                   const Answers& given)
      : batch_(batch),
        asked_(asked),
        given_(given),
        is_guest_(contestant.is_guest),
        promise_(distance_promise(contestant, asked)),
        bits_(contestant, batch, asked, given) {
    if (asked_.has_any(kDistances) || asked_.has_any(kOfExactPolygon)) checker_.emplace(batch);
  }

  Examined examine(std::size_t triangle) const {
    Examined examined;
    const std::string failure = bits_.failure(triangle);
    if (!failure.empty()) note(Question::total, Found::broken(failure), examined);
    examine_bits(triangle, examined);
    examine_distances(triangle, examined);
    examine_exactly(triangle, examined);
    std::ranges::sort(examined.violations, {}, &BrokenPromise::question);
    return examined;
  }

 private:
  static void note(Question question, Found found, Examined& examined) {
    if (!found.judged) return;
    examined.judged.add(question);
    if (found.reason.empty() || examined.violation(question)) return;
    examined.violations.push_back({question, std::move(found.reason), found.excess});
  }

  void examine_bits(std::size_t triangle, Examined& examined) const {
    for (const Question q :
         {Question::total, Question::confined, Question::watertight, Question::rotation,
          Question::scale, Question::constants, Question::steady}) {
      if (asked_.contains(q)) note(q, bits_.judge(q, triangle), examined);
    }
  }

  void examine_distances(std::size_t triangle, Examined& examined) const {
    if (!asked_.has_any(kDistances)) return;
    const PromiseCheck check = checker_->check(promise_, input_vertices(batch_, triangle),
                                               batch_.attributes, given_[triangle]);
    examined.ulps = check.ulps;
    examined.in_domain = check.verdict != PromiseVerdict::outside_domain;
    if (!examined.in_domain) return;
    const bool is_left_out = is_guest_ && given_[triangle].empty() && !has_area(triangle);
    const bool is_no_polygon = check.verdict == PromiseVerdict::broken &&
                               check.contained.reason.empty() && check.covers.reason.empty();
    const auto note_breach = [&](Question q, const PromiseCheck::Breach& breach) {
      if (is_no_polygon) {
        note(q, Found::broken(check.reason), examined);
      } else {
        note(q, {.judged = true, .reason = breach.reason, .excess = breach.excess}, examined);
      }
    };
    if (promise_.covers) {
      note_breach(Question::covers, is_left_out ? PromiseCheck::Breach{} : check.covers);
    }
    // Vertices off the triangle are bounded by either promise.
    note_breach(promise_.contained ? Question::contained : Question::covers, check.contained);
  }

  // Whether the exact polygon has an area on screen, where one without draws no pixel.
  bool has_area(std::size_t triangle) const {
    const auto polygon =
        reference::clip(checker_->truth(), input_vertices(batch_, triangle), batch_.attributes);
    Exact twice(0);
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      const reference::ExactVertex& a = polygon.vertices[i];
      const reference::ExactVertex& b = polygon.vertices[(i + 1) % polygon.vertices.size()];
      twice += reference::to_rational(a.x) * reference::to_rational(b.y) -
               reference::to_rational(b.x) * reference::to_rational(a.y);
    }
    return twice != Exact(0);
  }

  void examine_exactly(std::size_t triangle, Examined& examined) const {
    if (!asked_.has_any(kOfExactPolygon)) return;
    const PolygonView polygon = given_[triangle];
    const TruthPolygon truth =
        truth_polygon(checker_->truth(), input_vertices(batch_, triangle), batch_.attributes);
    const Comparison comparison = compare(polygon, truth);
    if (asked_.contains(Question::winding)) {
      note(Question::winding, judge_winding(comparison), examined);
    }
    // Who starts from a rounded matrix was not given the exact numbers.
    if (batch_.matrix) return;
    if (asked_.contains(Question::faithful)) {
      note(Question::faithful, judge_faithful(polygon, truth, comparison), examined);
    }
    if (asked_.contains(Question::correctly_rounded)) {
      note(Question::correctly_rounded, judge_correctly_rounded(polygon, truth), examined);
    }
  }

  const Batch& batch_;
  const Questions asked_;
  const Answers& given_;
  const bool is_guest_;
  const Promise promise_;
  const BitQuestions bits_;
  std::optional<PromiseChecker> checker_;  // where distances or the exact polygon are asked for
};

}  // namespace

std::vector<Question> Questions::list() const {
  std::vector<Question> list;
  for (std::size_t i = 0; i < kQuestions; ++i) {
    if (contains(static_cast<Question>(i))) list.push_back(static_cast<Question>(i));
  }
  return list;
}

const BrokenPromise* Examined::violation(Question question) const {
  const auto found = std::ranges::find(violations, question, &BrokenPromise::question);
  return found == violations.end() ? nullptr : &*found;
}

Questions stated_by(const Contestant& contestant) {
  const Promise& promise = contestant.promise;
  const Format& format = *contestant.format;
  const bool is_double_double = format.precision == kFormat<dd_real>.precision;
  Questions stated;
  const auto state = [&](bool is_stated, Question question) {
    if (is_stated) stated.add(question);
  };
  state(promise.total, Question::total);
  state(promise.confined && !is_double_double, Question::confined);
  state(promise.contained, Question::contained);
  state(promise.covers, Question::covers);
  state(promise.watertight && !format.is_exact(), Question::watertight);
  state(promise.rotation_invariant, Question::rotation);
  state(promise.scale_invariant, Question::scale);
  state(promise.constants, Question::constants);
  state(promise.correctly_rounded && format.is_float(), Question::correctly_rounded);
  return stated;
}

Questions usually_asked(const Contestant& contestant) {
  if (!contestant.is_guest) return stated_by(contestant);
  return {Question::total, Question::contained, Question::covers, Question::winding};
}

namespace {

bool has_failures(const Answers& answers) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].failure() != nullptr) return true;
  }
  return false;
}

Examined examined_without_answer(const Failure& failure) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  return {.judged = {Question::total},
          .violations = {{Question::total, failure.reason, kInfinite}}};
}

// Where some have no answer: the others are examined without them, so that who crashes does it once
// and takes nobody along. Guests alone leave out answers, whose numbers are doubles at most.
std::vector<Examined> examine_answered(const Contestant& contestant, const Batch& batch,
                                       const Questions& asked, const Answers& given) {
  std::vector<Examined> examined(batch.size());
  std::vector<std::size_t> answered;
  std::vector<double> numbers;
  Answers given_of_rest(given.format(), given.stride());
  const std::size_t size = 3 * batch.stride();  // of a triangle
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (const Failure* failure = given[i].failure()) {
      examined[i] = examined_without_answer(*failure);
      continue;
    }
    answered.push_back(i);
    for (std::size_t n = i * size; n < (i + 1) * size; ++n) numbers.push_back(batch.number(n));
    for (const VertexView& v : given[i]) {
      for (std::size_t n = 0; n < v.size(); ++n) given_of_rest.add(v[n].value);
    }
    given_of_rest.end_polygon();
  }
  if (answered.empty()) return examined;
  const Variant rest(batch, std::move(numbers));
  std::vector<Examined> of_rest = examine(contestant, rest.batch(), asked, given_of_rest);
  for (std::size_t i = 0; i < answered.size(); ++i) examined[answered[i]] = std::move(of_rest[i]);
  return examined;
}

}  // namespace

std::vector<Examined> examine(const Contestant& contestant, const Batch& batch,
                              const Questions& asked, const Answers& given) {
  if (batch.size() == 0) return {};
  if (has_more_attributes(batch, contestant.most_attributes)) {
    const NarrowBatch narrow(batch, contestant.most_attributes);  // which was answered
    return examine(contestant, narrow.batch(), asked, given);
  }
  if (has_failures(given)) return examine_answered(contestant, batch, asked, given);
  const BatchExamination examination(contestant, batch, asked, given);
  std::vector<Examined> examined(batch.size());
  if (examined.size() == 1) {
    examined[0] = examination.examine(0);
  } else {
    tbb::parallel_for(std::size_t{0}, examined.size(),
                      [&](std::size_t i) { examined[i] = examination.examine(i); });
  }
  return examined;
}

std::vector<Examined> examine(const Contestant& contestant, const Batch& batch,
                              const Questions& asked) {
  return examine(contestant, batch, asked, clip(contestant, batch));
}

std::string broken_bits(const Contestant& contestant, const Batch& triangle) {
  Questions bits = stated_by(contestant);
  for (const Question q : {Question::contained, Question::covers, Question::correctly_rounded}) {
    bits.remove(q);
  }
  const std::vector<Examined> examined = examine(contestant, triangle, bits);
  return examined[0].violations.empty() ? "" : examined[0].violations[0].reason;
}

}  // namespace clipscope::experiments
