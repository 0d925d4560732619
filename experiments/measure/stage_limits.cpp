// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/stage_limits.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>

namespace clipscope::experiments {
namespace {

constexpr std::size_t kStreams = 12;          // of the positions of triangles
constexpr std::size_t kLine = 64;             // bytes of a cache line
constexpr std::size_t kParts = 4;             // of an array, read side by side
constexpr std::size_t kBlockBytes = 1 << 18;  // that copies are written to, again and again

// As wide as the build's registers, or in parts.
using Words = std::uint64_t __attribute__((vector_size(kLine / 2)));

template <class T>
std::span<const std::byte> bytes_in(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

using Bytes = std::span<const std::byte>;

// What the passes over everything go over.
std::vector<Bytes> arrays_of(const StageInput& input) {
  if (input.indices.empty()) return {bytes_in(input.vertices)};
  return {bytes_in(input.mesh_vertices), bytes_in(input.indices)};
}

std::vector<Bytes> position_streams(const StageInput& input) {
  std::vector<Bytes> streams;
  if (!input.indices.empty()) return streams;
  for (const auto& vertex : input.positions) {
    for (const std::vector<float>& stream : vertex) streams.push_back(bytes_in(stream));
  }
  return streams;
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

// Line by line in turn, as a clipper that takes some triangles at once does, each stream by instructions of its
// own: prefetchers tell streams apart by these.
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

double triangles_of(const StageInput& input) {
  const std::size_t mesh = input.size(StageContract::indexed);
  return static_cast<double>(mesh > 0 ? mesh : input.array_size());
}

}  // namespace

std::string_view pass_name(MemoryPass pass) {
  switch (pass) {
    case MemoryPass::read_positions: return "read positions";
    case MemoryPass::read_everything: return "read everything";
    default: return "copy everything";
  }
}

double bytes_of(MemoryPass pass, const StageInput& input) {
  std::size_t bytes = 0;
  const bool positions = pass == MemoryPass::read_positions;
  for (const Bytes& array : positions ? position_streams(input) : arrays_of(input)) {
    bytes += array.size();
  }
  return static_cast<double>(bytes) / triangles_of(input);
}

MemoryRun::MemoryRun(MemoryPass pass, const StageInput& input)
    : pass_(pass), input_(input), block_(kBlockBytes) {}

double MemoryRun::run() {
  using Clock = std::chrono::steady_clock;
  const std::vector<Bytes> streams = position_streams(input_), arrays = arrays_of(input_);
  std::uint64_t sum = 0;
  const Clock::time_point start = Clock::now();
  if (pass_ == MemoryPass::read_positions) {
    sum = read_side_by_side(streams);
  } else {
    for (const Bytes& array : arrays) {
      sum += pass_ == MemoryPass::read_everything ? read_one(array) : copy_one(array, block_);
    }
  }
  const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
  sum_ = sum;
  return spent.count() / triangles_of(input_);
}

StageBytes stage_bytes(const StageInput& input, StageContract contract, double out) {
  if (contract != StageContract::reference) {
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

}  // namespace clipscope::experiments
