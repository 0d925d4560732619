// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/recentre.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

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

// Whether some edge changes by more than 1 % of its length when its ends become floats.
bool is_bent(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
    const glm::dvec3 given = point_in_double(mesh, b) - point_in_double(mesh, a);
    const glm::dvec3 rounded = point_of(mesh, b) - point_of(mesh, a);
    if (glm::distance(given, rounded) > 0.01 * glm::length(given)) return true;
  }
  return false;
}

}  // namespace

LostDetail lost_detail(const Mesh& mesh) {
  LostDetail detail;
  for (const auto& position : mesh.positions) {
    for (const float x : position) detail.largest = std::max(detail.largest, std::abs(double{x}));
  }
  const auto largest = static_cast<float>(detail.largest);
  detail.ulp = double{std::nextafter(largest, std::numeric_limits<float>::infinity())} - largest;
  if (mesh.double_positions.empty()) return detail;
  detail.positions = count_distinct(mesh.double_positions);
  detail.fallen = detail.positions - count_distinct(mesh.positions);
  detail.triangles = mesh.triangles.size();
  detail.bent = static_cast<std::size_t>(std::ranges::count_if(
      mesh.triangles, [&](const auto& corners) { return is_bent(mesh, corners); }));
  return detail;
}

std::string describe(const LostDetail& detail, const std::string& mesh) {
  std::vector<std::string> parts;
  if (detail.fallen > 0) {
    parts.push_back(fmt::format("{} of {} positions fall{} together with others", detail.fallen,
                                detail.positions, detail.fallen == 1 ? "s" : ""));
  }
  if (detail.bent > 0) {
    parts.push_back(fmt::format("{} of {} triangles ha{} an edge that changes by more than 1 %",
                                detail.bent, detail.triangles, detail.bent == 1 ? "s" : "ve"));
  }
  if (parts.empty()) return "";
  return fmt::format(
      "{}: in float {}: neighbouring floats are {:.6g} apart at {:.10g}; --recentre subtracts an origin in double first",
      mesh, fmt::join(parts, ", "), detail.ulp, detail.largest);
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
