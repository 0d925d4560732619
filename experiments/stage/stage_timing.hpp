// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage contracts under the clock: clip-space triangles in, clip-space polygons out.
//
// Memory passes run in the same rounds. The input streams through in blocks of some thousand
// triangles, so that answers stay in cache while the input comes from memory; a mesh is one call,
// since its vertices are classified once. A run takes the blocks after those that the run before it
// took, whoever's that was (StageCursor): nobody finds in cache what another one has just read, and
// a slow contestant, which takes a part of the blocks, has another one in each round. An input that
// fits into a cache stays there all the same: so does it in a renderer.
//
// A renderer's clipper has its input from a vertex shader mostly, still in cache. So the same is
// measured from there: of one block of the input at a time, which lies in the second-level cache
// with its answers. It was read before, off the clock, but not clipped, so that branches are no
// better predicted than from memory. A mesh comes in draws of that size then.
//
// The memory limit of the contracts is how long reading and copying the same bytes takes:
//
//   read positions   the twelve streams of a soup
//   read everything  all vertices; of a mesh its vertices and indices
//   copy everything  the same, written again and again to a buffer that stays in cache, as answers
//                    do
//
// These passes are own loops that compute nothing but a sum, which keeps the reads. Streams, and
// the quarters of one array, are read side by side: that keeps more of memory busy than one after
// the other.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "experiments/clock/clock.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/contestants/stage_input.hpp"
#include "experiments/judge/stage_check.hpp"

namespace clipscope::experiments {

enum class MemoryPass : std::uint8_t { read_positions, read_everything, copy_everything };
inline constexpr std::array kMemoryPasses = {
    MemoryPass::read_positions, MemoryPass::read_everything, MemoryPass::copy_everything};
constexpr std::array<std::string_view, 3> names_of(MemoryPass) {
  return {"read positions", "read everything", "copy everything"};
}

// What a pass reads, per triangle; 0 for one that the input has no data for.
double bytes_of(MemoryPass pass, const StageInput& input);

// Bytes that a contract must move per triangle: in, from memory, and out, to cache.
struct StageBytes {
  double positions = 0;  // in, read as streams of positions
  double rest = 0;       // in, everything else
  double out = 0;

  double total() const { return positions + rest + out; }
};

// `out`: the bytes of the answer per triangle. By number the attributes of cut triangles alone are
// read.
StageBytes stage_bytes(const StageInput& input, Contract contract, double out);

// The time that moving these bytes takes at the speed of the passes, in ns per triangle, from the
// times of the passes in one round, by MemoryPass. What a copy takes more than a read is the price
// of its writes.
double limit_ns(const StageBytes& bytes, const std::array<double, 3>& passes_ns,
                const StageInput& input);

inline constexpr std::size_t kStageBlock = 4096;  // triangles per call

// Where an input comes from when it is clipped.
enum class InputFrom : std::uint8_t {
  memory,  // it streams through, and is more than a second-level cache holds
  cache    // the second-level one
};
constexpr std::array<std::string_view, 2> names_of(InputFrom) { return {"memory", "cache"}; }

// Reads what the contract may read of triangles [first, first + count), so that it is in cache.
// Pre-condition: whole draws of a mesh.
void touch(Contract contract, const StageInput& input, std::size_t first, std::size_t count);

struct StageClock {
  int rounds = 21;                   // from memory; more of them from cache
  double milliseconds_per_run = 10;  // a contestant's part of a round; at least a block
  StageCheckOptions check = {};
};

struct StageTiming {
  const Contestant* contestant = nullptr;
  Timing timing = {};  // ratio: to textbook in the same round
  StageBytes bytes = {};
  MedianInterval times_fastest = {};  // time over that of the contract's fastest, the same round
  MedianInterval limit_percent = {};  // the memory limit over the time of the same round
};

struct MemoryTiming {
  MemoryPass pass;
  double bytes = 0;  // read per triangle
  Timing timing;     // ratio: to textbook
};

struct StageMeasurement {
  InputFrom from = InputFrom::memory;
  std::vector<StageTiming> contestants;  // in their order
  std::vector<MemoryTiming> passes;      // those that the input has data for
};

// Where the next run begins. Of all blocks it is the one that was read longest ago.
struct StageCursor {
  std::size_t next_block = 0;
};

// A contestant on the input, which outlives it: the next blocks of at most so many triangles in
// each run, whole draws of a mesh. Tasks over one input share the cursor.
Task stage_task(const Contestant& contestant, const StageInput& input,
                const StageCheckOptions& check,
                std::shared_ptr<StageCursor> cursor = std::make_shared<StageCursor>(),
                std::size_t block = kStageBlock);

// A pass over the next blocks in each run; triangles are what is counted.
// Pre-condition: bytes_of(pass, input) > 0.
Task memory_task(MemoryPass pass, const StageInput& input,
                 std::shared_ptr<StageCursor> cursor = std::make_shared<StageCursor>(),
                 std::size_t block = kStageBlock);

// Triangles of a soup that lie in half of a second-level cache; their answers are about as large.
std::size_t cached_triangles(const StageInput& input);

// Triangles of a block that lies in half of a second-level cache with its answers; at most
// kStageBlock.
std::size_t cached_block(const StageInput& input);

// The same from cache: each run is a block. Before it, off the clock, the block before is done,
// which brings code and answers into cache, and this one is read.
// Pre-condition: a mesh is in draws of cached_block.
Task cached_stage_task(const Contestant& contestant, const StageInput& input,
                       const StageCheckOptions& check,
                       std::shared_ptr<StageCursor> cursor = std::make_shared<StageCursor>());
Task cached_memory_task(MemoryPass pass, const StageInput& input,
                        std::shared_ptr<StageCursor> cursor = std::make_shared<StageCursor>());

// Bytes of a contestant's answer per triangle, over all of the input or about so many triangles.
double bytes_written(const Contestant& contestant, const StageInput& input, std::size_t triangles);

using StageMeasurements = std::array<StageMeasurement, 2>;  // by InputFrom

// Pre-condition: the first contestant is the baseline.
StageMeasurements measure_stage(const StageInput& input, const Contestants& contestants,
                                const StageClock& clock);

}  // namespace clipscope::experiments
