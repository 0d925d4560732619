// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/stage/stage_timing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <span>

#include "experiments/machine/machine.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kStreams = 12;          // of the positions of triangles
constexpr std::size_t kLine = 64;             // bytes of a cache line
constexpr std::size_t kParts = 4;             // of an array, read side by side
constexpr std::size_t kBlockBytes = 1 << 18;  // that copies are written to, again and again
constexpr std::size_t kPage = 4096;

// As wide as the build's registers, or in parts.
using Words = std::uint64_t __attribute__((vector_size(kLine / 2)));

using Bytes = std::span<const std::byte>;

// Triangles [first, first + count).
struct Range {
  std::size_t first, count;
};

// Of an array with so many values per triangle.
Bytes bytes_in(const std::vector<float>& values, std::size_t per_triangle, const Range& range) {
  return std::as_bytes(
      std::span(values).subspan(range.first * per_triangle, range.count * per_triangle));
}

// What the passes over everything go over.
Contract layout_of(const StageInput& input) {
  return input.indices.empty() ? Contract::copy : Contract::indexed;
}

std::size_t triangles_of(const StageInput& input) { return input.size(layout_of(input)); }

// The arrays of a soup's triangles, or of a mesh's. Pre-condition: whole draws of the mesh.
std::vector<Bytes> arrays_of(const StageInput& input, const Range& range) {
  if (input.indices.empty()) return {bytes_in(input.vertices, 3 * input.stride(), range)};
  const auto first = input.draw_vertices(range.first),
             last = input.draw_vertices(range.first + range.count - 1);
  return {std::as_bytes(std::span(first.data(), last.data() + last.size())),
          std::as_bytes(std::span(input.indices).subspan(3 * range.first, 3 * range.count))};
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

// Where a copy goes in a block of kBlockBytes and two pages: half a page away from its source by
// the bits within a page. A processor takes a load for one of the store before it if these bits are
// the same, and waits.
std::byte* apart_from(const std::byte* source, std::vector<std::byte>& block) {
  const auto address = [](const std::byte* p) { return reinterpret_cast<std::uintptr_t>(p); };
  const std::uintptr_t wanted = address(source) / kLine * kLine + kPage / 2,
                       first = (address(block.data()) + kLine - 1) / kLine * kLine;
  return block.data() + (first - address(block.data())) + (wanted - first) % kPage;
}

// Each part to a part of the block, again and again; a byte of it.
std::uint64_t copy_one(Bytes bytes, std::vector<std::byte>& block) {
  constexpr std::size_t kSize = kBlockBytes / kParts;
  std::byte* const to = apart_from(bytes.data(), block);
  for_each_line(bytes, [&](std::size_t part, const std::byte* line, std::size_t at) {
    std::memcpy(to + part * kSize + at % kSize, line, kLine);
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

// The input in calls, of which a draw of a mesh is one.
struct Blocks {
  std::size_t size, block;

  Blocks(std::size_t triangles, std::size_t per_call)
      : size(triangles), block(std::min(per_call, triangles)) {}
  Blocks(Contract contract, const StageInput& input, std::size_t per_call)
      : Blocks(input.clipped(contract),
               contract == Contract::indexed ? draw_size(input) : per_call) {}
  static std::size_t draw_size(const StageInput& mesh) {
    return mesh.draw_triangles > 0 ? mesh.draw_triangles : mesh.size(Contract::indexed);
  }
  std::size_t count() const { return (size + block - 1) / block; }
  double least_share() const { return 1 / static_cast<double>(count()); }
  // The triangles of blocks [first, last).
  Range between(std::size_t first, std::size_t last) const {
    return {first * block, std::min(last * block, size) - first * block};
  }
  Range next(const StageCursor& cursor) const {
    const std::size_t begin = cursor.next_block % count();
    return between(begin, begin + 1);
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

// A task of one block: off the clock it does the block before, which brings code and answers into
// cache, and reads the next, which it did not clip before.
Task from_cache(Task task, Contract contract, const StageInput& input, const Blocks& blocks,
                std::shared_ptr<StageCursor> cursor) {
  task.most_share = task.least_share;
  task.prepare = [=, &input, work = task.work, share = task.least_share] {
    work(share);
    const Range next = blocks.next(*cursor);
    touch(contract, input, next.first, next.count);
  };
  return task;
}

}  // namespace

void touch(Contract contract, const StageInput& input, std::size_t first, std::size_t count) {
  const Range range{first, count};
  std::vector<Bytes> read;
  if (contract == Contract::copy) {
    read = {bytes_in(input.vertices, 3 * input.stride(), range)};
  } else if (contract == Contract::indexed) {
    read = arrays_of(input, range);
  } else {
    const auto attributes = static_cast<std::size_t>(input.attributes);
    read = position_streams(input, range);
    read.push_back(bytes_in(input.stream_attributes, 3 * attributes, range));
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
                const StageCheckOptions& check, std::shared_ptr<StageCursor> cursor,
                std::size_t block) {
  const std::shared_ptr<Runner> runner = contestant.prepare_stage(input);
  const Blocks blocks(contestant.contract, input, block);
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

Task memory_task(MemoryPass pass, const StageInput& input, std::shared_ptr<StageCursor> cursor,
                 std::size_t block_size) {
  auto block = std::make_shared<std::vector<std::byte>>(kBlockBytes + 2 * kPage);
  const Blocks blocks(layout_of(input), input, block_size);
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
  const Blocks blocks(contestant.contract, input, kStageBlock);
  const std::size_t wanted = std::clamp<std::size_t>(triangles / blocks.block, 1, blocks.count());
  std::size_t clipped = 0, bytes = 0;
  for (std::size_t i = 0; i < wanted; ++i) {
    clipped += clip_in_blocks(*runner, blocks.between(i, i + 1), blocks.block);
    bytes += runner->bytes_written();
  }
  return static_cast<double>(bytes) / static_cast<double>(clipped);
}

std::size_t cached_triangles(const StageInput& input) {
  return level2_cache_bytes() / 2 / (3 * sizeof(float) * input.stride());
}

std::size_t cached_block(const StageInput& input) {
  constexpr std::size_t kLeast = 64;
  return std::clamp(cached_triangles(input) / 2 / kLeast * kLeast, kLeast, kStageBlock);
}

Task cached_stage_task(const Contestant& contestant, const StageInput& input,
                       const StageCheckOptions& check, std::shared_ptr<StageCursor> cursor) {
  const std::size_t block = cached_block(input);
  const Contract contract = contestant.contract;
  return from_cache(stage_task(contestant, input, check, cursor, block), contract, input,
                    Blocks(contract, input, block), cursor);
}

Task cached_memory_task(MemoryPass pass, const StageInput& input,
                        std::shared_ptr<StageCursor> cursor) {
  const std::size_t block = cached_block(input);
  const Contract all = layout_of(input);
  const Contract read = pass == MemoryPass::read_positions ? Contract::number : all;
  return from_cache(memory_task(pass, input, cursor, block), read, input, Blocks(all, input, block),
                    cursor);
}

}  // namespace clipscope::experiments
