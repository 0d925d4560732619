// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options of the clip volume: clip distances, user clip planes, depth clamp.
//
// A user clip plane becomes a clip distance, computed at each vertex in the scalar of the clipper and put
// in front of the vertex's attributes. Clip distances of the user's stay where they are, first of the
// attributes, so all distances lead.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/errors.hpp"
#include "spaces/clipper.hpp"
#include "spaces/planes.hpp"

namespace CLI {
class App;
}

namespace clipscope::experiments {

struct VolumeOptions {
  int clip_distances = 0;  // the first of the attributes
  bool depth_clamp = false;
  std::vector<std::array<double, 4>> planes;
};

// --clip-distances, --depth-clamp and --plane.
void add_volume_options(CLI::App& command, VolumeOptions& options);

// The volume for vertices that have the planes' distances in front of their attributes. Errors:
// UsageError if there are more clip distances than attributes, or more of either than fit.
ClipVolume volume_of(const VolumeOptions& options, DepthRange depth, int attributes);

// Errors: UsageError if the clipper does not promise to take the volume's options.
void check_applicable(std::string_view clipper, const Promise& promise, const ClipVolume& volume);

// The planes in the scalar, rounded once. Errors: UsageError if that is not finite.
template <class T>
std::vector<Vec4<T>> planes_in(const VolumeOptions& options) {
  std::vector<Vec4<T>> planes;
  for (const std::array<double, 4>& given : options.planes) {
    Vec4<T>& plane = planes.emplace_back();
    for (int i = 0; i < 4; ++i) {
      const double value = given[static_cast<std::size_t>(i)];
      plane[i] = scalar_from<T>(value);
      if (!is_finite(plane[i])) {
        throw UsageError(fmt::format("--plane: {} is not finite in {}; expected finite numbers",
                                     value, ScalarTraits<T>::name));
      }
    }
  }
  return planes;
}

// Inside is >= 0: a x + b y + c z + d in view space, a x + b y + c z + d w in clip space.
template <class T>
T plane_distance(const Vec4<T>& plane, const Vec3<T>& p) {
  return user_plane_distance(plane, p);
}

template <class T>
T plane_distance(const Vec4<T>& plane, const Vec4<T>& p) {
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3] * p[3];
}

// Puts the distances to the planes in front of the vertex's attributes. Pre-condition: they fit.
template <Space S, class T>
void prepend_distances(const std::vector<Vec4<T>>& planes, Vertex<S, T, kRunTime>& v) {
  const int count = static_cast<int>(planes.size());
  const int attributes = v.attributes.size();
  v.attributes.resize(count + attributes);
  for (int k = attributes; k-- > 0;) v.attributes[count + k] = v.attributes[k];
  for (int i = 0; i < count; ++i) {
    v.attributes[i] = plane_distance(planes[static_cast<std::size_t>(i)], v.position);
  }
}

}  // namespace clipscope::experiments
