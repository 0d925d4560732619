// SPDX-License-Identifier: GPL-3.0-or-later
//
// The driver that a user names, ready to be started as often as there are threads.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "experiments/audit/driver_pool.hpp"
#include "experiments/backends/known_drivers.hpp"

namespace clipscope::experiments {

struct DriverSource {
  std::string name = {};     // "llvmpipe", "own/row_missing"
  std::string options = {};  // of `clipscope audit`, which choose it: "--driver llvmpipe"
  DriverFactory make = {};
};

inline constexpr double kSecondsPerDraw = 10;

// One of known_drivers(), or "own": our rasteriser, "own/FAULT" with that fault (own_driver.hpp).
// seconds: that a draw call may take. Errors: UsageError with the names that there are.
DriverSource driver_source(std::string_view name, double seconds = kSecondsPerDraw);
// A Vulkan driver by its manifest, called by the file's stem. Errors: UsageError.
DriverSource driver_source_of_icd(const std::filesystem::path& manifest,
                                  double seconds = kSecondsPerDraw);
DriverSource driver_source(const KnownDriver& driver, double seconds = kSecondsPerDraw);

}  // namespace clipscope::experiments
