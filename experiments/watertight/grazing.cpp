// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/grazing.hpp"

#include <cmath>

#include "experiments/scenes/families.hpp"
#include "experiments/scenes/random.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

// A point whose ratio to the plane is `reach`: 1 on it, more outside, less inside. Of the other planes it
// is inside or outside.
glm::dvec3 point_by(Plane plane, double reach, const Frustum<float>& f, Random& random) {
  double depth = random.across_magnitudes(f.near / 4, 4 * f.far);
  if (plane == Plane::near) depth = f.near / reach;
  if (plane == Plane::far) depth = f.far * reach;
  double x = random.uniform(-1.5, 1.5), y = random.uniform(-1.5, 1.5);
  if (plane == Plane::left || plane == Plane::right) x = plane == Plane::left ? -reach : reach;
  if (plane == Plane::bottom || plane == Plane::top) y = plane == Plane::bottom ? -reach : reach;
  return {x * depth * f.right / f.near, y * depth * f.top / f.near, -depth};
}

// 1 plus or minus 2^-12 to 2^-27.
double nearly_one(Random& random) {
  const int exponent = -12 - static_cast<int>(random.below(16));
  const double sign = random.sign();
  return 1 + sign * std::ldexp(random.uniform(0.5, 1), exponent);
}

}  // namespace

Scene make_grazing_scene(std::size_t pairs, std::uint64_t seed) {
  Scene scene{
      std::string(kGrazing), "pairs of triangles that share an edge close to a plane", {}, {}};
  scene.views = {identity_view()};
  const Frustum<float>& f = scene.views.front().frustum;
  Random random(seed);
  for (std::size_t i = 0; i < pairs; ++i) {
    const Plane plane = kAllPlanes[random.below(kPlanes)];
    const double first_reach = nearly_one(random), second_reach = nearly_one(random);
    const std::array<double, 4> reaches = {first_reach, second_reach, 2, 0.5};
    std::array<std::uint32_t, 4> corner{};
    for (std::size_t c = 0; c < corner.size(); ++c) {
      corner[c] = add_vertex(scene.mesh, point_by(plane, reaches[c], f, random), {});
    }
    scene.mesh.triangles.push_back({corner[0], corner[1], corner[2]});
    scene.mesh.triangles.push_back({corner[1], corner[0], corner[3]});
  }
  return scene;
}

}  // namespace clipscope::experiments
