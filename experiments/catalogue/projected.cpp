// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/projected.hpp"

namespace clipscope::experiments {

HardCase projected(HardCase c) {
  if (c.space == Space::clip) return c;
  const reference::Truth truth = truth_of(c);
  for (reference::InputVertex& v : c.vertices) {
    const auto exact = truth.clip_position(v);
    for (std::size_t i = 0; i < 4; ++i) v.position[i] = reference::round_to<float>(exact[i]);
  }
  c.space = Space::clip;
  c.matrix.reset();
  c.frustum = Frustum<double>{.depth = c.volume.depth};
  return c;
}

}  // namespace clipscope::experiments
