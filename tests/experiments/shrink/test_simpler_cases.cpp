// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shrink/simpler_cases.hpp"

#include <algorithm>

#include "experiments/catalogue/catalogue.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

TEST_CASE("simpler cases: significant bits are counted from the first to the last") {
  CHECK(significant_bits(0) == 0);
  CHECK(significant_bits(0x1p-100) == 1);
  CHECK(significant_bits(-3) == 2);
  CHECK(significant_bits(0x1.000002p+0) == 24);
  CHECK(significant_bits(0x1p-149) == 1);
}

TEST_CASE("simpler cases: a bit costs more than any exponent, an option more than a number") {
  HardCase c;
  c.vertices.resize(3);
  c.vertices[0].position[0] = 0x1p+100;
  HardCase bits = c;
  bits.vertices[0].position[0] = 3;
  CHECK(cost_of(c) < cost_of(bits));
  HardCase option = c;
  option.volume.depth_clamp.near = true;
  CHECK(cost_of(bits) < cost_of(option));
}

TEST_CASE("simpler cases: all are cheaper, finite, and no frustum is empty") {
  for (const HardCase& c : builtin_catalogue()) {
    if (c.primitive == Primitive::polygon || c.file.find("scale") == std::string::npos) continue;
    const double cost = cost_of(c);
    for (const HardCase& simpler : simpler_wholes(c)) {
      REQUIRE(cost_of(simpler) < cost);
      REQUIRE(is_finite(simpler));
      REQUIRE((simpler.space == Space::clip || is_valid(simpler.frustum)));
      REQUIRE(simpler.attribute_count >= simpler.volume.clip_distances);
    }
    for (const CoordinateChange& change : simpler_coordinates(c)) {
      REQUIRE(cost_of(change.of(c)) < cost);
    }
  }
}
