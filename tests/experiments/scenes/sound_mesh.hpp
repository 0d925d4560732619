// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds of every mesh that a reader lets in.
#pragma once

#include <algorithm>
#include <cmath>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// Whether the float is the double's nearest or, since a decimal text is rounded once to each, the
// one beside it.
inline bool is_rounded(float x, double in_double) {
  const auto nearest = static_cast<float>(in_double);
  return x == nearest || x == std::nextafter(nearest, x);
}

// It has triangles of vertices that are there, and nothing but finite numbers.
inline bool is_sound(const Mesh& mesh) {
  const auto is_finite = [](const auto& values) {
    return std::ranges::all_of(values, [](float x) { return std::isfinite(x); });
  };
  for (std::size_t i = 0; i < mesh.double_positions.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_rounded(mesh.positions.at(i)[k], mesh.double_positions[i][k])) return false;
    }
  }
  const bool has_all_doubles =
      mesh.double_positions.empty() || mesh.double_positions.size() == mesh.positions.size();
  return has_all_doubles && !mesh.triangles.empty() &&
         mesh.attributes.size() == mesh.positions.size() &&
         std::ranges::all_of(mesh.positions, is_finite) &&
         std::ranges::all_of(mesh.attributes, is_finite) &&
         std::ranges::all_of(mesh.triangles, [&](const auto& t) {
           return std::ranges::all_of(t, [&](auto i) { return i < mesh.positions.size(); });
         });
}

}  // namespace clipscope::experiments
