// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/stage/stage_timing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <span>

namespace clipscope::experiments {
namespace {

constexpr std::size_t kStreams = 12;          // of the positions of triangles
constexpr std::size_t kLine = 64;             // bytes of a cache line
constexpr std::size_t kParts = 4;             // of an array, read side by side
constexpr std::size_t kBlockBytes = 1 << 18;  // that copies are written to, again and again

// As wide as the build's registers, or in parts.
using Words = std::uint64_t __attribute__((vector_size(kLine / 2)));

using Bytes = std::span<const std::byte>;

// Triangles [first, first + count).
struct Range {
  std::size_t first, count;
};

template <class T>
Bytes bytes_in(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

// Of an array with so many values per triangle.
Bytes bytes_in(const std::vector<float>& values, std::size_t per_triangle, const Range& range) {
  return std::as_bytes(
      std::span(values).subspan(range.first * per_triangle, range.count * per_triangle));
}

std::size_t triangles_of(const StageInput& input) {
  const std::size_t mesh = input.size(Contract::indexed);
  return mesh > 0 ? mesh : input.array_size();
}

// What the passes over everything go over. Pre-condition: of a mesh the range is all of it.
std::vector<Bytes> arrays_of(const StageInput& input, const Range& range) {
  if (input.indices.empty()) return {bytes_in(input.vertices, 3 * input.stride(), range)};
  return {bytes_in(input.mesh_vertices), bytes_in(input.indices)};
}

std::vector<Bytes> position_streams(const StageInput& input, const Range& range) {
  std::vector<Bytes> streams;
  if (!input.indices.empty()) return streams;
  for (const auto& vertex : input.positions) {
    for (const std::vector<float>& stream : vertex) streams.push_back(bytes_in(stream, 1, range));
  }
  return streams;
}

std::vector<Bytes> bytes_of_pass(MemoryPass pass, const StageInput& input, const Range& range) {
  const bool positions = pass == MemoryPass::read_positions;
  return positions ? position_streams(input, range) : arrays_of(input, range);
}

void add_line(const std::byte* line, Words& sum) {
  Words half;
  std::memcpy(&half, line, sizeof half);
  sum += half;
  std::memcpy(&half, line + sizeof half, sizeof half);
  sum += half;
}

std::uint64_t total(const Words& sum) { return sum[0] + sum[1] + sum[2] + sum[3]; }

// f(part, line, its offset in the part) for each line of an array's parts in turn.
template <class F>
void for_each_line(Bytes bytes, F&& f) {
  const std::size_t size = bytes.size() / kParts / kLine * kLine;
  for (std::size_t i = 0; i < size; i += kLine) {
#pragma GCC unroll 4
    for (std::size_t part = 0; part < kParts; ++part) f(part, bytes.data() + part * size + i, i);
  }
}

std::uint64_t read_one(Bytes bytes) {
  std::array<Words, kParts> sums{};
  for_each_line(bytes, [&](std::size_t part, const std::byte* line, std::size_t) {
    add_line(line, sums[part]);
  });
  return total(sums[0]) + total(sums[1]) + total(sums[2]) + total(sums[3]);
}

// Line by line in turn, as a clipper that takes some triangles at once does, each stream by
// instructions of its own: prefetchers tell streams apart by these.
std::uint64_t read_side_by_side(const std::vector<Bytes>& streams) {
  std::array<const std::byte*, kStreams> at;
  for (std::size_t s = 0; s < kStreams; ++s) at[s] = streams[s].data();
  Words sum{};
  for (std::size_t i = 0; i + kLine <= streams.front().size(); i += kLine) {
#pragma GCC unroll 12
    for (std::size_t s = 0; s < kStreams; ++s) add_line(at[s] + i, sum);
  }
  return total(sum);
}

// Each part to a part of the block, again and again; a byte of it.
std::uint64_t copy_one(Bytes bytes, std::vector<std::byte>& block) {
  constexpr std::size_t kSize = kBlockBytes / kParts;
  for_each_line(bytes, [&](std::size_t part, const std::byte* line, std::size_t at) {
    std::memcpy(block.data() + part * kSize + at % kSize, line, kLine);
  });
  return static_cast<std::uint64_t>(block[block.size() / 2]);
}

// What a pass reads of a range, summed up; `block` is what a copy goes to.
std::uint64_t pass_over(MemoryPass pass, const StageInput& input, const Range& range,
                        std::vector<std::byte>& block) {
  const std::vector<Bytes> read = bytes_of_pass(pass, input, range);
  if (pass == MemoryPass::read_positions) return read_side_by_side(read);
  std::uint64_t sum = 0;
  for (const Bytes& array : read) {
    sum += pass == MemoryPass::read_everything ? read_one(array) : copy_one(array, block);
  }
  return sum;
}

// The input in calls, of which a mesh is one.
struct Blocks {
  std::size_t size, block;

  Blocks(std::size_t triangles, bool whole)
      : size(triangles), block(whole ? size : std::min(kStageBlock, size)) {}
  Blocks(const Contestant& contestant, const StageInput& input)
      : Blocks(input.clipped(contestant.contract), contestant.contract == Contract::indexed) {}
  std::size_t count() const { return (size + block - 1) / block; }
  double least_share() const { return 1 / static_cast<double>(count()); }
  // The triangles of blocks [first, last).
  Range between(std::size_t first, std::size_t last) const {
    return {first * block, std::min(last * block, size) - first * block};
  }
  // The next blocks of that share, at most all of them, as one range or as two around the end.
  std::vector<Range> take(StageCursor& cursor, double share) const {
    const auto wanted = std::floor(share * static_cast<double>(count()) + 0.5);
    const std::size_t taken = std::clamp<std::size_t>(static_cast<std::size_t>(wanted), 1, count());
    const std::size_t begin = cursor.next_block % count(), end = begin + taken;
    cursor.next_block = end % count();
    if (end <= count()) return {between(begin, end)};
    return {between(begin, count()), between(0, end - count())};
  }
};

// A call for each block; the triangles.
std::size_t clip_in_blocks(Runner& runner, const Range& range, std::size_t block) {
  for (std::size_t done = 0; done < range.count; done += block) {
    runner.clip(0, range.first + done, std::min(block, range.count - done));
  }
  return range.count;
}

using PassSamples = std::array<std::span<const double>, kMemoryPasses.size()>;

// The memory limit over the time, round by round, in percent.
MedianInterval limit_percent(const StageBytes& bytes, std::span<const double> samples,
                             const PassSamples& passes, const StageInput& input) {
  std::vector<double> percent;
  for (std::size_t round = 0; round < samples.size(); ++round) {
    std::array<double, 3> ns{};
    for (std::size_t p = 0; p < 3; ++p) ns[p] = passes[p].empty() ? 0 : passes[p][round];
    percent.push_back(100 * limit_ns(bytes, ns, input) / samples[round]);
  }
  return median_interval(percent);
}

// The fastest that was timed in a row's contract.
const StageTiming& fastest_beside(const StageTiming& row, const std::vector<StageTiming>& rows) {
  const StageTiming* fastest = &row;
  for (const StageTiming& other : rows) {
    if (other.contestant->contract != row.contestant->contract || !other.timing.is_timed()) {
      continue;
    }
    if (other.timing.ns.median < fastest->timing.ns.median) fastest = &other;
  }
  return *fastest;
}

}  // namespace

void touch(Contract contract, const StageInput& input, std::size_t first, std::size_t count) {
  std::vector<Bytes> read = arrays_of(input, {first, count});
  if (contract == Contract::number) {
    read = position_streams(input, {first, count});
    read.push_back(bytes_in(input.stream_attributes, 3 * static_cast<std::size_t>(input.attributes),
                            {first, count}));
  }
  unsigned sum = 0;
  for (const Bytes& bytes : read) {
    for (std::size_t i = 0; i < bytes.size(); i += kLine) {
      sum += std::to_integer<unsigned>(bytes[i]);
    }
    if (!bytes.empty()) sum += std::to_integer<unsigned>(bytes.back());
  }
  [[maybe_unused]] volatile unsigned kept = sum;  // nobody can leave the reads out
}

double bytes_of(MemoryPass pass, const StageInput& input) {
  std::size_t bytes = 0;
  for (const Bytes& array : bytes_of_pass(pass, input, {0, triangles_of(input)})) {
    bytes += array.size();
  }
  return static_cast<double>(bytes) / static_cast<double>(triangles_of(input));
}

StageBytes stage_bytes(const StageInput& input, Contract contract, double out) {
  if (contract != Contract::number) {
    return {.positions = 0, .rest = bytes_of(MemoryPass::read_everything, input), .out = out};
  }
  const double attributes = 3.0 * sizeof(float) * input.attributes;
  return {.positions = bytes_of(MemoryPass::read_positions, input),
          .rest = attributes * shares_of(input, contract).straddling / 100,
          .out = out};
}

double limit_ns(const StageBytes& bytes, const std::array<double, 3>& passes_ns,
                const StageInput& input) {
  const double positions = bytes_of(MemoryPass::read_positions, input);
  const double everything = bytes_of(MemoryPass::read_everything, input);
  // A copy reads as well: where it is the faster of the two passes, it says what a read can do.
  const double read = std::min(passes_ns[1], passes_ns[2]) / everything;
  const double write = std::max(0.0, passes_ns[2] - passes_ns[1]) / everything;
  const double streams = positions > 0 ? passes_ns[0] / positions : 0;
  return bytes.positions * streams + bytes.rest * read + bytes.out * write;
}

Task stage_task(const Contestant& contestant, const StageInput& input,
                const StageCheckOptions& check, std::shared_ptr<StageCursor> cursor) {
  const std::shared_ptr<Runner> runner = contestant.prepare_stage(input);
  const Blocks blocks(contestant, input);
  return {.work =
              [=](double share) {
                std::size_t clipped = 0;
                for (const Range& range : blocks.take(*cursor, share)) {
                  clipped += clip_in_blocks(*runner, range, blocks.block);
                }
                return clipped;
              },
          .check = [=, &contestant,
                    &input] { return first_broken_promise(contestant, *runner, input, check); },
          .least_share = blocks.least_share()};
}

Task memory_task(MemoryPass pass, const StageInput& input, std::shared_ptr<StageCursor> cursor) {
  auto block = std::make_shared<std::vector<std::byte>>(kBlockBytes);
  const Blocks blocks(triangles_of(input), !input.indices.empty());
  const auto go_over = [=, &input](double share) {
    std::uint64_t sum = 0;
    std::size_t triangles = 0;
    for (const Range& range : blocks.take(*cursor, share)) {
      sum += pass_over(pass, input, range, *block);
      triangles += range.count;
    }
    [[maybe_unused]] volatile std::uint64_t kept = sum;  // nobody can leave the reads out
    return triangles;
  };
  return {.work = go_over, .check = nothing_to_check, .least_share = blocks.least_share()};
}

double bytes_written(const Contestant& contestant, const StageInput& input, std::size_t triangles) {
  const std::unique_ptr<Runner> runner = contestant.prepare_stage(input);
  const Blocks blocks(contestant, input);
  const std::size_t wanted = std::clamp<std::size_t>(triangles / blocks.block, 1, blocks.count());
  std::size_t clipped = 0, bytes = 0;
  for (std::size_t i = 0; i < wanted; ++i) {
    clipped += clip_in_blocks(*runner, blocks.between(i, i + 1), blocks.block);
    bytes += runner->bytes_written();
  }
  return static_cast<double>(bytes) / static_cast<double>(clipped);
}

StageMeasurement measure_stage(const StageInput& input, const Contestants& contestants,
                               const StageClock& clock) {
  StageMeasurement result;
  std::vector<Task> tasks;
  const auto cursor = std::make_shared<StageCursor>();
  for (const Contestant* c : contestants) {
    tasks.push_back(stage_task(*c, input, clock.check, cursor));
  }
  for (const MemoryPass pass : kMemoryPasses) {
    if (bytes_of(pass, input) == 0) continue;
    result.passes.push_back({pass, bytes_of(pass, input), {}});
    tasks.push_back(memory_task(pass, input, cursor));
  }
  const std::vector<Timing> timings = time_in_turn(
      tasks,
      {.rounds = clock.rounds, .milliseconds_per_run = clock.milliseconds_per_run, .baseline = 0});
  PassSamples samples;
  for (std::size_t p = 0; p < result.passes.size(); ++p) {
    result.passes[p].timing = timings[contestants.size() + p];
    samples[static_cast<std::size_t>(result.passes[p].pass)] = result.passes[p].timing.samples_ns;
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    StageTiming& row = result.contestants.emplace_back();
    row = {contestants[i], timings[i]};
    if (!row.timing.is_timed()) continue;
    const double written = bytes_written(*row.contestant, input, clock.check.triangles);
    row.bytes = stage_bytes(input, row.contestant->contract, written);
    row.limit_percent = limit_percent(row.bytes, row.timing.samples_ns, samples, input);
  }
  for (StageTiming& row : result.contestants) {
    if (!row.timing.is_timed()) continue;
    const StageTiming& fastest = fastest_beside(row, result.contestants);
    row.times_fastest = median_interval(ratios(row.timing.samples_ns, fastest.timing.samples_ns));
  }
  return result;
}

}  // namespace clipscope::experiments
