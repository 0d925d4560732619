// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/camera.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

using glm::dvec3;

// Below this sine two directions count as parallel.
constexpr double kParallelSine = 1e-9;

// Ratio of far to near that defaults don't exceed, however far the eye is from the mesh.
constexpr double kMostFarPerNear = 1e5;

std::string text(const dvec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

bool are_parallel(const dvec3& a, const dvec3& b) {
  return glm::length(glm::cross(a, b)) <= kParallelSine * glm::length(a) * glm::length(b);
}

void require_positive(const char* option, const std::optional<double>& v) {
  if (v && !(*v > 0 && std::isfinite(*v))) {
    throw UsageError(fmt::format("{}: {} given; it takes a finite number > 0", option, *v));
  }
}

void check(const CameraOptions& options) {
  for (const auto& [option, v] :
       {std::pair{"--eye", options.eye}, {"--target", options.target}, {"--up", options.up}}) {
    if (v && !(std::isfinite(v->x) && std::isfinite(v->y) && std::isfinite(v->z))) {
      throw UsageError(fmt::format("{}: {} is not a finite point", option, text(*v)));
    }
  }
  require_positive("--near", options.near);
  require_positive("--far", options.far);
  if (options.up == dvec3(0)) throw UsageError("--up: (0, 0, 0) given; it takes a direction");
  if (options.walk < 1) {
    throw UsageError(
        fmt::format("--walk: {} given; it takes a number of views, at least 1", options.walk));
  }
}

// What the views look at.
struct Subject {
  const Mesh& mesh;
  const CameraOptions& options;
  Box box;
  dvec3 centre;   // what the views look at
  double radius;  // half the diagonal of the box, or 1 for a mesh that is a single point
  double near;    // of views from nearby

  Subject(const Mesh& m, const CameraOptions& o)
      : mesh(m), options(o), box(bounding_box(m)), centre(o.target.value_or(box.centre())) {
    const double half_diagonal = 0.5 * glm::length(box.size());
    radius = half_diagonal > 0 ? half_diagonal : 1.0;
    const double far = o.far.value_or(std::numeric_limits<double>::infinity());
    near = o.near.value_or(std::min(radius / 100, far / 1000));
  }

  // The largest distance from a point to the box.
  double reach(const dvec3& from) const {
    return glm::length(glm::max(glm::abs(from - box.lo), glm::abs(from - box.hi)));
  }
};

// Where a view looks from and to.
struct Look {
  dvec3 eye, target;
};

// `depth` is where the far plane lies by default.
View make_view(std::string label, const Subject& subject, const Look& look, double depth) {
  const CameraOptions& options = subject.options;
  const double near = options.near.value_or(std::max(subject.near, depth / kMostFarPerNear));
  const double far = options.far.value_or(std::max(depth, 2 * near));
  Frustum<float> frustum = perspective_frustum(options.fovy_degrees, options.aspect, near, far);
  frustum.depth = options.depth;
  const dvec3 y(0, 1, 0), z(0, 0, 1);
  const dvec3 up = options.up.value_or(are_parallel(look.target - look.eye, y) ? z : y);
  return {std::move(label), look_at(look.eye, look.target, up), frustum};
}

// The digits of n in the base, mirrored at the point: evenly spread over (0, 1) as n counts up.
double radical_inverse(int base, int n) {
  double value = 0, place = 1;
  for (; n > 0; n /= base) {
    place /= base;
    value += place * (n % base);
  }
  return value;
}

// The n-th of a fixed sequence of directions, spread over the sphere, upwards for even n and
// downwards for odd n; never along an axis.
dvec3 spread_direction(int n) {
  const double x = 2 * radical_inverse(2, n + 1) - 0.9, z = 2 * radical_inverse(5, n + 1) - 0.85;
  const double y = 0.2 + radical_inverse(3, n + 1);
  return glm::normalize(dvec3(x, n % 2 == 0 ? y : -y, z));
}

// A fixed choice of triangles with an area, spread over the mesh; the first triangle if none has
// one.
std::array<dvec3, 3> spread_triangle(const Mesh& mesh, int n) {
  const auto count = mesh.triangles.size();
  const auto start =
      static_cast<std::size_t>(radical_inverse(2, n + 1) * static_cast<double>(count));
  std::array<dvec3, 3> corners;
  for (std::size_t i = 0; i < count; ++i) {
    std::ranges::transform(mesh.triangles[(start + i) % count], corners.begin(),
                           [&](std::uint32_t corner) { return point_in_double(mesh, corner); });
    if (!are_parallel(corners[1] - corners[0], corners[2] - corners[0])) break;
  }
  return corners;
}

Look from_outside(int n, const Subject& subject) {
  const double half_angle = subject.options.fovy_degrees * std::numbers::pi / 360;
  const double narrow = std::atan(std::tan(half_angle) * std::min(1.0, subject.options.aspect));
  const double distance = 1.05 * subject.radius / std::sin(narrow);
  return {subject.centre + spread_direction(n) * distance, subject.centre};
}

Look from_close_by(int n, const Subject& subject) {
  return {subject.centre + spread_direction(n) * (0.8 * subject.radius), subject.centre};
}

// The centroid of a triangle in the middle of the near rectangle, the view direction oblique to the
// triangle: its near plane cuts the triangle.
Look through_surface(int n, const Subject& subject) {
  const auto& up = subject.options.up;
  const auto [a, b, c] = spread_triangle(subject.mesh, n);
  const dvec3 centroid = (a + b + c) / 3.0;
  dvec3 forward = b == a ? dvec3(0, 0, -1) : glm::normalize(b - a);
  const dvec3 inwards = subject.centre - centroid;
  if (glm::length(inwards) > 0 && !are_parallel(inwards, forward)) {
    forward = glm::normalize(forward + glm::normalize(inwards));
  }
  if (up && are_parallel(forward, *up)) {
    forward = glm::normalize(forward + 0.1 * spread_direction(n));
  }
  const dvec3 eye = centroid - subject.near * forward;
  return {eye, eye + forward * subject.radius};
}

Look from_inside(int n, const Subject& subject) {
  const dvec3 eye = subject.centre + 0.25 * spread_direction(n) * subject.box.size();
  return {eye, eye + spread_direction(n + 1) * subject.radius};
}

// The views of the walk, again and again: what they are called, where they look, and where the far
// plane lies, as a share of the distance to the far end of the box.
struct Stop {
  const char* name;
  Look (*look)(int n, const Subject&);
  double depth;
};
constexpr std::array kStops = {
    Stop{"outside", from_outside, 1.01}, Stop{"outside", from_outside, 1.01},
    Stop{"close", from_close_by, 1.01},  Stop{"through", through_surface, 1.01},
    Stop{"inside", from_inside, 1.01},   Stop{"through, short far", through_surface, 0.5}};

View walk_view(int n, const Subject& subject) {
  const auto& [name, look_of, depth] = kStops[static_cast<std::size_t>(n) % kStops.size()];
  const Look look = look_of(n, subject);
  return make_view(fmt::format("{}: {}", n, name), subject, look, depth * subject.reach(look.eye));
}

View single_view(const dvec3& eye, const Subject& subject) {
  const dvec3& target = subject.centre;
  if (eye == target && !subject.options.target) {
    throw UsageError(
        fmt::format("--eye: {} is the centre of the mesh: give a --target", text(eye)));
  }
  return make_view("eye", subject, {eye, target},
                   1.01 * std::max(subject.reach(eye), glm::length(target - eye)));
}

}  // namespace

