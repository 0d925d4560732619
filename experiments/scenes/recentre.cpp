// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/recentre.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/scenes/equal_vertices.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

double rounded_to_multiple(double x, double unit) { return std::round(x / unit) * unit; }

glm::dvec3 origin_near(const Box& box) {
  const glm::dvec3 size = box.size(), centre = box.centre();
  const double half = 0.5 * std::max({size.x, size.y, size.z});
  const double unit = half > 0 ? std::exp2(std::floor(std::log2(half))) : 1.0;
  return {rounded_to_multiple(centre.x, unit), rounded_to_multiple(centre.y, unit),
          rounded_to_multiple(centre.z, unit)};
}

}  // namespace

LostDetail lost_detail(const Mesh& mesh) {
  LostDetail detail;
  for (const auto& position : mesh.positions) {
    for (const float x : position) {
      detail.largest = std::max(detail.largest, std::abs(double{x}));
    }
  }
  const auto largest = static_cast<float>(detail.largest);
  detail.ulp = double{std::nextafter(largest, std::numeric_limits<float>::infinity())} - largest;
  if (mesh.double_positions.empty()) return detail;
  detail.positions = count_distinct(mesh.double_positions);
  detail.fallen = detail.positions - count_distinct(mesh.positions);
  return detail;
}

std::string describe(const LostDetail& detail, const std::string& mesh) {
  if (detail.fallen == 0) return "";
  return fmt::format(
      "{}: {} of {} positions fall{} together with others in float, whose neighbours are {:.6g} apart at {:.10g}; --recentre subtracts an origin in double first",
      mesh, detail.fallen, detail.positions, detail.fallen == 1 ? "s" : "", detail.ulp,
      detail.largest);
}

glm::dvec3 recentre(Scene& scene) {
  Mesh& mesh = scene.mesh;
  const glm::dvec3 origin = origin_near(bounding_box(mesh));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 p = point_in_double(mesh, i) - origin;
    mesh.positions[i] = {nearest_float(p.x), nearest_float(p.y), nearest_float(p.z)};
    if (!mesh.double_positions.empty()) mesh.double_positions[i] = {p.x, p.y, p.z};
  }
  for (View& view : scene.views) {
    view.view_from_world[3] = view.view_from_world * glm::dvec4(origin, 1);
  }
  return origin;
}

}  // namespace clipscope::experiments
