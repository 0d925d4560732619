// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/scenes/convex_quadrangle.hpp"
#include "experiments/scenes/equal_vertices.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/scenes/triangulate.hpp"

namespace clipscope::experiments {
namespace {

// Stands for an attribute that the file does not have; those that it has are finite.
constexpr float kAbsent = std::numeric_limits<float>::quiet_NaN();

// The coordinates of points in a box, each scaled to [0, 1], the longest side's first.
class BoxCoordinates {
 public:
  explicit BoxCoordinates(const Box& box) : lo_(box.lo), size_(box.size()) {
    std::ranges::stable_sort(axes_, [this](int a, int b) { return size_[a] > size_[b]; });
  }

  double operator()(const std::array<float, 3>& p, int rank) const {
    const int axis = axes_[static_cast<std::size_t>(rank)];
    return size_[axis] > 0 ? (p[static_cast<std::size_t>(axis)] - lo_[axis]) / size_[axis] : 0.5;
  }

 private:
  glm::dvec3 lo_, size_;
  std::array<int, 3> axes_ = {0, 1, 2};
};

std::vector<bool> used_vertices(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) is_used[corner] = true;
  }
  return is_used;
}

}  // namespace

const char* to_string(VertexValue value) {
  constexpr std::array kNames = {
      "x", "y", "z", "texture coordinate u", "texture coordinate v", "the normal's length"};
  return kNames[static_cast<std::size_t>(value)];
}

void MeshBuilder::add_vertex(const std::array<double, 3>& p) {
  add_vertex(p, {nearest_float(p[0]), nearest_float(p[1]), nearest_float(p[2])});
}

void MeshBuilder::add_vertex(const std::array<double, 3>& position,
                             const std::array<float, 3>& rounded) {
  std::vector<std::array<double, 3>>& in_double = mesh_.double_positions;
  bool is_float = true;
  for (std::size_t k = 0; k < 3; ++k) {
    is_float = is_float && (double{rounded[k]} == position[k] || std::isnan(position[k]));
  }
  if (!is_float && in_double.empty()) {
    for (const auto& [x, y, z] : mesh_.positions) in_double.push_back({x, y, z});
  }
  if (!is_float || !in_double.empty()) in_double.push_back(position);
  mesh_.positions.push_back(rounded);
}

std::array<float, kSceneAttributes>& MeshBuilder::attributes_of(std::size_t vertex) {
  if (vertex >= mesh_.attributes.size()) {
    mesh_.attributes.resize(mesh_.positions.size(), {kAbsent, kAbsent, kAbsent, kAbsent});
  }
  return mesh_.attributes[vertex];
}

void MeshBuilder::set_texture(std::size_t vertex, double u, double v) {
  for (const auto& [what, value] : {std::pair{VertexValue::u, u}, {VertexValue::v, v}}) {
    if (!defect_of(value).empty()) defects_.push_back({vertex, what, value});
  }
  auto& attributes = attributes_of(vertex);
  attributes[0] = nearest_float(u);
  attributes[1] = nearest_float(v);
}

void MeshBuilder::set_normal(std::size_t vertex, const std::array<double, 3>& normal) {
  const double length = std::hypot(normal[0], std::hypot(normal[1], normal[2]));
  if (!std::isfinite(length)) defects_.push_back({vertex, VertexValue::normal, length});
  auto& attributes = attributes_of(vertex);
  attributes[2] = length == 0 ? 0.0f : static_cast<float>(normal[0] / length);
  attributes[3] = length == 0 ? 0.0f : static_cast<float>(normal[1] / length);
}

void MeshBuilder::add_polygon(std::span<const std::uint32_t> corners, std::size_t number) {
  const std::size_t first = mesh_.triangles.size();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    add_triangle(corners[0], corners[i - 1], corners[i]);
  }
  if (corners.size() > 3) fans_.push_back({first, corners.size() - 2, number});
}

void MeshBuilder::copy_vertices(std::span<const std::uint32_t> sources) {
  const auto copy = [&]<class T>(std::vector<T>& values) {
    if (values.empty()) return;
    std::vector<T> copies(sources.size());
    for (std::size_t i = 0; i < copies.size(); ++i) copies[i] = values[sources[i]];
    values = std::move(copies);
  };
  copy(mesh_.positions);
  copy(mesh_.double_positions);
}

