// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/circumstances.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/audit/sample_calls.hpp"

namespace clipscope::experiments {
namespace {

Passage passage_of(const DrawCall& call) { return circumstances_of(call, 0).passage; }

TEST_CASE("circumstances: the farthest vertex decides how a primitive gets to the window",
          "[audit]") {
  CHECK(passage_of(inside_call("")) == Passage::inside);
  CHECK(passage_of(behind_call("")) == Passage::behind_the_eye);
  DrawCall call = inside_call("");
  call.vertices[0].position = {-2, 0, 0, 1};
  CHECK(passage_of(call) == Passage::clipped);
  call.vertices[1].position[3] = 0;
  CHECK(passage_of(call) == Passage::behind_the_eye);
}

TEST_CASE("circumstances: planes that do not clip put no vertex outside", "[audit]") {
  DrawCall call = inside_call("");
  call.vertices[0].position[2] = -0.5f;
  CHECK(passage_of(call) == Passage::inside);
  call.volume.depth = DepthRange::zero_to_one;
  CHECK(passage_of(call) == Passage::clipped);
  call.volume.depth_clamp = true;
  CHECK(passage_of(call) == Passage::inside);
  call.volume.clip_distances = 2;
  call.vertices[2].clip_distances = {1, -1};
  CHECK(circumstances_of(call, 0) ==
        Circumstances{Primitive::triangle, Passage::clipped, true, true});
  CHECK(to_string(circumstances_of(call, 0)) == "triangle, clipped, clip distances, depth clamp");
}

TEST_CASE("circumstances: each primitive of a strip has its own", "[audit]") {
  DrawCall call = behind_call("");
  call.topology = Topology::line_strip;
  CHECK(circumstances_of(call, 0) == Circumstances{Primitive::segment, Passage::inside});
  CHECK(circumstances_of(call, 1) == Circumstances{Primitive::segment, Passage::behind_the_eye});
}

}  // namespace
}  // namespace clipscope::experiments
