// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps: very many triangles through all clippers against the exact reference, chunk by chunk.
//
// Chunks are made, clipped and judged in parallel and tallied in order: memory does not grow with the
// number of triangles, and the result depends neither on the number of threads nor on their order.
// A search by random triangles gives a lower bound of the worst error, an exhaustive lattice an upper
// bound on that lattice.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {

// Triangles of one space: view-space ones with their frustum, or clip-space ones with their volume.
struct SweepChunk {
  std::optional<Frustum<float>> frustum;  // none: clip space
  ClipVolume volume;
  std::vector<ViewTriangle<float, kSceneAttributes>> view;
  std::vector<ClipTriangle<float, kSceneAttributes>> clip;

  std::size_t size() const { return frustum ? view.size() : clip.size(); }
};

struct SweepTally {
  std::array<std::int64_t, kOutcomes> outcomes{};  // of triangles visible in truth or in the answer
  std::int64_t triangles = 0;
  std::int64_t failures = 0;
  double max_px = 0, max_ulp = 0, max_attribute = 0;  // over triangles with the right vertices
  std::string worst;    // input of the triangle with max_px, as hex floats
  std::string failing;  // input of the first triangle of the rarest kind of failure
  Outcome failing_outcome = Outcome::exact;
};

// What the triangle is, for `clipscope explain`: options, then its numbers as hex floats.
std::string replay_text(const SweepChunk& chunk, std::size_t triangle);

// One tally per contestant; a clipper that does not take a chunk's space has nothing for it.
// make_chunk(i), 0 <= i < chunks, is called from several threads and always gives the same for an i.
// Contestants in float and double only. Errors: UsageError for other scalars.
std::vector<SweepTally> sweep(std::size_t chunks,
                              const std::function<SweepChunk(std::size_t)>& make_chunk,
                              const std::vector<AnyContestant>& contestants, Progress& progress);

}  // namespace clipscope::experiments
