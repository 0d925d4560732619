// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>

#include "experiments/perspective/measure.hpp"
#include "experiments/render/figure.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments::perspective {
namespace {

constexpr int K = kSceneAttributes;
constexpr int kDrawnHalvings = 3;

using Vertices = std::span<const NdcVertex<double, K>>;

ViewTriangle<double, K> in_double(const SceneTriangle& triangle) {
  ViewTriangle<double, K> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) result[i].position[c] = triangle[i].position[c];
    for (int k = 0; k < K; ++k) result[i].attributes[k] = triangle[i].attributes[k];
  }
  return result;
}

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

void draw_piece(Vertices piece, std::uint32_t id, AffinePicture& out) {
  std::vector<ScreenVertex> polygon;
  for (const auto& [p, a] : piece) {
    polygon.push_back({p[0], p[1], p[2], p[3], {a[0], a[1], a[2], a[3]}});
  }
  draw_polygon(out.correct, polygon, id);
  for (ScreenVertex& v : polygon) v.inv_w = 1;
  draw_polygon(out.affine, polygon, id);
}

void draw_triangle(const Projection<double>& projection, const ViewTriangle<double, K>& triangle,
                   Pieces pieces, std::uint32_t id, AffinePicture& out) {
  NdcPolygon<double, K> polygon;
  if (pieces == Pieces::near_cut) {
    ClipPolygon<double, K> cut, scratch;
    cut.assign(to_clip(projection, triangle));
    divide(HomogeneousSutherlandHodgman::cut(projection.volume, bit(Plane::near), cut, scratch),
           polygon);
  } else {
    HomogeneousSutherlandHodgman{}(projection, triangle, polygon);
  }
  const Vertices vertices(polygon.begin(), polygon.end());
  if (pieces == Pieces::split) {
    for_each_part(vertices, kDrawnHalvings, middle,
                  [&](const auto& part) { draw_piece(part, id, out); });
  } else {
    draw_piece(vertices, id, out);
  }
}

}  // namespace

AffinePicture draw(const Scene& scene, const View& view, Pieces pieces, const PictureSize& size) {
  const FrameBuffer empty(size.width, size.height, view.frustum.depth);
  AffinePicture picture{empty, empty, {}};
  const Projection<double> projection(frustum_cast<double>(view.frustum));
  const auto draw_chunk = [&](std::span<const SceneTriangle> triangles, std::size_t first) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      draw_triangle(projection, in_double(triangles[i]), pieces,
                    static_cast<std::uint32_t>(first + i), picture);
    }
  };
  for_each_chunk(scene, view, spacing_of(scene, 0), draw_chunk);
  picture.error =
      compare(picture.affine, picture.correct, {.lowest = 1e-2, .highest = 1e6, .dilate = true});
  return picture;
}

Picture write_picture(const std::filesystem::path& folder, const Scene& scene, Pieces pieces,
                      const AffinePicture& picture) {
  constexpr std::array kDrawnAs = {"affine, each triangle cut by the near plane only",
                                   "affine, each triangle clipped first",
                                   "affine, clipped, then each triangle cut into 64"};
  const std::string drawn_as = kDrawnAs[static_cast<std::size_t>(pieces)];
  const std::string title = fmt::format("{}, {}", scene.name, scene.views.front().label);
  std::string file = fmt::format(
      "perspective-{}-{}.png", std::filesystem::path(scene.name).stem().string(), name_of(pieces));
  std::replace(file.begin(), file.end(), ' ', '_');
  constexpr PictureOptions kOptions{.cells_per_unit = 1};
  const std::array<CaptionedImage, 3> panels = {
      {{drawn_as, shade(picture.affine, kOptions)},
       {"perspective-correct", shade(picture.correct, kOptions)},
       {"error of the affine picture", picture.error.image}}};
  write_png(folder / file, compose_row(title, panels, picture.error), title);
  return {file, fmt::format("{}: {}, and its error", title, drawn_as)};
}

}  // namespace clipscope::experiments::perspective
