// SPDX-License-Identifier: GPL-3.0-or-later
//
// VulkanDriver: a Vulkan driver that draws what it is asked for and reads it back.
#pragma once

#include <memory>

#include "experiments/backends/vulkan/physical_device.hpp"
#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

class VulkanDrawing;

class VulkanDriver : public Driver {
 public:
  // The instance outlives it.
  explicit VulkanDriver(PhysicalDevice physical);
  ~VulkanDriver() override;

  const DriverInfo& info() const override { return physical_.info; }
  // Refused: an error of Vulkan, after which the next call has a new device.
  Drawn draw(const DrawCall& call) override;

 private:
  PhysicalDevice physical_;
  std::unique_ptr<VulkanDrawing> drawing_;
};

}  // namespace clipscope::experiments
