// SPDX-License-Identifier: GPL-3.0-or-later
//
// The planes of a clip volume beside its sides.
#pragma once

#include <functional>
#include <vector>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

// What a plane of depth or a clip distance has at a vertex (>= 0 is inside), and that with all
// terms positive.
struct PlaneValue {
  double value = 0, size = 0;
};
using PlaneValues = std::vector<std::function<PlaneValue(const DrawVertex&)>>;

// Near and far unless they are clamped, then the clip distances.
PlaneValues planes_in(const ClipVolume& volume);

}  // namespace clipscope::experiments
