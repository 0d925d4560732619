// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one piece of an experiment's work leaves beside the rows of its tables.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/clock/clock.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/machine/measuring.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/selection/select.hpp"

namespace clipscope::experiments {

// The raw samples behind a figure, such as the ns per triangle of each round.
struct Samples {
  std::string series;  // what was sampled: "soup homogeneous/sutherland_hodgman float"
  std::string unit;
  std::vector<double> values;
};

// The input on which a contestant was farthest off.
struct WorstInput {
  std::string clipper, scalar;
  std::string measure;  // what `error` is, with its unit: "position_px"
  double error = 0;
  // Options that `clipscope explain` takes, " : ", and hex floats as it reads them; of a crack both
  // triangles, without options.
  std::string input;
  std::string replay;  // the command that shows it
};

// A picture that was written into the experiment's folder.
struct Picture {
  std::string
      file;  // relative to that folder: "floor-cvv-naive.png"; in the store to that of the run
  std::string caption;
};

// The series of a piece's runs under the clock; its values are those of Interruptions, in order.
inline constexpr const char* kRunSeries = "runs under the clock";

struct PieceRecord {
  std::vector<Samples> samples;
  std::vector<WorstInput> worst_inputs;
  std::vector<Picture> pictures;

  // What was timed, in ns per item; nothing of a task that was refused.
  void add(std::string series, const Timing& timing, std::string_view item = "triangle") {
    if (!timing.is_timed()) return;
    samples.push_back({std::move(series), "ns per " + std::string(item), timing.samples_ns});
  }
  // What was run under the clock; nothing if nothing was.
  void add(const Interruptions& runs) {
    if (runs.runs == 0) return;
    const auto value = [](std::int64_t count) { return static_cast<double>(count); };
    samples.push_back({kRunSeries,
                       "runs and seconds",
                       {value(runs.runs), value(runs.redone), value(runs.disturbed), runs.seconds,
                        runs.others_seconds}});
  }
};

// The record of a scene's triangle that a contestant is farthest off on.
struct WorstTriangle {
  const View& view;
  const SceneTriangle& triangle;
  std::size_t number;   // in the scene's mesh
  std::string measure;  // what `error` is, with its unit
  double error;
};

// With the triangle as hex floats and the command that shows it.
WorstInput worst_input(const Selection& selection, const Scene& scene, const Contestant& contestant,
                       const WorstTriangle& worst);

// The same of a primitive that is in no scene, from its replay_text (selection/replay_text.hpp).
// command: which of the program's reads it.
WorstInput worst_input(const Contestant& contestant, const std::string& replay_text,
                       const std::string& measure, double error,
                       std::string_view command = "explain");

}  // namespace clipscope::experiments
