// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles that are hard to clip by their shape: needles, near-collinear and near-planar ones.
//
// Everything is random in view space and starts from a point inside the volume; lengths spread over
// the magnitudes 1e-4 to 1e6, so that many reach across planes and behind the eye.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "experiments/scenes/builtin.hpp"

namespace clipscope::experiments {
namespace {

using glm::dvec3;

constexpr double kShortest = 1e-4, kLongest = 1e6;

dvec3 inside_point(const Frustum<float>& f, Random& random) {
  const double depth = random.across_magnitudes(f.near, f.far);
  const double x = random.uniform(f.left, f.right), y = random.uniform(f.bottom, f.top);
  return {x * depth / f.near, y * depth / f.near, -depth};
}

// Uniform in [lo, 1), times a random power of two down to 2^-23.
double small_factor(Random& random, double lo) {
  const double factor = random.uniform(lo, 1);
  return std::ldexp(factor, -static_cast<int>(random.below(24)));
}

// Two corners close together, the third far away.
std::array<dvec3, 3> needle(const dvec3& anchor, Random& random) {
  const double length = random.across_magnitudes(kShortest, kLongest);
  const double width = random.across_magnitudes(kShortest, std::fmax(length / 100, kShortest));
  const dvec3 along = random.direction(), across = random.direction();
  const double share = random.uniform();  // of the length that lies before the anchor
  return {anchor - share * length * along, anchor - share * length * along + width * across,
          anchor + (1 - share) * length * along};
}

// Three corners almost on one line.
std::array<dvec3, 3> near_collinear(const dvec3& anchor, Random& random) {
  const double length = random.across_magnitudes(kShortest, kLongest);
  const dvec3 along = random.direction(), aside = random.direction();
  const double off = length * small_factor(random, 0);
  return {anchor - random.uniform() * length * along, anchor + off * aside,
          anchor + random.uniform() * length * along};
}

// An ordinary triangle almost in a plane of the volume.
std::array<dvec3, 3> near_planar(const Frustum<float>& f, Random& random) {
  const int plane = static_cast<int>(random.below(6));
  const double sign = plane % 2 == 0 ? -1 : 1;
  std::array<dvec3, 3> corners;
  for (dvec3& p : corners) {
    p = inside_point(f, random);
    p *= random.uniform(0.5, 2);
    const double off = small_factor(random, -1);
    if (plane < 2) {
      p.x = sign * double{f.right} / f.near * -p.z * (1 + off);
    } else if (plane < 4) {
      p.y = sign * double{f.top} / f.near * -p.z * (1 + off);
    } else {
      p.z = -(plane == 4 ? f.near : f.far) * (1 + off);
    }
  }
  return corners;
}

std::array<dvec3, 3> sliver(const Frustum<float>& f, Random& random) {
  switch (random.below(3)) {
    case 0: return needle(inside_point(f, random), random);
    case 1: return near_collinear(inside_point(f, random), random);
    default: return near_planar(f, random);
  }
}

}  // namespace

Scene make_slivers_scene(const SceneOptions& options) {
  Scene scene;
  scene.views = {identity_view()};
  Random random(options.seed);
  const int triangles = options.quick ? 4000 : 20000;
  for (int i = 0; i < triangles; ++i) {
    add_random_triangle(scene.mesh, sliver(scene.views.front().frustum, random), random);
  }
  return scene;
}

}  // namespace clipscope::experiments
