// SPDX-License-Identifier: GPL-3.0-or-later
//
// A software rasteriser of our own as a Driver: right as it stands, wrong in one place on request.
//
// It is what the judge is judged by: what it draws without a fault must come out clean, each fault
// must be found. It shares no arithmetic with the judge: it clips in homogeneous coordinates
// (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974) to the depths and to a guard band,
// divides, snaps to its sub-pixel bits, and fills in integers, all in double; what it hands over
// are floats. Edges own what lies on them by which side of them is filled, so that two polygons of
// one edge never share a pixel and never leave one out.
//
// Lines: in each column of an x-major line the pixel that the line crosses at the column's centre,
// without the last one; y-major lines by rows (legal by rules 1 to 4 of OpenGL 4.6 core, 14.5.1).
#pragma once

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

enum class RasterFault : std::uint8_t {
  none,
  noperspective_nan,      // of triangles that are clipped, noperspective values are NaN
  smooth_affine,          // smooth values are interpolated linearly in the window
  row_missing,            // one row of the target is never drawn
  near_unclipped,         // the near plane does not clip
  far_vertex_dropped,     // primitives with a vertex beyond 64 times the side planes are dropped
  edges_drawn_twice,      // pixel centres on an edge belong to both sides of it
  edges_never_drawn,      // ... to neither
  flat_of_other_vertex,   // the other provoking vertex
  facing_of_clipped,      // triangles that are clipped face the other way
  w_not_reciprocal,       // FragCoord.w is w
  depth_unclamped,        // with depth clamp, depths beyond the range are kept
  clip_distance_ignored,  // the last clip distance does not clip
  absolute_w,             // w of each vertex without its sign
  guard_band_wraps,       // no guard band: window coordinates wrap around at 2^12 px
  fewer_bits,             // snapped to a grid of 1/4 px
  primitive_id_off,       // one too many from the second primitive on
  zero_area_drawn,        // triangles without area are drawn as their bounding boxes
  extrapolated            // values are those two pixels away, outside of the triangle, too
};
constexpr std::array<std::string_view, 19> names_of(RasterFault) {
  return {"none",
          "noperspective_nan",
          "smooth_affine",
          "row_missing",
          "near_unclipped",
          "far_vertex_dropped",
          "edges_drawn_twice",
          "edges_never_drawn",
          "flat_of_other_vertex",
          "facing_of_clipped",
          "w_not_reciprocal",
          "depth_unclamped",
          "clip_distance_ignored",
          "absolute_w",
          "guard_band_wraps",
          "fewer_bits",
          "primitive_id_off",
          "zero_area_drawn",
          "extrapolated"};
}

struct OwnDriverSetup {
  GraphicsApi api = GraphicsApi::opengl;
  int subpixel_bits = 8;  // 0 to 8
};

// Never fails. Pre-condition of a draw: its coordinates are finite.
class OwnDriver : public Driver {
 public:
  explicit OwnDriver(RasterFault fault = RasterFault::none, const OwnDriverSetup& setup = {});

  const DriverInfo& info() const override { return info_; }
  Drawn draw(const DrawCall& call) override;

 private:
  RasterFault fault_;
  DriverInfo info_;
};

}  // namespace clipscope::experiments
