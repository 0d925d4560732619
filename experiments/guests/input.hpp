// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a guest is given of a batch: its numbers in the guest's scalar and in the space that it
// starts in.
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/contestants/batch.hpp"

namespace clipscope::experiments {

struct GuestInput {
  Space space = Space::clip;
  ClipVolume volume = {};  // the distances to the batch's planes among the clip distances
  int attributes = 0;      // likewise
  // Vertex after vertex: position, attributes. Every number is one of the guest's scalar.
  std::vector<double> numbers = {};
  std::vector<std::size_t> ends = {};  // primitive i has the vertices [ends[i - 1], ends[i])

  std::size_t stride() const {
    return static_cast<std::size_t>((space == Space::view ? 3 : 4) + attributes);
  }
  std::size_t first_vertex(std::size_t primitive) const {
    return primitive == 0 ? 0 : ends[primitive - 1];
  }
};

// Each number rounded once to the format, float or double. For a guest that starts in clip space
// what is in view space is projected in the format, as our own clippers project.
GuestInput guest_input(const Batch& batch, const Format& format, Space space);

}  // namespace clipscope::experiments
