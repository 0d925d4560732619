// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "experiments/backends/driver_process.hpp"
#include "experiments/guests/process.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "tests/experiments/reproductions/cases.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

bool has_piglit() {
  return is_there_or_not_required(CLIPSCOPE_SHADER_RUNNER, "CLIPSCOPE_REQUIRE_PIGLIT");
}

// "pass", "fail" or "skip".
std::string result_of(const std::string& test, const std::string& driver) {
  const fs::path file =
      fs::temp_directory_path() /
      ("clipscope-" + std::to_string(std::hash<std::string>{}(test + driver)) + ".shader_test");
  write_file(file, test);
  const std::vector<std::string> environment = {
      "LIBGL_ALWAYS_SOFTWARE=1", "GALLIUM_DRIVER=" + driver, "PIGLIT_PLATFORM=surfaceless_egl"};
  const ProcessResult run =
      run_process(std::string(CLIPSCOPE_SHADER_RUNNER) + " " + file.string() + " -auto -fbo", "",
                  environment, "PIGLIT", {.seconds = 60});
  fs::remove(file);
  const std::string mark = "{\"result\": \"";
  const std::size_t at = run.output.find(mark);
  if (at == std::string::npos) return run.output + run.errors;
  return run.output.substr(at + mark.size(), 4);
}

TEST_CASE("piglit: a right driver passes each test, and none whose claim is turned round") {
  if (!has_piglit()) return;
  for (const Claim& claim : right_claims()) {
    CAPTURE(claim.name);
    const std::string right = text_of(claim, ".shader_test");
    const std::string wrong = text_of(turned(claim), ".shader_test");
    CAPTURE(right, wrong);
    CHECK(result_of(right, "llvmpipe") == "pass");
    CHECK(result_of(wrong, "llvmpipe") == "fail");
  }
}

TEST_CASE("piglit: a test fails on the drivers that draw what it says is wrong, and on no others") {
  if (!has_piglit()) return;
  DrawCall call = corner_triangle();
  call.quantities.set(bit(Quantity::noperspective));
  const Claim claim = {"noperspective",
                       call,
                       {.quantity = Quantity::noperspective,
                        .kind = ViolationKind::not_finite,
                        .worst = {20, 24, 0, 0.75, std::numeric_limits<float>::quiet_NaN()},
                        .size = std::numeric_limits<double>::infinity()}};
  for (const std::string driver : {"llvmpipe", "softpipe"}) {
    CAPTURE(driver);
    const Drawn drawn = DriverProcess(find_driver(driver), 20).draw(call);
    REQUIRE(std::holds_alternative<Pixels>(drawn));
    const float value = std::get<Pixels>(drawn).at(Quantity::noperspective, 20, 24);
    CHECK(result_of(text_of(claim, ".shader_test"), driver) ==
          (std::isfinite(value) ? "pass" : "fail"));
  }
}

}  // namespace
}  // namespace clipscope::experiments
