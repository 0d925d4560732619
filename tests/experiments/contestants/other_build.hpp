// SPDX-License-Identifier: GPL-3.0-or-later
//
// All triangle and segment clippers in float and double, compiled as what reads CGAL is: hardly
// optimised, with -frounding-math and without SLP. In a namespace of its own, as in
// experiments/cost/builds.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "spaces/projection.hpp"
#include "spaces/volume.hpp"

namespace other_build {

inline constexpr int kAttributes = 4;

// A primitive; the other build has the types of frustum and volume under other names.
struct Input {
  bool in_clip_space = false;
  std::array<std::byte, sizeof(clipscope::Frustum<double>)> frustum;
  std::array<std::byte, sizeof(clipscope::ClipVolume)> volume;
  std::span<const double> numbers;  // of each vertex x y z, in clip space w, and four attributes
};

struct Clipper {
  const char* clipper;
  const char* scalar;
  int vertices;  // of a primitive
  // Each vertex x y z 1/w and four attributes; a null pointer where the space is not taken.
  void (*from_view)(const Input&, std::vector<double>& out);
  void (*from_clip)(const Input&, std::vector<double>& out);
};

const std::vector<Clipper>& clippers();

}  // namespace other_build
