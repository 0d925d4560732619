// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/band_work.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/outcome.hpp"

namespace clipscope::experiments {
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

void add_polygon(FloatPolygon polygon, BandTally& tally) {
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

double BandTally::cut_percent() const {
  return passed() == 0 ? 0 : 100.0 * static_cast<double>(side_cut) / static_cast<double>(passed());
}

BandTally tally_band(std::span<const TimedBatch> batches, const GuardBand& band) {
  BandTally tally;
  NdcPolygon<float, kSceneAttributes> polygon;
  for (const TimedBatch& batch : batches) {
    const auto projection = projection_of<float>(batch.view);
    for (const SceneTriangle& triangle : batch.triangles) {
      const BandWork work = clip_to_band(projection, band, triangle, polygon);
      ++tally.triangles;
      tally.rejected += work == BandWork::rejected;
      tally.side_cut += work == BandWork::side_cut;
      add_polygon({polygon.begin(), polygon.end()}, tally);
    }
  }
  return tally;
}

BandTally tally_full(std::span<const TimedBatch> batches) {
  BandTally tally;
  const auto& full = *std::get<const Contestant<float>*>(
      find_contestant("homogeneous/sutherland_hodgman", "float"));
  PolygonStream<float, kSceneAttributes> polygons;
  for (const TimedBatch& batch : batches) {
    polygons.clear();
    full.view(projection_of<float>(batch.view), batch.triangles, polygons);
    for (std::size_t i = 0; i < polygons.size(); ++i) add_polygon(polygons[i], tally);
  }
  const BandTally cuts = tally_band(batches, {1, 1});
  tally.triangles = cuts.triangles;
  tally.rejected = cuts.rejected;
  tally.side_cut = cuts.side_cut;
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

PointTally tally_points(std::span<const TimedBatch> batches) {
  PointTally tally;
  const auto on_screen = [](const NdcVertex<float, kSceneAttributes>& v) {
    const double x = std::floor(x_px(v)), y = std::floor(y_px(v));
    return 0 <= x && x < kScreenWidth && 0 <= y && y < kScreenHeight;
  };
  for (const TimedBatch& batch : batches) {
    const auto projection = projection_of<float>(batch.view);
    for (const SceneTriangle& triangle : batch.triangles) {
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

}  // namespace clipscope::experiments
