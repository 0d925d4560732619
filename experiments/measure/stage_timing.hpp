// SPDX-License-Identifier: GPL-3.0-or-later
//
// Timing of the stage contract: clip-space triangles in, clip-space polygons out.
//
// As in experiments/measure/timing.hpp: answers are checked first and whoever breaks its promise is not timed;
// then all run in turn, round after round, each once per round, memory passes included, and ratios are
// formed round by round. The input streams through in blocks of some thousand triangles, so that answers stay
// in cache while the input comes from memory; a mesh is one call, since its vertices are classified once. A slow
// contestant takes a part of the blocks, another one in each round.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/measure/stage_check.hpp"
#include "experiments/measure/stage_limits.hpp"
#include "experiments/measure/statistics.hpp"
#include "experiments/measure/timing.hpp"

namespace clipscope::experiments {

inline constexpr std::size_t kStageBlock = 4096;  // triangles per call

struct StageTimingOptions {
  int rounds = 31;
  double milliseconds_per_run = 10;  // a contestant's share of a round; at least a block
  StageCheckOptions check = {};
};

// A contestant with its input. Both must outlive it.
class StageRun {
 public:
  StageRun(StageContestant& contestant, const StageInput& input);

  // Clips the next blocks; ns per triangle.
  double run();
  // Chooses how many blocks a run takes, so that it lasts about so long, and warms up.
  void choose_share(double target_ns);
  // All blocks in each run.
  void take_all() { taken_ = blocks(); }
  // Bytes of the answer per triangle, over all of the input or about so many triangles.
  double bytes_out(std::size_t triangles);

 private:
  std::size_t blocks() const { return (size_ + block_ - 1) / block_; }
  std::size_t clip_block(std::size_t index);  // its triangles

  StageContestant& contestant_;
  const StageInput& input_;
  std::size_t size_, block_;
  std::size_t next_ = 0, taken_ = 1;  // blocks
};

struct StageTiming {
  std::string method, scalar, build, contract;
  Timing timing = {};  // speedup: times faster than textbook in the same round
  StageBytes bytes = {};
  MedianInterval times_fastest = {};  // time over that of the contract's fastest, the same round
  MedianInterval limit_percent = {};  // the memory limit over the time of the same round
};

struct MemoryTiming {
  MemoryPass pass;
  double bytes = 0;  // read per triangle
  Timing timing;     // speedup: against textbook
};

struct StageMeasurement {
  std::vector<StageTiming> contestants;  // in their order
  std::vector<MemoryTiming> passes;      // those that the input has data for
};

// Pre-condition: the first contestant is the baseline.
StageMeasurement measure_stage(const StageInput& input, const StageContestants& contestants,
                               const StageTimingOptions& options);

}  // namespace clipscope::experiments
