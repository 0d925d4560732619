// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the effects' tables, what makes them and what is said of them at the end.
//
// Planned pipelines are compared with the full one, homogeneous/sutherland_hodgman, and timed
// beside it and beside transform and divide alone, on the same triangles in the mesh's order.
// Before that the full polygons are checked against their clipper's promise, on some triangles of
// each view, and the planned ones against the full ones, on all. Facts are right where the plans
// made of them do no harm; transform and divide alone are no answer, but what no pipeline does
// without.
#pragma once

#include <span>

#include "experiments/clock/clock.hpp"
#include "experiments/effects/plan_table.hpp"
#include "experiments/report/plot.hpp"

namespace clipscope::experiments::effects {

struct Harm {
  std::size_t polygons = 0;  // compared
  // Polygons of which some bit differs: of x, y and the attributes; of z if the plan has depth; of
  // 1/w if it has perspective correction.
  std::size_t changed = 0;
  // The largest difference of an attribute between perspective-correct and affine interpolation
  // that was found within a polygon; 0 with perspective correction. A lower bound: edges are
  // searched at their worst point, insides at the points of a grid.
  double attribute_error = 0;
  // How full polygons break their promise; empty if they keep it.
  std::string broken = {};

  Harm& operator+=(const Harm& other);
  // Why planned polygons are not to be used; empty if they may be.
  std::string text(double tolerance) const;

  static constexpr auto columns() {
    return std::tuple(column("polygons", &Harm::polygons),
                      column("changed_polygons", "changed", &Harm::changed),
                      column("max_attribute_error", "max attribute error", &Harm::attribute_error));
  }
};
Harm harm_of(const PlannedView& view);
Harm harm_of(std::span<const PlannedView> views);

// ns per triangle. A pipeline whose answers are wrong is refused.
struct Timings {
  Timing full, planned;
  Timing bare;        // transform and divide alone, nothing clipped
  Timing facts;       // SceneFacts of each view
  Timing attributes;  // AttributeFacts, once per mesh
};

// harm: that of the views. Pre-condition: there is a triangle.
Timings time_planned(std::span<const PlannedView> views, const Harm& harm,
                     const ClockOptions& options);

// Medians in ns per triangle, and ratios of rounds.
struct Times {
  double full_ns = 0, planned_ns = 0, bare_ns = 0, facts_ns = 0, mesh_facts_ns = 0;
  MedianInterval to_full, to_bare;  // of planned
  std::optional<double> facts_to_saved;

  Times() = default;
  // Pre-condition: all were timed.
  explicit Times(const Timings& timings);

  static constexpr auto columns() {
    using T = Times;
    return std::tuple(column("full_ns_per_triangle", "full ns/tri", &T::full_ns),
                      column("planned_ns_per_triangle", "planned ns/tri", &T::planned_ns),
                      interval("planned_to_full", "planned_to_full", "/ full", &T::to_full),
                      column("bare_ns_per_triangle", "bare ns/tri", &T::bare_ns),
                      interval("planned_to_bare", "planned_to_bare", "/ bare", &T::to_bare),
                      column("facts_ns_per_triangle", "facts ns/tri", &T::facts_ns),
                      column("facts_to_saved", "facts / saved", &T::facts_to_saved),
                      column("mesh_facts_ns_per_triangle", "mesh facts ns/tri", &T::mesh_facts_ns));
  }
};

struct Row {
  std::string scene;
  std::optional<Times> times;  // nothing where the planned pipeline's answers are wrong
  Harm harm;
  std::string called_for;

  static constexpr std::string_view kName = "effects";
  static constexpr std::string_view kTitle =
      "What a scene calls for, and the time of a pipeline of just that (float)";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "full: homogeneous/sutherland_hodgman. planned: what each view calls for, planned by itself. bare: transform and divide alone, nothing clipped. Ratios: median over rounds, 95 % interval.",
      "facts: the look at a view from which its plan is made; facts / saved: in how many frames with the same facts that look is paid for. mesh facts: the look at attributes, once per mesh."};
  static constexpr auto columns() {
    return std::tuple(column("scene", &Row::scene), group(&Row::times), group(&Row::harm),
                      column("effects_called_for", "effects called for", &Row::called_for));
  }
};

struct PlanRow {
  std::string scene;
  PlanLine line;

  static constexpr std::string_view kName = "effects_plan";
  static constexpr std::string_view kTitle = "Which effects each scene calls for, and why";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Over all views of a scene: the view that calls for most. test: what is outside is dropped, nothing is cut."};
  static constexpr auto columns() {
    return std::tuple(column("scene", &PlanRow::scene), group(&PlanRow::line));
  }
};

// Bars by scene: the full pipeline, the planned one, transform and divide alone.
Plot time_plot(const std::vector<Row>& rows);

std::string finding(const std::vector<Row>& rows);

}  // namespace clipscope::experiments::effects
