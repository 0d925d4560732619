// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two ways to a picture, side by side: cutting every triangle and rasterising what is left, or
// rasterising it uncut by its homogeneous edge functions (Olano and Greer 1997).
//
// Both set up the same planes (depth, 1/w, four attributes) and run the same pixel loop over a
// bounding rectangle, in float. The timed whole is view-space triangles in, picture out; the
// picture is cleared off the clock. Both are held to the exact picture first: what covers other
// pixels than it is not timed, but for one in a thousand of them, since pixel centres on edges
// count as covered here.
#include "experiments/claims/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/clock/clock.hpp"
#include "spaces/barycentric/edge_functions.hpp"
#include "spaces/bounds/projected_bounds.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::claims {
namespace {

using Positions = std::array<Vec4<float>, 3>;
using Bounds = ScreenRectangle<float>;

// What a pixel of a triangle is computed from.
struct Setup {
  EdgeFunctions<float> edges;
  ScreenPlane<float> inv_w, depth;
  std::array<ScreenPlane<float>, kSceneAttributes> attributes_over_w;
};

// Vertices at p, and what is linear over the screen there: `one` is 1 where p has w, else 1/w, and
// attribute(i, k) is times that.
template <class Attribute>
Setup set_up(const Positions& p, const std::array<float, 3>& one, const Attribute& attribute) {
  Setup s{edge_functions(p[0], p[1], p[2]), {}, {}, {}};
  s.inv_w = s.edges.over_w(one[0], one[1], one[2]);
  s.depth = s.edges.over_w(p[0][2], p[1][2], p[2][2]);
  for (int k = 0; k < kSceneAttributes; ++k) {
    s.attributes_over_w[k] = s.edges.over_w(attribute(0, k), attribute(1, k), attribute(2, k));
  }
  return s;
}

class Target {
 public:
  explicit Target(const PictureSize& size)
      : width_(size.width),
        height_(size.height),
        pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

  void clear() { std::fill(pixels_.begin(), pixels_.end(), Pixel{}); }

  // kTestDepth: the triangle may reach beyond near and far.
  template <bool kTestDepth>
  void draw(const Setup& setup, const Bounds& bounds) {
    const auto centres = [](float lo, float hi, int n) {
      return std::pair(std::max(0, static_cast<int>(std::floor((lo + 1) / 2 * n - 0.5f))),
                       std::min(n - 1, static_cast<int>(std::ceil((hi + 1) / 2 * n - 0.5f))));
    };
    const auto [i0, i1] = centres(bounds.left, bounds.right, width_);
    const auto [j0, j1] = centres(bounds.bottom, bounds.top, height_);
    for (int j = j0; j <= j1; ++j) {
      const float y = (2 * j + 1) / static_cast<float>(height_) - 1;
      for (int i = i0; i <= i1; ++i) {
        const float x = (2 * i + 1) / static_cast<float>(width_) - 1;
        shade<kTestDepth>(setup, x, y, pixels_[static_cast<std::size_t>(j) * width_ + i]);
      }
    }
  }

