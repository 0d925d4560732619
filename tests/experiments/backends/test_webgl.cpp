// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "experiments/machine/temporary_folder.hpp"
#include "tests/experiments/backends/drivers_for_tests.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

Pixels drawn_by(DriverProcess& driver, const DrawCall& call) {
  const Drawn drawn = driver.draw(call);
  const auto* failure = std::get_if<DrawFailure>(&drawn);
  if (failure) FAIL(failure->reason);
  return std::get<Pixels>(drawn);
}

// A folder of this test's own, where its browsers have theirs.
struct BrowserFolder : TemporaryFolder {
  std::size_t count() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(path()), fs::directory_iterator()));
  }
  fs::path browser() const { return fs::directory_iterator(path())->path(); }
  bool is_empty_soon() const {
    for (int i = 0; i < 500 && count() > 0; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return count() == 0;
  }
  KnownDriver webgl() const {
    KnownDriver driver = find_driver("webgl");
    driver.environment.push_back("TMPDIR=" + path().string());
    return driver;
  }
};

// The command line of a process; empty where it has none.
std::string command_line(const fs::path& process) {
  std::ifstream file(process / "cmdline");
  return {std::istreambuf_iterator<char>(file), {}};
}

// Kills the browser whose folder it is.
void kill_browser(const fs::path& folder) {
  for (const fs::directory_entry& process : fs::directory_iterator("/proc")) {
    const std::string line = command_line(process.path());
    const bool is_browser = line.find("--user-data-dir=" + folder.string()) != std::string::npos &&
                            line.find("--type=") == std::string::npos && !line.starts_with("sh");
    if (is_browser) kill(std::stoi(process.path().filename().string()), SIGKILL);
  }
}

TEST_CASE("webgl: each quantity of a triangle whose values are all exact is what it should be") {
  const auto driver = driver_for_test("webgl");
  if (!driver) return;
  CHECK(driver->info().api == GraphicsApi::webgl);
  CHECK(driver->info().renderer.find("SwiftShader") != std::string::npos);
  DrawCall call = half_square(8);
  call.quantities = driver->info().quantities;
  const Pixels pixels = drawn_by(*driver, call);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      if (x + y == 7) continue;  // on the edge
      CAPTURE(x, y);
      const bool is_in = x + y < 7;
      CHECK(pixels.at(Quantity::covered, x, y) == (is_in ? 1 : 0));
      CHECK(pixels.at(Quantity::hits, x, y, 1) == (is_in ? 1 : 0));
      CHECK(pixels.at(Quantity::depth, x, y) == 0.5f);
      if (!is_in) continue;
      const float x_px = static_cast<float>(x) + 0.5f, y_px = static_cast<float>(y) + 0.5f;
      CHECK(pixels.at(Quantity::smooth, x, y, 0) == x_px / 8);
      CHECK(pixels.at(Quantity::smooth, x, y, 1) == y_px / 8);
      CHECK(pixels.at(Quantity::flat, x, y, 1) == 1);  // of the last vertex
      CHECK(pixels.at(Quantity::frag_coord, x, y, 0) == x_px);
      CHECK(pixels.at(Quantity::frag_coord, x, y, 3) == 1);
      CHECK(pixels.at(Quantity::facing, x, y) == 1);
    }
  }
}

