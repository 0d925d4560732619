// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/rows.hpp"

#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::claims {
namespace {

TEST_CASE("claims: a floor past the eye is drawn the same with and without cutting, and timed") {
  const Scene scene = make_builtin_scene("floor", {});
  const PictureRow row = time_clipless(scene, scene.views.front(), {96, 54}, 1);
  CHECK(row.scene == "floor");
  CHECK(row.clipped_wrong_px <= 5);
  CHECK(row.clipless_wrong_px <= 5);
  REQUIRE(row.speedup);
  CHECK(row.speedup->median == Approx(*row.clipped_ns / *row.clipless_ns));
}

}  // namespace
}  // namespace clipscope::experiments::claims
