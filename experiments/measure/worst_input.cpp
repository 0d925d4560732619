// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/worst_input.hpp"

#include <fmt/format.h>

namespace clipscope::experiments {
namespace {

std::string hex_floats(const SceneTriangle& triangle) {
  std::string text;
  for (const auto& v : triangle) {
    for (int c = 0; c < 3; ++c) text += fmt::format("{:a} ", v.position[c]);
    for (int k = 0; k < kSceneAttributes; ++k) text += fmt::format("{:a} ", v.attributes[k]);
  }
  text.pop_back();
  return text;
}

}  // namespace

WorstInput worst_input(const Selection& selection, const Scene& scene,
                       const AnyContestant& contestant, const WorstTriangle& worst) {
  const std::string clipper(clipper_name(contestant)), scalar(scalar_name(contestant));
  return {clipper,
          scalar,
          worst.measure,
          worst.error,
          hex_floats(worst.triangle),
          fmt::format("clipscope explain --scene {} --view '{}' --triangle {} --seed {}{} "
                      "--clipper {} --scalar {}",
                      scene.name, worst.view.label, worst.number, selection.seed,
                      selection.quick ? " --quick" : "", clipper, scalar)};
}

}  // namespace clipscope::experiments
