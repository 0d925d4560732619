// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/affine_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/measure/batches.hpp"
#include "experiments/perspective/panels.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments {
namespace {

constexpr int K = kSceneAttributes;
constexpr std::size_t kChunk = 4096;  // triangles
constexpr int kSplits = 3;            // each makes four triangles of one

using NdcTriangle = std::array<NdcVertex<double, K>, 3>;

// The point halfway between two in view space: halfway in homogeneous coordinates.
NdcVertex<double, K> middle(const NdcVertex<double, K>& a, const NdcVertex<double, K>& b) {
  const double w_a = 1 / a.position[3], w_b = 1 / b.position[3];
  NdcVertex<double, K> r;
  for (int i = 0; i < 3; ++i) {
    r.position[i] = (a.position[i] * w_a + b.position[i] * w_b) / (w_a + w_b);
  }
  r.position[3] = 2 / (w_a + w_b);
  for (int k = 0; k < K; ++k) r.attributes[k] = (a.attributes[k] + b.attributes[k]) / 2;
  return r;
}

ScreenVertex screen_vertex(const NdcVertex<double, K>& v, bool affine) {
  ScreenVertex s{v.position[0], v.position[1], v.position[2], affine ? 1 : v.position[3], {}};
  for (int k = 0; k < kScreenAttributes; ++k) {
    s.attributes[static_cast<std::size_t>(k)] = v.attributes[k];
  }
  return s;
}

void draw_piece(std::span<const NdcVertex<double, K>> piece, std::uint32_t id, AffinePicture& out) {
  std::vector<ScreenVertex> affine, correct;
  for (const NdcVertex<double, K>& v : piece) {
    affine.push_back(screen_vertex(v, true));
    correct.push_back(screen_vertex(v, false));
  }
  draw_polygon(out.affine, affine, id);
  draw_polygon(out.correct, correct, id);
}

void draw_split(const NdcTriangle& t, int splits, std::uint32_t id, AffinePicture& out) {
  if (splits == 0) {
    draw_piece(t, id, out);
    return;
  }
  const auto a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
  for (const NdcTriangle& part : {NdcTriangle{t[0], c, b}, NdcTriangle{c, t[1], a},
                                  NdcTriangle{b, a, t[2]}, NdcTriangle{a, b, c}}) {
    draw_split(part, splits - 1, id, out);
  }
}

NdcPolygon<double, K> after_near_cut(const Projection<double>& projection,
                                     const ViewTriangle<double, K>& triangle) {
  ClipPolygon<double, K> polygon, scratch;
  polygon.assign(to_clip(projection, triangle));
  cut_if_crossed(polygon, scratch, [&](const ClipVertex<double, K>& v) {
    return signed_distance(projection.volume.depth, Plane::near, v);
  });
  NdcPolygon<double, K> out;
  divide(polygon, out);
  return out;
}

void draw_triangle(const Projection<double>& projection, const ViewTriangle<double, K>& triangle,
                   Pieces pieces, std::uint32_t id, AffinePicture& out) {
  NdcPolygon<double, K> polygon;
  if (pieces == Pieces::near_cut) {
    polygon = after_near_cut(projection, triangle);
  } else {
    HomogeneousSutherlandHodgman{}(projection, triangle, polygon);
  }
  if (pieces != Pieces::split) {
    draw_piece({polygon.begin(), polygon.end()}, id, out);
    return;
  }
  for (int i = 2; i < polygon.size(); ++i) {
    draw_split({polygon[0], polygon[i - 1], polygon[i]}, kSplits, id, out);
  }
}

}  // namespace

std::string_view pieces_name(Pieces pieces) {
  switch (pieces) {
    case Pieces::near_cut: return "near cut";
    case Pieces::clipped: return "clipped";
    case Pieces::split: return "split";
  }
  return "";
}

AffinePicture draw_affine(const Scene& scene, const View& view, Pieces pieces,
                          const PictureSize& size) {
  const FrameBuffer empty(size.width, size.height, view.frustum.depth);
  AffinePicture picture{empty, empty, {}};
  const auto projection = projection_of<double>(view);
  const Sample all = sample_of(scene, 0);
  for (std::size_t first = 0; first < all.count; first += kChunk) {
    const auto triangles = simplices_cast<double>(
        sampled_view_triangles(scene, view, all, first, std::min(kChunk, all.count - first)));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      draw_triangle(projection, triangles[i], pieces, static_cast<std::uint32_t>(first + i),
                    picture);
    }
  }
  picture.error =
      compare(picture.affine, picture.correct, {.lowest = 1e-2, .highest = 1e6, .dilate = true});
  return picture;
}

Picture write_affine_picture(const std::filesystem::path& folder, const Scene& scene, Pieces pieces,
                             const AffinePicture& picture) {
  static constexpr std::array<std::string_view, 3> kHow = {
      "affine, each triangle cut by the near plane only", "affine, each triangle clipped first",
      "affine, clipped, then each triangle cut into 64"};
  static constexpr PictureOptions kOptions{.cells_per_unit = 1};
  const std::string how(kHow[static_cast<std::size_t>(pieces)]);
  const std::array<PicturePanel, 3> panels = {
      {{how, shade(picture.affine, kOptions)},
       {"perspective-correct", shade(picture.correct, kOptions)},
       {"error of the affine picture", picture.error.image}}};
  const std::string title = fmt::format("{}, {}", scene.name, scene.views.front().label);
  std::string file =
      fmt::format("perspective-{}-{}.png", std::filesystem::path(scene.name).stem().string(),
                  pieces_name(pieces));
  std::replace(file.begin(), file.end(), ' ', '_');
  write_png(folder / file, compose_panels(title, panels, picture.error), title);
  return {file, fmt::format("{}: {}, and its error", title, how)};
}

}  // namespace clipscope::experiments
