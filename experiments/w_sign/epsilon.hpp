// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a plane w >= epsilon costs and what it prevents: surfaces near the eye by scale, and the
// divisions that clipping leaves behind.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// Sutherland-Hodgman in clip space with and without a w-plane.
struct WPlaneClipper {
  std::string_view clipper;
  std::optional<float> epsilon;  // none: no w-plane
};
std::span<const WPlaneClipper> w_plane_clippers();

// Surfaces that reach from behind the eye to far ahead, one triangle each, at a scale in metres; seen with
// 90 degrees and a near plane at 1/100 of the scale, which cuts off their nearest part. With depth clamp
// neither near nor far cuts, and the surface is visible to where the sides cut it.
//   wall   a tenth of the scale to the right, a corner 1/500 of the scale from the eye
//   floor  1/500 of the scale beneath the eye
HardCase wall_past_the_eye(double scale, bool depth_clamp);
HardCase floor_beneath_the_eye(double scale, bool depth_clamp);

// What a clipper draws of a triangle, against the exact answer. Area on 3840 x 2160.
struct VisibleLoss {
  double visible_px2 = 0, drawn_px2 = 0;
  std::optional<double> nearest_visible, nearest_drawn;  // w, the depth in front of the eye

  double lost_px2() const { return visible_px2 - drawn_px2; }
  // How much of the visible depth, from its nearest point on, is lost.
  std::optional<double> lost_depth() const;
};
VisibleLoss loss_of(const TruthPolygon& truth, std::span<const std::array<double, 4>> drawn);

// Triangles in clip space, as float projection gives them.
struct ClipBatch {
  ClipVolume volume;
  std::vector<ClipTriangle<float, kSceneAttributes>> triangles;
};

// At most `most` triangles of the scene's views, all lengths, near and far scaled.
std::vector<ClipBatch> scaled_batches(const Scene& scene, double scale, bool depth_clamp,
                                      std::size_t most);

// Triangles by the worst that their divisions meet, after the cut by the w-plane if there is one, and by
// the planes that outcodes name, in float. A clipper that goes on all the same draws garbage or
// nothing there; ours leave such vertices out.
struct DivisionHazards {
  std::int64_t triangles = 0;
  std::int64_t zero_w = 0;      // some w is 0
  std::int64_t negative_w = 0;  // none is 0, some is negative
  std::int64_t overflow = 0;    // all are positive, some x/w, y/w, z/w or 1/w overflows

  std::int64_t total() const { return zero_w + negative_w + overflow; }
};
DivisionHazards count_hazards(std::span<const ClipBatch> batches, std::optional<float> epsilon);

// The same triangles: what the clipper in float loses of them, against clipping these clip coordinates
// exactly.
struct VisibleLossTally {
  double visible_px2 = 0;
  double lost_px2 = 0;        // where less is drawn than is visible
  std::int64_t vanished = 0;  // triangles with a visible pixel's area of which nothing is drawn
};
VisibleLossTally tally_loss(std::span<const ClipBatch> batches, std::string_view clipper);

}  // namespace clipscope::experiments
