// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "experiments/answers/rows.hpp"
#include "experiments/effects/rows.hpp"

namespace clipscope::experiments::answers {

std::vector<EffectRow> effect_rows(const Results& results) {
  const auto& plans = results.rows<effects::PlanRow>();
  std::vector<EffectRow> rows;
  for (const effects::Row& scene : results.rows<effects::Row>()) {
    const auto left_out = std::ranges::count_if(plans, [&](const effects::PlanRow& plan) {
      return plan.scene == scene.scene && plan.line.called_for == "no";
    });
    std::optional<double> saved;
    if (scene.times) saved = 100 * (1 - scene.times->to_full.median);
    rows.push_back({scene.scene, scene.called_for, static_cast<std::int64_t>(left_out), saved,
                    static_cast<std::int64_t>(scene.harm.changed)});
  }
  return rows;
}

}  // namespace clipscope::experiments::answers
