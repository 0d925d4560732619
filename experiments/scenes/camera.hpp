// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cameras: perspective frusta, look-at views, and an automatic walk around and through a mesh.
//
// Matrix: the gluLookAt manual page (OpenGL Utility Library), in double precision: right-handed,
// looking down -z. Results repeat bit for bit on one machine; tan comes from the C library, so that
// another library could in principle round a frustum number to the neighbouring float.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

struct CameraOptions {
  std::optional<glm::dvec3> eye;     // without one: an automatic walk
  std::optional<glm::dvec3> target;  // default: the centre of the mesh's bounding box
  std::optional<glm::dvec3> up;      // default: +y, or +z where the view is along y
  double fovy_degrees = 60;          // the whole vertical angle, in (0, 180)
  double aspect = 16.0 / 9.0;        // width / height
  std::optional<double> near, far;   // default: from the mesh's bounding box
  int walk = 6;                      // number of views of an automatic walk, at least 1
  DepthRange depth = DepthRange::minus_one_to_one;

  friend bool operator==(const CameraOptions&, const CameraOptions&) = default;
};

// The symmetric perspective frustum: top = near tan(fovy / 2), right = aspect top, each computed in
// double and rounded to float once. These floats *are* the frustum.
// Errors: UsageError naming the option unless 0 < fovy < 180, 0 < aspect and 0 < near < far hold,
// also after rounding.
Frustum<float> perspective_frustum(double fovy_degrees, double aspect, double near, double far);

// World to view: the eye goes to the origin, the target onto the negative z axis, up into the half
// plane x = 0, y > 0. Errors: UsageError if eye = target or up is parallel to the view direction.
glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

// With an eye: that one view. Else a walk of `walk` views, in turns of six:
//   two from outside that see the whole mesh, one from so close that it leaves the sides,
//   one whose near plane cuts the mesh in the middle of the picture,
//   one from within the bounding box, with parts of the mesh behind the eye,
//   one whose near and far planes both cut the mesh.
// A near or far that is not given is chosen from the bounding box: near is 1/100 of its half
// diagonal, or more for an eye far away, so that far / near stays below 1e5; far lies behind all of
// the box (in the last of the six: halfway through it).
// Errors: UsageError naming the option and what it takes.
// Pre-condition: the mesh has a triangle.
std::vector<View> make_views(const Mesh& mesh, const CameraOptions& options);

}  // namespace clipscope::experiments
