// SPDX-License-Identifier: GPL-3.0-or-later
//
// A draw call with a violation as what the people who can mend it run: a test of piglit (OpenGL), a
// script of Amber (Vulkan), a web page (WebGL 2).
//
// Each draws the very vertices, to the bit, and checks what is wrong at the worst pixel: that a
// value is a number and within a tolerance of the exact one, how many fragments there are, or, of a
// crash or a standstill, that drawing comes to its end. The tolerance lies between what the
// specification allows and what came, so that it fails where the violation is, and passes on a
// driver that is right. Of shader_runner in Debian's package piglit, of the grammar in Amber's
// documentation, and of WebGL 2.
#pragma once

#include <string>
#include <vector>

#include "experiments/pixels/judgement.hpp"

namespace clipscope::experiments {

struct Reproduction {
  std::string file_name;  // "noperspective_not_finite.shader_test"
  std::string text;
};

// Those of the three that can say it. An API without the depth range, the quantity or the state
// that it needs has none: no noperspective in WebGL, no depth range of -1 to 1 in Amber. The one of
// the driver's own API comes first. `info` is of the driver that did it; texts name it.
std::vector<Reproduction> reproductions(const DrawCall& call, const Violation& violation,
                                        const DriverInfo& info);

}  // namespace clipscope::experiments