  // Pixels covered here and not there, or the other way round.
  std::int64_t unlike(const FrameBuffer& other) const {
    std::int64_t unlike = 0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const std::size_t row = i / width_;  // from the bottom; the other's are from the top
      const std::size_t theirs = (height_ - 1 - row) * width_ + i % width_;
      unlike += (pixels_[i].depth < kEmpty) != other.covered(theirs);
    }
    return unlike;
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

void include(float x, float y, Bounds& bounds) {
  bounds.left = std::min(bounds.left, x), bounds.right = std::max(bounds.right, x);
  bounds.bottom = std::min(bounds.bottom, y), bounds.top = std::max(bounds.top, y);
}

// Cut, divide, and draw the fan.
void draw_clipped(const Projection<float>& projection, const std::vector<SceneTriangle>& triangles,
                  Target& target) {
  NdcPolygon<float, kSceneAttributes> polygon;
  for (const SceneTriangle& triangle : triangles) {
    HomogeneousSutherlandHodgman{}(projection, triangle, polygon);
    for (int i = 2; i < polygon.size(); ++i) {
      const std::array v = {&polygon[0], &polygon[i - 1], &polygon[i]};
      Positions screen;
      Bounds bounds;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& p = v[c]->position;
        screen[c] = Vec4<float>(p[0], p[1], p[2], 1);
        include(p[0], p[1], bounds);
      }
      const auto inv_w = [&](std::size_t c) { return v[c]->position[3]; };
      const Setup setup = set_up(screen, {inv_w(0), inv_w(1), inv_w(2)}, [&](std::size_t c, int k) {
        return v[c]->attributes[k] * inv_w(c);
      });
      target.draw<false>(setup, bounds);
    }
  }
}

// The rectangle of the screen that a triangle may cover.
Bounds bounds_on_screen(const Positions& p) {
  constexpr Bounds kScreen{-1, -1, 1, 1};
  if (!(p[0][3] > 0 && p[1][3] > 0 && p[2][3] > 0)) {
    return projected_bounds_within(kScreen, std::span<const Vec4<float>>(p), Rounding::outward);
  }
  Bounds r;
  for (const Vec4<float>& v : p) include(v[0] / v[3], v[1] / v[3], r);
  return {std::max(r.left, -1.0f), std::max(r.bottom, -1.0f), std::min(r.right, 1.0f),
          std::min(r.top, 1.0f)};
}

// No cut and no divide of vertices but for the bounds; near and far by pixel where they are
// crossed.
void draw_clipless(const Projection<float>& projection, const std::vector<SceneTriangle>& triangles,
                   Target& target) {
  constexpr Outcode kDepthPlanes = bit(Plane::near) | bit(Plane::far);
  for (const SceneTriangle& triangle : triangles) {
    Positions p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = to_clip(projection, triangle[i].position);
    const OutcodeSummary code = summarize_outcodes(projection.volume, triangle, [&](std::size_t i) {
      return clip_outcode(projection.volume.depth, p[i]);
    });
    if (code.all != 0) continue;
    const Setup setup =
        set_up(p, {1, 1, 1}, [&](std::size_t i, int k) { return triangle[i].attributes[k]; });
    const Bounds bounds = bounds_on_screen(p);
    if (bounds.empty()) continue;
    if ((code.any & kDepthPlanes) != 0) {
      target.draw<true>(setup, bounds);
    } else {
      target.draw<false>(setup, bounds);
    }
  }
}

}  // namespace

PictureRow time_clipless(const Scene& scene, const View& view, const PictureSize& size,
                         int rounds) {
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  view_triangles(scene, view, 0, triangles);
  const Projection<float> projection(view.frustum);
  const FrameBuffer exact = draw_exact(scene, view, size);
  Target target(size);
  PictureRow row{.scene = scene.name};
  const auto task = [&](auto* draw, std::int64_t PictureRow::*wrong_px) {
    const auto work = [&, draw](double) {
      draw(projection, triangles, target);
      return triangles.size();
    };
    const auto check = [&, draw, wrong_px]() -> std::string {
      target.clear();
      draw(projection, triangles, target);
      row.*wrong_px = target.unlike(exact);
      if (static_cast<std::size_t>(row.*wrong_px) <= exact.pixels() / 1000) return "";
      return fmt::format("{} pixels are wrong", row.*wrong_px);
    };
    return Task{.work = work, .check = check, .prepare = [&] { target.clear(); }};
  };
  const std::array tasks = {task(draw_clipped, &PictureRow::clipped_wrong_px),
                            task(draw_clipless, &PictureRow::clipless_wrong_px)};
  const std::vector<Timing> timings = time_in_turn(tasks, {.rounds = rounds, .baseline = 0});
  if (timings[0].is_timed()) row.clipped_ns = timings[0].ns.median;
  if (timings[1].is_timed()) row.clipless_ns = timings[1].ns.median;
  row.speedup = timings[1].speedup;
  return row;
}

}  // namespace clipscope::experiments::claims
