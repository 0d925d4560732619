// SPDX-License-Identifier: GPL-3.0-or-later
//
// The memory limit of the stage contracts: how long reading and copying the same bytes takes.
//
//   read positions   the twelve streams of a soup
//   read everything  all vertices; of a mesh its vertices and indices
//   copy everything  the same, written again and again to a buffer that stays in cache, as answers do
//
// Own loops, nothing computed but a sum that keeps the reads. Streams, and the quarters of one array, are read
// side by side: that keeps more of memory busy than one after the other.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "experiments/measure/stage_input.hpp"
#include "experiments/measure/statistics.hpp"

namespace clipscope::experiments {

enum class MemoryPass : std::uint8_t { read_positions, read_everything, copy_everything };
inline constexpr std::array kMemoryPasses = {
    MemoryPass::read_positions, MemoryPass::read_everything, MemoryPass::copy_everything};
std::string_view pass_name(MemoryPass pass);  // "read positions" and so on

// What a pass reads, per triangle; 0 for one that the input has no data for.
double bytes_of(MemoryPass pass, const StageInput& input);

// A pass over all of the input; ns per triangle. Pre-condition: bytes_of(pass, input) > 0.
class MemoryRun {
 public:
  // The input must outlive it.
  MemoryRun(MemoryPass pass, const StageInput& input);
  double run();

 private:
  MemoryPass pass_;
  const StageInput& input_;
  std::vector<std::byte> block_;
  volatile std::uint64_t sum_ = 0;  // nobody can leave the reads out
};

// Bytes that a contract must move per triangle: in, from memory, and out, to cache.
struct StageBytes {
  double positions = 0;  // in, read as streams of positions
  double rest = 0;       // in, everything else
  double out = 0;

  double total() const { return positions + rest + out; }
};

// `out`: the bytes of the answer per triangle. By reference the attributes of cut triangles alone are read.
StageBytes stage_bytes(const StageInput& input, StageContract contract, double out);

// The time that moving these bytes takes at the speed of the passes, in ns per triangle, from the times of the
// passes in one round, by MemoryPass. What a copy takes more than a read is the price of its writes.
double limit_ns(const StageBytes& bytes, const std::array<double, 3>& passes_ns,
                const StageInput& input);

}  // namespace clipscope::experiments
