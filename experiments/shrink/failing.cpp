// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shrink/failing.hpp"

#include <limits>
#include <utility>

#include "experiments/shrink/case_groups.hpp"

namespace clipscope::experiments {

Failing failing_by(const Contestant& contestant, ExcessOf excess_of) {
  return [&contestant, excess_of = std::move(excess_of)](std::span<const HardCase> cases) {
    std::vector<double> excess(cases.size(), 0.0);
    for (const CaseGroup& group : grouped(cases)) {
      if (!contestant.takes(group.batch)) continue;
      const Answers answers = clip(contestant, group.batch);
      const std::vector<Comparison> comparisons =
          compare(answers, truth_polygons(reference::truth_of(group.batch), group.batch));
      for (std::size_t i = 0; i < comparisons.size(); ++i) {
        const std::size_t place = group.places[i];
        excess[place] = excess_of(cases[place], answers[i], comparisons[i]);
      }
    }
    return excess;
  };
}

Failing failing_at(const Contestant& contestant, Question question) {
  return [&contestant, question](std::span<const HardCase> cases) {
    std::vector<double> excess(cases.size(), 0.0);
    for (const CaseGroup& group : grouped(cases)) {
      if (!contestant.takes(group.batch)) continue;
      const std::vector<Examined> examined = examine(contestant, group.batch, {question});
      for (std::size_t i = 0; i < examined.size(); ++i) {
        const BrokenPromise* const violation = examined[i].violation(question);
        if (violation != nullptr && examined[i].in_domain) {
          excess[group.places[i]] = violation->excess;
        }
      }
    }
    return excess;
  };
}

Failing failing_in_domain(const Contestant& contestant, Failing failing) {
  return [&contestant, failing = std::move(failing)](std::span<const HardCase> cases) {
    std::vector<double> excess = failing(cases);
    for (const CaseGroup& group : grouped(cases)) {
      if (!contestant.takes(group.batch)) continue;
      const std::vector<Examined> examined = examine(contestant, group.batch, {Question::covers});
      for (std::size_t i = 0; i < examined.size(); ++i) {
        if (!examined[i].in_domain) excess[group.places[i]] = 0;
      }
    }
    return excess;
  };
}

Failing failing_with(const Contestant& contestant, Outcome outcome) {
  return failing_by(contestant, [outcome](const auto&, const auto&, const Comparison& c) {
    if (!c.visible || c.outcome != outcome) return 0.0;
    return outcome == Outcome::visible ? c.position_px / kSubpixel
                                       : std::numeric_limits<double>::infinity();
  });
}

}  // namespace clipscope::experiments
