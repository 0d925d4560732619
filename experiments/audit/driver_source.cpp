// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/driver_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "experiments/backends/driver_process.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/pixels/own_driver.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kOwn = "own";

// "own" or "own/FAULT".
bool is_own(std::string_view name) {
  return name == kOwn || (name.starts_with(kOwn) && name.substr(kOwn.size()).starts_with('/'));
}

RasterFault fault_of(std::string_view name) {
  if (name == kOwn) return RasterFault::none;
  const std::string_view fault = name.substr(kOwn.size() + 1);
  constexpr auto kNames = names_of(RasterFault{});
  const auto found = std::ranges::find(kNames, fault);
  if (found != kNames.end()) return static_cast<RasterFault>(found - kNames.begin());
  throw UsageError(fmt::format("--driver: '{}' given; the faults of our own rasteriser are {}",
                               name, fmt::join(kNames, ", ")));
}

}  // namespace

DriverSource driver_source(std::string_view name, double seconds) {
  if (!is_own(name)) return driver_source(find_driver(name), seconds);
  const RasterFault fault = fault_of(name);
  return {std::string(name), fmt::format("--driver {}", name),
          [fault] { return std::make_unique<OwnDriver>(fault); }};
}

DriverSource driver_source_of_icd(const std::filesystem::path& manifest, double seconds) {
  DriverSource source = driver_source(driver_of_icd(manifest), seconds);
  source.options = "--icd " + shell_word(manifest.string());
  return source;
}

DriverSource driver_source(const KnownDriver& driver, double seconds) {
  return {driver.name, "--driver " + driver.name,
          [=] { return std::make_unique<DriverProcess>(driver, seconds); }};
}

}  // namespace clipscope::experiments
