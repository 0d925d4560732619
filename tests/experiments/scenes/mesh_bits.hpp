// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// FNV-1a over the bits of all floats: changes with any bit of any vertex.
inline std::uint64_t hash_of(const Mesh& mesh) {
  std::uint64_t hash = 14695981039346656037u;
  const auto mix = [&hash](float value) {
    hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 1099511628211u;
  };
  for (const auto& p : mesh.positions) std::ranges::for_each(p, mix);
  for (const auto& a : mesh.attributes) std::ranges::for_each(a, mix);
  return hash;
}

}  // namespace clipscope::experiments
