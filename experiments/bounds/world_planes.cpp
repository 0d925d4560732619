// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/world_planes.hpp"

#include <cmath>

namespace clipscope::experiments {
namespace {

// From the error bounds of double to 32 u of float; see the header.
constexpr double kFloatWeights = 0x1p30;

// m^T v, with the magnitudes of m if `absolute`.
Vec3<double> turned_back(const glm::dmat4& m, const Vec3<double>& v, bool absolute) {
  Vec3<double> r(0.0);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double entry = m[column][row];
      r[column] += (absolute ? std::abs(entry) : entry) * v[row];
    }
  }
  return r;
}

}  // namespace

CullingPlanes<double> world_planes(const View& view) {
  const glm::dmat4& m = view.view_from_world;
  const Vec3<double> shift(m[3][0], m[3][1], m[3][2]);
  const CullingPlanes<float> in_view = culling_planes(Projection<float>(view.frustum));
  CullingPlanes<double> r;
  for (int i = 0; i < in_view.count; ++i) {
    const CullingPlane<float>& plane = in_view.planes[static_cast<std::size_t>(i)];
    const Vec3<double> normal(plane.normal), weight(plane.weight);
    CullingPlane<double> world;
    world.normal = turned_back(m, normal, false);
    world.offset = bounds::dot(normal, shift) + double{plane.offset};
    world.weight = kFloatWeights * turned_back(m, weight, true);
    world.offset_weight =
        kFloatWeights * (bounds::dot(weight, bounds::absolute(shift)) + plane.offset_weight);
    bounds::push_back(r, world);
  }
  return r;
}

}  // namespace clipscope::experiments
