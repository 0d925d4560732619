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
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/judge/rounding_count.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

// Primitives with the right vertices by the ulp that they are off: not more than each of these that
// the ones before it do not hold, and more.
inline constexpr std::array kUlpLimits = {0.5, 1.0, 2.0, 4.0, 16.0, 256.0, 65536.0};
inline constexpr std::size_t kUlpBins = kUlpLimits.size() + 1;
inline constexpr std::array<std::string_view, kUlpBins> kUlpBinNames = {
    "half_ulp", "1_ulp", "2_ulp", "4_ulp", "16_ulp", "256_ulp", "65536_ulp", "more_ulp"};

// What a contestant did on many primitives: outcomes, largest errors, and the inputs of the worst.
// The sum of tallies depends neither on their order nor on what was added to what before: of equal
// errors that of the lowest chunk stays.
struct Tally {
  std::int64_t primitives = 0;  // all of them
  std::int64_t failures = 0;    // see is_failure
  OutcomeCounts outcomes{};     // of primitives visible in truth or in the answer
  double max_px = 0, max_ulp = 0, max_attribute = 0;  // over those with the right vertices
  std::array<std::int64_t, kUlpBins> ulps{};          // likewise, by kUlpLimits
  RoundingCount rounding;
  std::string worst;    // input of the primitive with max_px, as hex floats
  std::string failing;  // input of the first primitive of the rarest kind of failure
  std::optional<std::int64_t> worst_chunk, failing_chunk;  // of a sweep, where these are

  // The rarest kind of failure; exact if there was none.
  Outcome failing_outcome() const;

  // replay: the primitive's input as text.
  void add(const Comparison& comparison, const std::function<std::string()>& replay);
  Tally& operator+=(const Tally& other);

  static constexpr auto columns() {
    using T = Tally;
    return std::tuple(
        column("triangles", &T::primitives), column("failures", "fails", &T::failures),
        columns_of_array(&T::outcomes, kOutcomeNames), column("max_px", "max px", &T::max_px),
        column("max_ulp", "max ulp", &T::max_ulp),
        column("max_attribute", "max attr", &T::max_attribute),
        columns_of_array(&T::ulps, kUlpBinNames), group(&T::rounding),
        column("worst_chunk", "chunk", &T::worst_chunk),
        column("worst", "largest error on", &T::worst),
        column("failing_chunk", "chunk", &T::failing_chunk),
        column("failing", "fails on", &T::failing));
  }
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

// Chunks of a sweep, by their numbers, ascending.
using ChunkNumbers = std::span<const std::size_t>;

// What a sweep goes through: so many chunks, each a pure function of its number.
struct SweepSource {
  std::size_t chunks = 0;
  // Called from several threads, with numbers below `chunks`.
  std::function<SweepChunk(std::size_t)> chunk;
};

// How many chunks are in work at once.
inline constexpr std::size_t kChunksAtOnce = 64;

// One tally per contestant over some chunks of the source; a clipper that does not take a chunk's
// space has nothing for it. Contestants in float and double only. Errors: UsageError for other
// scalars.
std::vector<Tally> sweep(const SweepSource& source, ChunkNumbers chunks,
                         const Contestants& contestants, Progress& progress);
// Over all of them.
std::vector<Tally> sweep(const SweepSource& source, const Contestants& contestants,
                         Progress& progress);

}  // namespace clipscope::experiments
