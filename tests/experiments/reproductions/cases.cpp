// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/reproductions/cases.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace clipscope::experiments {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Violation violation(Quantity quantity, ViolationKind kind, WorstPixel worst) {
  return {.quantity = quantity, .kind = kind, .pixels = 1, .worst = worst, .size = kInfinity};
}

// A quarter of the target, whose varying is (x_px, y_px, 0, 1) / 32.
DrawCall quarter() {
  DrawCall call;
  call.topology = Topology::triangle_strip;
  for (const auto& [x, y] : {std::pair{0.f, 0.f}, {1.f, 0.f}, {0.f, 1.f}, {1.f, 1.f}}) {
    call.vertices.push_back({{x, y, 0, 1}, {(x + 1) / 2, (y + 1) / 2, 0, 1}});
  }
  return call;
}

DrawCall with_everything() {
  DrawCall call = quarter();
  call.indices = {3, 2, 1, 0};
  call.volume.depth_clamp = true;
  call.volume.clip_distances = 6;
  call.viewport = {-32, -32, 64, 64};  // the quarter is all of the target
  for (DrawVertex& vertex : call.vertices) {
    vertex.position[2] = 7;
    vertex.clip_distances[5] = 1.5f - vertex.position[0];
  }
  return call;
}

DrawCall point() {
  DrawCall call;
  call.topology = Topology::points;
  call.vertices = {{{0, 0, 0, 1}, {5, 6, 7, 8}}};
  call.point_size = 4;
  return call;
}

// From the middle to the right, half of it beyond the target: 16 px, x-major.
DrawCall line() {
  DrawCall call;
  call.topology = Topology::lines;
  call.vertices = {{{0, 0.25f, 0, 1}}, {{2, 0.75f, 0, 1}}};
  return call;
}

// Each covers the quarter once.
DrawCall twice() {
  DrawCall call = quarter();
  call.topology = Topology::triangles;
  call.indices = {0, 1, 2, 0, 1, 2};
  return call;
}

}  // namespace

DrawCall corner_triangle() {
  DrawCall call;
  call.vertices = {{{0, 0, 0.5f, 1}, {1, 0}}, {{4, 0, 0.5f, 1}, {0, 1}}, {{0, 4, 1, 2}, {0, 0, 1}}};
  return call;
}

std::vector<Claim> right_claims() {
  using K = ViolationKind;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  // (20.5, 24.5) is the centre of pixel (20, 24).
  return {
      {"smooth", quarter(),
       violation(Quantity::smooth, K::not_finite, {20, 24, 0, 20.5 / 32, nan})},
      {"smooth of the corner", corner_triangle(),
       violation(Quantity::smooth, K::not_finite, {20, 24, 2, 0.133, nan})},
      {"hull", quarter(), violation(Quantity::smooth, K::outside_hull, {20, 24, 1, 24.5 / 32, 3})},
      {"flat", quarter(), violation(Quantity::flat, K::flat_value, {28, 30, 1, 1, 0.5f})},
      {"frag_coord", corner_triangle(),
       violation(Quantity::frag_coord, K::wrong_value, {20, 24, 2, 0.75, 0.5f})},
      {"facing", quarter(), violation(Quantity::facing, K::facing, {20, 24, 0, 1, -1})},
      {"primitive", quarter(),
       violation(Quantity::primitive_id, K::primitive_id, {30, 30, 0, 1, 0})},
      {"depth", corner_triangle(),
       violation(Quantity::depth, K::wrong_value, {20, 24, 0, 0.75, 0.7f})},
      {"missing", quarter(), violation(Quantity::covered, K::missing, {20, 24, 0, 1, 0})},
      {"extra", quarter(), violation(Quantity::covered, K::extra, {4, 24, 0, 0, 1})},
      {"shared edge", quarter(), violation(Quantity::hits, K::shared_edge, {20, 24, 0, 1, 2})},
      {"two of them", twice(), violation(Quantity::hits, K::missing, {18, 18, 0, 2, 1})},
      {"line", line(), violation(Quantity::covered, K::missing, {24, 22, 0, 14, 2})},
      {"column", line(), violation(Quantity::covered, K::extra, {24, 22, 0, 1, 2})},
      {"point", point(), violation(Quantity::covered, K::primitive_lost, {17, 17, 0, 1, 0})},
      {"clip distance", with_everything(),
       violation(Quantity::clip_distances, K::outside_hull, {16, 16, 5, 1.5 - 16.5 / 32, 9})},
      {"clamped", with_everything(), violation(Quantity::depth, K::missing, {16, 16, 0, 1, 0})}};
}

Claim turned(Claim claim) {
  WorstPixel& worst = claim.wrong.worst;
  const bool is_hull = claim.wrong.kind == ViolationKind::outside_hull;
  if (is_hull) claim.wrong.kind = ViolationKind::wrong_value;
  if (claim.name == "line") {  // more than there can be
    worst.exact = 20;
    return claim;
  }
  if (claim.name == "column") {  // at most 1 in a row, which has several
    worst.channel = 1;
    return claim;
  }
  const double right = worst.exact;
  worst.exact = std::isnan(worst.returned) ? right + 3 : worst.returned;
  worst.returned = static_cast<float>(right);
  return claim;
}

std::string text_of(const Claim& claim, const std::string& extension) {
  DriverInfo info;
  info.renderer = "a driver";
  for (const Reproduction& one : reproductions(claim.call, claim.wrong, info)) {
    if (one.file_name.ends_with(extension)) return one.text;
  }
  return {};
}

bool is_there_or_not_required(const std::string& program, const char* variable) {
  if (std::system(("command -v " + program + " >/dev/null").c_str()) == 0) return true;
  if (std::getenv(variable)) FAIL(program << " is missing");
  WARN("not tested: " << program << " is missing");
  return false;
}

}  // namespace clipscope::experiments
