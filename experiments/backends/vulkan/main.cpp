// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope_draw_vulkan [--device NUMBER]: the process that the program starts to draw by Vulkan.
// Which driver it has is the loader's affair: VK_ICD_FILENAMES.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <string>

#include "experiments/backends/vulkan/vulkan_driver.hpp"
#include "experiments/drawcalls/wire.hpp"

using namespace clipscope::experiments;

namespace {

// Nothing if the command line is not as it has to be.
std::optional<std::size_t> device_number(int count, char** words) {
  if (count == 1) return std::size_t{0};
  if (count != 3 || std::strcmp(words[1], "--device") != 0) return std::nullopt;
  std::size_t number = 0;
  const char* end = words[2] + std::strlen(words[2]);
  const auto parsed = std::from_chars(words[2], end, number);
  return parsed.ec == std::errc{} && parsed.ptr == end ? std::optional(number) : std::nullopt;
}

}  // namespace

int main(int count, char** words) {
  const std::optional<std::size_t> number = device_number(count, words);
  if (!number) {
    std::fputs("Usage: clipscope_draw_vulkan [--device NUMBER]\n", stderr);
    return 2;
  }
  VulkanInstance instance;
  std::unique_ptr<VulkanDriver> driver;
  std::string reason;
  try {
    instance = make_instance();
    driver = std::make_unique<VulkanDriver>(find_physical_device(instance.get(), *number));
  } catch (const std::exception& error) {
    reason = std::string("no Vulkan driver: ") + error.what();
  }
  return serve(driver.get(), reason);
}
