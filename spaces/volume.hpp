// SPDX-License-Identifier: MIT
//
// ClipVolume: what is clipped against, apart from the numbers of a projection.
//
// Depth clamp: OpenGL 4.6 specification, section 13.7 (near and far do not clip; whoever draws the
// polygon clamps its depth); of one plane alone: AMD_depth_clamp_separate. Clip distances: the
// same section, gl_ClipDistance: a value per vertex, linear over the primitive; the part where it
// is >= 0 is kept. A user clip plane is a clip distance computed from a position (see
// user_plane_distance in planes.hpp).
#pragma once

#include <cstdint>

namespace clipscope {

enum class DepthRange : std::uint8_t {
  minus_one_to_one,  // OpenGL: near at -1, far at 1
  zero_to_one,       // Direct3D, Vulkan: near at 0, far at 1
  reversed           // near at 1, far at 0
};

inline constexpr int kMaxClipDistances = 8;

// Which of the two planes of depth do not clip; `true` stands for both.
struct DepthClamp {
  bool near = false, far = false;

  constexpr DepthClamp() = default;
  constexpr DepthClamp(bool both) : near(both), far(both) {}  // NOLINT: as specifications say it
  constexpr DepthClamp(bool clamps_near, bool clamps_far) : near(clamps_near), far(clamps_far) {}

  // Whether either does not clip.
  constexpr explicit operator bool() const { return near || far; }
  friend constexpr bool operator==(const DepthClamp&, const DepthClamp&) = default;
};
inline constexpr DepthClamp kClampNear{true, false}, kClampFar{false, true};

struct ClipVolume {
  DepthRange depth = DepthRange::minus_one_to_one;
  // The near plane, the far plane or both do not clip. The side planes leave w >= 0; depths outside
  // the range remain.
  DepthClamp depth_clamp = {};
  // The first so many attributes of each vertex are clip distances: 0 to kMaxClipDistances, and at
  // most the number of attributes.
  int clip_distances = 0;

  friend constexpr bool operator==(const ClipVolume&, const ClipVolume&) = default;
};

}  // namespace clipscope
