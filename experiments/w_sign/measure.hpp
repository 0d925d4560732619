// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clip-space triangles by the sign of w at their vertices; what a plane w >= epsilon costs and
// prevents: surfaces near the eye by scale, and the divisions that clipping leaves behind; and
// pictures.
#pragma once

#include <cstdint>
#include <span>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/render/heat_map.hpp"
#include "experiments/survey/draw_scene.hpp"
#include "experiments/survey/sweep.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::w_sign {

// Random vertices have an x, y, z of the size of w, so that they lie in or near the volume, or of
// size 1, which for a tiny w is nearly a direction; with w = 0 it is one, or in one of eight the
// point 0 0 0 0. tiny: from the smallest normal float to 1e-5, every power of two equally often.
// positive, negative: magnitudes 0.1 to 10.
enum class Kind : std::uint8_t { negative, minus_zero, zero, tiny, positive };
constexpr std::array<std::string_view, 5> names_of(Kind) { return {"-", "-0", "+0", "tiny", "+"}; }

// In ascending order; the order of the vertices is random. There are 35.
using Pattern = std::array<Kind, 3>;

std::vector<Pattern> all_patterns();
std::string pattern_name(const Pattern& pattern);  // "- +0 tiny"
// So many random triangles of the pattern; of the volume [-1, 1]. The same for the same seed.
SweepChunk pattern_chunk(const Pattern& pattern, std::size_t triangles, std::uint64_t seed);

// Sutherland-Hodgman in clip space with and without a w-plane.
struct WPlaneClipper {
  std::string_view name;
  std::optional<double> epsilon;  // none: no w-plane
  // What is left of a triangle to be divided, in float; vertices with w <= 0 are still there.
  ClipPolygon<float, kSceneAttributes> (*cut)(
      const ClipVolume& volume, const ClipTriangle<float, kSceneAttributes>& triangle);
};
// The first has none; then come those with epsilon 0, FLT_MIN, 1e-5 and 1/16384.
std::span<const WPlaneClipper> w_plane_clippers();

// Surfaces that reach from behind the eye to far ahead, one triangle each, at a scale in metres;
// seen with 90 degrees and a near plane at 1/100 of the scale, which cuts off their nearest part.
// With depth clamp neither near nor far cuts, and the surface is visible to where the sides cut it.
//   wall   a tenth of the scale to the right, a corner 1/500 of the scale from the eye
//   floor  1/500 of the scale beneath the eye
struct Surface {
  std::string_view name;
  std::array<std::array<double, 3>, 3> corners;  // at a scale of 1 m
};
inline constexpr std::array<Surface, 2> kSurfaces = {
    {{"wall", {{{0.1, -5, 2}, {0.1, 0.1, -60}, {0.0015, 0.001, 0.5}}}},
     {"floor", {{{-60, -0.002, 5}, {60, -0.002, 5}, {0, -0.002, -200}}}}}};
HardCase case_of(const Surface& surface, double scale, bool depth_clamp);

// What a clipper draws of a triangle, against the exact answer. Areas are those on 3840 x 2160.
struct Loss {
  double visible_px2 = 0, drawn_px2 = 0, lost_px2 = 0, lost_percent = 0;
  // w, the depth in front of the eye; and how much of it is lost, from the nearest visible point
  // on.
  std::optional<double> nearest_visible = {}, nearest_drawn = {}, lost_depth = {};

  static constexpr auto columns() {
    return std::tuple(column("visible_px2", "visible [px^2]", &Loss::visible_px2),
                      column("lost_px2", "lost [px^2]", &Loss::lost_px2),
                      column("lost_percent", "lost [%]", &Loss::lost_percent),
                      column("nearest_visible_m", "nearest visible [m]", &Loss::nearest_visible),
                      column("nearest_drawn_m", "nearest drawn [m]", &Loss::nearest_drawn),
                      column("lost_depth_m", "lost depth [m]", &Loss::lost_depth));
  }
};
// drawn: x y z 1/w.
Loss loss_of(const TruthPolygon& truth, std::span<const std::array<double, 4>> drawn);

// At most `most` triangles of the scene's views, all lengths, near and far scaled, as float
// projection takes them to clip space; a chunk for each view.
std::vector<SweepChunk> scaled_chunks(const Scene& scene, double scale, bool depth_clamp,
                                      std::size_t most);

// Triangles by the worst that their divisions meet after the clipper's cuts. A clipper that goes on
// all the same draws garbage or nothing there; ours leave such vertices out.
struct Hazards {
  std::int64_t triangles = 0;
  std::int64_t zero_w = 0;      // some w is 0
  std::int64_t negative_w = 0;  // none is 0, some is negative
  std::int64_t overflow = 0;    // all are positive, some x/w, y/w, z/w or 1/w overflows

  std::int64_t total() const { return zero_w + negative_w + overflow; }

  static constexpr auto columns() {
    return std::tuple(column("triangles", &Hazards::triangles),
                      column("zero_w", "w = 0", &Hazards::zero_w),
                      column("negative_w", "w < 0", &Hazards::negative_w),
                      column("overflow", &Hazards::overflow));
  }
};
Hazards count_hazards(std::span<const SweepChunk> chunks, const WPlaneClipper& clipper);

// What the clipper in float loses of the same triangles, against clipping these clip coordinates
// exactly.
struct LossTally {
  double visible_px2 = 0, lost_percent = 0;
  double lost_px2 = 0;        // where less is drawn than is visible
  std::int64_t vanished = 0;  // triangles with a visible pixel's area of which nothing is drawn

  static constexpr auto columns() {
    return std::tuple(column("vanished", &LossTally::vanished),
                      column("lost_px2", "lost [px^2]", &LossTally::lost_px2),
                      column("lost_percent", "lost [%]", &LossTally::lost_percent));
  }
};
LossTally tally_loss(std::span<const SweepChunk> chunks, const WPlaneClipper& clipper);

// What clipping after the divide shows of surfaces that reach behind the eye, beside what is there.
struct Picture {
  std::string scene;
  FrameBuffer naive;  // cvv/naive in float
  FrameBuffer exact;
  HeatMapCounts counts;  // naive against exact
};

// One triangle: a corner low on the left, one on the right, and one behind the eye and above.
Scene triangle_behind_the_eye();

// The first view of the scene.
Picture draw_picture(const Scene& scene, const PictureSize& size);

// A sheet with a row for each picture: naive on the left, exact on the right, beneath them what
// differs.
// Pre-conditions: there is a picture, and all have the same size. Errors: see canvas.hpp.
Image side_by_side(std::span<const Picture> pictures);

}  // namespace clipscope::experiments::w_sign
