// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/vulkan/device.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace clipscope::experiments {
namespace {

constexpr std::uint64_t kForever = std::numeric_limits<std::uint64_t>::max();

// The extensions that are used, with their features on.
class UsedExtensions {
 public:
  explicit UsedExtensions(const PhysicalDevice& physical) {
    depth_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_CONTROL_FEATURES_EXT;
    provoking_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROVOKING_VERTEX_FEATURES_EXT;
    lines_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_LINE_RASTERIZATION_FEATURES_EXT;
    depth_.depthClipControl = provoking_.provokingVertexLast = lines_.rectangularLines = VK_TRUE;
    if (physical.depth_clip_control) use(depth_, VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME);
    if (physical.provoking_last) use(provoking_, VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME);
    if (physical.rectangular_lines) use(lines_, VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME);
    // Who offers it has it used: VUID-VkDeviceCreateInfo-pProperties-04451.
    if (!physical.info.triangle_fans) names_.push_back("VK_KHR_portability_subset");
  }
  UsedExtensions(const UsedExtensions&) = delete;

  const std::vector<const char*>& names() const { return names_; }
  const void* chain() const { return chain_; }

 private:
  template <class T>
  void use(T& features, const char* name) {
    features.pNext = chain_;
    chain_ = &features;
    names_.push_back(name);
  }

  VkPhysicalDeviceDepthClipControlFeaturesEXT depth_ = {};
  VkPhysicalDeviceProvokingVertexFeaturesEXT provoking_ = {};
  VkPhysicalDeviceLineRasterizationFeaturesEXT lines_ = {};
  std::vector<const char*> names_;
  void* chain_ = nullptr;
};

VkDevice make_device(const PhysicalDevice& physical) {
  const float priority = 1;
  VkDeviceQueueCreateInfo queue = {};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = physical.queue_family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  const UsedExtensions extensions(physical);
  VkDeviceCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = extensions.chain();
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.names().size());
  info.ppEnabledExtensionNames = extensions.names().data();
  info.pEnabledFeatures = &physical.features;
  VkDevice device = {};
  check(vkCreateDevice(physical.handle, &info, nullptr, &device), "vkCreateDevice");
  return device;
}

}  // namespace

Device::Device(const PhysicalDevice& physical)
    : physical_(physical), device_(make_device(physical)) {
  vkGetDeviceQueue(handle(), physical.queue_family, 0, &queue_);
  VkCommandPoolCreateInfo pool = {};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool.queueFamilyIndex = physical.queue_family;
  pool_ = make<vkDestroyCommandPool>(handle(), vkCreateCommandPool, pool, "vkCreateCommandPool");
  VkFenceCreateInfo fence = {};
  fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  fence_ = make<vkDestroyFence>(handle(), vkCreateFence, fence, "vkCreateFence");
  VkCommandBufferAllocateInfo commands = {};
  commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  commands.commandPool = pool_;
  commands.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  commands.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(handle(), &commands, &commands_), "vkAllocateCommandBuffers");
}

DeviceMemory Device::allocate(const VkMemoryRequirements& requirements,
                              VkMemoryPropertyFlags needed, VkMemoryPropertyFlags wished) const {
  VkPhysicalDeviceMemoryProperties memory = {};
  vkGetPhysicalDeviceMemoryProperties(physical_.handle, &memory);
  VkMemoryAllocateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = requirements.size;
  for (const VkMemoryPropertyFlags properties : {needed | wished, needed}) {
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
      const bool fits = (requirements.memoryTypeBits >> i & 1) != 0;
      if (!fits || (memory.memoryTypes[i].propertyFlags & properties) != properties) continue;
      info.memoryTypeIndex = i;
      return make<vkFreeMemory>(handle(), vkAllocateMemory, info, "vkAllocateMemory");
    }
  }
  throw VulkanError("vkGetPhysicalDeviceMemoryProperties", VK_ERROR_FEATURE_NOT_PRESENT);
}

void Device::run(const std::function<void(VkCommandBuffer)>& record) const {
  VkCommandBufferBeginInfo begin = {};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
  record(commands_);
  check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
  VkSubmitInfo submit = {};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands_;
  check(vkResetFences(handle(), 1, fence_.address()), "vkResetFences");
  check(vkQueueSubmit(queue_, 1, &submit, fence_), "vkQueueSubmit");
  check(vkWaitForFences(handle(), 1, fence_.address(), VK_TRUE, kForever), "vkWaitForFences");
}

void Buffer::reserve(std::size_t bytes) {
  if (bytes <= size_) return;
  VkBufferCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = std::max(bytes, 2 * size_);
  info.usage = usage_;
  VulkanObject buffer =
      make<vkDestroyBuffer>(device_->handle(), vkCreateBuffer, info, "vkCreateBuffer");
  VkMemoryRequirements requirements = {};
  vkGetBufferMemoryRequirements(device_->handle(), buffer, &requirements);
  DeviceMemory memory = device_->allocate(
      requirements, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
      VK_MEMORY_PROPERTY_HOST_CACHED_BIT);
  check(vkBindBufferMemory(device_->handle(), buffer, memory, 0), "vkBindBufferMemory");
  void* begin = nullptr;
  check(vkMapMemory(device_->handle(), memory, 0, VK_WHOLE_SIZE, 0, &begin), "vkMapMemory");
  std::swap(buffer_, buffer);
  std::swap(memory_, memory);
  bytes_ = static_cast<std::byte*>(begin);
  size_ = info.size;
}

void Buffer::write(std::span<const std::byte> bytes) {
  reserve(std::max<std::size_t>(bytes.size(), 1));
  if (!bytes.empty()) std::memcpy(bytes_, bytes.data(), bytes.size());
}

Image::Image(const Device& device, VkFormat format, VkExtent2D size) {
  VkImageCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {size.width, size.height, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
               (is_depth(format) ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                 : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  image_ = make<vkDestroyImage>(device.handle(), vkCreateImage, info, "vkCreateImage");
  VkMemoryRequirements requirements = {};
  vkGetImageMemoryRequirements(device.handle(), image_, &requirements);
  memory_ = device.allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkBindImageMemory(device.handle(), image_, memory_, 0), "vkBindImageMemory");
  VkImageViewCreateInfo view = {};
  view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  view.image = image_;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format;
  view.subresourceRange = {aspect_of(format), 0, 1, 0, 1};
  view_ = make<vkDestroyImageView>(device.handle(), vkCreateImageView, view, "vkCreateImageView");
}

}  // namespace clipscope::experiments
