// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy on the very triangles that are timed, against the exact frustum (T_frustum); in the
// stage contract, whose input are clip-space triangles, against these (T_clip).
//
// Two measures that compare across scalars and leave no failure out:
//
//   error_px           how far off the screen picture of a triangle is. With the right vertices:
//                      the farthest vertex; with others: the Hausdorff distance of the two
//                      polygons; if nothing is drawn that should be, or something that should not,
//                      or inside out: how far that reaches on screen. Infinite for a coordinate
//                      that is not a number.
//   correctly rounded  coordinates (x, y, z, 1/w) that are, kept as floats, the floats nearest to
//                      the exact ones: what is left of an answer in a vertex buffer, whatever
//                      scalar it was computed in. A triangle with the wrong vertices has none; but
//                      an answer that as floats is the exact polygon rounded once is right, though
//                      vertices fall together. In the stage it is x, y, z, w.
//
// Triangles are judged in parallel and tallied in order: the result does not depend on the threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/table/statistics.hpp"

namespace clipscope::experiments {

struct BatchAccuracy {
  std::int64_t triangles = 0;  // judged
  std::int64_t visible = 0;    // in truth or in the answer; all that follows is about these
  std::int64_t wrong = 0;      // an outcome beyond `visible`
  std::int64_t coordinates = 0, correctly_rounded = 0;
  LogHistogram error_px;  // one value per visible triangle
  // The first triangle with the largest error: number in its view.
  std::size_t worst_view = 0, worst_triangle = 0;

  double correctly_rounded_percent() const;  // NaN if nothing is visible
  double wrong_percent() const;
};

// One per contestant, on every triangle of the views; advances progress by triangles.
std::vector<BatchAccuracy> judge_batches(std::span<const SampledView> views,
                                         const Contestants& contestants, Progress& progress);

// The same for the stage, on every triangle of a soup with four attributes; those without area in
// NDC count as not visible. Triangles that come out by number are drawn as they went in.
// Pre-condition: finite.
std::vector<BatchAccuracy> judge_stage(const StageInput& input, const Contestants& contestants,
                                       Progress& progress);

}  // namespace clipscope::experiments
