// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sign of w: the cases of the catalogue about it by clipper, and what a w-plane w >= epsilon costs
// near the eye by the scale of the scene.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/experiment.hpp"
#include "experiments/hard_cases/judge.hpp"
#include "experiments/measure/machine.hpp"

namespace clipscope::experiments {
namespace {

// The cases about w, and those about the scale of homogeneous coordinates.
bool is_about_w(const HardCase& c) {
  return c.primitive == Primitive::triangle &&
         (c.name.starts_with("w_sign/") || c.name.starts_with("scale/"));
}

Table outcomes_by_clipper(const Selection& selection) {
  std::vector<Column> columns = {
      {"clipper", "clipper"}, {"scalar", "scalar"}, {"failures", "fails"}};
  for (const std::string_view name : kOutcomeNames) {
    columns.push_back({std::string(name), std::string(name)});
  }
  Table table("w_sign", "What each clipper does with w < 0, w = 0, tiny w and mixed signs",
              columns);
  for (const CaseContestant& contestant :
       case_contestants(Primitive::triangle, selection.clipper, selection.scalars)) {
    std::array<std::int64_t, kOutcomes> counts{};
    std::int64_t failures = 0;
    for (const HardCase& c : builtin_catalogue()) {
      if (!is_about_w(c)) continue;
      const Outcome outcome = contestant.answer(c, truth_polygon(c)).comparison.outcome;
      ++counts[static_cast<std::size_t>(outcome)];
      failures += is_failure(outcome);
    }
    std::vector<Cell> cells = {contestant.clipper, contestant.scalar, failures};
    cells.insert(cells.end(), counts.begin(), counts.end());
    table.add_row(std::move(cells));
  }
  table.add_note("The cases of the themes w_sign and scale of the catalogue.");
  return table;
}

// A wall that passes the eye: from behind it to far ahead, a tenth of the scale to the right, seen with
// 90 degrees and a near plane at 1/1000 of the scale.
HardCase wall_past_the_eye(double scale) {
  HardCase wall;
  wall.space = Space::view;
  const auto length = [scale](double x) { return double{static_cast<float>(x * scale)}; };
  wall.frustum = {.near = length(1e-3), .far = length(1e3)};
  wall.frustum.right = wall.frustum.top = wall.frustum.near;
  wall.frustum.left = wall.frustum.bottom = -wall.frustum.near;
  const std::array<std::array<double, 3>, 3> corners = {
      {{0.1, -5, 2}, {0.1, 0.1, -60}, {0.0015, 0.001, 0.5}}};
  for (const auto& p : corners) {
    reference::InputVertex& v = wall.vertices.emplace_back();
    v.position = {length(p[0]), length(p[1]), length(p[2]), 1};
  }
  return wall;
}

// Area on a screen of 3840 x 2160.
template <class Vertices>
double area_px(const Vertices& vertices) {
  double area = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& a = vertices[i];
    const auto& b = vertices[(i + 1) % vertices.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2 * (kScreenWidth / 2) * (kScreenHeight / 2);
  }
  return std::abs(area);
}

// The smallest depth that is drawn: w is the depth in front of the eye.
double nearest_depth(const std::vector<std::array<double, 4>>& polygon) {
  double nearest = HUGE_VAL;
  for (const auto& v : polygon) nearest = std::min(nearest, 1 / v[3]);
  return nearest;
}

Table price_of_epsilon() {
  Table table("w_sign_epsilon",
              "A wall past the eye: what w >= epsilon cuts away, by the scene's scale",
              {{"scale_m", "scale [m]"},
               {"near_m", "near plane [m]"},
               {"clipper", "clipper"},
               {"visible_px2", "visible [px^2]"},
               {"lost_px2", "lost [px^2]"},
               {"lost_percent", "lost [%]"},
               {"nearest_drawn_m", "nearest drawn [m]"}});
  for (const double scale : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    const HardCase wall = wall_past_the_eye(scale);
    const TruthPolygon truth = truth_polygon(wall);
    const double visible = area_px(truth.approximation);
    for (const CaseContestant& contestant :
         case_contestants(Primitive::triangle, "homogeneous/w_first_*", {"float"})) {
      const CaseAnswer answer = contestant.answer(wall, truth);
      const double lost = visible - area_px(answer.polygon);
      table.add_row({scale, wall.frustum.near, contestant.clipper, visible, lost,
                     100 * lost / visible,
                     answer.polygon.empty() ? Cell() : Cell(nearest_depth(answer.polygon))});
    }
  }
  table.add_note(
      "Lost: the exact visible area less the area drawn, on 3840 x 2160, float. A w-plane in front "
      "of "
      "the near plane costs nothing; behind it, everything in between.");
  return table;
}

}  // namespace

void run_w_sign(const ExperimentContext& context) {
  Table outcomes = outcomes_by_clipper(context.selection());
  outcomes.add_note(machine_description());
  context.emit(outcomes);
  context.emit(price_of_epsilon());
}

}  // namespace clipscope::experiments
