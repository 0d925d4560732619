// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/objects.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <numeric>

#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments::bounds {
namespace {

constexpr const char* kField = "teapot field";
constexpr double kSpacing = 8;  // between pots; one is some 6.4 long, spout to handle

// Adds the pot turned about y by (cosine, sine), scaled, standing at (x, z).
void add_pot(Mesh& mesh, const Mesh& pot, Random& random, double x, double z) {
  const glm::dvec3 direction = random.direction();
  const double length = std::hypot(direction.x, direction.z);
  const double c = length > 0 ? direction.x / length : 1, s = length > 0 ? direction.z / length : 0;
  const double scale = random.uniform(0.5, 1.1);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < pot.positions.size(); ++i) {
    const auto& p = pot.positions[i];
    const glm::dvec3 turned(c * p[0] - s * p[2], p[1], s * p[0] + c * p[2]);
    const auto& a = pot.attributes[i];
    add_vertex(mesh, scale * turned + glm::dvec3(x, 0, z), {a[0], a[1], a[2], a[3]});
  }
  for (const auto& t : pot.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

// Half: of the side of the field.
std::vector<View> field_walk(double half) {
  return {make_view("along a row", {-half, 2, 0.4 * half}, {half, 1, 0.3 * half}, 0.1, 200),
          make_view("across", {-half, 3, -half}, {half, 0, half}, 0.1, 200),
          make_view("between pots", {4, 1.6, 4}, {12, 1.4, 9}, 0.05, 60),
          make_view("at a pot", {0, 2, 7}, {0, 1, 0}, 0.1, 100),
          make_view("along the edge", {-half, 2, half + 6}, {half, 1, half - 2}, 0.1, 200),
          make_view("from above", {0, 60, 0}, {2, 0, 1}, 1, 100),
          make_view("short far plane", {0.5 * half, 4, half}, {-half, 0, -half}, 0.1, 30),
          make_view("away from it", {half, 2, half}, {2 * half, 2, 1.5 * half}, 0.1, 200)};
}

// From the error bounds of double to 32 u of float; see objects.hpp.
constexpr double kFloatWeights = 0x1p30;

using Points = std::span<const Vec3<double>>;

AxisBox<double> axis_box(Points points) { return clipscope::bounding_box(points); }
Sphere<double> sphere(Points points) { return bounding_sphere(points); }
OrientedBox<double> oriented_box(Points points) { return bounding_oriented_box(points); }

template <auto kAround>
auto volumes_of(const Mesh& mesh, const Objects& objects) {
  std::vector<decltype(kAround(Points()))> volumes;
  for (const TriangleRange& range : objects.ranges) {
    volumes.push_back(kAround(positions_of(mesh, objects, range)));
  }
  return volumes;
}

// A volume around each object, by the planes.
template <auto kAround>
Culler by_planes(const Mesh& mesh, const Objects& objects) {
  return [volumes = volumes_of<kAround>(mesh, objects)](const View& view,
                                                        std::span<Visibility> answers) {
    const CullingPlanes<double> planes = world_planes(view);
    for (std::size_t i = 0; i < volumes.size(); ++i) answers[i] = visibility(planes, volumes[i]);
  };
}

// The same, and by all separating axes what the planes leave open.
template <auto kAround>
Culler by_axes(const Mesh& mesh, const Objects& objects) {
  return [volumes = volumes_of<kAround>(mesh, objects)](const View& view,
                                                        std::span<Visibility> answers) {
    const CullingPlanes<double> planes = world_planes(view);
    const CullingHull<double> hull = world_hull(view);
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      answers[i] = visibility(planes, hull, volumes[i]);
    }
  };
}

// Ranges are reported in order, and so lie the objects.
template <auto kHierarchy>
Culler hierarchy(const Mesh&, const Objects& objects) {
  if ((objects.*kHierarchy).nodes().empty()) return {};
  return [&objects](const View& view, std::span<Visibility> answers) {
    std::size_t object = 0;
    (objects.*kHierarchy).query(world_planes(view), [&](TriangleRange range, Visibility answer) {
      const std::uint32_t end = range.first + range.count;
      while (object < answers.size() && objects.ranges[object].first < end) {
        answers[object++] = answer;
      }
    });
  };
}

}  // namespace

Objects clusters(const Mesh& mesh, std::uint32_t most) {
  std::vector<Vec3<double>> positions;
  for (const auto& p : mesh.positions) positions.emplace_back(p[0], p[1], p[2]);
  std::vector<std::uint32_t> indices;
  for (const auto& t : mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
  Objects r;
  r.boxes = BoxHierarchy<double>(positions, indices, most);
  r.spheres = SphereHierarchy<double>(positions, indices, most);
  r.oriented_boxes = OrientedBoxHierarchy<double>(positions, indices, most);
  r.order = r.boxes.order();
  const auto& nodes = r.boxes.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].next == i + 1) r.ranges.push_back(nodes[i].range);
  }
  return r;
}

Objects instances(const Mesh& mesh, std::uint32_t each) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  assert(each > 0 && count % each == 0);
  Objects r;
  r.order.resize(count);
  std::iota(r.order.begin(), r.order.end(), 0u);
  for (std::uint32_t first = 0; first < count; first += each) r.ranges.push_back({first, each});
  return r;
}