TEST_CASE("webgl: what extensions bring is drawn as they say") {
  const auto driver = driver_for_test("webgl");
  if (!driver) return;
  const DriverInfo& info = driver->info();
  DrawCall call = half_square(8);
  SECTION("clip distances, read in the fragment shader, too") {
    if (info.max_clip_distances < 6) {
      WARN("not tested: clip distances");
      return;
    }
    call.volume.clip_distances = 6;
    call.quantities.set(bit(Quantity::clip_distances));
    for (DrawVertex& vertex : call.vertices) vertex.clip_distances[5] = vertex.position[0] + 0.5f;
    const Pixels pixels = drawn_by(*driver, call);
    CHECK(pixels.at(Quantity::covered, 1, 0) == 0);
    CHECK(pixels.at(Quantity::covered, 2, 0) == 1);
    CHECK(pixels.at(Quantity::clip_distances, 2, 0, 5) == 0.125f);
  }
  SECTION("depth clamp") {
    if (!info.depth_clamp) {
      WARN("not tested: depth clamp");
      return;
    }
    for (DrawVertex& vertex : call.vertices) vertex.position[2] = 3;
    call.quantities.set(bit(Quantity::depth));
    CHECK(drawn_by(*driver, call).at(Quantity::hits, 1, 1) == 0);
    call.volume.depth_clamp = true;
    CHECK(drawn_by(*driver, call).at(Quantity::hits, 1, 1) == 1);
    CHECK(drawn_by(*driver, call).at(Quantity::depth, 1, 1) == 1);
  }
  SECTION("depths of 0 to 1") {
    if (!info.zero_to_one) {
      WARN("not tested: depths of 0 to 1");
      return;
    }
    for (DrawVertex& vertex : call.vertices) vertex.position[2] = 0.25f;
    call.quantities.set(bit(Quantity::depth));
    CHECK(drawn_by(*driver, call).at(Quantity::depth, 1, 1) == 0.625f);
    call.volume.depth = DepthRange::zero_to_one;
    CHECK(drawn_by(*driver, call).at(Quantity::depth, 1, 1) == 0.25f);
    for (DrawVertex& vertex : call.vertices) vertex.position[2] = -0.25f;
    CHECK(drawn_by(*driver, call).at(Quantity::hits, 1, 1) == 0);
  }
}

TEST_CASE("webgl: fragments of several primitives are counted, indexed or not") {
  const auto driver = driver_for_test("webgl");
  if (!driver) return;
  DrawCall call = half_square(16);
  call.topology = Topology::triangle_strip;
  call.indices = {0, 1, 2, 0};
  const Pixels pixels = drawn_by(*driver, call);
  CHECK(pixels.at(Quantity::hits, 2, 3, 0) == 2);
  CHECK(pixels.at(Quantity::covered, 2, 3) == 1);
  CHECK(pixels.at(Quantity::hits, 13, 13, 0) == 0);
}

TEST_CASE("webgl: a point has its size, in a viewport that reaches beyond the target") {
  const auto driver = driver_for_test("webgl");
  if (!driver) return;
  DrawCall call;
  call.topology = Topology::points;
  call.vertices = {{.position = {0, 0, 0, 1}}};
  call.point_size = 4;
  call.viewport = {-8, -16, 64, 64};  // its middle is (24, 16)
  const Pixels pixels = drawn_by(*driver, call);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      CAPTURE(x, y);
      const bool is_in = x >= 22 && x < 26 && y >= 14 && y < 18;
      CHECK(pixels.at(Quantity::covered, x, y) == (is_in ? 1 : 0));
    }
  }
}

TEST_CASE("webgl: a browser that dies is an outcome, and the next call finds another one") {
  if (!driver_for_test("webgl")) return;
  const BrowserFolder folder;
  DriverProcess driver(folder.webgl(), 20);
  REQUIRE(folder.count() == 1);
  const fs::path first = folder.browser();
  kill_browser(first);
  const Drawn drawn = driver.draw(half_square(8));
  const auto* failure = std::get_if<DrawFailure>(&drawn);
  REQUIRE(failure);
  CHECK(failure->kind == DrawFailure::Kind::crashed);
  CHECK(failure->reason == "the browser has ended");
  CHECK(drawn_by(driver, half_square(8)).at(Quantity::covered, 1, 1) == 1);
  CHECK(!fs::exists(first));
}

TEST_CASE("webgl: a browser ends with its host, and leaves nothing behind") {
  if (!driver_for_test("webgl")) return;
  const BrowserFolder folder;
  auto driver = std::make_unique<DriverProcess>(folder.webgl(), 20);
  REQUIRE(folder.count() == 1);
  driver.reset();
  CHECK(folder.is_empty_soon());
}

TEST_CASE("webgl: where the browser is no program the message says so") {
  KnownDriver driver = find_driver("webgl");
  driver.environment.emplace_back("CLIPSCOPE_CHROMIUM=/nowhere/chromium");
  try {
    DriverProcess(driver, 20);
    FAIL("it has drawn");
  } catch (const GuestError& error) {
    CHECK(std::string(error.what())
              .find("$CLIPSCOPE_CHROMIUM is /nowhere/chromium, which is no program") !=
          std::string::npos);
  }
}

}  // namespace
}  // namespace clipscope::experiments
