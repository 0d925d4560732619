// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/known_drivers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>

#include "experiments/backends/driver_process.hpp"
#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

constexpr double kSecondsToDraw = 10;

KnownDriver opengl_driver(std::string name, std::vector<std::string> environment) {
  return {.name = name,
          .host = "clipscope_draw_gl",
          .environment = std::move(environment),
          .renderer = name,
          .package = "libgl1-mesa-dri",
          .built_with = "libepoxy-dev and libegl1"};
}

// Mesa's own, in software; drawn by the processor even where there is a graphics card.
KnownDriver mesa_driver(const std::string& name) {
  return opengl_driver(name, {"LIBGL_ALWAYS_SOFTWARE=1", "GALLIUM_DRIVER=" + name});
}

KnownDriver vulkan_driver(std::string name, std::string package) {
  return {.name = std::move(name),
          .host = "clipscope_draw_vulkan",
          .package = std::move(package),
          .built_with = "libvulkan-dev and glslang-tools"};
}

// Loaders before 1.3.207 know the old variable alone, and later ones prefer the new one.
std::vector<std::string> environment_of_icd(const fs::path& manifest) {
  return {"VK_DRIVER_FILES=" + manifest.string(), "VK_ICD_FILENAMES=" + manifest.string()};
}

struct ManifestPlace {
  std::vector<std::string> folders;
  std::string beginning;  // of its name, which ends with .json
  std::string package;    // Debian's that has it
};

// The first by name, so that it is the same one every time; empty if there is none.
fs::path manifest_at(const ManifestPlace& place) {
  std::vector<fs::path> found;
  std::error_code ignored;
  for (const std::string& folder : place.folders) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
      const fs::path& file = entry.path();
      const bool is_named_so = file.filename().string().starts_with(place.beginning);
      if (is_named_so && file.extension() == ".json") found.push_back(file);
    }
  }
  const auto first = std::ranges::min_element(found);
  return first == found.end() ? fs::path() : *first;
}

// Leads the driver to its manifest, or says that there is none.
void use_manifest(KnownDriver& driver, const ManifestPlace& place) {
  const fs::path manifest = manifest_at(place);
  if (manifest.empty()) {
    driver.missing = fmt::format("there is no {}*.json in {} (Debian package: {})", place.beginning,
                                 fmt::join(place.folders, " or "), driver.package);
    return;
  }
  for (std::string& variable : environment_of_icd(manifest)) {
    driver.environment.push_back(std::move(variable));
  }
}

// What is said of the driver, without its name in front.
std::string without_name(const std::string& said, const std::string& name) {
  return said.starts_with(name + ": ") ? said.substr(name.size() + 2) : said;
}

std::vector<KnownDriver> make_known_drivers() {
  const ManifestPlace lavapipe_place = {
      {"/usr/share/vulkan/icd.d", "/etc/vulkan/icd.d"}, "lvp_icd", "mesa-vulkan-drivers"};
  const ManifestPlace swiftshader_place = {
      {"/usr/lib/chromium", "/usr/lib/chromium-browser", "/usr/share/vulkan/icd.d"},
      "vk_swiftshader_icd",
      "chromium"};
  KnownDriver zink = mesa_driver("zink");
  zink.package += " and mesa-vulkan-drivers";
  use_manifest(zink, lavapipe_place);
  KnownDriver lavapipe = vulkan_driver("lavapipe", lavapipe_place.package);
  lavapipe.renderer = "llvmpipe";
  use_manifest(lavapipe, lavapipe_place);
  KnownDriver swiftshader = vulkan_driver("swiftshader", swiftshader_place.package);
  swiftshader.renderer = "SwiftShader";
  use_manifest(swiftshader, swiftshader_place);
  // ANGLE on SwiftShader, the stack in which Chromium draws without a graphics card.
  const KnownDriver webgl = {
      .name = "webgl",
      .host = "clipscope_draw_webgl",
      .arguments = {"--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"},
      .renderer = "SwiftShader",
      .package = "chromium"};
  KnownDriver standard = opengl_driver("default", {});
  standard.renderer.clear();
  return {mesa_driver("llvmpipe"),
          mesa_driver("softpipe"),
          zink,
          lavapipe,
          swiftshader,
          webgl,
          standard};
}

}  // namespace

const std::vector<KnownDriver>& known_drivers() {
  static const std::vector<KnownDriver> drivers = make_known_drivers();
  return drivers;
}

KnownDriver find_driver(std::string_view name) {
  std::vector<std::string> names;
  for (const KnownDriver& driver : known_drivers()) {
    if (driver.name == name) return driver;
    names.push_back(driver.name);
  }
  throw UsageError(
      fmt::format("there is no driver \"{}\"; those known are {}", name, fmt::join(names, ", ")));
}

KnownDriver driver_of_icd(const fs::path& manifest) {
  std::error_code ignored;
  if (!fs::is_regular_file(manifest, ignored)) {
    throw UsageError(fmt::format(
        "{}: there is no such file; expected the manifest of a Vulkan driver, such as /usr/share/vulkan/icd.d/lvp_icd.x86_64.json",
        manifest.string()));
  }
  KnownDriver driver = vulkan_driver(manifest.stem().string(), "");
  driver.environment = environment_of_icd(fs::absolute(manifest));
  return driver;
}

std::vector<DriverHere> drivers_here() {
  std::vector<DriverHere> all;
  for (const KnownDriver& driver : known_drivers()) {
    DriverHere here{driver};
    try {
      here.info = DriverProcess(driver, kSecondsToDraw).info();
    } catch (const GuestError& error) {
      here.reason = without_name(error.what(), driver.name);
    }
    all.push_back(std::move(here));
  }
  return all;
}

}  // namespace clipscope::experiments
