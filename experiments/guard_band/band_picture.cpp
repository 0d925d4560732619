// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/band_picture.hpp"

#include <cmath>

#include "experiments/measure/batches.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kSubpixels = 256;  // per pixel
constexpr std::size_t kChunk = 4096;

// An NDC coordinate rounded to a sub-pixel of a screen that is so many pixels wide or high.
double snap(double ndc, int pixels) {
  const double half = pixels / 2.0 * kSubpixels;
  return std::nearbyint(ndc * half) / half;
}

std::vector<ScreenVertex> screen_polygon(std::span<const NdcVertex<float, kSceneAttributes>> in,
                                         const PictureSize& size, bool snapped) {
  std::vector<ScreenVertex> polygon;
  for (const auto& v : in) {
    ScreenVertex& s = polygon.emplace_back(
        ScreenVertex{v.position[0], v.position[1], v.position[2], v.position[3], {}});
    if (snapped) {
      s.x = snap(s.x, size.width);
      s.y = snap(s.y, size.height);
    }
    for (int k = 0; k < kScreenAttributes; ++k) {
      s.attributes[static_cast<std::size_t>(k)] = v.attributes[k];
    }
  }
  return polygon;
}

void clip(const BandDrawing& drawing, const Projection<float>& projection,
          std::span<const SceneTriangle> triangles, PolygonStream<float, kSceneAttributes>& out) {
  out.clear();
  if (!drawing.band) {
    std::get<const Contestant<float>*>(find_contestant("homogeneous/sutherland_hodgman", "float"))
        ->view(projection, triangles, out);
    return;
  }
  NdcPolygon<float, kSceneAttributes> polygon;
  for (const SceneTriangle& triangle : triangles) {
    clip_to_band(projection, *drawing.band, triangle, polygon);
    out.append(polygon);
  }
}

}  // namespace

FrameBuffer draw_in_band(const Scene& scene, const View& view, const PictureSize& size,
                         const BandDrawing& drawing) {
  FrameBuffer buffer(size.width, size.height, view.frustum.depth);
  const auto projection = projection_of<float>(view);
  const Sample all = sample_of(scene, 0);
  PolygonStream<float, kSceneAttributes> polygons;
  for (std::size_t first = 0; first < all.count; first += kChunk) {
    const std::size_t count = std::min(kChunk, all.count - first);
    clip(drawing, projection, sampled_view_triangles(scene, view, all, first, count), polygons);
    for (std::size_t i = 0; i < count; ++i) {
      draw_polygon(buffer, screen_polygon(polygons[i], size, drawing.snapped),
                   static_cast<std::uint32_t>(first + i));
    }
  }
  return buffer;
}

BandPicture compare_band(const FrameBuffer& drawn, const FrameBuffer& full,
                         const FrameBuffer& exact) {
  BandPicture picture{compare(drawn, exact).counts};
  for (std::size_t i = 0; i < drawn.pixels(); ++i) {
    picture.unlike_full_px +=
        drawn.triangle[i] != full.triangle[i] || drawn.facing[i] != full.facing[i];
  }
  return picture;
}

}  // namespace clipscope::experiments
