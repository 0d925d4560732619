// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/measure.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/judge/outcome.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments::guard_band {
namespace {

using FloatPolygon = std::span<const NdcVertex<float, kSceneAttributes>>;

double x_px(const NdcVertex<float, kSceneAttributes>& v) {
  return (double{v.position[0]} * 0.5 + 0.5) * kScreenWidth;
}
double y_px(const NdcVertex<float, kSceneAttributes>& v) {
  return (0.5 - double{v.position[1]} * 0.5) * kScreenHeight;
}

// Pixel centres in [lo, hi] that lie on a screen of so many pixels.
double centres_between(double lo, double hi, double size) {
  const double first = std::max(0.0, std::ceil(lo - 0.5));
  const double last = std::min(size - 1, std::floor(hi - 0.5));
  return std::max(0.0, last - first + 1);
}

void add_polygon(FloatPolygon polygon, Tally& tally) {
  if (polygon.empty()) return;
  ++tally.polygons;
  tally.vertices += static_cast<std::int64_t>(polygon.size());
  const double ax = x_px(polygon[0]), ay = y_px(polygon[0]);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const double bx = x_px(polygon[i - 1]), by = y_px(polygon[i - 1]);
    const double cx = x_px(polygon[i]), cy = y_px(polygon[i]);
    tally.visited_px +=
        centres_between(std::min({ax, bx, cx}), std::max({ax, bx, cx}), kScreenWidth) *
        centres_between(std::min({ay, by, cy}), std::max({ay, by, cy}), kScreenHeight);
    tally.area_px2 += std::abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
  }
}

}  // namespace

double Tally::cut_percent() const {
  return passed() == 0 ? 0 : 100.0 * static_cast<double>(side_cut) / static_cast<double>(passed());
}

Tally tally_band(std::span<const SampledView> views, const GuardBand& band) {
  Tally tally;
  NdcPolygon<float, kSceneAttributes> polygon;
  for (const SampledView& v : views) {
    const Projection<float> projection(v.view.frustum);
    for (const SceneTriangle& triangle : v.triangles) {
      const Work work = clip_to_band(projection, band, triangle, polygon);
      ++tally.triangles;
      tally.rejected += work == Work::rejected;
      tally.side_cut += work == Work::side_cut;
      add_polygon({polygon.begin(), polygon.end()}, tally);
    }
  }
  return tally;
}

Tally tally_full(std::span<const SampledView> views) {
  // The same triangles are rejected and cut at a side as with a band that ends at the screen.
  const Tally cuts = tally_band(views, {1, 1});
  Tally tally{.triangles = cuts.triangles, .rejected = cuts.rejected, .side_cut = cuts.side_cut};
  NdcPolygon<float, kSceneAttributes> polygon;
  for (const SampledView& v : views) {
    const Projection<float> projection(v.view.frustum);
    for (const SceneTriangle& triangle : v.triangles) {
      HomogeneousSutherlandHodgman{}(projection, triangle, polygon);
      add_polygon({polygon.begin(), polygon.end()}, tally);
    }
  }
  return tally;
}

double FixedPoint::band_px() const { return std::ldexp(1.0, integer_bits - 1); }

GuardBand FixedPoint::band() const {
  return {band_px() / (kScreenWidth / 2), band_px() / (kScreenHeight / 2)};
}

int FixedPoint::edge_function_bits(int subpixel_bits) const {
  const int difference = integer_bits + subpixel_bits + 1;
  return 2 * difference + 1;
}

PointTally tally_points(std::span<const SampledView> views) {
  PointTally tally;
  const auto on_screen = [](const NdcVertex<float, kSceneAttributes>& v) {
    const double x = std::floor(x_px(v)), y = std::floor(y_px(v));
    return 0 <= x && x < kScreenWidth && 0 <= y && y < kScreenHeight;
  };
  for (const SampledView& v : views) {
    const Projection<float> projection(v.view.frustum);
    for (const SceneTriangle& triangle : v.triangles) {
      for (const auto& vertex : triangle) {
        const auto clip = to_clip(projection, vertex);
        const Outcode code = clip_outcode(projection.volume.depth, clip.position);
        const bool by_depth = (code & ~kSideBits) == 0;
        const bool seen = by_depth && on_screen(to_ndc(clip));
        ++tally.points;
        tally.kept_full += code == 0;
        tally.kept_near_far += by_depth;
        tally.drawn += seen;
        tally.differ += seen != (code == 0 && seen);
      }
    }
  }
  return tally;
}

}  // namespace clipscope::experiments::guard_band
