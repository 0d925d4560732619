// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/clipless.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/pictures/draw_scene.hpp"
#include "spaces/barycentric/edge_functions.hpp"
#include "spaces/bounds/projected_bounds.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;

// What a pixel of a triangle is computed from.
struct Setup {
  EdgeFunctions<float> edges;
  ScreenPlane<float> inv_w, depth;
  std::array<ScreenPlane<float>, kSceneAttributes> attributes_over_w;
};

class Target {
 public:
  Target(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height) {}

  void clear() { std::fill(pixels_.begin(), pixels_.end(), Pixel{}); }
  bool covered(std::size_t i) const { return pixels_[i].depth < kEmpty; }
  std::size_t size() const { return pixels_.size(); }

  // kTestDepth: the triangle may reach beyond near and far.
  template <bool kTestDepth>
  void draw(const Setup& setup, const ScreenRectangle<float>& bounds) {
    const auto first = [](float lo, int n) {
      return std::max(0, static_cast<int>(std::floor((lo + 1) / 2 * n - 0.5f)));
    };
    const auto last = [](float hi, int n) {
      return std::min(n - 1, static_cast<int>(std::ceil((hi + 1) / 2 * n - 0.5f)));
    };
    const int i0 = first(bounds.left, width_), i1 = last(bounds.right, width_);
    const int j0 = first(bounds.bottom, height_), j1 = last(bounds.top, height_);
    for (int j = j0; j <= j1; ++j) {
      const float y = (2 * j + 1) / static_cast<float>(height_) - 1;
      for (int i = i0; i <= i1; ++i) {
        const float x = (2 * i + 1) / static_cast<float>(width_) - 1;
        shade<kTestDepth>(setup, x, y, pixels_[static_cast<std::size_t>(j) * width_ + i]);
      }
    }
  }

 private:
  static constexpr float kEmpty = 2;  // beyond every depth in [-1, 1]
  struct Pixel {
    float depth = kEmpty;
    std::array<float, kSceneAttributes> attributes{};
  };

  template <bool kTestDepth>
  static void shade(const Setup& s, float x, float y, Pixel& pixel) {
    const auto& [e, f, g] = s.edges.edges;
    if (e.at(x, y) < 0 || f.at(x, y) < 0 || g.at(x, y) < 0) return;
    const float inv_w = s.inv_w.at(x, y), depth = s.depth.at(x, y);
    if (!(inv_w > 0) || !(depth < pixel.depth)) return;
    if (kTestDepth && !(-1 <= depth && depth <= 1)) return;
    pixel.depth = depth;
    for (int k = 0; k < kSceneAttributes; ++k) {
      pixel.attributes[k] = s.attributes_over_w[k].at(x, y) / inv_w;
    }
  }

  int width_, height_;
  std::vector<Pixel> pixels_;
};

// Cut, divide, and draw the fan.
void draw_clipped(const Projection<float>& projection, const std::vector<SceneTriangle>& triangles,
                  Target& target) {
  NdcPolygon<float, kSceneAttributes> polygon;
  for (const SceneTriangle& triangle : triangles) {
    HomogeneousSutherlandHodgman{}(projection, triangle, polygon);
    for (int i = 2; i < polygon.size(); ++i) {
      const std::array v = {&polygon[0], &polygon[i - 1], &polygon[i]};
      std::array<Vec4<float>, 3> screen;
      ScreenRectangle<float> bounds;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& p = v[c]->position;
        screen[c] = Vec4<float>(p[0], p[1], p[2], 1);
        bounds.left = std::min(bounds.left, p[0]), bounds.right = std::max(bounds.right, p[0]);
        bounds.bottom = std::min(bounds.bottom, p[1]), bounds.top = std::max(bounds.top, p[1]);
      }
      Setup s{edge_functions(screen[0], screen[1], screen[2]), {}, {}, {}};
      const auto plane = [&](auto&& value) {
        return s.edges.over_w(value(*v[0]), value(*v[1]), value(*v[2]));
      };
      s.inv_w = plane([](const auto& u) { return u.position[3]; });
      s.depth = plane([](const auto& u) { return u.position[2]; });
      for (int k = 0; k < kSceneAttributes; ++k) {
        s.attributes_over_w[k] =
            plane([k](const auto& u) { return u.attributes[k] * u.position[3]; });
      }
      target.draw<false>(s, bounds);
    }
  }
}

