// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <map>

#include "experiments/pixels/coverage.hpp"

namespace clipscope::experiments {
namespace {

using Position = std::array<float, 4>;

// One triangle at an edge: the edge is that of its half-plane `edge`, opposite to its vertex
// `edge`.
struct EdgeUse {
  std::size_t primitive = 0, edge = 0;
};

// Ends in ascending order. Zeros of both signs are one.
using Edges = std::map<std::array<Position, 2>, std::vector<EdgeUse>>;

Position without_signed_zeros(Position p) {
  for (float& c : p) c += 0.0f;
  return p;
}

Edges edges_in_volume(const DrawCall& call, const std::vector<JudgedPrimitive>& primitives) {
  Edges edges;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const JudgedPrimitive& primitive = primitives[i];
    const bool has_edges = primitive.is_triangle() && primitive.has_values();
    if (!has_edges || primitive.region.is_discarded) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const DrawVertex& a = call.vertices[primitive.vertices[(k + 1) % 3]];
      const DrawVertex& b = call.vertices[primitive.vertices[(k + 2) % 3]];
      if (!is_in_volume(a, call.volume) || !is_in_volume(b, call.volume)) continue;
      std::array<Position, 2> ends = {without_signed_zeros(a.position),
                                      without_signed_zeros(b.position)};
      if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
      edges[ends].push_back({i, k});
    }
  }
  return edges;
}

// Whether the insides are on the two sides of the edge.
bool is_on_either_side(const HalfPlane& a, const HalfPlane& b) { return a.a * b.a + a.b * b.b < 0; }

// Whether the pixel may be on either side.
bool is_open(const HalfPlane& h, int x, int y) { return std::abs(h.at(x, y)) < h.margin(); }

bool is_within_others(const Region& region, std::size_t edge, int x, int y) {
  for (std::size_t k = 0; k < region.half_planes.size(); ++k) {
    const HalfPlane& h = region.half_planes[k];
    if (k != edge && h.at(x, y) < h.margin()) return false;
  }
  return true;
}

void judge_edge(const std::vector<JudgedPrimitive>& primitives, const EdgeUse& one,
                const EdgeUse& other, const CoverageMap& map, const Pixels& pixels,
                Accusations& accusations) {
  const Region& a = primitives[one.primitive].region;
  const Region& b = primitives[other.primitive].region;
  const HalfPlane& edge = a.half_planes[one.edge];
  const HalfPlane& other_edge = b.half_planes[other.edge];
  if (!is_on_either_side(edge, other_edge)) return;
  for (int y = std::max(a.box.bottom, b.box.bottom); y < std::min(a.box.top, b.box.top); ++y) {
    for (int x = std::max(a.box.left, b.box.left); x < std::min(a.box.right, b.box.right); ++x) {
      if (!is_open(edge, x, y) || !is_open(other_edge, x, y)) continue;
      const PixelClaim& claim = map.at(x, y);
      const bool is_alone = claim.open == 2 && is_within_others(a, one.edge, x, y) &&
                            is_within_others(b, other.edge, x, y);
      if (!is_alone) continue;
      const double right = claim.covered + 1.0;
      const float hits = pixels.at(Quantity::hits, x, y);
      if (static_cast<double>(hits) == right) continue;
      accusations.add(other.primitive, Quantity::hits, ViolationKind::shared_edge,
                      {x, y, 0, right, hits}, std::numeric_limits<double>::infinity());
    }
  }
}

}  // namespace

void judge_shared_edges(const DrawCall& call, const std::vector<JudgedPrimitive>& primitives,
                        const CoverageMap& map, const Pixels& pixels, Accusations& accusations) {
  for (const auto& [ends, uses] : edges_in_volume(call, primitives)) {
    if (uses.size() != 2) continue;
    judge_edge(primitives, uses[0], uses[1], map, pixels, accusations);
  }
}

}  // namespace clipscope::experiments
