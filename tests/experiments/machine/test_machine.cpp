// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/machine.hpp"
#include "experiments/machine/measuring.hpp"
#include "spaces/batch/batch.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("machine: it is described, with the commit that was measured") {
  CHECK(holds(machine_description(), "commit"));
}

TEST_CASE("machine: its name has the instruction set that batch clippers run on, and never moves") {
  CHECK(holds(machine_name(), clipscope::batch::target_name()));
  CHECK(machine_name() == machine_name());
  CHECK(machine_description().starts_with(machine_name() + ";"));
}

TEST_CASE(
    "machine: the description of what is timed says what else ran, how it was scheduled, and at which speed") {
  const std::string state = machine_state();
  CHECK(timing_description().starts_with(machine_name() + "; "));
  CHECK(holds(timing_description(), "commit"));
  CHECK(holds(state, "governor"));
  count_runs({.runs = 1, .seconds = 2, .others_seconds = 1});
  CHECK(holds(machine_state(), "other programs took"));
  CHECK(holds(state, "real-time class"));
}
