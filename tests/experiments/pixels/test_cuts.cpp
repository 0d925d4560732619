// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>

#include "experiments/pixels/cuts.hpp"
#include "experiments/pixels/region.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/pixels/draw_calls.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<std::uint32_t, 3> kAll = {0, 1, 2};

// Covers the whole viewport, with vertices as far away as `reach`.
DrawCall covering(float reach) {
  return call_of(Topology::triangles, {vertex_at(-reach, -reach, 0, 1),
                                       vertex_at(reach, -reach, 0, 1), vertex_at(0, reach, 0, 1)});
}

Coverage middle_of(const DrawCall& call) {
  return coverage_at(triangle_region(call, kAll, {.subpixel_bits = 8}, 1), 16, 16);
}

// The cut of the edge from (-3, 0) to (1, 0) at x = -1, w = 1, found by hand.
TEST_CASE("cuts: the border is off by a part of the whole edge that is cut", "[pixels]") {
  const DrawCall call = call_of(
      Topology::triangles, {vertex_at(-3, 0, 0, 1), vertex_at(1, 0, 0, 1), vertex_at(0, 1, 0, 1)});
  const Cuts cuts(call, kAll);
  CHECK(cuts.slack({-2, 2, 1}) == Approx(kEpsilon * kClip * 4));
  CHECK(cuts.slack({1, 1, 2}) == 0);
}

TEST_CASE("cuts: the middle is covered for certain until vertices are too far away", "[pixels]") {
  CHECK(middle_of(covering(8)) == Coverage::covered);
  CHECK(middle_of(covering(1024)) == Coverage::covered);
  CHECK(middle_of(covering(1e8f)) == Coverage::nearly_covered);
}

TEST_CASE("cuts: a plane that all of a clipped triangle is in leaves it open", "[pixels]") {
  DrawCall call = covering(8);
  for (DrawVertex& vertex : call.vertices) vertex.position[2] = 1;  // in the far plane
  CHECK(middle_of(call) == Coverage::undecided);
  call.volume.depth_clamp = true;
  CHECK(middle_of(call) == Coverage::covered);
}

}  // namespace
}  // namespace clipscope::experiments
