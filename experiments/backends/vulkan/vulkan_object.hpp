// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every call of Vulkan needs: an error that is thrown, and objects that are destroyed.
#pragma once

#include <vulkan/vulkan.h>

#include <stdexcept>
#include <utility>

namespace clipscope::experiments {

class VulkanError : public std::runtime_error {
 public:
  // call: the function that gave the result.
  VulkanError(const char* call, VkResult result);
};

// Errors: VulkanError. Positive results are none.
inline void check(VkResult result, const char* call) {
  if (result < VK_SUCCESS) throw VulkanError(call, result);
}

// An object of a device, destroyed with this one; the device outlives it.
template <class T, auto kDestroy>
class VulkanObject {
 public:
  VulkanObject() = default;
  VulkanObject(VkDevice device, T handle) : device_(device), handle_(handle) {}
  ~VulkanObject() {
    if (handle_) kDestroy(device_, handle_, nullptr);
  }
  VulkanObject(VulkanObject&& other) noexcept { *this = std::move(other); }
  VulkanObject& operator=(VulkanObject&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    return *this;
  }

  operator T() const { return handle_; }  // NOLINT: as the functions of Vulkan take it
  const T* address() const { return &handle_; }

 private:
  VkDevice device_ = {};
  T handle_ = {};
};

// make<vkDestroyFence>(device, vkCreateFence, info, "vkCreateFence"). Errors: VulkanError.
template <auto kDestroy, class T, class Info>
VulkanObject<T, kDestroy> make(VkDevice device,
                               VkResult (*create)(VkDevice, const Info*,
                                                  const VkAllocationCallbacks*, T*),
                               const Info& info, const char* call) {
  T handle = {};
  check(create(device, &info, nullptr, &handle), call);
  return {device, handle};
}

}  // namespace clipscope::experiments
