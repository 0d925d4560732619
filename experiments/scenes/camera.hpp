// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cameras: where they stand (a look-at view, a pose, a camera of a glTF file), what they see (a
// lens or a matrix as given), and an automatic walk around and through a mesh.
//
// Look-at matrix: the gluLookAt manual page (OpenGL Utility Library), in double precision:
// right-handed, looking down -z. Results repeat bit for bit on one machine; tan comes from the C
// library, so that another library could in principle round a frustum number to the neighbouring
// float.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/scenes/lens.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// Which way a camera looks in its own axes: gl down -z with y up (OpenGL, glTF), cv down +z with y
// down (OpenCV, COLMAP).
enum class CameraAxes { gl, cv };

// What fits together is said at make_views.
struct CameraOptions {
  std::optional<glm::dvec3> eye;     // without a place to stand: an automatic walk
  std::optional<glm::dvec3> target;  // default: the centre of the mesh's bounding box
  std::optional<glm::dvec3> up;      // default: +y, or +z where the view is along y
  // Instead of target and up, world from camera: a quaternion x y z w about the eye, of any length.
  std::optional<std::array<double, 4>> orientation;
  std::optional<std::array<double, 16>> pose;  // instead of the eye too: 4 x 4, affine
  CameraAxes axes = CameraAxes::gl;            // of orientation and pose
  std::optional<std::string> gltf_camera;      // name or number in the mesh's file

  double fovy_degrees = 60;         // the whole vertical angle, in (0, 180)
  double aspect = 16.0 / 9.0;       // width / height
  std::optional<double> near, far;  // default: from the mesh's bounding box; far may be infinite
  std::optional<Intrinsics> intrinsics;          // instead of fovy and aspect
  std::optional<Frustum<double>> frustum;        // instead of near and far, too
  std::optional<std::array<double, 16>> matrix;  // to clip space
  bool by_columns = false;                       // of matrix and pose

  int walk = 6;  // number of views of an automatic walk, at least 1
  DepthRange depth = DepthRange::minus_one_to_one;

  friend bool operator==(const CameraOptions&, const CameraOptions&) = default;
};

// The rows of 16 numbers.
MatrixRows<double> rows_of(const std::array<double, 16>& numbers, bool by_columns);

// World to view: the eye goes to the origin, the target onto the negative z axis, up into the half
// plane x = 0, y > 0. Errors: UsageError if eye = target or up is parallel to the view direction.
glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

// World to view of a camera with that pose; a pose that scales or mirrors is taken as it is.
// Errors: UsageError unless it is finite and affine (last row 0 0 0 1) and can be inverted.
glm::dmat4 view_of_pose(const MatrixRows<double>& world_from_camera, CameraAxes axes);

// With a matrix, rounded to float once: one view that takes it as given, of the world itself
// unless an eye or a pose says where the camera stands. With these alone: that one view. Else a
// walk of `walk` views, in turns of six:
//   two from outside that see the whole mesh, one from so close that it leaves the sides,
//   one whose near plane cuts the mesh in the middle of the picture,
//   one from within the bounding box, with parts of the mesh behind the eye,
//   one whose near and far planes both cut the mesh.
// A near or far that is not given is chosen from the bounding box: near is 1/100 of its half
// diagonal, or more for an eye far away, so that far / near stays below 1e5; far lies behind all of
// the box (in the last of the six: halfway through it).
// A frustum or intrinsics say nothing of the place: they need an eye or a pose. A name of a glTF
// camera is not looked at: load_scene puts in its place what it stands for.
// Errors: UsageError naming the option and what it takes, or with what it does not go together.
// Pre-condition: the mesh has a triangle.
std::vector<View> make_views(const Mesh& mesh, const CameraOptions& options);

}  // namespace clipscope::experiments
