// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/selection/replay_text.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("replay: a frustum is told whole, the shear of an oblique one too") {
  CHECK(frustum_options(Frustum<float>{}) ==
        "--frustum -0x1p+0,0x1p+0,-0x1p+0,0x1p+0,0x1p+0,0x1.4p+3");
  Frustum<float> oblique{ProjectionKind::parallel};
  oblique.shear_y = 0.25f;
  CHECK(frustum_options(oblique) ==
        "--ortho -0x1p+0,0x1p+0,-0x1p+0,0x1p+0,0x1p+0,0x1.4p+3 --shear 0x0p+0,0x1p-2");
}

}  // namespace
}  // namespace clipscope::experiments
