// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a contestant makes of a litter of prey: all of it by the cheap comparison (sketch.hpp), what
// may be worst by the exact one.
#pragma once

#include <bitset>
#include <span>
#include <utility>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/hunt/measure.hpp"
#include "experiments/hunt/prey.hpp"

namespace clipscope::experiments::hunt {

using Outcomes = std::bitset<kOutcomes>;

struct Evaluated {
  std::vector<Prey> worst;                             // values are exact, the largest first
  std::vector<std::pair<Outcome, Prey>> failing = {};  // exact, at most one of each outcome
};

// Who says of a litter what is worst: an evaluator, or whoever else a hunt is made for.
class Rater {
 public:
  virtual ~Rater() = default;
  // How many of a prey's attributes count.
  virtual int attributes() const = 0;
  // floor: only larger values count. known: outcomes of which there is an example already.
  // Asked for several litters at once.
  virtual Evaluated evaluate(const Setting& setting, std::span<const Prey> litter, double floor,
                             const Outcomes& known) const = 0;
  // The exact values of the measure.
  virtual std::vector<double> exact_values(const Setting& setting,
                                           std::span<const Prey> litter) const = 0;
};

class Evaluator : public Rater {
 public:
  // The contestant outlives it. in_domain: only triangles that the bounds of `covers` speak of have
  // a value (judge/questions.hpp); not of pairs.
  Evaluator(const Contestant& contestant, Measure measure, bool in_domain = false);

  // How many of a prey's attributes the contestant gets.
  int attributes() const override { return attributes_; }
  Evaluated evaluate(const Setting& setting, std::span<const Prey> litter, double floor,
                     const Outcomes& known) const override;
  std::vector<double> exact_values(const Setting& setting,
                                   std::span<const Prey> litter) const override;

 private:
  struct Litter;
  // Whether the measure is of the exact answer, so that a cheap comparison goes before it.
  bool is_cheap() const { return measure_ <= Measure::attribute || measure_ == Measure::crack; }
  Batch batch_of(const Setting& setting, int attributes, std::span<const float> numbers) const;
  std::vector<double> cheap_values(const Setting& setting, const Litter& litter,
                                   std::vector<Outcome>& outcomes) const;
  double plain_value(const Setting& setting, const Litter& litter, std::size_t i) const;
  std::vector<double> plain_values(const Setting& setting, const Litter& litter,
                                   std::vector<Outcome>& outcomes) const;
  double exact_value(const Setting& setting, const Litter& litter, std::size_t i) const;
  bool is_outside(const HardCase& hard_case) const;
  Outcome exact_outcome_of(const Setting& setting, const Litter& litter, std::size_t i) const;
  void find_failing(const Setting& setting, const Litter& litter,
                    const std::vector<Outcome>& seeming, const Outcomes& known,
                    Evaluated& evaluated) const;

  const Contestant& contestant_;
  const Contestant* wide_;
  Measure measure_;
  int attributes_;
  bool in_domain_;
};

}  // namespace clipscope::experiments::hunt