Mesh MeshBuilder::finish(const Place& place) {
  if (mesh_.triangles.empty()) refuse(file_, "the file has no triangles");
  if (vertices() >= UINT32_MAX) {
    refuse(file_, "{} vertices are too many; fewer than 2^32 expected", vertices());
  }
  if (!mesh_.attributes.empty()) attributes_of(vertices() - 1);  // of all vertices
  const std::vector<bool> is_used = used_vertices(mesh_);
  require_finite_values(is_used, place);
  split_polygons();
  merge_equal_vertices(is_used);
  fill_attributes();
  mesh_.triangles.shrink_to_fit();
  return std::move(mesh_);
}

void MeshBuilder::require_finite_values(const std::vector<bool>& is_used,
                                        const Place& place) const {
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (!is_used[i]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::isfinite(mesh_.positions[i][k])) continue;
      const std::size_t axis = k;
      require_finite(point_in_double(mesh_, i)[static_cast<int>(axis)],
                     [&] { return place(i, static_cast<VertexValue>(axis)); });
    }
  }
  for (const auto& [vertex, what, value] : defects_) {
    if (!is_used[vertex]) continue;
    const VertexValue which = what;
    const std::size_t at = vertex;
    require_finite(value, [&] { return place(at, which); });
  }
}

// Replaces a fan, unless its polygon is certainly a convex quadrangle; false if it is not simple.
bool MeshBuilder::split(const Fan& fan) {
  const std::span triangles = std::span(mesh_.triangles).subspan(fan.first, fan.triangles);
  std::vector<std::uint32_t> corners = {triangles[0][0], triangles[0][1]};
  for (const auto& triangle : triangles) corners.push_back(triangle[2]);
  std::vector<std::array<double, 3>> points;
  for (const std::uint32_t corner : corners) {
    const glm::dvec3 p = point_in_double(mesh_, corner);
    points.push_back({p.x, p.y, p.z});
  }
  if (is_certainly_convex_quadrangle(points)) return true;
  try {
    auto triangle = triangles.begin();
    for (const auto& [a, b, c] : triangulate(points)) {
      const auto at = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
      *triangle++ = {at(a), at(b), at(c)};
    }
    return true;
  } catch (const InputError&) {
    return false;
  }
}

void MeshBuilder::split_polygons() {
  std::size_t not_simple = 0, first_of_those = 0;
  for (const Fan& fan : fans_) {
    if (!split(fan) && not_simple++ == 0) first_of_those = fan.number;
  }
  if (not_simple == 0) return;
  mesh_.remarks.push_back(fmt::format(
      "{}: {} simple (edges cross or touch, or there is no area), the first in {} {}; each is cut into a fan around its first corner",
      file_, counted(not_simple, "polygon is not", "polygons are not"), numbered_by_,
      first_of_those));
}

// Leaves one vertex of those with the same bits, and none that no triangle has.
void MeshBuilder::merge_equal_vertices(const std::vector<bool>& is_used) {
  EqualVertices kept(mesh_);
  std::vector<std::uint32_t> new_index(vertices());
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    if (is_used[i]) new_index[i] = kept.keep(i);
  }
  kept.drop_others();
  for (auto& triangle : mesh_.triangles) {
    for (std::uint32_t& corner : triangle) corner = new_index[corner];
  }
}

void MeshBuilder::fill_attributes() {
  mesh_.attributes.resize(vertices(), {kAbsent, kAbsent, kAbsent, kAbsent});
  const BoxCoordinates coordinates(bounding_box(mesh_));
  for (std::size_t i = 0; i < vertices(); ++i) {
    const std::array<float, 3>& p = mesh_.positions[i];
    auto& [u, v, a, b] = mesh_.attributes[i];
    if (std::isnan(u)) {
      u = static_cast<float>(coordinates(p, 0));
      v = static_cast<float>(coordinates(p, 1));
    }
    if (std::isnan(a)) {
      a = static_cast<float>(2 * coordinates(p, 0) - 1);
      b = static_cast<float>(2 * coordinates(p, 2) - 1);
    }
  }
}

}  // namespace clipscope::experiments
