// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/scene_draws.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "experiments/workloads/plain_call.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {
namespace {

using Position = std::array<float, 4>;
using Corners = std::array<Position, 3>;

// One per triangle of the scene.
std::vector<Corners> clip_triangles(const Scene& scene, const View& view) {
  const MatrixRows<float> rows =
      view.matrix ? *view.matrix : rows_of(Projection<float>(view.frustum));
  std::vector<Corners> all;
  for_each_chunk(scene, view, spacing_of(scene, 0), [&](const auto& triangles, std::size_t) {
    for (const SceneTriangle& triangle : triangles) {
      Corners& corners = all.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec4<float> p = to_clip(rows, triangle[i].position);
        corners[i] = {p[0], p[1], p[2], p[3]};
      }
    }
  });
  return all;
}

// Neither all inside nor all outside of one plane.
bool is_cut(const Corners& corners, DepthRange depth) {
  unsigned any = 0, all = ~0u;
  for (const Position& p : corners) {
    unsigned code = 0;
    const float near = depth == DepthRange::minus_one_to_one ? p[3] + p[2] : p[2];
    const std::array distances = {p[3] + p[0], p[3] - p[0], p[3] + p[1],
                                  p[3] - p[1], near,        p[3] - p[2]};
    for (unsigned k = 0; k < 6; ++k) code |= distances[k] < 0 ? 1u << k : 0u;
    any |= code;
    all &= code;
  }
  return any != 0 && all == 0;
}

// The first triangle of the chunk with the most that are cut, and how many they are.
std::pair<std::size_t, std::size_t> richest_chunk(const std::vector<Corners>& triangles,
                                                  DepthRange depth) {
  std::pair<std::size_t, std::size_t> richest = {0, 0};
  for (std::size_t first = 0; first < triangles.size(); first += kChunkTriangles) {
    const std::size_t end = std::min(first + kChunkTriangles, triangles.size());
    const auto count = static_cast<std::size_t>(
        std::count_if(triangles.begin() + static_cast<std::ptrdiff_t>(first),
                      triangles.begin() + static_cast<std::ptrdiff_t>(end),
                      [depth](const Corners& t) { return is_cut(t, depth); }));
    if (count > richest.second) richest = {first, count};
  }
  return richest;
}

// Triangles [first, end) of the mesh, each of its vertices once.
void add_chunk(DrawCall& call, const Mesh& mesh, const std::vector<Corners>& triangles,
               std::size_t first, std::size_t end) {
  std::map<std::uint32_t, std::uint32_t> numbers;  // in the call, by number in the mesh
  for (std::size_t t = first; t < end; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto next = static_cast<std::uint32_t>(call.vertices.size());
      const auto [found, is_new] = numbers.emplace(mesh.triangles[t][i], next);
      if (is_new) {
        call.vertices.push_back({.position = triangles[t][i], .varying = varying_of(next)});
      }
      call.indices.push_back(found->second);
    }
  }
}

}  // namespace

std::vector<DrawCall> scene_draws(const Scene& scene, const DriverInfo& info) {
  std::vector<DrawCall> calls;
  for (View view : scene.views) {
    const DrawCall plain = plain_call("", Topology::triangles, {}, info);
    view.frustum.depth = plain.volume.depth;
    const std::vector<Corners> triangles = clip_triangles(scene, view);
    const auto [first, count] = richest_chunk(triangles, view.frustum.depth);
    if (count == 0) continue;
    const std::size_t end = std::min(first + kChunkTriangles, triangles.size());
    DrawCall call = plain;
    call.name =
        fmt::format("scene/{} ({}, triangles {} to {})", scene.name, view.label, first, end - 1);
    set_size(call, kLargeTarget, kLargeTarget);
    add_chunk(call, scene.mesh, triangles, first, end);
    if (is_finite(call)) calls.push_back(std::move(call));
  }
  return calls;
}

}  // namespace clipscope::experiments
