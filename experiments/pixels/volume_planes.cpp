// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/volume_planes.hpp"

#include <cmath>

namespace clipscope::experiments {

PlaneValues planes_in(const ClipVolume& volume) {
  PlaneValues r;
  const bool is_symmetric = volume.depth == DepthRange::minus_one_to_one;
  if (!volume.depth_clamp.near) {
    r.emplace_back([is_symmetric](const DrawVertex& v) {
      const double z = v.position[2], w = is_symmetric ? v.position[3] : 0;
      return PlaneValue{z + w, std::abs(z) + std::abs(w)};
    });
  }
  if (!volume.depth_clamp.far) {
    r.emplace_back([](const DrawVertex& v) {
      const double z = v.position[2], w = v.position[3];
      return PlaneValue{w - z, std::abs(z) + std::abs(w)};
    });
  }
  for (int c = 0; c < volume.clip_distances; ++c) {
    r.emplace_back([c](const DrawVertex& v) {
      const double d = v.clip_distances[static_cast<std::size_t>(c)];
      return PlaneValue{d, std::abs(d)};
    });
  }
  return r;
}

}  // namespace clipscope::experiments
