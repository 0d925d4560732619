// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/vulkan/shaders.hpp"

#include <array>

#include "backends/vulkan/compiled_shaders.hpp"  // kValues, kVertex, kClipDistances, kHits

namespace clipscope::experiments {
namespace {

// In the order of the bits by which CMakeLists.txt counts the variants.
constexpr std::array kRead = {Quantity::smooth, Quantity::noperspective,
                              Quantity::flat,   Quantity::frag_coord,
                              Quantity::facing, Quantity::primitive_id};

}  // namespace

SpirV vertex_shader(int clip_distances) {
  return kVertexShaders[static_cast<std::size_t>(clip_distances)];
}

SpirV values_shader(const Quantities& reads) {
  std::size_t variant = 0;
  for (std::size_t i = 0; i < kRead.size(); ++i) {
    if (reads[bit(kRead[i])]) variant |= std::size_t{1} << i;
  }
  return kValuesShaders[variant];
}

SpirV hits_shader() { return kHitsShaders[0]; }

SpirV clip_distances_shader(int clip_distances) {
  return kClipDistancesShaders[static_cast<std::size_t>(clip_distances) - 1];
}

}  // namespace clipscope::experiments
