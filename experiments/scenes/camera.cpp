// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/camera.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <initializer_list>
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

void check_numbers(const CameraOptions& options) {
  for (const auto& [option, v] :
       {std::pair{"--eye", options.eye}, {"--target", options.target}, {"--up", options.up}}) {
    if (v && !(std::isfinite(v->x) && std::isfinite(v->y) && std::isfinite(v->z))) {
      throw UsageError(fmt::format("{}: {} is not a finite point", option, text(*v)));
    }
  }
  for (const auto& [option, v] : {std::pair{"--near", options.near}, {"--far", options.far}}) {
    if (v && !(*v > 0)) {
      throw UsageError(fmt::format("{}: {} given; it takes a number > 0", option, *v));
    }
  }
}

// The first option of the list that was given; null if none was.
using Given = std::pair<const char*, bool>;
const char* first_given(std::initializer_list<Given> options) {
  const auto found = std::ranges::find_if(options, [](const Given& g) { return g.second; });
  return found == options.end() ? nullptr : found->first;
}

void refuse_together(const char* option, const char* other) {
  if (other == nullptr) return;
  throw UsageError(
      fmt::format("{}: it does not go together with {}; leave one out", option, other));
}

// What says where the camera stands, and what it sees, must not be said twice.
void check_together(const CameraOptions& o) {
  const CameraOptions unset;
  const Given target{"--target", o.target.has_value()}, up{"--up", o.up.has_value()};
  const Given lens[] = {{"--fovy", o.fovy_degrees != unset.fovy_degrees},
                        {"--aspect", o.aspect != unset.aspect}};
  const Given near{"--near", o.near.has_value()}, far{"--far", o.far.has_value()};
  if (o.orientation) refuse_together("--orientation", first_given({target, up}));
  if (o.pose) {
    refuse_together("--pose", first_given({{"--eye", o.eye.has_value()},
                                           {"--orientation", o.orientation.has_value()},
                                           target,
                                           up}));
  }
  if (o.intrinsics) refuse_together("--intrinsics", first_given({lens[0], lens[1]}));
  const Given intrinsics{"--intrinsics", o.intrinsics.has_value()};
  if (o.frustum) {
    refuse_together("--frustum", first_given({lens[0], lens[1], near, far, intrinsics}));
  }
  if (o.matrix) {
    refuse_together(
        "--matrix",
        first_given(
            {lens[0], lens[1], near, far, intrinsics, {"--frustum", o.frustum.has_value()}}));
  }
  const char* placeless = first_given({{"--frustum", o.frustum.has_value()}, intrinsics});
  if (placeless != nullptr && !o.eye && !o.pose) {
    throw UsageError(fmt::format(
        "{}: it says what the camera sees, not where it is; give --eye or --pose too", placeless));
  }
  if (o.orientation && !o.eye) {
    throw UsageError("--orientation: it turns a camera that stands somewhere; give --eye too");
  }
}

void check(const CameraOptions& options) {
  check_numbers(options);
  check_together(options);
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

// What the camera sees; `depth` is where the far plane lies by default.
Frustum<float> lens_of(const Subject& subject, double depth) {
  const CameraOptions& options = subject.options;
  if (options.frustum) return rounded_frustum(*options.frustum, "--frustum");
  const double near = options.near.value_or(std::max(subject.near, depth / kMostFarPerNear));
  const double far = options.far.value_or(std::max(depth, 2 * near));
  if (options.intrinsics) {
    return rounded_frustum(intrinsics_frustum(*options.intrinsics, near, far), "--intrinsics");
  }
  return perspective_frustum(options.fovy_degrees, options.aspect, near, far);
}

View view_of(std::string label, const glm::dmat4& view_from_world, const Subject& subject,
             double depth) {
  View view{std::move(label), view_from_world, lens_of(subject, depth)};
  view.frustum.depth = subject.options.depth;
  return view;
}

glm::dmat4 look_at(const Look& look, const std::optional<dvec3>& up) {
  const dvec3 y(0, 1, 0), z(0, 0, 1);
  return experiments::look_at(look.eye, look.target,
                              up.value_or(are_parallel(look.target - look.eye, y) ? z : y));
}

View make_view(std::string label, const Subject& subject, const Look& look, double depth) {
  return view_of(std::move(label), look_at(look, subject.options.up), subject, depth);
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
                           [&](std::uint32_t corner) { return point_of(mesh, corner); });
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

// World from camera.
MatrixRows<double> pose_of(const dvec3& eye, const std::array<double, 4>& q) {
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(length > 0 && std::isfinite(length))) {
    throw UsageError(fmt::format(
        "--orientation: {},{},{},{} is no rotation; finite numbers that are not all 0 expected",
        q[0], q[1], q[2], q[3]));
  }
  const double x = q[0] / length, y = q[1] / length, z = q[2] / length, w = q[3] / length;
  return {glm::dvec4(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), eye.x),
          glm::dvec4(2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), eye.y),
          glm::dvec4(2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), eye.z),
          glm::dvec4(0, 0, 0, 1)};
}

