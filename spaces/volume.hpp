// SPDX-License-Identifier: MIT
//
// ClipVolume: what is clipped against, apart from the numbers of a projection.
//
// Depth clamp: OpenGL 4.6 specification, section 13.7 (near and far do not clip; whoever draws the
// polygon clamps its depth); of one plane alone: AMD_depth_clamp_separate. Clip distances: the
// same section, gl_ClipDistance: a value per vertex, linear over the primitive; the part where it
// is >= 0 is kept. A user clip plane is a clip distance computed from a position (see
// user_plane_distance in planes.hpp).
//
// Open sides: tiles side by side give what lies in their common border to both of them if both are
// closed. In a half-open volume some of the sides do not own their points, by the top-left rule of
// rasterisers the right and the bottom one: Microsoft, "Rasterization Rules", documentation of
// Direct3D 11. Clipping means here:
//
//   the answer is the closure of what the primitive has in common with the half-open volume.
//
// That is nothing, or else it is the answer of the closed volume: from a common point that is
// strictly inside of the open sides every point of the closed part is reached through common
// points. It is nothing where all vertices are on or outside of one open side; otherwise only
// where nothing but a point, or a segment of a polygon, touches that side from outside of others,
// and of these clippers make nothing anyhow. So a triangle or segment that crosses the common
// border of two tiles is cut as ever, up to the border on both sides, and a point in the border,
// or a segment or triangle all in it, comes out of one tile alone.
#pragma once

#include <bit>
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

// Which sides do not own their points; `true` stands for the top-left rule in a picture whose y
// points up, right and bottom. Where y points down (Vulkan) the sides to name are right and top.
struct OpenSides {
  bool left = false, right = false, bottom = false, top = false;

  constexpr OpenSides() = default;
  constexpr OpenSides(bool is_top_left_rule)  // NOLINT: as with DepthClamp
      : right(is_top_left_rule), bottom(is_top_left_rule) {}
  constexpr OpenSides(bool left_open, bool right_open, bool bottom_open, bool top_open)
      : left(left_open), right(right_open), bottom(bottom_open), top(top_open) {}

  // Whether any does not own its points: asked for every primitive, so the four at once.
  constexpr explicit operator bool() const { return std::bit_cast<std::uint32_t>(*this) != 0; }
  friend constexpr bool operator==(const OpenSides& a, const OpenSides& b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
  }
};

struct ClipVolume {
  DepthRange depth = DepthRange::minus_one_to_one;
  // The near plane, the far plane or both do not clip. The side planes leave w >= 0; depths outside
  // the range remain.
  DepthClamp depth_clamp = {};
  // The first so many attributes of each vertex are clip distances: 0 to kMaxClipDistances, and at
  // most the number of attributes.
  int clip_distances = 0;
  OpenSides open_sides = {};

  friend constexpr bool operator==(const ClipVolume&, const ClipVolume&) = default;
};

// Whether it is the closed volume of six planes.
constexpr bool is_plain(const ClipVolume& volume) {
  return volume == ClipVolume{.depth = volume.depth};
}

}  // namespace clipscope
