// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small inputs of the stage.
#pragma once

#include "experiments/contestants/stage_input.hpp"

namespace clipscope::experiments {

inline StageInput small_soup(std::size_t triangles = 600) {
  return random_input("soup", {.inside = 40, .outside = 30, .straddling = 30}, triangles,
                      kSceneAttributes, 1);
}

}  // namespace clipscope::experiments
