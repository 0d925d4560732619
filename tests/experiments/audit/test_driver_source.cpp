// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/driver_source.hpp"
#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/audit/sample_calls.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("driver source: our own rasteriser comes with the fault named", "[audit]") {
  const DriverSource right = driver_source("own"), wrong = driver_source("own/noperspective_nan");
  CHECK(wrong.options == "--driver own/noperspective_nan");
  const DrawCall call = behind_call("");
  CHECK(right.make()->draw(call) == OwnDriver().draw(call));
  CHECK(wrong.make()->draw(call) != right.make()->draw(call));
}

TEST_CASE("driver source: a name that is none is a usage error", "[audit]") {
  CHECK_THROWS_AS(driver_source("own/no_such_fault"), UsageError);
  CHECK_THROWS_AS(driver_source("owner"), UsageError);
  CHECK_THROWS_AS(driver_source_of_icd("/no/such/manifest.json"), UsageError);
}

}  // namespace
}  // namespace clipscope::experiments
