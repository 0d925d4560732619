// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a cell, one piece of an experiment's work, leaves beside the rows of its tables.
#pragma once

#include <string>
#include <vector>

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
  std::string input;   // hex floats, as `clipscope explain` reads them
  std::string replay;  // the command that shows it
};

// A picture that was written into the results folder.
struct Picture {
  std::string file;  // relative to the results folder: "floor-cvv-naive.png"
  std::string caption;
};

struct CellRecord {
  std::vector<Samples> samples;
  std::vector<WorstInput> worst_inputs;
  std::vector<Picture> pictures;
};

}  // namespace clipscope::experiments
