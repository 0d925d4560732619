// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the accuracy's tables.
#pragma once

#include "experiments/contestants/columns.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/survey/accuracy.hpp"

namespace clipscope::experiments::accuracy {

struct Row {
  std::string scene, clipper, scalar;
  AccuracyFigures figures;

  static constexpr std::string_view kName = "accuracy";
  static constexpr std::string_view kTitle = "Accuracy against the exact reference";
  static constexpr std::array kNotes = {kAccuracyNote};
  static constexpr auto columns() {
    using R = Row;
    return std::tuple(column("scene", &R::scene), contestant_columns(&R::clipper, &R::scalar),
                      group(&R::figures));
  }
};

struct WorstRow {
  std::string scene, clipper, scalar;
  double error_px = 0;
  std::string view;
  std::size_t triangle = 0;  // its number in the scene's mesh

  static constexpr std::string_view kName = "accuracy_worst";
  static constexpr std::string_view kTitle =
      "The triangle of each scene on which a clipper is farthest off";
  static constexpr auto columns() {
    using R = WorstRow;
    return std::tuple(column("scene", &R::scene), contestant_columns(&R::clipper, &R::scalar),
                      column("error_px", "error [px]", &R::error_px), column("view", &R::view),
                      column("triangle", &R::triangle));
  }
};

// What is said of accuracy at the end, from the rows of its table alone.

// The largest error of the usual clippers in float, by scene. Without series if nothing was judged.
Plot error_plot(const std::vector<Row>& rows);

// Where float clipping is visibly off though the vertices are the right ones, and by how much.
std::string finding(const std::vector<Row>& rows);

}  // namespace clipscope::experiments::accuracy