std::vector<Vec3<double>> positions_of(const Mesh& mesh, const Objects& objects,
                                       const TriangleRange& range) {
  std::vector<Vec3<double>> positions;
  for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
    for (const std::uint32_t corner : mesh.triangles[objects.order[i]]) {
      const auto& p = mesh.positions[corner];
      positions.emplace_back(p[0], p[1], p[2]);
    }
  }
  return positions;
}

ObjectScene teapot_field(std::uint64_t seed, bool quick) {
  const int side = quick ? 6 : 12;
  const Mesh pot = teapot_mesh(quick ? 2 : 3);
  Random random(seed);
  ObjectScene r;
  r.scene.name = kField;
  r.scene.description = fmt::format("{} teapots, turned and scaled", side * side);
  r.object = "teapot";
  const double half = 0.5 * kSpacing * side;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      add_pot(r.scene.mesh, pot, random, (i + 0.5) * kSpacing - half, (j + 0.5) * kSpacing - half);
    }
  }
  r.scene.views = field_walk(half);
  r.objects = instances(r.scene.mesh, static_cast<std::uint32_t>(pot.triangles.size()));
  return r;
}

std::vector<ObjectSceneName> object_scenes(const Selection& selection) {
  std::vector<ObjectSceneName> names;
  for (const std::string& scene : selection.scenes) {
    names.push_back({scene, 64});
    names.push_back({scene, 256});
  }
  if (!names.empty()) return names;
  return {{kField, 0},      {kField, 64},     {"teapot", 64}, {"terrain", 64},
          {"terrain", 256}, {"corridor", 64}, {"soup", 64}};
}

ObjectScene load_object_scene(const Selection& selection, const ObjectSceneName& name) {
  const bool is_field = name.scene == kField && selection.scenes.empty();
  ObjectScene r;
  if (is_field) r = teapot_field(selection.seed, selection.quick);
  if (name.most == 0) return r;
  if (!is_field) r.scene = load_selected_scene(selection, name.scene);
  r.objects = clusters(r.scene.mesh, name.most);
  r.object = fmt::format("cluster of {}", name.most);
  return r;
}

CullingPlanes<double> world_planes(const View& view) {
  const glm::dmat3 turn(view.view_from_world);
  const glm::dmat3 magnitudes(clipscope::bounds::absolute(turn[0]),
                              clipscope::bounds::absolute(turn[1]),
                              clipscope::bounds::absolute(turn[2]));
  const Vec3<double> shift(view.view_from_world[3]);
  const CullingPlanes<float> in_view = culling_planes(Projection<float>(view.frustum));
  CullingPlanes<double> r;
  for (int i = 0; i < in_view.count; ++i) {
    const CullingPlane<float>& plane = in_view.planes[static_cast<std::size_t>(i)];
    const Vec3<double> normal(plane.normal), weight(plane.weight);
    CullingPlane<double> world;
    world.normal = normal * turn;
    world.offset = clipscope::bounds::dot(normal, shift) + double{plane.offset};
    world.weight = kFloatWeights * (weight * magnitudes);
    world.offset_weight =
        kFloatWeights *
        (clipscope::bounds::dot(weight, clipscope::bounds::absolute(shift)) + plane.offset_weight);
    clipscope::bounds::push_back(r, world);
  }
  return r;
}

CullingHull<double> world_hull(const View& view) {
  // The inverse of a rotation and a shift: R^T (p - t).
  const glm::dmat3 back = glm::transpose(glm::dmat3(view.view_from_world));
  const glm::dmat3 magnitudes(clipscope::bounds::absolute(back[0]),
                              clipscope::bounds::absolute(back[1]),
                              clipscope::bounds::absolute(back[2]));
  const Vec3<double> shift(view.view_from_world[3]);
  CullingHull<double> hull;
  hull.corners = culling_hull(frustum_cast<double>(view.frustum)).corners;
  for (HullCorner<double>& corner : hull.corners) {
    corner.position = back * (corner.position - corner.weight * shift);
    const Vec3<double> moved =
        corner.magnitude + corner.weight_magnitude * clipscope::bounds::absolute(shift);
    corner.magnitude = kFloatWeights * (magnitudes * moved);
    corner.weight_magnitude *= kFloatWeights;
  }
  clipscope::bounds::complete(hull);
  return hull;
}

std::span<const BoundKind> bound_kinds() {
  static constexpr std::array<BoundKind, 8> kKinds = {{
      {"axis box", by_planes<axis_box>},
      {"sphere", by_planes<sphere>},
      {"oriented box", by_planes<oriented_box>},
      {"axis box, all axes", by_axes<axis_box>},
      {"oriented box, all axes", by_axes<oriented_box>},
      {"box hierarchy", hierarchy<&Objects::boxes>},
      {"sphere hierarchy", hierarchy<&Objects::spheres>},
      {"oriented box hierarchy", hierarchy<&Objects::oriented_boxes>},
  }};
  return kKinds;
}

}  // namespace clipscope::experiments::bounds
