// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/culling_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>

#include "experiments/bounds/world_planes.hpp"
#include "spaces/homogeneous/divide.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int K = kSceneAttributes;
constexpr std::size_t kBlock = 1024;  // polygons that stay in cache

// A small scene is clipped again and again, so that the clock does not matter.
constexpr std::size_t kLeastTriangles = 10000;

double nanoseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

using Polygon = std::span<const NdcVertex<float, K>>;

bool same_bits(Polygon a, Polygon b) {
  static_assert(sizeof(NdcVertex<float, K>) == (4 + K) * sizeof(float), "no padding to compare");
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

}  // namespace

CulledView::CulledView(const Contestant<float>& clipper, const View& view, const Objects& objects,
                       std::span<const SceneTriangle> triangles)
    : clipper_(clipper),
      view_(view),
      objects_(objects),
      triangles_(triangles),
      projection_(view.frustum),
      answers_(objects.ranges.size()) {}

void CulledView::clip(const TriangleRange& range) {
  clipper_.view(projection_, triangles_.subspan(range.first, range.count), out_);
}

void CulledView::project(const TriangleRange& range) {
  NdcPolygon<float, K> polygon;
  for (const SceneTriangle& triangle : triangles_.subspan(range.first, range.count)) {
    const std::array<Vec4<float>, 3> positions = {to_clip(projection_, triangle[0].position),
                                                  to_clip(projection_, triangle[1].position),
                                                  to_clip(projection_, triangle[2].position)};
    divide_inside(projection_.volume, positions, triangle, polygon);
    out_.append(polygon);
  }
}

void CulledView::make_room() {
  if (out_.size() >= kBlock) out_.clear();
}

std::string CulledView::first_difference(std::span<const Visibility> answers) {
  PolygonStream<float, K> all;
  clipper_.view(projection_, triangles_, all);
  for (std::size_t object = 0; object < answers.size(); ++object) {
    const TriangleRange& range = objects_.ranges[object];
    out_.clear();
    if (answers[object] == Visibility::accepted) project(range);
    if (answers[object] == Visibility::look_closer) clip(range);
    for (std::uint32_t i = 0; i < range.count; ++i) {
      const Polygon expected = all[range.first + i];
      const Polygon found = i < out_.size() ? out_[i] : Polygon();
      if (!same_bits(found, expected)) {
        return fmt::format("triangle {} has {} vertices, with bounds {} or other bits",
                           objects_.order[range.first + i], expected.size(), found.size());
      }
    }
  }
  return "";
}

double CulledView::clip_all() {
  return timed([&] {
    for (const TriangleRange& range : objects_.ranges) {
      make_room();
      clip(range);
    }
  });
}

double CulledView::clip_culled(const Culler& culler) {
  return timed([&] {
    culler.query(world_planes(view_), answers_);
    for (std::size_t object = 0; object < answers_.size(); ++object) {
      if (answers_[object] == Visibility::rejected) continue;
      make_room();
      if (answers_[object] == Visibility::accepted) {
        project(objects_.ranges[object]);
      } else {
        clip(objects_.ranges[object]);
      }
    }
  });
}

template <class Work>
double CulledView::timed(Work&& work) {
  const std::size_t repeats = 1 + kLeastTriangles / triangles_.size();
  out_.clear();
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < repeats; ++i) work();
  return nanoseconds_since(start) / static_cast<double>(repeats * triangles_.size());
}

}  // namespace clipscope::experiments
