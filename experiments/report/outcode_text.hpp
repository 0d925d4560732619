// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planes and outcodes in words.
#pragma once

#include <fmt/format.h>

#include <string>

#include "spaces/planes.hpp"

namespace clipscope::experiments {

inline std::string plane_text(Plane plane) {
  static constexpr std::array<const char*, kPlanes> kNames = {"left", "right", "bottom",
                                                              "top",  "near",  "far"};
  if (is_clip_distance(plane)) return fmt::format("clip distance {}", clip_distance_index(plane));
  return kNames[static_cast<std::size_t>(plane)];
}

// "inside", "outside left near", "outside left clip distance 0 3".
inline std::string outcode_text(Outcode code) {
  std::string text;
  bool distances = false;
  for (int p = 0; p < kMaxPlanes; ++p) {
    const auto plane = static_cast<Plane>(p);
    if ((code & bit(plane)) == 0) continue;
    text += distances ? fmt::format(" {}", clip_distance_index(plane)) : ' ' + plane_text(plane);
    distances = is_clip_distance(plane);
  }
  return text.empty() ? "inside" : "outside" + text;
}

}  // namespace clipscope::experiments
