// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pipelines in which passes are drawn, made when they are first asked for and kept.
#pragma once

#include <vulkan/vulkan.h>

#include <compare>
#include <cstddef>
#include <map>
#include <vector>

#include "experiments/backends/vulkan/device.hpp"
#include "experiments/backends/vulkan/passes.hpp"

namespace clipscope::experiments {

// What a pipeline depends on.
struct PipelineKey {
  PassKind kind = PassKind::values;
  unsigned long reads = 0;
  std::vector<VkFormat> formats = {};  // of the attachments, depth last
  Topology topology = Topology::triangles;
  ProvokingVertex provoking = ProvokingVertex::first;
  bool minus_one_to_one = false, depth_clamp = false;
  int clip_distances = 0;

  friend auto operator<=>(const PipelineKey&, const PipelineKey&) = default;
};
PipelineKey key_of(const Pass& pass, const DrawCall& call, const PhysicalDevice& physical);

struct Pipeline {
  VulkanObject<VkRenderPass, vkDestroyRenderPass> render_pass = {};
  VulkanObject<VkPipeline, vkDestroyPipeline> pipeline = {};
};

class Pipelines {
 public:
  explicit Pipelines(const Device& device);

  // Push constant: the size of points, a float, for the vertex shader. Vertices: DrawVertex.
  VkPipelineLayout layout() const { return layout_; }
  const Pipeline& of(const PipelineKey& key);
  // Destroys all of them where they have become many; none is in use.
  void tidy_up();

 private:
  const Device* device_;
  VulkanObject<VkPipelineLayout, vkDestroyPipelineLayout> layout_;
  std::map<PipelineKey, Pipeline> pipelines_ = {};
};

}  // namespace clipscope::experiments
