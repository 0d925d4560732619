// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/known_drivers.hpp"

#include <cstdlib>
#include <string>
#include <vector>

#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/backends/drivers_for_tests.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("known drivers: a name that nobody has is refused with those that there are") {
  CHECK_THROWS_WITH(
      find_driver("llvmpype"),
      "there is no driver \"llvmpype\"; those known are llvmpipe, softpipe, zink, lavapipe, swiftshader, webgl, default");
  CHECK_THROWS_AS(find_driver("llvmpype"), UsageError);
  CHECK(find_driver("softpipe").name == "softpipe");
}

TEST_CASE("known drivers: a manifest that does not exist is refused, and one that does is used") {
  CHECK_THROWS_AS(driver_of_icd("/nowhere/icd.json"), UsageError);
  CHECK_THROWS_WITH(driver_of_icd("/nowhere/icd.json"), Catch::StartsWith("/nowhere/icd.json: "));
  const KnownDriver driver = driver_of_icd("/proc/self/exe");
  CHECK(driver.host == "clipscope_draw_vulkan");
  CHECK(driver.environment == std::vector<std::string>{"VK_DRIVER_FILES=/proc/self/exe",
                                                       "VK_ICD_FILENAMES=/proc/self/exe"});
}

TEST_CASE("known drivers: one without a manifest names the package that has it") {
  for (const KnownDriver& driver : known_drivers()) {
    CAPTURE(driver.name);
    if (driver.missing.empty()) continue;
    CHECK_THAT(driver.missing, Catch::Contains("(Debian package: "));
  }
}

TEST_CASE("known drivers: each is here, or says why it is not") {
  const std::vector<DriverHere> all = drivers_here();
  REQUIRE(all.size() == known_drivers().size());
  for (const DriverHere& here : all) {
    CAPTURE(here.driver.name, here.reason);
    CHECK(here.info.has_value() == here.reason.empty());
    CHECK_THAT(here.reason, !Catch::StartsWith(here.driver.name));
    if (here.info) CHECK_THAT(here.info->renderer, Catch::Contains(here.driver.renderer));
  }
}

TEST_CASE("known drivers: a driver is itself whatever the user's environment asks for") {
  setenv("GALLIUM_DRIVER", "softpipe", 1);
  const auto driver = driver_for_test("llvmpipe");
  unsetenv("GALLIUM_DRIVER");
  if (driver) CHECK(driver->info().renderer.starts_with("llvmpipe"));
}

}  // namespace
}  // namespace clipscope::experiments
