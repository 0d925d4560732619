// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/scene_draws.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>
#include <span>
#include <utility>

#include "experiments/workloads/plain_call.hpp"
#include "spaces/planes.hpp"
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
  OutcodeSummary codes{~Outcode{0}, 0};
  for (const auto& [x, y, z, w] : corners) {
    const Outcode code = clip_outcode(depth, Vec4<float>(x, y, z, w));
    codes.all &= code;
    codes.any |= code;
  }
  return codes.any != 0 && codes.all == 0;
}

struct Chunk {
  std::size_t first = 0, end = 0;  // triangles
  std::ptrdiff_t cut = 0;          // how many of them
};

// Those in which something is cut, the most first.
std::vector<Chunk> cut_chunks(const std::vector<Corners>& triangles, DepthRange depth) {
  std::vector<Chunk> chunks;
  for (std::size_t first = 0; first < triangles.size(); first += kChunkTriangles) {
    Chunk chunk{first, std::min(first + kChunkTriangles, triangles.size())};
    chunk.cut = std::count_if(triangles.begin() + static_cast<std::ptrdiff_t>(chunk.first),
                              triangles.begin() + static_cast<std::ptrdiff_t>(chunk.end),
                              [depth](const Corners& t) { return is_cut(t, depth); });
    if (chunk.cut > 0) chunks.push_back(chunk);
  }
  std::ranges::stable_sort(chunks, std::greater<>(), &Chunk::cut);
  return chunks;
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

std::vector<DrawCall> scene_draws(const Scene& scene, const DriverInfo& info, std::size_t most) {
  std::vector<DrawCall> calls;
  for (View view : scene.views) {
    const DrawCall plain = plain_call("", Topology::triangles, {}, info);
    view.frustum.depth = plain.volume.depth;
    const std::vector<Corners> triangles = clip_triangles(scene, view);
    std::vector<Chunk> chunks = cut_chunks(triangles, view.frustum.depth);
    chunks.resize(std::min(chunks.size(), most));
    for (const Chunk& chunk : chunks) {
      DrawCall call = plain;
      call.name = fmt::format("scene/{} ({}, triangles {} to {})", scene.name, view.label,
                              chunk.first, chunk.end - 1);
      set_size(call, kLargeTarget, kLargeTarget);
      add_chunk(call, scene.mesh, triangles, chunk.first, chunk.end);
      if (is_finite(call)) calls.push_back(std::move(call));
    }
  }
  return calls;
}

}  // namespace clipscope::experiments
