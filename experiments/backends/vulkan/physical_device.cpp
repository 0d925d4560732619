// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/vulkan/physical_device.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/backends/vulkan/vulkan_object.hpp"

namespace clipscope::experiments {
namespace {

// Physical devices are asked by the functions of 1.1; driver properties came with 1.2.
constexpr std::uint32_t kNewestUsed = VK_API_VERSION_1_2;

std::uint32_t instance_version() {
  std::uint32_t version = VK_API_VERSION_1_0;
  check(vkEnumerateInstanceVersion(&version), "vkEnumerateInstanceVersion");
  return std::min(version, kNewestUsed);
}

std::string text_of_version(std::uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
         std::to_string(VK_API_VERSION_MINOR(version)) + "." +
         std::to_string(VK_API_VERSION_PATCH(version));
}

std::vector<std::string> extensions_of(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr),
        "vkEnumerateDeviceExtensionProperties");
  std::vector<VkExtensionProperties> properties(count);
  check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, properties.data()),
        "vkEnumerateDeviceExtensionProperties");
  std::vector<std::string> names;
  for (const VkExtensionProperties& extension : properties) {
    names.emplace_back(extension.extensionName);
  }
  return names;
}

bool has(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::uint32_t graphics_family(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  const auto family =
      std::find_if(families.begin(), families.end(), [](const VkQueueFamilyProperties& it) {
        return (it.queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;
      });
  if (family == families.end()) throw std::runtime_error("the Vulkan device has no graphics queue");
  return static_cast<std::uint32_t>(family - families.begin());
}

bool has_float_depth(VkPhysicalDevice device) {
  VkFormatProperties properties = {};
  vkGetPhysicalDeviceFormatProperties(device, VK_FORMAT_D32_SFLOAT, &properties);
  return (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) != 0;
}

// A chain of structures that the driver fills in.
class Question {
 public:
  template <class T>
  void add(T& structure) {
    structure.pNext = first_;
    first_ = &structure;
  }
  void* first() const { return first_; }

 private:
  void* first_ = nullptr;
};

void ask_features_of_extensions(PhysicalDevice& device, const std::vector<std::string>& names) {
  VkPhysicalDeviceDepthClipControlFeaturesEXT depth = {};
  VkPhysicalDeviceProvokingVertexFeaturesEXT provoking = {};
  VkPhysicalDeviceLineRasterizationFeaturesEXT lines = {};
  depth.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_CONTROL_FEATURES_EXT;
  provoking.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROVOKING_VERTEX_FEATURES_EXT;
  lines.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_LINE_RASTERIZATION_FEATURES_EXT;
  Question question;
  if (has(names, VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME)) question.add(depth);
  if (has(names, VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME)) question.add(provoking);
  if (has(names, VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME)) question.add(lines);
  VkPhysicalDeviceFeatures2 features = {};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  features.pNext = question.first();
  vkGetPhysicalDeviceFeatures2(device.handle, &features);
  device.depth_clip_control = depth.depthClipControl;
  device.provoking_last = provoking.provokingVertexLast;
  // Who is strict draws rectangles by default.
  device.rectangular_lines = lines.rectangularLines && !device.limits.strictLines;
}

// What the driver says of itself, and whether it clips points at the sides.
void ask_properties(PhysicalDevice& device, std::uint32_t version,
                    const std::vector<std::string>& names) {
  VkPhysicalDevicePointClippingProperties points = {};
  VkPhysicalDeviceDriverProperties driver = {};
  points.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_POINT_CLIPPING_PROPERTIES;
  driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
  Question question;
  question.add(points);
  const bool tells_driver =
      version >= VK_API_VERSION_1_2 || has(names, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME);
  if (tells_driver) question.add(driver);
  VkPhysicalDeviceProperties2 properties = {};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = question.first();
  vkGetPhysicalDeviceProperties2(device.handle, &properties);
  device.info.points_clip_at_sides =
      points.pointClippingBehavior == VK_POINT_CLIPPING_BEHAVIOR_ALL_CLIP_PLANES;
  const std::string name = driver.driverName, words = driver.driverInfo;
  if (!words.empty()) device.info.version = words;
  if (words.empty() && !name.empty()) device.info.version = name + " " + device.info.version;
}

VkPhysicalDeviceFeatures used_features(VkPhysicalDevice device) {
  VkPhysicalDeviceFeatures all = {}, used = {};
  vkGetPhysicalDeviceFeatures(device, &all);
  used.depthClamp = all.depthClamp;
  used.shaderClipDistance = all.shaderClipDistance;
  used.largePoints = all.largePoints;
  used.geometryShader = all.geometryShader;
  return used;
}

Quantities told_by(const PhysicalDevice& device) {
  Quantities told;
  told.set();
  told.set(bit(Quantity::primitive_id), device.features.geometryShader);
  told.set(bit(Quantity::clip_distances), device.features.shaderClipDistance);
  told.set(bit(Quantity::depth), has_float_depth(device.handle));
  return told;
}

void fill_in_limits(DriverInfo& info, const PhysicalDevice& device) {
  const VkPhysicalDeviceLimits& limits = device.limits;
  info.subpixel_bits = static_cast<int>(limits.subPixelPrecisionBits);
  info.max_size = static_cast<int>(
      std::min({limits.maxFramebufferWidth, limits.maxFramebufferHeight, limits.maxImageDimension2D,
                limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]}));
  if (device.features.shaderClipDistance) {
    info.max_clip_distances =
        static_cast<int>(std::min(limits.maxClipDistances, std::uint32_t{kMaxClipDistances}));
  }
  info.max_point_size = device.features.largePoints ? limits.pointSizeRange[1] : 1;
  info.strict_lines = limits.strictLines || device.rectangular_lines;
}

}  // namespace

