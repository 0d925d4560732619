// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drivers that the audit knows by name, and how each is started.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

// How a driver is started: a host of ours in an environment that leads it there.
struct KnownDriver {
  std::string name = {};                      // "softpipe"
  std::string host = {};                      // "clipscope_draw_gl", see file_beside_program
  std::vector<std::string> arguments = {};    // of the host
  std::vector<std::string> environment = {};  // "NAME=value", in place of the user's of that name
  std::string renderer = {};    // what it calls itself has these words in it; empty: anything
  std::string package = {};     // Debian's, for people who lack it: "libgl1-mesa-dri"
  std::string built_with = {};  // Debian's packages that its host is built with
  std::string missing = {};     // why it can't be started, seen already from here; empty: it may

  friend bool operator==(const KnownDriver&, const KnownDriver&) = default;
};

// llvmpipe, softpipe, zink, lavapipe, swiftshader, webgl and default, which is OpenGL as the user's
// environment has it.
const std::vector<KnownDriver>& known_drivers();

// Errors: UsageError with the names that there are.
KnownDriver find_driver(std::string_view name);

// A Vulkan driver by its manifest (VK_ICD_FILENAMES). Errors: UsageError if there is no such file.
KnownDriver driver_of_icd(const std::filesystem::path& manifest);

struct DriverHere {
  KnownDriver driver;
  std::optional<DriverInfo> info = {};
  std::string reason = {};  // why there is none, for people
};

// Starts each of them once: some seconds.
std::vector<DriverHere> drivers_here();

}  // namespace clipscope::experiments
