// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/stage_limits.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>

namespace clipscope::experiments {
namespace {

constexpr std::size_t kBlockBytes = 1 << 18;

template <class T>
std::span<const std::byte> bytes_in(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

// What the pass goes over, array by array.
std::vector<std::span<const std::byte>> arrays_of(MemoryPass pass, const StageInput& input) {
  const bool is_mesh = !input.indices.empty();
  if (pass != MemoryPass::read_positions) {
    if (is_mesh) return {bytes_in(input.mesh_vertices), bytes_in(input.indices)};
    return {bytes_in(input.vertices)};
  }
  std::vector<std::span<const std::byte>> arrays;
  if (is_mesh) return arrays;
  for (const auto& vertex : input.positions) {
    for (const std::vector<float>& stream : vertex) arrays.push_back(bytes_in(stream));
  }
  return arrays;
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
  for (const auto& array : arrays_of(pass, input)) bytes += array.size();
  return static_cast<double>(bytes) / triangles_of(input);
}

void MemoryRun::read(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0, word = 0;
  for (std::size_t i = 0; i + sizeof(word) <= bytes.size(); i += sizeof(word)) {
    std::memcpy(&word, bytes.data() + i, sizeof(word));
    sum += word;
  }
  sum_ = sum;
}

double MemoryRun::run() {
  using Clock = std::chrono::steady_clock;
  const auto arrays = arrays_of(pass_, input_);
  block_.resize(kBlockBytes);
  const Clock::time_point start = Clock::now();
  for (const std::span<const std::byte>& array : arrays) {
    if (pass_ != MemoryPass::copy_everything) {
      read(array);
      continue;
    }
    for (std::size_t i = 0; i < array.size(); i += kBlockBytes) {
      const std::size_t count = std::min(kBlockBytes, array.size() - i);
      std::memcpy(block_.data(), array.data() + i, count);
      sum_ = static_cast<std::uint64_t>(block_[count / 2]);
    }
  }
  const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
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
