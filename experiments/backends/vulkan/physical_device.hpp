// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Vulkan driver, found and asked what it is and what it can.
//
// Nothing but Vulkan 1.0 is required. Of what the driver has besides, these are used: the features
// depthClamp, shaderClipDistance, largePoints and geometryShader (without which no fragment shader
// may read gl_PrimitiveID), and, from Vulkan 1.1 on, VK_EXT_depth_clip_control,
// VK_EXT_provoking_vertex and VK_EXT_line_rasterization.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

struct DestroyInstance {
  void operator()(VkInstance instance) const { vkDestroyInstance(instance, nullptr); }
};
using VulkanInstance = std::unique_ptr<VkInstance_T, DestroyInstance>;

// Errors: VulkanError if there is no driver that the loader can load.
VulkanInstance make_instance();

struct PhysicalDevice {
  VkPhysicalDevice handle = {};
  std::uint32_t queue_family = 0;  // one that draws
  VkPhysicalDeviceLimits limits = {};
  VkPhysicalDeviceFeatures features = {};  // those that we use and that are there
  // Those of extensions: from -1 to 1, the last vertex, and, where they need to be asked for, lines
  // that are rectangles.
  bool depth_clip_control = false, provoking_last = false, rectangular_lines = false;
  DriverInfo info = {};
};

// The device of that number in the loader's order. Errors: std::runtime_error if there is none.
PhysicalDevice find_physical_device(VkInstance instance, std::size_t number);

}  // namespace clipscope::experiments
