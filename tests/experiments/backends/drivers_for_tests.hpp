// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drivers for tests, which may not be there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <variant>

#include "experiments/backends/driver_process.hpp"
#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {

// Null, with a warning, where there is no such driver; a failure of the test if
// CLIPSCOPE_REQUIRE_DRIVERS, a list of names, has it.
inline std::unique_ptr<DriverProcess> driver_for_test(const std::string& name) {
  try {
    return std::make_unique<DriverProcess>(find_driver(name), 20);
  } catch (const GuestError& error) {
    const char* required = std::getenv("CLIPSCOPE_REQUIRE_DRIVERS");
    const std::string list = std::string(" ") + (required == nullptr ? "" : required) + " ";
    if (list.find(" " + name + " ") != std::string::npos) FAIL(error.what());
    WARN("not tested: " << error.what());
    return nullptr;
  }
}

// All of the lower left half of a square target: (x, y) in [-1, 1] with x + y <= 0, at the depth
// of the middle. Its varying is (x_px, y_px, 0, 1) / size, of the corners, so that all is exact.
inline DrawCall half_square(int size) {
  DrawCall call;
  call.vertices = {
      {{-1, -1, 0, 1}, {0, 0, 0, 1}}, {{1, -1, 0, 1}, {1, 0, 0, 1}}, {{-1, 1, 0, 1}, {0, 1, 0, 1}}};
  call.width = call.height = size;
  call.viewport = {0, 0, size, size};
  return call;
}

// A failure of the test if the driver draws nothing.
inline Pixels pixels_of(DriverProcess& driver, const DrawCall& call) {
  const Drawn drawn = driver.draw(call);
  const auto* failure = std::get_if<DrawFailure>(&drawn);
  if (failure) FAIL(failure->reason);
  return std::get<Pixels>(drawn);
}

template <std::size_t n>
std::array<float, n> values_at(const Pixels& pixels, Quantity quantity, int x, int y) {
  std::array<float, n> values{};
  for (std::size_t c = 0; c < n; ++c) values[c] = pixels.at(quantity, x, y, c);
  return values;
}

}  // namespace clipscope::experiments