// The rectangle of the screen that a triangle may cover.
ScreenRectangle<float> bounds_on_screen(const std::array<Vec4<float>, 3>& p) {
  constexpr ScreenRectangle<float> kScreen{-1, -1, 1, 1};
  if (!(p[0][3] > 0 && p[1][3] > 0 && p[2][3] > 0)) {
    return projected_bounds_within(kScreen, std::span<const Vec4<float>>(p), Rounding::outward);
  }
  ScreenRectangle<float> r;
  for (const Vec4<float>& v : p) {
    const float x = v[0] / v[3], y = v[1] / v[3];
    r.left = std::min(r.left, x), r.right = std::max(r.right, x);
    r.bottom = std::min(r.bottom, y), r.top = std::max(r.top, y);
  }
  return {std::max(r.left, -1.0f), std::max(r.bottom, -1.0f), std::min(r.right, 1.0f),
          std::min(r.top, 1.0f)};
}

// No cut and no divide of vertices but for the bounds; near and far by pixel where they are crossed.
void draw_clipless(const Projection<float>& projection, const std::vector<SceneTriangle>& triangles,
                   Target& target) {
  constexpr Outcode kDepthPlanes = bit(Plane::near) | bit(Plane::far);
  for (const SceneTriangle& triangle : triangles) {
    std::array<Vec4<float>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = to_clip(projection, triangle[i].position);
    const OutcodeSummary code = summarize_outcodes(projection.volume, triangle, [&](std::size_t i) {
      return clip_outcode(projection.volume.depth, p[i]);
    });
    if (code.all != 0) continue;
    Setup s{edge_functions(p[0], p[1], p[2]), {}, {}, {}};
    s.inv_w = s.edges.over_w(1, 1, 1);
    s.depth = s.edges.over_w(p[0][2], p[1][2], p[2][2]);
    for (int k = 0; k < kSceneAttributes; ++k) {
      s.attributes_over_w[k] = s.edges.over_w(triangle[0].attributes[k], triangle[1].attributes[k],
                                              triangle[2].attributes[k]);
    }
    const ScreenRectangle<float> bounds = bounds_on_screen(p);
    if (bounds.empty()) continue;
    if ((code.any & kDepthPlanes) != 0) {
      target.draw<true>(s, bounds);
    } else {
      target.draw<false>(s, bounds);
    }
  }
}

std::int64_t wrong_pixels(const Target& target, const FrameBuffer& exact, int width, int height) {
  std::int64_t wrong = 0;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const auto ours = static_cast<std::size_t>(j) * width + i;                 // from the bottom
      const auto theirs = static_cast<std::size_t>(height - 1 - j) * width + i;  // from the top
      wrong += target.covered(ours) != exact.covered(theirs);
    }
  }
  return wrong;
}

}  // namespace

ClipAndRasterise measure_clipless(const Scene& scene, const View& view, int width, int height,
                                  int rounds) {
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  view_triangles(scene, view, 0, triangles);
  const Projection<float> projection = projection_of<float>(view);
  const FrameBuffer exact = draw_exact(scene, view, {width, height});
  Target target(width, height);
  const auto timed = [&](auto&& draw) {
    target.clear();
    const auto start = Clock::now();
    draw(projection, triangles, target);
    const std::chrono::duration<double, std::nano> time = Clock::now() - start;
    return time.count() / static_cast<double>(triangles.size());
  };

  ClipAndRasterise result;
  timed(draw_clipped);
  result.clipped_wrong_px = wrong_pixels(target, exact, width, height);
  timed(draw_clipless);
  result.clipless_wrong_px = wrong_pixels(target, exact, width, height);

  const PinnedThread pinned;
  std::vector<double> clipped, clipless, speedup;
  for (int round = 0; round < rounds; ++round) {
    clipped.push_back(timed(draw_clipped));
    clipless.push_back(timed(draw_clipless));
    speedup.push_back(clipped.back() / clipless.back());
  }
  result.clipped_ns = median_interval(clipped);
  result.clipless_ns = median_interval(clipless);
  result.speedup = median_interval(speedup);
  return result;
}

}  // namespace clipscope::experiments
