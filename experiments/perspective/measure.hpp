// SPDX-License-Identifier: GPL-3.0-or-later
//
// What affine interpolation does to attributes: on edges and triangles made for it, in a scene's
// triangles, and in the vertices that clipping makes.
//
// On edges and triangles nothing rounds: they are made of rationals and judged in rationals, so
// that `attained` and `beyond` are decided exactly. A search by points gives a lower bound of the
// largest error. A scene's polygon is drawn as a fan about its first vertex; the largest error of a
// fan triangle lies on one of its edges and has a closed form there (affine_error.hpp), so that
// nothing is sampled within triangles.
// Does not guarantee: more of a scene than the triangles that were sampled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/perspective/rows.hpp"
#include "experiments/render/heat_map.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/survey/draw_scene.hpp"

namespace clipscope::experiments::perspective {

struct EdgeSearch {
  int edge_steps = 1024;
  int triangles = 2000;
  std::uint64_t seed = 1;
};

// The ratio is root^2: a perfect square, so that the bound is rational. Pre-condition: root >= 1,
// and its square is a double.
RatioRow search_edges(double root, const EdgeSearch& search);

// Whether an edge with the ratio that the closed form gives for the error numerator / denominator
// has that error at its worst point, exactly. Pre-condition: 0 <= numerator / denominator < 1.
bool is_error_at_its_ratio(int numerator, int denominator);

// The smallest ratio at which the error, sought along the edge without use of the closed form,
// reaches `error`. Relative error: below 1e-12 (see the source). Pre-condition: 0 < error < 0.9.
double measured_ratio_at_error(double error);

// Each error that can be seen, and the ratio that it takes.
std::vector<ThresholdRow> threshold_rows();

// A vertex as the error of texture coordinates sees it.
struct TextureCorner {
  double w = 1, u = 0, v = 0;
};

struct PolygonNeed {
  double ratio = 1;  // w_max / w_min
  double error = 0;  // the largest of |du| and |dv| of the affine answer, in units of u and v
  // The same after each fan triangle was cut into 16 by halving its edges in view space twice.
  double error_split = 0;
};

// Pre-condition: three corners or more, all w > 0.
PolygonNeed need_of(std::span<const TextureCorner> polygon);

// One for each sampled triangle that is visible, in its exact polygon within the volume.
// triangles_per_view: evenly spaced over the mesh; 0: all.
std::vector<PolygonNeed> scene_needs(const Scene& scene, std::size_t triangles_per_view,
                                     Progress& progress);

// Pre-condition: something is visible.
SceneRow scene_row(const std::string& scene, const std::vector<PolygonNeed>& needs);

// Triangles whose vertices lie in front of the near plane and whose largest w is `ratio` times the
// smallest, to the bit; some vertex is outside a side plane, and something is visible. Attributes
// lie in [0, 1]. The frustum is `cut_frustum()`. Pre-condition: ratio is a float in [1, 2^15].
std::vector<SceneTriangle> cut_triangles(float ratio, std::size_t count, std::uint64_t seed);
Frustum<float> cut_frustum();

// What a contestant makes of the attributes of triangles with that ratio.
CutRow measure_cut(const Contestant& contestant, float ratio,
                   const std::vector<SceneTriangle>& triangles);

// Calls f for each triangle of the polygon's fan, halved so many times: each time, the middles of
// its edges make four of one.
template <class Polygon, class Middle, class F>
void for_each_part(const Polygon& polygon, int halvings, const Middle& middle, const F& f) {
  for (std::size_t i = 2; i < std::size(polygon); ++i) {
    const std::array t = {polygon[0], polygon[i - 1], polygon[i]};
    if (halvings == 0) {
      f(t);
      continue;
    }
    const auto a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
    for (const auto& part : {std::array{t[0], c, b}, std::array{c, t[1], a}, std::array{b, a, t[2]},
                             std::array{a, b, c}}) {
      for_each_part(part, halvings - 1, middle, f);
    }
  }
}

// A scene drawn without perspective correction and with it, and the difference. Affine drawing is
// the rasterizer's with 1/w = 1 at every vertex and the true attributes there. What it shows
// depends on the pieces that a triangle is drawn in.
struct AffinePicture {
  FrameBuffer affine, correct;
  HeatMap error;  // of the texture coordinates, in texels of a 1024-texel texture
};

AffinePicture draw(const Scene& scene, const View& view, Pieces pieces, const PictureSize& size);

// Writes the three as one PNG with captions and the scale of the error into the folder, and names
// it. Throws OutputError.
Picture write_picture(const std::filesystem::path& folder, const Scene& scene, Pieces pieces,
                      const AffinePicture& picture);

}  // namespace clipscope::experiments::perspective
