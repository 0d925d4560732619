// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "experiments/pixels/lines.hpp"
#include "experiments/pixels/values.hpp"

namespace clipscope::experiments {
namespace {

bool is_beyond(float v) { return std::abs(v) > kGreatest; }
bool is_subnormal(float v) { return v != 0 && std::abs(v) < kLeastNormal; }

std::string_view apart_by(const DrawVertex& v) {
  float greatest_varying = 0;
  bool has_beyond = false, has_subnormal = false;
  const auto look = [&](float c) {
    has_beyond = has_beyond || is_beyond(c);
    has_subnormal = has_subnormal || is_subnormal(c);
  };
  for (const float c : v.position) look(c);
  for (const float c : v.clip_distances) look(c);
  for (const float c : v.varying) {
    look(c);
    greatest_varying = std::max(greatest_varying, std::abs(c));
  }
  const auto& [x, y, z, w] = v.position;
  if (has_beyond) return "numbers beyond 2^32";
  if (has_subnormal) return "numbers below the normal range";
  if (w != 0 && std::max(1.0f, greatest_varying) > kGreatest * std::abs(w)) {
    return "divided by w, numbers beyond 2^32";
  }
  if (x == 0 && y == 0 && w == 0) return "a vertex at the eye";
  return {};
}

std::string_view apart_of(const DrawCall& call) {
  for (const DrawVertex& vertex : call.vertices) {
    const std::string_view reason = apart_by(vertex);
    if (!reason.empty()) return reason;
  }
  return {};
}

JudgedPrimitive judged(const DrawCall& call, std::vector<std::uint32_t> vertices,
                       const DriverInfo& info) {
  JudgedPrimitive r;
  r.vertices = std::move(vertices);
  if (r.vertices.size() > 1) r.exact.emplace(call, r.vertices);
  switch (r.vertices.size()) {
    case 1: r.region = point_region(call, r.vertices[0], info); break;
    case 2: r.region = line_region(call, r.vertices, info); break;
    default: r.region = triangle_region(call, r.vertices, info, r.exact->orientation());
  }
  return r;
}

}  // namespace

Judgement judge_pixels(const DrawCall& call, const Pixels& pixels, const DriverInfo& info) {
  Judgement judgement;
  judgement.apart = apart_of(call);
  std::vector<JudgedPrimitive> primitives;
  for (auto& vertices : primitives_of(call)) {
    if (is_divided_by_zero(call, vertices, info)) judgement.apart = "a line that is divided by 0";
    primitives.push_back(judged(call, vertices, info));
  }
  Accusations accusations;
  const CoverageMap map = coverage_map(call, primitives);
  judge_coverage(primitives, map, pixels, accusations, judgement);
  judge_lines(call, primitives, pixels, info, accusations);
  judge_shared_edges(call, primitives, map, pixels, accusations);
  judge_values({call, info, pixels, accusations, judgement}, primitives, map);
  judgement.violations = accusations.violations();
  return judgement;
}

}  // namespace clipscope::experiments
