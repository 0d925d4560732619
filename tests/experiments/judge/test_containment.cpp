// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/containment.hpp"

#include <cmath>
#include <limits>

#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

template <class T>
double overshoot_of(const std::array<T, 3>& ndc, const ClipVolume& volume = {}) {
  Answers answers(kFormat<T>, 4);
  for (const T& x : ndc) answers.add(x);
  answers.add(T(1));
  answers.end_polygon();
  return overshoot(volume, answers[0]);
}

}  // namespace

TEST_CASE("containment: the volume is closed, and one ulp beyond it counts") {
  CHECK(overshoot_of<float>({1, -1, 1}) == 0);
  CHECK(overshoot_of<float>({std::nextafter(1.0f, 2.0f), 0, 0}) == 0x1p-23);
  CHECK(overshoot_of<double>({0, -std::nextafter(1.0, 2.0), 0}) == 0x1p-52);
  CHECK(overshoot_of<float>({0, 0, -2}) == 1);
  CHECK(overshoot_of<float>({0, 0, std::numeric_limits<float>::quiet_NaN()}) ==
        std::numeric_limits<double>::infinity());
}

TEST_CASE("containment: what is nearer to the bound than any double is beyond it") {
  CHECK(overshoot_of<dd_real>({dd_real(1.0, 0x1p-100), dd_real(0.0), dd_real(0.0)}) == 0x1p-100);
  CHECK(overshoot_of<dd_real>({dd_real(1.0, -0x1p-100), dd_real(0.0), dd_real(0.0)}) == 0);
  const Exact little = Exact(0x1p-300);
  CHECK(overshoot_of<Exact>({Exact(1 + little), Exact(0), Exact(0)}) == 0x1p-300);
  CHECK(overshoot_of<Exact>({Exact(1 - little), Exact(0), Exact(0)}) == 0);
}

TEST_CASE("containment: depth has the range of the volume, and no bound where it is clamped") {
  const DepthRange zero = DepthRange::zero_to_one, reversed = DepthRange::reversed;
  CHECK(overshoot_of<float>({0, 0, -0.5}, {.depth = zero}) == 0.5);
  CHECK(overshoot_of<float>({0, 0, -0.5}) == 0);
  CHECK(overshoot_of<float>({0, 0, -0.5}, {.depth = zero, .depth_clamp = kClampNear}) == 0);
  CHECK(overshoot_of<float>({0, 0, -0.5}, {.depth = zero, .depth_clamp = kClampFar}) == 0.5);
  CHECK(overshoot_of<float>({0, 0, 1.5}, {.depth = reversed, .depth_clamp = kClampNear}) == 0);
  CHECK(overshoot_of<float>({0, 0, -0.5}, {.depth = reversed, .depth_clamp = kClampNear}) == 0.5);
  CHECK(overshoot_of<float>({0, 0, 9}, {.depth_clamp = true}) == 0);
}
