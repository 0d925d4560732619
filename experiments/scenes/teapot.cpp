// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Utah teapot, tessellated from its 32 bicubic Bezier patches.
//
// Source: Newell, "The Utilization of Procedure Models in Digital Image Synthesis", PhD thesis,
// University of Utah, 1975; control points as published by Crow, "The Origins of the Teapot", IEEE
// CG&A 7(1), 1987, which added the bottom. Stored by its symmetries: rim, body, lid and bottom are
// profiles turned in four quarters, handle and spout are half tubes and their mirror images.
// Not guaranteed: a closed surface. The lid does not touch the rim, and handle and spout end inside
// the body; such is the teapot.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "experiments/scenes/builtin.hpp"

namespace clipscope::experiments {
namespace {

using glm::dvec3;

// Control points, row by row: u runs within a row, v from row to row. In Newell's frame, z up.
using Patch = std::array<dvec3, 16>;

// A control point of a profile that is turned about the z axis. `arm` is the length of its quarter
// circle's control polygon arms as a share of the radius: the published points have 0.56, but for
// one.
struct ProfilePoint {
  double radius, height;
  double arm = 0.56;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr std::array<Profile, 6> kProfiles = {{
    {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}},  // rim
    {{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}},                // body, upper half
    {{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}},                // body, lower half
    {{{0, 3.15}, {0.8, 3.15, 0.5625}, {0, 2.85}, {0.2, 2.7}}},         // lid, knob
    {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}},              // lid
    {{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0}, {0, 0}}},                 // bottom
}};

// One row of control points of a half tube: from (x0, 0, z0) over y = -width to (x1, 0, z1).
struct TubeRow {
  double x0, z0, x1, z1, width;
};
using HalfTube = std::array<TubeRow, 4>;

constexpr std::array<HalfTube, 4> kHalfTubes = {{
    {{{-1.6, 2.025, -1.5, 2.25, 0.3},  // handle, upper half
      {-2.3, 2.025, -2.5, 2.25, 0.3},
      {-2.7, 2.025, -3, 2.25, 0.3},
      {-2.7, 1.8, -3, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3, 1.8, 0.3},  // handle, lower half
      {-2.7, 1.575, -3, 1.35, 0.3},
      {-2.5, 1.125, -2.65, 0.9375, 0.3},
      {-2, 0.9, -1.9, 0.6, 0.3}}},
    {{{1.7, 1.425, 1.7, 0.6, 0.66},  // spout, lower half
      {2.6, 1.425, 3.1, 0.825, 0.66},
      {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25},  // spout, upper half
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
}};

// The quarter from +x to -y, turned on by 90 degrees `quarter` times, exactly.
Patch turn(const Profile& profile, int quarter) {
  Patch patch;
  for (int row = 0; row < 4; ++row) {
    const double r = profile[row].radius, a = r * profile[row].arm, h = profile[row].height;
    patch[row * 4 + 0] = {r, 0, h};
    patch[row * 4 + 1] = {r, -a, h};
    patch[row * 4 + 2] = {a, -r, h};
    patch[row * 4 + 3] = {0, -r, h};
  }
  for (int i = 0; i < quarter; ++i) {
    for (dvec3& p : patch) p = {p.y, -p.x, p.z};
  }
  return patch;
}

Patch half_tube(const HalfTube& tube, double side) {
  Patch patch;
  for (int row = 0; row < 4; ++row) {
    const TubeRow& r = tube[row];
    patch[row * 4 + 0] = {r.x0, 0, r.z0};
    patch[row * 4 + 1] = {r.x0, -side * r.width, r.z0};
    patch[row * 4 + 2] = {r.x1, -side * r.width, r.z1};
    patch[row * 4 + 3] = {r.x1, 0, r.z1};
  }
  return patch;
}

// The cubic Bernstein polynomials and their derivatives at t.
struct Bernstein {
  std::array<double, 4> value, slope;

  explicit Bernstein(double t) {
    const double s = 1 - t;
    value = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    slope = {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
  }
};

dvec3 combine_points(const Patch& patch, const std::array<double, 4>& u,
                     const std::array<double, 4>& v) {
  dvec3 sum(0);
  for (int row = 0; row < 4; ++row) {
    const dvec3* p = &patch[row * 4];
    sum += v[row] * (u[0] * p[0] + u[1] * p[1] + u[2] * p[2] + u[3] * p[3]);
  }
  return sum;
}

dvec3 normal_at(const Patch& patch, double u, double v) {
  // At the poles every u is the same point and the tangent along it vanishes: step off them.
  const double inside_v = std::fmin(std::fmax(v, 1e-3), 1 - 1e-3);
  const Bernstein bu(u), bv(inside_v);
  return glm::normalize(glm::cross(combine_points(patch, bu.slope, bv.value),
                                   combine_points(patch, bu.value, bv.slope)));
}

// From Newell's frame to y up, a rotation.
dvec3 y_up(const dvec3& p) { return {p.x, p.z, -p.y}; }

// `mirrored` patches have their winding and normals turned, so that the outside stays in front.
void add_patch(Mesh& mesh, const Patch& patch, int segments, bool mirrored) {
  const std::size_t first = mesh.positions.size();
  for (int j = 0; j <= segments; ++j) {
    for (int i = 0; i <= segments; ++i) {
      const double u = double(i) / segments, v = double(j) / segments;
      const dvec3 p = y_up(combine_points(patch, Bernstein(u).value, Bernstein(v).value));
      const dvec3 n = y_up(normal_at(patch, u, v)) * (mirrored ? -1.0 : 1.0);
      add_vertex(mesh, p, {u, v, n.x, n.y});
    }
  }
  add_grid(mesh, first, segments, segments, mirrored);
}

}  // namespace

Mesh teapot_mesh(int segments) {
  Mesh mesh;
  for (const Profile& profile : kProfiles) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      add_patch(mesh, turn(profile, quarter), segments, false);
    }
  }
  for (const HalfTube& tube : kHalfTubes) {
    add_patch(mesh, half_tube(tube, 1), segments, false);
    add_patch(mesh, half_tube(tube, -1), segments, true);
  }
  return mesh;
}

}  // namespace clipscope::experiments
