// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frusta, look-at matrices and the automatic walk.
#include "experiments/scenes/camera.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "experiments/errors.hpp"

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

void require_finite(const char* option, const std::optional<dvec3>& v) {
  if (v && !(std::isfinite(v->x) && std::isfinite(v->y) && std::isfinite(v->z))) {
    throw UsageError(fmt::format("{}: {} is not a finite point", option, text(*v)));
  }
}

void require_positive(const char* option, const std::optional<double>& v) {
  if (v && !(*v > 0 && std::isfinite(*v))) {
    throw UsageError(fmt::format("{}: {} given; it takes a finite number > 0", option, *v));
  }
}

void check(const CameraOptions& options) {
  require_finite("--eye", options.eye);
  require_finite("--target", options.target);
  require_finite("--up", options.up);
  require_positive("--near", options.near);
  require_positive("--far", options.far);
  if (options.up && *options.up == dvec3(0)) {
    throw UsageError("--up: (0, 0, 0) given; it takes a direction");
  }
  if (options.walk < 1) {
    throw UsageError(
        fmt::format("--walk: {} given; it takes a number of views, at least 1", options.walk));
  }
}

// What the walk needs to know of a mesh.
struct Subject {
  const Mesh& mesh;
  Box box;
  dvec3 centre;   // what the views look at
  double radius;  // half the diagonal of the box, or 1 for a mesh that is a single point

  Subject(const Mesh& m, const CameraOptions& options)
      : mesh(m), box(bounding_box(m)), centre(options.target.value_or(box.centre())) {
    const double half_diagonal = 0.5 * glm::length(box.size());
    radius = half_diagonal > 0 ? half_diagonal : 1.0;
  }

  // The largest distance from a point to the box.
  double reach(const dvec3& from) const {
    const dvec3 far_corner = glm::max(glm::abs(from - box.lo), glm::abs(from - box.hi));
    return glm::length(far_corner);
  }
};

dvec3 up_for(const dvec3& forward, const CameraOptions& options) {
  if (options.up) {
    return *options.up;
  }
  return are_parallel(forward, dvec3(0, 1, 0)) ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
}

double near_of(const Subject& subject, const CameraOptions& options) {
  if (options.near) {
    return *options.near;
  }
  const double near = subject.radius / 100;
  return options.far ? std::min(near, *options.far / 1000) : near;
}

// `depth` is where the far plane lies by default.
View place(std::string label, const Subject& subject, const CameraOptions& options,
           const dvec3& eye, const dvec3& target, double depth) {
  const double near =
      options.near.value_or(std::max(near_of(subject, options), depth / kMostFarPerNear));
  const double far = options.far.value_or(std::max(depth, 2 * near));
  Frustum<float> frustum = perspective_frustum(options.fovy_degrees, options.aspect, near, far);
  frustum.depth = options.depth;
  return {std::move(label), look_at(eye, target, up_for(target - eye, options)), frustum};
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

// The n-th of a fixed sequence of directions, spread over the sphere, upwards for even n and downwards
// for odd n; never along an axis.
dvec3 spread_direction(int n) {
  const double x = 2 * radical_inverse(2, n + 1) - 0.9, z = 2 * radical_inverse(5, n + 1) - 0.85;
  const double y = 0.2 + radical_inverse(3, n + 1);
  return glm::normalize(dvec3(x, n % 2 == 0 ? y : -y, z));
}

// A fixed choice of triangles with an area, spread over the mesh; the first triangle if none has one.
std::array<dvec3, 3> spread_triangle(const Mesh& mesh, int n) {
  const auto count = mesh.triangles.size();
  const auto start =
      static_cast<std::size_t>(radical_inverse(2, n + 1) * static_cast<double>(count));
  std::array<dvec3, 3> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& indices = mesh.triangles[(start + i) % count];
    for (int k = 0; k < 3; ++k) {
      const auto& p = mesh.positions[indices[k]];
      corners[k] = dvec3(p[0], p[1], p[2]);
    }
    if (!are_parallel(corners[1] - corners[0], corners[2] - corners[0])) {
      break;
    }
  }
  return corners;
}

View from_outside(int n, const Subject& subject, const CameraOptions& options) {
  const double half_angle = options.fovy_degrees * std::numbers::pi / 360;
  const double narrow = std::atan(std::tan(half_angle) * std::min(1.0, options.aspect));
  const double distance = 1.05 * subject.radius / std::sin(narrow);
  const dvec3 eye = subject.centre + spread_direction(n) * distance;
  return place(fmt::format("{}: outside", n), subject, options, eye, subject.centre,
               1.01 * subject.reach(eye));
}

