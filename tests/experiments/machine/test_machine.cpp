// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/machine.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("machine: it is described, with the commit that was measured") {
  CHECK(machine_description().find("commit") != std::string::npos);
}