VulkanInstance make_instance() {
  VkApplicationInfo application = {};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "clipscope";
  application.apiVersion = instance_version();
  VkInstanceCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  VkInstance instance = {};
  check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
  return VulkanInstance(instance);
}

PhysicalDevice find_physical_device(VkInstance instance, std::size_t number) {
  std::uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> handles(count);
  check(vkEnumeratePhysicalDevices(instance, &count, handles.data()), "vkEnumeratePhysicalDevices");
  if (number >= handles.size()) {
    throw std::runtime_error("there is no Vulkan device " + std::to_string(number) +
                             ", for the loader finds " + std::to_string(handles.size()));
  }
  PhysicalDevice device{.handle = handles[number],
                        .queue_family = graphics_family(handles[number])};
  VkPhysicalDeviceProperties properties = {};
  vkGetPhysicalDeviceProperties(device.handle, &properties);
  device.limits = properties.limits;
  device.features = used_features(device.handle);
  const std::vector<std::string> extensions = extensions_of(device.handle);
  DriverInfo& info = device.info;
  info.api = GraphicsApi::vulkan;
  info.api_version = text_of_version(properties.apiVersion);
  info.renderer = properties.deviceName;
  info.version = text_of_version(properties.driverVersion);
  const std::uint32_t version = std::min(instance_version(), properties.apiVersion);
  if (version >= VK_API_VERSION_1_1) {
    ask_features_of_extensions(device, extensions);
    ask_properties(device, version, extensions);
  }
  fill_in_limits(info, device);
  // Vulkan 1.0 leaves it open whether a point outside is drawn: no answer would be wrong.
  if (version < VK_API_VERSION_1_1) info.max_point_size = 0;
  info.zero_to_one = true;
  info.minus_one_to_one = device.depth_clip_control;
  info.depth_clamp = device.features.depthClamp;
  info.provoking_first = true;
  info.provoking_last = device.provoking_last;
  // Where this one is, fans may be missing.
  info.triangle_fans = !has(extensions, "VK_KHR_portability_subset");
  info.quantities = told_by(device);
  return device;
}

}  // namespace clipscope::experiments