View from_close_by(int n, const Subject& subject, const CameraOptions& options) {
  const dvec3 eye = subject.centre + spread_direction(n) * (0.8 * subject.radius);
  return place(fmt::format("{}: close", n), subject, options, eye, subject.centre,
               1.01 * subject.reach(eye));
}

// The centroid of a triangle in the middle of the near rectangle, the view direction oblique to the
// triangle: its near plane cuts the triangle.
View through_surface(int n, const Subject& subject, const CameraOptions& options, bool cut_far) {
  const std::array<dvec3, 3> corners = spread_triangle(subject.mesh, n);
  const dvec3 centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
  const dvec3 along = corners[1] - corners[0];
  dvec3 forward = along == dvec3(0) ? dvec3(0, 0, -1) : glm::normalize(along);
  const dvec3 inwards = subject.centre - centroid;
  if (glm::length(inwards) > 0 && !are_parallel(inwards, forward)) {
    forward = glm::normalize(forward + glm::normalize(inwards));
  }
  if (options.up && are_parallel(forward, *options.up)) {
    forward = glm::normalize(forward + 0.1 * spread_direction(n));
  }
  const dvec3 eye = centroid - near_of(subject, options) * forward;
  const double depth = cut_far ? 0.5 * subject.reach(eye) : 1.01 * subject.reach(eye);
  return place(fmt::format("{}: {}", n, cut_far ? "through, short far" : "through"), subject,
               options, eye, eye + forward * subject.radius, depth);
}

View from_inside(int n, const Subject& subject, const CameraOptions& options) {
  const dvec3 eye = subject.centre + 0.25 * spread_direction(n) * subject.box.size();
  const dvec3 target = eye + spread_direction(n + 1) * subject.radius;
  return place(fmt::format("{}: inside", n), subject, options, eye, target,
               1.01 * subject.reach(eye));
}

View walk_view(int n, const Subject& subject, const CameraOptions& options) {
  switch (n % 6) {
    case 0:
    case 1: return from_outside(n, subject, options);
    case 2: return from_close_by(n, subject, options);
    case 3: return through_surface(n, subject, options, false);
    case 4: return from_inside(n, subject, options);
    default: return through_surface(n, subject, options, true);
  }
}

View single_view(const Subject& subject, const CameraOptions& options) {
  const dvec3& eye = *options.eye;
  dvec3 target = subject.centre;
  if (eye == target && !options.target) {
    throw UsageError(
        fmt::format("--eye: {} is the centre of the mesh: give a --target", text(eye)));
  }
  return place("eye", subject, options, eye, target,
               1.01 * std::max(subject.reach(eye), glm::length(target - eye)));
}

}  // namespace

bool is_camera_set(const CameraOptions& options) {
  CameraOptions unset;
  unset.depth = options.depth;
  return options != unset;
}

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
  const double top = near * std::tan(fovy_degrees * std::numbers::pi / 360);
  Frustum<float> f;
  f.top = static_cast<float>(top);
  f.bottom = -f.top;
  f.right = static_cast<float>(top * aspect);
  f.left = -f.right;
  f.near = static_cast<float>(near);
  f.far = static_cast<float>(far);
  if (!is_valid(f) || !std::isfinite(f.top) || !std::isfinite(f.right) || !std::isfinite(f.far)) {
    throw UsageError(
        fmt::format("--near: {} and far {} with --fovy {} and --aspect {} enclose no "
                    "volume once rounded to float; move near and far apart",
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
  const std::array<dvec3, 3> rows = {right, upright, back};
  glm::dmat4 m(1.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m[column][row] = rows[row][column];
    }
    m[3][row] = -glm::dot(rows[row], eye);
  }
  return m;
}

std::vector<View> make_views(const Mesh& mesh, const CameraOptions& options) {
  assert(!mesh.triangles.empty() && !mesh.positions.empty());
  check(options);
  const Subject subject(mesh, options);
  if (options.eye) {
    return {single_view(subject, options)};
  }
  std::vector<View> views;
  for (int n = 0; n < options.walk; ++n) {
    views.push_back(walk_view(n, subject, options));
  }
  return views;
}

}  // namespace clipscope::experiments
