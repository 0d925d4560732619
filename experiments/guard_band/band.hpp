// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a geometry stage with a guard band does: near and far are cut, sides only where a triangle
// leaves the band; the rest of the sides is the rasteriser's, which scissors.
//
// The polygon that comes out reaches up to the band; homogeneous/guard_band (spaces/homogeneous) is
// the same with a band of 16 and the scissoring done, as the contract of clippers asks.
// Does not guarantee: anything for triangles with w <= 0 in front of the near plane, which no
// projection makes.
#pragma once

#include <array>
#include <cstdint>

#include "spaces/cut.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::guard_band {

// Half widths of the band, in half widths of the volume: |x| <= band.x w, |y| <= band.y w is
// inside.
// Infinite: the sides are never cut.
struct GuardBand {
  double x = 1, y = 1;
};

enum class Work : std::uint8_t {
  rejected,   // outside one plane
  none,       // passed on as it is
  depth_cut,  // cut by near or far alone
  side_cut    // left the band
};

inline constexpr Outcode kSideBits =
    bit(Plane::left) | bit(Plane::right) | bit(Plane::bottom) | bit(Plane::top);

template <Scalar T>
constexpr T band_distance(const GuardBand& band, Plane plane, const Vec4<T>& p) {
  switch (plane) {
    case Plane::left: return T(band.x) * p[3] + p[0];
    case Plane::right: return T(band.x) * p[3] - p[0];
    case Plane::bottom: return T(band.y) * p[3] + p[1];
    default: return T(band.y) * p[3] - p[1];
  }
}

// The sides of the band that the point is outside of.
template <Scalar T>
constexpr Outcode band_outcode(const GuardBand& band, const Vec4<T>& p) {
  Outcode code = 0;
  for (const Plane plane : {Plane::left, Plane::right, Plane::bottom, Plane::top}) {
    code |= static_cast<Outcode>(!(T(0) <= band_distance(band, plane, p)))
            << static_cast<int>(plane);
  }
  return code;
}

// Fills `out` with the divided polygon. Shapes: `positions` are the clip positions of the triangle
// whose attributes `source` gives.
template <Scalar T, Space S, int K>
constexpr Work clip_to_band(const ClipVolume& volume, const GuardBand& band,
                            const std::array<Vec4<T>, 3>& positions,
                            const Triangle<S, T, K>& source, NdcPolygon<T, K>& out) {
  constexpr std::array kDepth = {Plane::near, Plane::far};
  constexpr std::array kSides = {Plane::left, Plane::right, Plane::bottom, Plane::top};
  out.clear();
  const OutcodeSummary code = summarize_outcodes(
      volume, source, [&](std::size_t i) { return clip_outcode(volume.depth, positions[i]); });
  if (code.all != 0) return Work::rejected;
  const Outcode depth = code.any & ~kSideBits;
  Outcode sides = 0;
  if (depth == 0) {
    for (const Vec4<T>& p : positions) sides |= band_outcode(band, p);
    if (sides == 0) {
      divide_inside(volume, positions, source, out);
      return Work::none;
    }
  }
  ClipPolygon<T, K> polygon, scratch;
  for (std::size_t i = 0; i < 3; ++i) polygon.push_back({positions[i], source[i].attributes});
  for_each_plane(depth, kDepth, [&](Plane plane) {
    cut_if_crossed(polygon, scratch,
                   [&](const auto& v) { return signed_distance(volume.depth, plane, v); });
  });
  if (depth != 0) {
    for (const ClipVertex<T, K>& v : polygon) sides |= band_outcode(band, v.position);
  }
  for_each_plane(sides, kSides, [&](Plane plane) {
    cut_if_crossed(polygon, scratch,
                   [&](const auto& v) { return band_distance(band, plane, v.position); });
  });
  divide(polygon, out);
  return sides == 0 ? Work::depth_cut : Work::side_cut;
}

// From view space.
template <Scalar T, int K>
constexpr Work clip_to_band(const Projection<T>& projection, const GuardBand& band,
                            const ViewTriangle<T, K>& triangle, NdcPolygon<T, K>& out) {
  return clip_to_band(
      projection.volume, band,
      {to_clip(projection, triangle[0].position), to_clip(projection, triangle[1].position),
       to_clip(projection, triangle[2].position)},
      triangle, out);
}

}  // namespace clipscope::experiments::guard_band
