// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/w_sign/epsilon.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "experiments/contestants/contestant.hpp"
#include "experiments/measure/batches.hpp"
#include "spaces/cut.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments {
namespace {

using Triangle4 = ClipTriangle<float, kSceneAttributes>;
using Polygon4 = ClipPolygon<float, kSceneAttributes>;

template <class Vertices>
double area_px2(const Vertices& vertices) {
  double area = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& a = vertices[i];
    const auto& b = vertices[(i + 1) % vertices.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2 * (kScreenWidth / 2) * (kScreenHeight / 2);
  }
  return std::abs(area);
}

template <class Vertices>
std::optional<double> nearest_w(const Vertices& vertices) {
  std::optional<double> nearest;
  for (const auto& v : vertices) nearest = std::min(nearest.value_or(HUGE_VAL), 1 / v[3]);
  return nearest;
}

using Corners = std::array<std::array<double, 3>, 3>;

HardCase surface(const Corners& corners, double scale, bool depth_clamp) {
  HardCase surface;
  surface.space = Space::view;
  surface.volume.depth_clamp = depth_clamp;
  const auto length = [scale](double x) { return double{static_cast<float>(x * scale)}; };
  surface.frustum = {.near = length(1e-2), .far = length(1e3)};
  surface.frustum.right = surface.frustum.top = surface.frustum.near;
  surface.frustum.left = surface.frustum.bottom = -surface.frustum.near;
  for (const auto& p : corners) {
    reference::InputVertex& v = surface.vertices.emplace_back();
    v.position = {length(p[0]), length(p[1]), length(p[2]), 1};
  }
  return surface;
}

// What is left to divide: a clipped polygon in clip space.
Polygon4 clipped(const ClipVolume& volume, const Triangle4& triangle,
                 std::optional<float> epsilon) {
  Polygon4 polygon, scratch;
  const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
    return clip_outcode(volume.depth, triangle[i].position);
  });
  if (code.all != 0) return polygon;
  polygon.assign(triangle);
  if (epsilon) {
    cut_if_crossed(polygon, scratch, [&](const auto& v) { return v.position[3] - *epsilon; });
  }
  return cut_by_planes(
      polygon, scratch, code.any, kPlaneOrder<PlaneOrder::near_first>,
      [&](Plane plane, const auto& v) { return signed_distance(volume.depth, plane, v); });
}

bool overflows(const ClipVertex<float, kSceneAttributes>& v) {
  const Vec4<float> ndc = to_ndc(v.position);
  return !(is_finite(ndc[0]) && is_finite(ndc[1]) && is_finite(ndc[2]) && is_finite(ndc[3]));
}

void add_hazard(const Polygon4& polygon, DivisionHazards& hazards) {
  const auto any = [&](auto&& is) { return std::any_of(polygon.begin(), polygon.end(), is); };
  ++hazards.triangles;
  if (any([](const auto& v) { return v.position[3] == 0; })) {
    ++hazards.zero_w;
  } else if (any([](const auto& v) { return v.position[3] < 0; })) {
    ++hazards.negative_w;
  } else if (any(overflows)) {
    ++hazards.overflow;
  }
}

ViewTriangle<float, kSceneAttributes> scaled(SceneTriangle triangle, double scale) {
  for (auto& v : triangle) {
    for (int i = 0; i < 3; ++i) v.position[i] = static_cast<float>(v.position[i] * scale);
  }
  return triangle;
}

Frustum<float> scaled(Frustum<float> f, double scale) {
  for (float* length : {&f.left, &f.right, &f.bottom, &f.top, &f.near, &f.far}) {
    *length = static_cast<float>(*length * scale);
  }
  return f;
}

void add_loss(const VisibleLoss& loss, VisibleLossTally& tally) {
  tally.visible_px2 += loss.visible_px2;
  tally.lost_px2 += std::max(0.0, loss.lost_px2());
  tally.vanished += loss.visible_px2 >= 1 && loss.drawn_px2 == 0;
}

}  // namespace

