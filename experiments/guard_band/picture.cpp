// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/measure.hpp"

#include <cmath>

#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments::guard_band {
namespace {

constexpr double kSubpixels = 256;  // per pixel

// An NDC coordinate rounded to a sub-pixel of a screen that is so many pixels wide or high.
double snap(double ndc, int pixels) {
  const double half = pixels / 2.0 * kSubpixels;
  return std::nearbyint(ndc * half) / half;
}

std::vector<ScreenVertex> screen_polygon(const NdcPolygon<float, kSceneAttributes>& in,
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

}  // namespace

FrameBuffer draw(const Scene& scene, const View& view, const PictureSize& size,
                 const Drawing& drawing) {
  FrameBuffer buffer(size.width, size.height, view.frustum.depth);
  const Projection<float> projection(view.frustum);
  NdcPolygon<float, kSceneAttributes> polygon;
  const auto draw_chunk = [&](const std::vector<SceneTriangle>& triangles, std::size_t first) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (drawing.band) {
        clip_to_band(projection, *drawing.band, triangles[i], polygon);
      } else {
        HomogeneousSutherlandHodgman{}(projection, triangles[i], polygon);
      }
      draw_polygon(buffer, screen_polygon(polygon, size, drawing.snapped),
                   static_cast<std::uint32_t>(first + i));
    }
  };
  for_each_chunk(scene, view, spacing_of(scene, 0), draw_chunk);
  return buffer;
}

std::int64_t unlike_pixels(const FrameBuffer& drawn, const FrameBuffer& full) {
  std::int64_t unlike = 0;
  for (std::size_t i = 0; i < drawn.pixels(); ++i) {
    unlike += drawn.triangle[i] != full.triangle[i] || drawn.facing[i] != full.facing[i];
  }
  return unlike;
}

}  // namespace clipscope::experiments::guard_band