// Where the camera stands; none where nothing says so.
struct Stand {
  std::string label;
  glm::dmat4 view_from_world;
  dvec3 eye;
};
std::optional<Stand> stand_of(const CameraOptions& o, const dvec3& centre) {
  if (o.pose || o.orientation) {
    const MatrixRows<double> pose =
        o.pose ? rows_of(*o.pose, o.by_columns) : pose_of(*o.eye, *o.orientation);
    return Stand{"pose", view_of_pose(pose, o.axes), {pose[0][3], pose[1][3], pose[2][3]}};
  }
  if (!o.eye) return {};
  if (*o.eye == centre && !o.target) {
    throw UsageError(
        fmt::format("--eye: {} is the centre of the mesh: give a --target", text(*o.eye)));
  }
  return Stand{"eye", look_at({*o.eye, centre}, o.up), *o.eye};
}

// The matrix in float.
MatrixRows<float> given_matrix(const CameraOptions& options) {
  const MatrixRows<float> rows = matrix_cast<float>(rows_of(*options.matrix, options.by_columns));
  for (const Vec4<float>& row : rows) {
    for (int k = 0; k < 4; ++k) {
      if (std::isfinite(row[k])) continue;
      throw UsageError(
          fmt::format("--matrix: an entry is {} in float; finite numbers expected", row[k]));
    }
  }
  return rows;
}

}  // namespace

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

MatrixRows<double> rows_of(const std::array<double, 16>& numbers, bool by_columns) {
  MatrixRows<double> rows;
  for (std::size_t i = 0; i < 16; ++i) {
    const std::size_t row = by_columns ? i % 4 : i / 4;
    rows[row][static_cast<int>(by_columns ? i / 4 : i % 4)] = numbers[i];
  }
  return rows;
}

glm::dmat4 view_of_pose(const MatrixRows<double>& rows, CameraAxes axes) {
  glm::dmat4 world_from_camera;
  bool finite = true;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const bool flipped = axes == CameraAxes::cv && (column == 1 || column == 2);
      const double entry = rows[static_cast<std::size_t>(row)][column];
      finite = finite && std::isfinite(entry);
      world_from_camera[column][row] = flipped ? 0.0 - entry : entry;
    }
  }
  if (!finite || rows[3] != glm::dvec4(0, 0, 0, 1)) {
    throw UsageError(
        "--pose: it is not finite and affine; expected 16 numbers with the last row 0 0 0 1 (see --matrix-order)");
  }
  const glm::dmat4 view_from_world = glm::inverse(world_from_camera);
  for (int column = 0; column < 4; ++column) {
    if (std::isfinite(glm::dot(view_from_world[column], glm::dvec4(1)))) continue;
    throw UsageError("--pose: it flattens space and can't be inverted");
  }
  return view_from_world;
}

std::vector<View> make_views(const Mesh& mesh, const CameraOptions& options) {
  assert(!mesh.triangles.empty() && !mesh.positions.empty());
  check(options);
  const Subject subject(mesh, options);
  const std::optional<Stand> stand = stand_of(options, subject.centre);
  if (options.matrix) {
    View view{"matrix as given"};
    if (stand) view.view_from_world = stand->view_from_world;
    view.frustum.depth = options.depth;
    view.matrix = given_matrix(options);
    return {view};
  }
  if (stand) {
    const double depth =
        std::max(subject.reach(stand->eye), glm::length(subject.centre - stand->eye));
    return {view_of(stand->label, stand->view_from_world, subject, 1.01 * depth)};
  }
  std::vector<View> views;
  for (int n = 0; n < options.walk; ++n) views.push_back(walk_view(n, subject));
  return views;
}

}  // namespace clipscope::experiments
