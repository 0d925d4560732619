// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "experiments/machine/progress.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

const std::array kSteps = {RunStep{"long", 60}, RunStep{"short", 10}, RunStep{"last", 30}};

}  // namespace

TEST_CASE("progress: before the first step a run takes what is expected of its steps") {
  CHECK(seconds_left(kSteps, 0, 0) == Approx(100));
}

TEST_CASE("progress: steps that took as long as expected leave what is expected of the others") {
  CHECK(seconds_left(kSteps, 1, 60) == Approx(40));
  CHECK(seconds_left(kSteps, 2, 70) == Approx(30));
}

TEST_CASE("progress: a step that took twice as long makes the rest longer, less than twice") {
  CHECK(seconds_left(kSteps, 1, 120) == Approx(40 * 130.0 / 70.0));
  CHECK(seconds_left(kSteps, 1, 30) < 40);
}

TEST_CASE("progress: nothing is left of a run that is done, or has no steps") {
  CHECK(seconds_left(kSteps, 3, 100) == 0);
  CHECK(seconds_left({}, 0, 0) == 0);
}
