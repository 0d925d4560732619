// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/hunt/sketch.hpp"
#include "experiments/judge/exact_questions.hpp"
#include "experiments/judge/questions.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/shrink/case_groups.hpp"

namespace clipscope::experiments::hunt {
namespace {

constexpr std::size_t kExact = 8;        // of a litter are compared exactly, the first by rank
constexpr std::size_t kFailing = 3;      // of each outcome that seems new
constexpr std::size_t kThird = 2;        // the attribute that is 0 on the edge of `crack`
constexpr int kWide = kSceneAttributes;  // attributes of the wider answer

void add_triangle(const Prey& prey, const std::array<std::size_t, 3>& places, int dimension,
                  int attributes, std::vector<float>& numbers) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& position = prey.position[places[i]];
    const auto& values = prey.attributes[i < 2 ? i : 2];
    numbers.insert(numbers.end(), position.begin(), position.begin() + dimension);
    numbers.insert(numbers.end(), values.begin(), values.begin() + attributes);
  }
}

std::vector<float> numbers_of(const Setting& setting, std::span<const Prey> litter, int attributes,
                              bool in_pairs) {
  std::vector<float> numbers;
  for (const Prey& prey : litter) {
    add_triangle(prey, {0, 1, 2}, setting.dimension(), attributes, numbers);
    if (in_pairs) add_triangle(prey, {1, 0, 3}, setting.dimension(), attributes, numbers);
  }
  return numbers;
}

// Whether an x, y or z of the exact polygon is beyond the format; then nothing comes out
// (spaces/clipper.hpp).
bool overflows(const Format& format, const TruthPolygon& truth) {
  if (format.is_exact()) return false;
  return std::ranges::any_of(truth.approximation, [&](const std::vector<double>& v) {
    return std::any_of(v.begin(), v.begin() + 3,
                       [&](double x) { return !(std::abs(x) <= format.largest()); });
  });
}

// Wider than the contestant's own.
const Contestant* wide_for(const Contestant& contestant) {
  const bool is_float = contestant.format->is_float();
  const bool is_double = contestant.format == &kFormat<double>;
  return find_in_contract("homogeneous/sutherland_hodgman",
                          is_float    ? kFormat<double>.name
                          : is_double ? kFormat<dd_real>.name
                                      : kFormat<Exact>.name,
                          Contract::full);
}

}  // namespace

// The prey and what was answered; in `crack` two polygons each.
struct Evaluator::Litter {
  std::span<const Prey> prey;
  Answers answers;
};

Evaluator::Evaluator(const Contestant& contestant, Measure measure, bool in_domain)
    : contestant_(contestant),
      wide_(wide_for(contestant)),
      measure_(measure),
      attributes_(std::min(contestant.most_attributes, Prey::kAttributes)),
      in_domain_(in_domain) {}

Batch Evaluator::batch_of(const Setting& setting, int attributes,
                          std::span<const float> numbers) const {
  return {.space = setting.space,
          .frustum = frustum_cast<double>(setting.frustum),
          .volume = setting.volume,
          .attributes = attributes,
          .numbers = numbers};
}

std::vector<double> Evaluator::cheap_values(const Setting& setting, const Litter& litter,
                                            std::vector<Outcome>& outcomes) const {
  std::vector<double> values(litter.prey.size(), 0.0);
  const bool in_pairs = measure_ == Measure::crack;
  const std::vector<float> numbers = numbers_of(setting, litter.prey, kWide, in_pairs);
  const Answers wide = clip(*wide_, batch_of(setting, kWide, numbers));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (in_pairs) {
      const Sketch a(litter.answers[2 * i]), wide_a(wide[2 * i]), b(litter.answers[2 * i + 1]),
          wide_b(wide[2 * i + 1]);
      values[i] = crack_between({a, wide_a}, {b, wide_b}, kThird);
    } else {
      const PolygonView polygon = litter.answers[i];
      Errors errors = sketched_errors(polygon, Sketch(polygon), Sketch(wide[i]));
      outcomes[i] = errors.comparison.outcome;
      if (measure_ == Measure::attribute) {
        errors.largest_attribute = largest_attribute(case_of(setting, litter.prey[i], attributes_));
      }
      values[i] = hunt::value_of(measure_, errors);
    }
  }
  return values;
}

double Evaluator::plain_value(const Setting& setting, const Litter& litter, std::size_t i) const {
  if (measure_ == Measure::containment) return overshoot(setting.volume, litter.answers[i]);
  return is_crash(litter.answers[i]) ? 1 : 0;
}

std::vector<double> Evaluator::plain_values(const Setting& setting, const Litter& litter,
                                            std::vector<Outcome>& outcomes) const {
  std::vector<double> values(litter.prey.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = plain_value(setting, litter, i);
    if (is_crash(litter.answers[i])) outcomes[i] = Outcome::not_finite;
  }
  return values;
}

