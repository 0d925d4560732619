// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/worst_input.hpp"

#include <fmt/format.h>

#include "experiments/report/replay_text.hpp"

namespace clipscope::experiments {
WorstInput worst_input(const Selection& selection, const Scene& scene,
                       const AnyContestant& contestant, const WorstTriangle& worst) {
  const std::string clipper(clipper_name(contestant)), scalar(scalar_name(contestant));
  return {clipper,
          scalar,
          worst.measure,
          worst.error,
          hex_line(worst.triangle),
          fmt::format("clipscope explain --scene {} --view '{}' --triangle {} --seed {}{} "
                      "--clipper {} --scalar {}",
                      scene.name, worst.view.label, worst.number, selection.seed,
                      selection.quick ? " --quick" : "", clipper, scalar)};
}

}  // namespace clipscope::experiments