Frustum<float> perspective_frustum(double fovy_degrees, double aspect, double near, double far) {
  if (!(fovy_degrees > 0 && fovy_degrees < 180)) {
    throw UsageError(fmt::format(
        "--fovy: {} given; it takes degrees between 0 and 180, both excluded", fovy_degrees));
  }
  require_positive("--aspect", aspect);
  require_positive("--near", near);
  require_positive("--far", far);
  if (!(near < far)) {
    throw UsageError(
        fmt::format("--near: {} given; it must be less than far, which is {}", near, far));
  }
  const double height = near * std::tan(fovy_degrees * std::numbers::pi / 360);
  const auto top = static_cast<float>(height), right = static_cast<float>(height * aspect);
  const Frustum<float> f{
      ProjectionKind::perspective, -right, right, -top, top, static_cast<float>(near),
      static_cast<float>(far)};
  if (!is_valid(f) || !std::isfinite(f.top) || !std::isfinite(f.right) || !std::isfinite(f.far)) {
    throw UsageError(fmt::format(
        "--near: {} and far {} with --fovy {} and --aspect {} enclose no volume once rounded to float; move near and far apart",
        near, far, fovy_degrees, aspect));
  }
  return f;
}

glm::dmat4 look_at(const dvec3& eye, const dvec3& target, const dvec3& up) {
  const dvec3 forward = target - eye;
  if (!(glm::length(forward) > 0)) {
    throw UsageError(
        fmt::format("--target: {} is the eye itself; it takes another point", text(target)));
  }
  if (are_parallel(forward, up)) {
    throw UsageError(fmt::format("--up: {} is parallel to the view direction {}; give another one",
                                 text(up), text(forward)));
  }
  const dvec3 back = -glm::normalize(forward);
  const dvec3 right = glm::normalize(glm::cross(up, back));
  const dvec3 upright = glm::cross(back, right);
  glm::dmat4 m(glm::transpose(glm::dmat3(right, upright, back)));
  m[3] = {-glm::dot(right, eye), -glm::dot(upright, eye), -glm::dot(back, eye), 1};
  return m;
}

std::vector<View> make_views(const Mesh& mesh, const CameraOptions& options) {
  assert(!mesh.triangles.empty() && !mesh.positions.empty());
  check(options);
  const Subject subject(mesh, options);
  if (options.eye) return {single_view(*options.eye, subject)};
  std::vector<View> views;
  for (int n = 0; n < options.walk; ++n) views.push_back(walk_view(n, subject));
  return views;
}

}  // namespace clipscope::experiments
