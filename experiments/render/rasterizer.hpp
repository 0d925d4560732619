// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws convex polygons given in NDC into a frame buffer of raw values: depth, attributes, facing.
//
// Source of the fill rule: OpenGL 4.6 specification, section 14.6.1, and the Direct3D 11
// rasterization rules (top-left). Of the interpolation: Heckbert and Moreton, "Interpolation for
// Polygon Texture Mapping and Shading", 1991 (attribute/w and 1/w are linear on the screen).
//
// Guarantees: a pixel is drawn where its centre is inside; a centre on a shared edge belongs to
// exactly one of the two triangles (top-left rule); the same calls give the same bits. Computes in
// double.
// Does not guarantee: hardware's snapping of vertices to 1/256 px (there is none, so that errors
// below a sub-pixel stay visible), and nothing is cut at the depth range: clipping is what is under
// test, and what a clipper let through is drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spaces/projection.hpp"

namespace clipscope::experiments {

inline constexpr int kScreenAttributes = 4;

using ScreenAttributes = std::array<double, kScreenAttributes>;

// A vertex of the canonical view volume: x y z in NDC (y up), 1/w, and the attributes' true values.
// The first two attributes are texture coordinates u and v.
struct ScreenVertex {
  double x = 0, y = 0, z = 0, inv_w = 1;
  ScreenAttributes attributes = {};
};

// What a pixel shows: nothing, a front face (counter-clockwise in NDC) or a back face.
enum class Facing : std::uint8_t { none, front, back };

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

// width * height pixels, row by row from the top left. Where facing is `none` the other values are
// those of an empty buffer: depth at the far plane, the rest 0, triangle kNoTriangle.
// Attributes are kept in double: float would round them by more than float clipping does.
struct FrameBuffer {
  // Pre-condition: width and height are at least 1.
  FrameBuffer(int width, int height, DepthRange depth_range);

  int width, height;
  DepthRange depth_range;                    // says which of two depths is nearer
  std::vector<float> depth;                  // NDC z
  std::vector<double> inv_w;                 // 1/w
  std::vector<ScreenAttributes> attributes;  // not finite where the polygon's 1/w make it so
  std::vector<std::uint32_t> triangle;       // the id that was given with the polygon
  std::vector<Facing> facing;
  std::uint64_t not_finite =
      0;  // fan triangles left out: a vertex or their area is NaN or infinite

  std::size_t pixels() const { return facing.size(); }
  bool covered(std::size_t pixel) const { return facing[pixel] != Facing::none; }
  bool finite(std::size_t pixel) const;  // depth and all attributes
};

// Draws the polygon as a fan about its first vertex, with a depth test: the nearer pixel stays, of
// two equally near ones the first. Fewer than three vertices and triangles without area draw
// nothing. Takes any values: polygons may reach beyond the screen, 1/w may be 0 or negative.
void draw_polygon(FrameBuffer& target, std::span<const ScreenVertex> polygon,
                  std::uint32_t triangle);

}  // namespace clipscope::experiments
