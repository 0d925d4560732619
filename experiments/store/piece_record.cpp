// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/piece_record.hpp"

#include <fmt/format.h>

#include "experiments/selection/replay_text.hpp"

namespace clipscope::experiments {
namespace {

// replay: the command without the options that name the contestant.
WorstInput input_of(const Contestant& contestant, const std::string& measure, double error,
                    const std::string& input, const std::string& replay) {
  return {std::string(contestant.clipper),
          std::string(contestant.scalar()),
          measure,
          error,
          input,
          fmt::format("{} {}", replay, options_of(contestant))};
}

}  // namespace

WorstInput worst_input(const Selection& selection, const Scene& scene, const Contestant& contestant,
                       const WorstTriangle& worst) {
  const View& view = worst.view;
  const std::string input =
      fmt::format("--space view {} --depth {} --attributes {} : {}", projection_options(view),
                  depth_option(view.frustum.depth), kSceneAttributes, hex_line(worst.triangle));
  return input_of(contestant, worst.measure, worst.error, input,
                  fmt::format("clipscope explain --scene {} --view '{}' --triangle {} --seed {}{}",
                              scene.name, worst.view.label, worst.number, selection.seed,
                              selection.quick ? " --quick" : ""));
}

WorstInput worst_input(const Contestant& contestant, const std::string& replay_text,
                       const std::string& measure, double error, std::string_view command) {
  const std::size_t colon = replay_text.find(" : ");
  return input_of(contestant, measure, error, replay_text,
                  fmt::format("echo '{}' | clipscope {} {}", replay_text.substr(colon + 3), command,
                              replay_text.substr(0, colon)));
}

}  // namespace clipscope::experiments
