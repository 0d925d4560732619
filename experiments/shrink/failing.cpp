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
        excess[group.places[i]] = excess_of(comparisons[i], answers[i], group.batch.volume);
      }
    }
    return excess;
  };
}

Failing failing_with(const Contestant& contestant, Outcome outcome) {
  return failing_by(contestant, [outcome](const Comparison& c, const auto&, const auto&) {
    if (!c.visible || c.outcome != outcome) return 0.0;
    return outcome == Outcome::visible ? c.position_px / kSubpixel
                                       : std::numeric_limits<double>::infinity();
  });
}

}  // namespace clipscope::experiments
