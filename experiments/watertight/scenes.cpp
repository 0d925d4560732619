// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/watertight/rows.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::watertight {
namespace {

// The unit is the half diagonal of the mesh's box, so that the mesh reaches from half to one and a
// half times the distance.
constexpr double kDistance = 2;
constexpr double kClose = 0.02;  // a near plane within the mesh, the eye too
constexpr double kBeforeAll = 0.1, kBehindAll = 100;

struct Placement {
  std::string label;
  double near, far;   // in half diagonals
  glm::dvec3 middle;  // of the box, in half diagonals
  bool both_sides = true;
};

Placement placed_on(Plane a, Plane b) {
  const auto is = [&](Plane p) { return a == p || b == p; };
  const auto name = [](Plane p) { return name_of(static_cast<EdgeClass>(p)); };
  Placement r{a == b ? std::string(name(a)) : fmt::format("{} and {}", name(a), name(b)),
              is(Plane::near) ? kDistance : kBeforeAll,
              is(Plane::far) ? kDistance : kBehindAll,
              {0, 0, -kDistance},
              a == b};
  const Frustum<float> f = perspective_frustum(60, 16.0 / 9.0, r.near, r.far);
  const double x = kDistance * f.right / f.near, y = kDistance * f.top / f.near;
  if (is(Plane::left)) r.middle.x = -x;
  if (is(Plane::right)) r.middle.x = x;
  if (is(Plane::bottom)) r.middle.y = -y;
  if (is(Plane::top)) r.middle.y = y;
  return r;
}

std::vector<Placement> placements() {
  std::vector<Placement> all;
  for (const Plane p : kAllPlanes) all.push_back(placed_on(p, p));
  all.push_back({"near, at the eye", kClose, kBehindAll, {0, 0, -kClose}});
  all.push_back({"near, beside the eye", kClose, kBehindAll, {0.3, 0.2, -kClose}});
  for (const Plane side : {Plane::left, Plane::right, Plane::bottom, Plane::top}) {
    for (const Plane depth : {Plane::near, Plane::far}) all.push_back(placed_on(side, depth));
  }
  for (const Plane x : {Plane::left, Plane::right}) {
    for (const Plane y : {Plane::bottom, Plane::top}) all.push_back(placed_on(x, y));
  }
  return all;
}

// A point whose ratio to the plane is `reach`: 1 on it, more outside, less inside. It may be inside
// or outside of the other planes.
glm::dvec3 point_by(Plane plane, double reach, const Frustum<float>& f, Random& random) {
  double depth = random.across_magnitudes(f.near / 4, 4 * f.far);
  double x = random.uniform(-1.5, 1.5), y = random.uniform(-1.5, 1.5);
  switch (plane) {
    case Plane::left: x = -reach; break;
    case Plane::right: x = reach; break;
    case Plane::bottom: y = -reach; break;
    case Plane::top: y = reach; break;
    case Plane::near: depth = f.near / reach; break;
    case Plane::far: depth = f.far * reach; break;
  }
  return {x * depth * f.right / f.near, y * depth * f.top / f.near, -depth};
}

// 1 plus or minus 2^-12 to 2^-27.
double nearly_one(Random& random) {
  const int exponent = -12 - static_cast<int>(random.below(16));
  const double sign = random.sign();
  return 1 + sign * std::ldexp(random.uniform(0.5, 1), exponent);
}

}  // namespace

Scene cut_by_every_plane(const Scene& scene) {
  Scene result{fmt::format("{} by plane", scene.name),
               fmt::format("{}, cut by every plane", scene.description),
               scene.mesh,
               {}};
  const Box box = bounding_box(scene.mesh);
  const double unit = glm::length(box.size()) / 2;
  const glm::dmat4 one(1.0), to_middle = glm::translate(one, -box.centre());
  // Turned about an axis along which no edge of a regular mesh lies.
  const glm::dmat4 tilt = glm::rotate(one, 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
  const glm::dmat4 half_turn = tilt * glm::rotate(one, std::numbers::pi, glm::dvec3(0, 1, 0));
  for (const Placement& p : placements()) {
    const glm::dmat4 place = glm::translate(one, p.middle * unit);
    const auto frustum = perspective_frustum(60, 16.0 / 9.0, p.near * unit, p.far * unit);
    result.views.push_back({p.label, place * tilt * to_middle, frustum});
    if (!p.both_sides) continue;
    result.views.push_back({p.label + ", turned", place * half_turn * to_middle, frustum});
  }
  return result;
}

Scene make_grazing_scene(std::size_t pairs, std::uint64_t seed) {
  Scene scene{std::string(name_of(Kind::grazing)),
              "pairs of triangles that share an edge close to a plane",
              {},
              {identity_view()}};
  const Frustum<float>& f = scene.views.front().frustum;
  Random random(seed);
  for (std::size_t i = 0; i < pairs; ++i) {
    const Plane plane = kAllPlanes[random.below(kPlanes)];
    const double first_reach = nearly_one(random), second_reach = nearly_one(random);
    std::array<std::uint32_t, 4> corner{};
    for (std::size_t c = 0; c < corner.size(); ++c) {
      const double reach = std::array{first_reach, second_reach, 2.0, 0.5}[c];
      corner[c] = add_vertex(scene.mesh, point_by(plane, reach, f, random), {});
    }
    scene.mesh.triangles.push_back({corner[0], corner[1], corner[2]});
    scene.mesh.triangles.push_back({corner[1], corner[0], corner[3]});
  }
  return scene;
}

}  // namespace clipscope::experiments::watertight
