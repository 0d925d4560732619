// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/stage_limits.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>

namespace clipscope::experiments {
namespace {

// Several streams at once keep more of memory busy than one: as many as the positions of triangles have.
constexpr std::size_t kStreams = 12;
constexpr std::size_t kStep = 512;            // bytes of a stream before it is the next one's turn
constexpr std::size_t kBlockBytes = 1 << 18;  // that copies are written to, again and again

template <class T>
std::span<const std::byte> bytes_in(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

using Bytes = std::span<const std::byte>;

// In as many parts of whole steps; a rest of less than a step per part is left out.
std::vector<Bytes> parts_of(Bytes array) {
  const std::size_t size = array.size() / kStreams / kStep * kStep;
  if (size == 0) return {array};
  std::vector<Bytes> parts;
  for (std::size_t i = 0; i < kStreams; ++i) parts.push_back(array.subspan(i * size, size));
  return parts;
}

// What the pass goes over: groups of streams that are read side by side.
std::vector<std::vector<Bytes>> streams_of(MemoryPass pass, const StageInput& input) {
  const bool is_mesh = !input.indices.empty();
  if (pass != MemoryPass::read_positions) {
    if (!is_mesh) return {parts_of(bytes_in(input.vertices))};
    return {parts_of(bytes_in(input.mesh_vertices)), parts_of(bytes_in(input.indices))};
  }
  if (is_mesh) return {};
  std::vector<Bytes> streams;
  for (const auto& vertex : input.positions) {
    for (const std::vector<float>& stream : vertex) streams.push_back(bytes_in(stream));
  }
  return {streams};
}

std::uint64_t sum_of(Bytes bytes) {
  std::uint64_t sum = 0, word = 0;
  for (std::size_t i = 0; i + sizeof(word) <= bytes.size(); i += sizeof(word)) {
    std::memcpy(&word, bytes.data() + i, sizeof(word));
    sum += word;
  }
  return sum;
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
  if (pass == MemoryPass::read_positions) {
    for (const auto& vertex : input.positions) {
      for (const std::vector<float>& stream : vertex) bytes += bytes_in(stream).size();
    }
  } else if (input.indices.empty()) {
    bytes = bytes_in(input.vertices).size();
  } else {
    bytes = bytes_in(input.mesh_vertices).size() + bytes_in(input.indices).size();
  }
  return static_cast<double>(bytes) / triangles_of(input);
}

MemoryRun::MemoryRun(MemoryPass pass, const StageInput& input)
    : pass_(pass), input_(input), block_(kBlockBytes) {}

double MemoryRun::run() {
  using Clock = std::chrono::steady_clock;
  const auto groups = streams_of(pass_, input_);
  std::uint64_t sum = 0;
  std::size_t written = 0;
  const Clock::time_point start = Clock::now();
  for (const std::vector<Bytes>& streams : groups) {
    for (std::size_t at = 0; at < streams.front().size(); at += kStep) {
      const std::size_t count = std::min(kStep, streams.front().size() - at);
      for (const Bytes& stream : streams) {
        if (pass_ != MemoryPass::copy_everything) {
          sum += sum_of(stream.subspan(at, count));
          continue;
        }
        std::memcpy(block_.data() + written, stream.data() + at, count);
        written = written + 2 * kStep > kBlockBytes ? 0 : written + kStep;
      }
    }
  }
  const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
  sum_ = sum + static_cast<std::uint64_t>(block_[kBlockBytes / 2]);
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
  const double read = passes_ns[1] / everything;
  const double write = std::max(0.0, passes_ns[2] - passes_ns[1]) / everything;
  const double streams = positions > 0 ? passes_ns[0] / positions : 0;
  return bytes.positions * streams + bytes.rest * read + bytes.out * write;
}

}  // namespace clipscope::experiments