std::span<const WPlaneClipper> w_plane_clippers() {
  static constexpr std::array<WPlaneClipper, 5> kClippers = {
      {{"homogeneous/sutherland_hodgman", std::nullopt},
       {"homogeneous/w_first_0", w_plane_epsilon(WPlane::zero)},
       {"homogeneous/w_first_flt_min", w_plane_epsilon(WPlane::smallest_normal)},
       {"homogeneous/w_first_1e-5", w_plane_epsilon(WPlane::one_100000th)},
       {"homogeneous/w_first_1_16384", w_plane_epsilon(WPlane::one_16384th)}}};
  return kClippers;
}

HardCase wall_past_the_eye(double scale, bool depth_clamp) {
  return surface({{{0.1, -5, 2}, {0.1, 0.1, -60}, {0.0015, 0.001, 0.5}}}, scale, depth_clamp);
}

HardCase floor_beneath_the_eye(double scale, bool depth_clamp) {
  return surface({{{-60, -0.002, 5}, {60, -0.002, 5}, {0, -0.002, -200}}}, scale, depth_clamp);
}

std::optional<double> VisibleLoss::lost_depth() const {
  if (!nearest_visible || !nearest_drawn) return std::nullopt;
  return std::max(0.0, *nearest_drawn - *nearest_visible);
}

VisibleLoss loss_of(const TruthPolygon& truth, std::span<const std::array<double, 4>> drawn) {
  return {area_px2(truth.approximation), area_px2(drawn), nearest_w(truth.approximation),
          nearest_w(drawn)};
}

std::vector<ClipBatch> scaled_batches(const Scene& scene, double scale, bool depth_clamp,
                                      std::size_t most) {
  std::vector<ClipBatch> batches;
  const Sample sample = sample_of(scene, std::max<std::size_t>(1, most / scene.views.size()));
  for (const View& view : scene.views) {
    Projection<float> projection(scaled(view.frustum, scale));
    projection.volume.depth_clamp = depth_clamp;
    ClipBatch& batch = batches.emplace_back(ClipBatch{projection.volume, {}});
    for (const SceneTriangle& t : sampled_view_triangles(scene, view, sample, 0, sample.count)) {
      batch.triangles.push_back(to_clip(projection, scaled(t, scale)));
    }
  }
  return batches;
}

DivisionHazards count_hazards(std::span<const ClipBatch> batches, std::optional<float> epsilon) {
  DivisionHazards hazards;
  for (const ClipBatch& batch : batches) {
    for (const Triangle4& triangle : batch.triangles) {
      add_hazard(clipped(batch.volume, triangle, epsilon), hazards);
    }
  }
  return hazards;
}

VisibleLossTally tally_loss(std::span<const ClipBatch> batches, std::string_view clipper) {
  VisibleLossTally tally;
  const auto& contestant = *std::get<const Contestant<float>*>(find_contestant(clipper, "float"));
  for (const ClipBatch& batch : batches) {
    const auto truth = reference::Truth::of_clip(batch.volume);
    PolygonStream<float, kSceneAttributes> stream;
    contestant.clip(batch.volume, batch.triangles, stream);
    std::vector<VisibleLoss> losses(batch.triangles.size());
    tbb::parallel_for(std::size_t{0}, losses.size(), [&](std::size_t i) {
      std::vector<std::array<double, 4>> drawn;
      for (const auto& v : stream[i]) {
        drawn.push_back({v.position[0], v.position[1], v.position[2], v.position[3]});
      }
      losses[i] =
          loss_of(truth_polygon(truth, reference::input_triangle(batch.triangles[i])), drawn);
    });
    for (const VisibleLoss& loss : losses) add_loss(loss, tally);
  }
  return tally;
}

}  // namespace clipscope::experiments
