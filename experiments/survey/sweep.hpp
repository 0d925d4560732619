// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps: very many triangles through all clippers against the exact reference, chunk by chunk.
//
// Chunks are made, clipped and judged in parallel and tallied in order: memory does not grow with
// the number of triangles, and the result depends neither on the number of threads nor on their
// order. A search by random triangles gives a lower bound of the worst error, an exhaustive lattice
// an upper bound on that lattice.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/machine/progress.hpp"

namespace clipscope::experiments {

// What a contestant did on many primitives: outcomes, largest errors, and the inputs of the worst.
struct Tally {
  OutcomeCounts outcomes{};     // of primitives visible in truth or in the answer
  std::int64_t primitives = 0;  // all of them
  std::int64_t failures = 0;    // see is_failure
  double max_px = 0, max_ulp = 0, max_attribute = 0;  // over those with the right vertices
  std::string worst;    // input of the primitive with max_px, as hex floats
  std::string failing;  // input of the first primitive of the rarest kind of failure
  Outcome failing_outcome = Outcome::exact;

  // replay: the primitive's input as text.
  void add(const Comparison& comparison, const std::function<std::string()>& replay);
  // Adds what comes after this.
  Tally& operator+=(const Tally& other);
};

// Calls work(i) for 0 <= i < count, a window of them at once in parallel, and take(result) in their
// order.
template <class Work, class Take>
void work_in_order(std::size_t count, std::size_t window, Progress& progress, const Work& work,
                   const Take& take) {
  for (std::size_t first = 0; first < count; first += window) {
    std::vector<decltype(work(first))> results(std::min(window, count - first));
    tbb::parallel_for(std::size_t{0}, results.size(),
                      [&](std::size_t i) { results[i] = work(first + i); });
    for (auto& result : results) take(result);
    progress.advance(results.size());
  }
}

// Triangles of one space: view-space ones with their frustum, or clip-space ones with their volume.
struct SweepChunk {
  std::optional<Frustum<float>> frustum;  // none: clip space
  ClipVolume volume;
  std::vector<ViewTriangle<float, kSceneAttributes>> view;
  std::vector<ClipTriangle<float, kSceneAttributes>> clip;

  Batch batch() const;
};

// What the triangle is, for `clipscope explain`: options, then its numbers as hex floats.
std::string replay_text(const SweepChunk& chunk, std::size_t triangle);

// One tally per contestant; a clipper that does not take a chunk's space has nothing for it.
// make_chunk(i), 0 <= i < chunks, is called from several threads and always gives the same for an
// i. Contestants in float and double only. Errors: UsageError for other scalars.
std::vector<Tally> sweep(std::size_t chunks,
                         const std::function<SweepChunk(std::size_t)>& make_chunk,
                         const Contestants& contestants, Progress& progress);

}  // namespace clipscope::experiments
