// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/plane_views.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "experiments/scenes/camera.hpp"
#include "experiments/watertight/measure.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

// In units of the half diagonal of the mesh's box, so that the mesh reaches from half to one and a half
// times the distance.
constexpr double kDistance = 2;
constexpr double kClose = 0.02;  // a near plane within the mesh, the eye too
constexpr double kBeforeAll = 0.1, kBehindAll = 100;

struct Placement {
  std::string label;
  double near, far;   // in half diagonals
  glm::dvec3 middle;  // of the box, in half diagonals
};

double direction(Plane plane) { return plane == Plane::left || plane == Plane::bottom ? -1 : 1; }

Placement placed_on(Plane a, Plane b) {
  const auto is = [&](Plane p) { return a == p || b == p; };
  Placement r{fmt::format("{}", kEdgeClasses[static_cast<std::size_t>(a)]),
              is(Plane::near) ? kDistance : kBeforeAll,
              is(Plane::far) ? kDistance : kBehindAll,
              {0, 0, -kDistance}};
  if (a != b) r.label += fmt::format(" and {}", kEdgeClasses[static_cast<std::size_t>(b)]);
  const Frustum<float> f = perspective_frustum(60, 16.0 / 9.0, r.near, r.far);
  for (const Plane p : {a, b}) {
    if (p == Plane::left || p == Plane::right) {
      r.middle.x = direction(p) * kDistance * f.right / f.near;
    } else if (p == Plane::bottom || p == Plane::top) {
      r.middle.y = direction(p) * kDistance * f.top / f.near;
    }
  }
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

// Turned by an angle about an axis along which no edge of a regular mesh lies.
View view_of(const Placement& p, const Box& box, double turn, const std::string& label) {
  const double unit = glm::length(box.size()) / 2;
  const glm::dmat4 one(1.0);
  const glm::dmat4 rotation = glm::rotate(one, 0.7, glm::normalize(glm::dvec3(1, 2, 3))) *
                              glm::rotate(one, turn, glm::dvec3(0, 1, 0));
  return {label,
          glm::translate(one, p.middle * unit) * rotation * glm::translate(one, -box.centre()),
          perspective_frustum(60, 16.0 / 9.0, p.near * unit, p.far * unit)};
}

}  // namespace

Scene cut_by_every_plane(const Scene& scene) {
  Scene result{fmt::format("{} by plane", scene.name),
               fmt::format("{}, cut by every plane", scene.description),
               scene.mesh,
               {}};
  const Box box = bounding_box(scene.mesh);
  for (const Placement& p : placements()) {
    result.views.push_back(view_of(p, box, 0, p.label));
    const bool on_one_plane = p.label.find(" and ") == std::string::npos;
    if (on_one_plane) {
      result.views.push_back(view_of(p, box, std::numbers::pi, p.label + ", turned"));
    }
  }
  return result;
}

}  // namespace clipscope::experiments
