// SPDX-License-Identifier: GPL-3.0-or-later
//
// A device that draws, and the memory that it draws from and to. Errors everywhere: VulkanError.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "experiments/backends/vulkan/physical_device.hpp"
#include "experiments/backends/vulkan/vulkan_object.hpp"

namespace clipscope::experiments {

using DeviceMemory = VulkanObject<VkDeviceMemory, vkFreeMemory>;

class Device {
 public:
  explicit Device(const PhysicalDevice& physical);

  VkDevice handle() const { return device_.get(); }
  const PhysicalDevice& physical() const { return physical_; }

  // Memory that has all properties of `needed`; of those, the first that has `wished` ones, too.
  DeviceMemory allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags needed,
                        VkMemoryPropertyFlags wished) const;
  // Records one command buffer, and returns when the device has carried it out.
  void run(const std::function<void(VkCommandBuffer)>& record) const;

 private:
  struct Destroy {
    void operator()(VkDevice device) const { vkDestroyDevice(device, nullptr); }
  };
  PhysicalDevice physical_;
  std::unique_ptr<VkDevice_T, Destroy> device_;
  VkQueue queue_ = {};
  VulkanObject<VkCommandPool, vkDestroyCommandPool> pool_ = {};
  VulkanObject<VkFence, vkDestroyFence> fence_ = {};
  VkCommandBuffer commands_ = {};
};

// Memory of the device that the host reads and writes. It only grows.
class Buffer {
 public:
  Buffer(const Device& device, VkBufferUsageFlags usage) : device_(&device), usage_(usage) {}

  // What was in it is lost if it has to grow.
  void reserve(std::size_t bytes);
  void write(std::span<const std::byte> bytes);
  const std::byte* bytes() const { return bytes_; }
  VkBuffer handle() const { return buffer_; }

 private:
  const Device* device_;
  VkBufferUsageFlags usage_;
  std::size_t size_ = 0;
  DeviceMemory memory_ = {};
  VulkanObject<VkBuffer, vkDestroyBuffer> buffer_ = {};
  std::byte* bytes_ = nullptr;
};

// What is drawn into, and copied from.
class Image {
 public:
  Image(const Device& device, VkFormat format, VkExtent2D size);
  VkImage handle() const { return image_; }
  VkImageView view() const { return view_; }

 private:
  DeviceMemory memory_ = {};
  VulkanObject<VkImage, vkDestroyImage> image_ = {};
  VulkanObject<VkImageView, vkDestroyImageView> view_ = {};
};

inline bool is_depth(VkFormat format) { return format == VK_FORMAT_D32_SFLOAT; }
inline VkImageAspectFlags aspect_of(VkFormat format) {
  return is_depth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

}  // namespace clipscope::experiments