bool Evaluator::is_outside(const HardCase& hard_case) const {
  if (!in_domain_) return false;
  const auto groups = grouped(std::span(&hard_case, 1));
  return !examine(contestant_, groups.front().batch, {Question::covers}).front().in_domain;
}

double Evaluator::exact_value(const Setting& setting, const Litter& litter, std::size_t i) const {
  const Prey& prey = litter.prey[i];
  if (measure_ == Measure::crack) {
    const HardCase a = case_of(setting, prey, kWide), b = neighbour_of(setting, prey, kWide);
    const TruthPolygon truth_a = truth_polygon(truth_of(a), a.vertices, kWide),
                       truth_b = truth_polygon(truth_of(b), b.vertices, kWide);
    const Sketch answer_a(litter.answers[2 * i]), answer_b(litter.answers[2 * i + 1]),
        wide_a(truth_a), wide_b(truth_b);
    return crack_between({answer_a, wide_a}, {answer_b, wide_b}, kThird);
  }
  const HardCase c = case_of(setting, prey, attributes_);
  if (is_outside(c)) return 0;
  const TruthPolygon truth = truth_polygon(truth_of(c), c.vertices, c.attribute_count);
  return hunt::value_of(measure_, errors_of(c, litter.answers[i], truth));
}

// What is next to the exact polygon number by number does not fail, though vertices that are apart
// may have become one; nor does who gives no answer where none has room for it.
Outcome Evaluator::exact_outcome_of(const Setting& setting, const Litter& litter,
                                    std::size_t i) const {
  const HardCase c = case_of(setting, litter.prey[i], attributes_);
  if (is_outside(c)) return Outcome::exact;
  const TruthPolygon truth = truth_polygon(truth_of(c), c.vertices, c.attribute_count);
  const Comparison comparison = compare(litter.answers[i], truth);
  if (!comparison.visible || !is_failure(comparison.outcome)) return Outcome::exact;
  if (comparison.outcome == Outcome::missing && overflows(*contestant_.format, truth)) {
    return Outcome::exact;
  }
  const Found faithful = judge_faithful(litter.answers[i], truth, comparison);
  return faithful.judged && faithful.reason.empty() ? Outcome::exact : comparison.outcome;
}

void Evaluator::find_failing(const Setting& setting, const Litter& litter,
                             const std::vector<Outcome>& seeming, const Outcomes& known,
                             Evaluated& evaluated) const {
  Outcomes found = known;
  std::array<std::size_t, kOutcomes> asked{};
  for (std::size_t i = 0; i < seeming.size(); ++i) {
    const auto place = static_cast<std::size_t>(seeming[i]);
    if (!is_failure(seeming[i]) || known.test(place) || asked[place] == kFailing) continue;
    ++asked[place];
    const Outcome outcome = exact_outcome_of(setting, litter, i);
    if (!is_failure(outcome) || found.test(static_cast<std::size_t>(outcome))) continue;
    found.set(static_cast<std::size_t>(outcome));
    evaluated.failing.emplace_back(outcome, litter.prey[i]);
  }
}

Evaluated Evaluator::evaluate(const Setting& setting, std::span<const Prey> prey, double floor,
                              const Outcomes& known) const {
  Evaluated evaluated;
  if (prey.empty()) return evaluated;
  const bool in_pairs = measure_ == Measure::crack;
  const std::vector<float> numbers = numbers_of(setting, prey, attributes_, in_pairs);
  const Litter litter{prey, clip(contestant_, batch_of(setting, attributes_, numbers))};
  std::vector<Outcome> seeming(prey.size(), Outcome::exact);
  const std::vector<double> values =
      is_cheap() ? cheap_values(setting, litter, seeming) : plain_values(setting, litter, seeming);
  std::vector<std::size_t> order(prey.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !(values[i] > floor); });
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) { return values[i]; });
  order.resize(std::min(order.size(), kExact));
  for (const std::size_t i : order) {
    Prey found = prey[i];
    found.value = is_cheap() ? exact_value(setting, litter, i) : values[i];
    if (found.value > floor) evaluated.worst.push_back(found);
  }
  std::ranges::stable_sort(evaluated.worst, std::ranges::greater(), &Prey::value);
  if (!in_pairs) find_failing(setting, litter, seeming, known, evaluated);
  return evaluated;
}

std::vector<double> Evaluator::exact_values(const Setting& setting,
                                            std::span<const Prey> prey) const {
  const std::vector<float> numbers =
      numbers_of(setting, prey, attributes_, measure_ == Measure::crack);
  const Litter litter{prey, clip(contestant_, batch_of(setting, attributes_, numbers))};
  std::vector<double> values(prey.size());
  for (std::size_t i = 0; i < prey.size(); ++i) {
    values[i] = is_cheap() ? exact_value(setting, litter, i) : plain_value(setting, litter, i);
  }
  return values;
}

}  // namespace clipscope::experiments::hunt
