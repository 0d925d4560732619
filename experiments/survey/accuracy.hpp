// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy of clippers on a scene: every triangle of every view against the exact reference.
//
// The mesh is streamed in chunks; memory does not grow with the number of triangles. Triangles of a
// chunk are judged in parallel and tallied in order, so that the result does not depend on the
// number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/table/row.hpp"
#include "experiments/table/statistics.hpp"

namespace clipscope::experiments {

// The triangle that a largest error was found on.
struct Worst {
  double error = 0;
  std::string scene, view;
  std::size_t triangle = 0;  // its number in the mesh
};

struct AccuracyTally {
  OutcomeCounts outcomes{};    // of triangles visible in truth or in the answer
  std::int64_t triangles = 0;  // all of them
  LogHistogram position_px, position_ulp, attribute;
  double overshoot = 0;  // the largest (judge/containment.hpp)
  Worst worst_position;
};

struct AccuracyOptions {
  reference::TruthKind truth = reference::TruthKind::frustum;
  std::size_t triangles_per_view = 0;  // evenly spaced over the mesh; 0: all
  bool in_double = false;              // for whom takes_doubles holds
};

// The number of triangles that measure_accuracy will go through.
std::size_t sampled_triangles(const Scene& scene, const AccuracyOptions& options);

// Adds to tallies[i] what contestants[i] does on the scene; advances progress by sampled triangles.
void measure_accuracy(const Scene& scene, const Contestants& contestants,
                      const AccuracyOptions& options, std::span<AccuracyTally> tallies,
                      Progress& progress);

// The columns that tell a clipper's accuracy in every table that does: counts by outcome, errors.
struct AccuracyFigures {
  std::array<std::int64_t, kViewOutcomes> outcomes{};
  std::optional<Spread> px, ulp, attribute;
  double overshoot = 0;

  AccuracyFigures() = default;
  explicit AccuracyFigures(const AccuracyTally& tally)
      : outcomes(view_outcomes(tally.outcomes)),
        px(spread_of(tally.position_px)),
        ulp(spread_of(tally.position_ulp)),
        attribute(spread_of(tally.attribute)),
        overshoot(tally.overshoot) {}

  // Triangles that look wrong, see is_failure.
  std::int64_t wrong() const {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (is_failure(static_cast<Outcome>(i))) sum += outcomes[i];
    }
    return sum;
  }

  static constexpr auto outcome_columns() {
    return std::tuple(columns_of_array(&AccuracyFigures::outcomes, kViewOutcomeNames));
  }
  static constexpr auto px_columns() {
    return std::tuple(spread("px", "px", &AccuracyFigures::px));
  }
  static constexpr auto other_columns() {
    return std::tuple(spread("ulp", "ulp", &AccuracyFigures::ulp),
                      spread("attribute", "attr", &AccuracyFigures::attribute),
                      column("overshoot_ndc", "beyond", &AccuracyFigures::overshoot));
  }
  static constexpr auto columns() {
    return std::tuple_cat(outcome_columns(), px_columns(), other_columns());
  }
};

// What the columns mean.
inline constexpr std::string_view kAccuracyNote =
    "Outcomes count triangles that are visible in truth or in the answer. Errors are each triangle's largest, over triangles with the right vertices: px on 3840 x 2160; ulp of the scalar's own format over x, y, z and 1/w; attributes absolute. Beyond is how far the farthest vertex lies outside the volume, in NDC.";

}  // namespace clipscope::experiments
