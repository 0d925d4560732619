// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/vulkan/pipelines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include "experiments/backends/vulkan/shaders.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kMostPipelines = 2048;  // each takes a software driver up to 0.2 s to compile

VkPrimitiveTopology topology_of(Topology topology) {
  switch (topology) {
    case Topology::points: return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    case Topology::lines: return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    case Topology::line_strip: return VK_PRIMITIVE_TOPOLOGY_LINE_STRIP;
    case Topology::triangles: return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    case Topology::triangle_strip: return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    case Topology::triangle_fan: return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
  }
  return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
}

// Cleared, drawn, and left to be copied from.
VkAttachmentDescription description_of(VkFormat format) {
  VkAttachmentDescription attachment = {};
  attachment.format = format;
  attachment.samples = VK_SAMPLE_COUNT_1_BIT;
  attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  attachment.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  attachment.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  attachment.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  attachment.finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  return attachment;
}

// The pass before has been copied from the same images, and this one will be.
std::array<VkSubpassDependency, 2> dependencies() {
  constexpr VkPipelineStageFlags kDraws = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT |
                                          VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                                          VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
  constexpr VkAccessFlags kWrites =
      VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
  constexpr VkAccessFlags kReads =
      VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
  constexpr VkPipelineStageFlags kCopies = VK_PIPELINE_STAGE_TRANSFER_BIT;
  constexpr VkAccessFlags kCopy = VK_ACCESS_TRANSFER_READ_BIT;
  return {{{VK_SUBPASS_EXTERNAL, 0, kCopies, kDraws, kCopy, kWrites | kReads, 0},
           {0, VK_SUBPASS_EXTERNAL, kDraws, kCopies, kWrites, kCopy, 0}}};
}

VulkanObject<VkRenderPass, vkDestroyRenderPass> render_pass_of(
    VkDevice device, const std::vector<VkFormat>& formats) {
  std::vector<VkAttachmentDescription> attachments;
  std::vector<VkAttachmentReference> colours;
  VkAttachmentReference depth = {};
  VkSubpassDescription subpass = {};
  for (const VkFormat format : formats) {
    const auto number = static_cast<std::uint32_t>(attachments.size());
    attachments.push_back(description_of(format));
    if (is_depth(format)) {
      depth = {number, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
      subpass.pDepthStencilAttachment = &depth;
    } else {
      colours.push_back({number, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL});
    }
  }
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = static_cast<std::uint32_t>(colours.size());
  subpass.pColorAttachments = colours.data();
  const std::array around = dependencies();
  VkRenderPassCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
  info.attachmentCount = static_cast<std::uint32_t>(attachments.size());
  info.pAttachments = attachments.data();
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = static_cast<std::uint32_t>(around.size());
  info.pDependencies = around.data();
  return make<vkDestroyRenderPass>(device, vkCreateRenderPass, info, "vkCreateRenderPass");
}

using ShaderModule = VulkanObject<VkShaderModule, vkDestroyShaderModule>;

ShaderModule module_of(VkDevice device, SpirV words) {
  VkShaderModuleCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = words.size_bytes();
  info.pCode = words.data();
  return make<vkDestroyShaderModule>(device, vkCreateShaderModule, info, "vkCreateShaderModule");
}

SpirV fragment_shader(const PipelineKey& key) {
  switch (key.kind) {
    case PassKind::values: return values_shader(Quantities(key.reads));
    case PassKind::hits: return hits_shader();
    case PassKind::clip_distances: return clip_distances_shader(key.clip_distances);
  }
  return {};
}

VkPipelineShaderStageCreateInfo stage_of(VkShaderStageFlagBits stage, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

// The fixed functions, each with what it points to.
class FixedFunctions {
 public:
  FixedFunctions(const PipelineKey& key, const PhysicalDevice& physical) {
    read_vertices(key);
    set_viewport(key);
    rasterise(key, physical);
    write(key);
  }
  FixedFunctions(const FixedFunctions&) = delete;

  void fill_in(VkGraphicsPipelineCreateInfo& info) const {
    info.pVertexInputState = &vertices_;
    info.pInputAssemblyState = &assembly_;
    info.pViewportState = &viewport_;
    info.pRasterizationState = &rasterisation_;
    info.pMultisampleState = &samples_;
    info.pDepthStencilState = &depth_;
    info.pColorBlendState = &blending_;
    info.pDynamicState = &dynamic_;
  }

 private:
  void read_vertices(const PipelineKey& key) {
    constexpr VkFormat kFloats = VK_FORMAT_R32G32B32A32_SFLOAT;
    constexpr std::uint32_t kDistances = offsetof(DrawVertex, clip_distances);
    attributes_ = {{{0, 0, kFloats, offsetof(DrawVertex, position)},
                    {1, 0, kFloats, offsetof(DrawVertex, varying)},
                    {2, 0, kFloats, kDistances},
                    {3, 0, kFloats, kDistances + 4 * sizeof(float)}}};
    vertices_.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    vertices_.vertexBindingDescriptionCount = 1;
    vertices_.pVertexBindingDescriptions = &binding_;
    vertices_.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes_.size());
    vertices_.pVertexAttributeDescriptions = attributes_.data();
    assembly_.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly_.topology = topology_of(key.topology);
  }

  void set_viewport(const PipelineKey& key) {
    viewport_.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport_.viewportCount = viewport_.scissorCount = 1;
    clip_control_.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_DEPTH_CLIP_CONTROL_CREATE_INFO_EXT;
    clip_control_.negativeOneToOne = VK_TRUE;
    if (key.minus_one_to_one) viewport_.pNext = &clip_control_;
    dynamic_.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic_.dynamicStateCount = static_cast<std::uint32_t>(kDynamic.size());
    dynamic_.pDynamicStates = kDynamic.data();
  }

  // Front is what turns from x to y in pixels. Vulkan takes the area with the sign turned, as seen
  // with y downwards, so that this is its clockwise.
  void rasterise(const PipelineKey& key, const PhysicalDevice& physical) {
    rasterisation_.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    rasterisation_.depthClampEnable = key.depth_clamp;
    rasterisation_.polygonMode = VK_POLYGON_MODE_FILL;
    rasterisation_.cullMode = VK_CULL_MODE_NONE;
    rasterisation_.frontFace = VK_FRONT_FACE_CLOCKWISE;
    rasterisation_.lineWidth = 1;
    provoking_.sType =
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_PROVOKING_VERTEX_STATE_CREATE_INFO_EXT;
    provoking_.provokingVertexMode = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
    lines_.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_LINE_STATE_CREATE_INFO_EXT;
    lines_.lineRasterizationMode = VK_LINE_RASTERIZATION_MODE_RECTANGULAR_EXT;
    if (key.provoking == ProvokingVertex::last) rasterisation_.pNext = &provoking_;
    if (physical.rectangular_lines) {
      lines_.pNext = rasterisation_.pNext;
      rasterisation_.pNext = &lines_;
    }
    samples_.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    samples_.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  }

  // All fragments are written, except that hits are added up.
  void write(const PipelineKey& key) {
    depth_.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth_.depthTestEnable = depth_.depthWriteEnable = is_depth(key.formats.back());
    depth_.depthCompareOp = VK_COMPARE_OP_ALWAYS;
    VkPipelineColorBlendAttachmentState state = {};
    state.blendEnable = key.kind == PassKind::hits;
    state.srcColorBlendFactor = state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
    state.srcAlphaBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    state.colorBlendOp = state.alphaBlendOp = VK_BLEND_OP_ADD;
    state.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                           VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    colours_.assign(key.formats.size() - (is_depth(key.formats.back()) ? 1 : 0), state);
    blending_.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blending_.attachmentCount = static_cast<std::uint32_t>(colours_.size());
    blending_.pAttachments = colours_.data();
  }

  static constexpr std::array kDynamic = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkVertexInputBindingDescription binding_ = {0, sizeof(DrawVertex), VK_VERTEX_INPUT_RATE_VERTEX};
  std::array<VkVertexInputAttributeDescription, 4> attributes_ = {};
  VkPipelineVertexInputStateCreateInfo vertices_ = {};
  VkPipelineInputAssemblyStateCreateInfo assembly_ = {};
  VkPipelineViewportDepthClipControlCreateInfoEXT clip_control_ = {};
  VkPipelineViewportStateCreateInfo viewport_ = {};
  VkPipelineRasterizationProvokingVertexStateCreateInfoEXT provoking_ = {};
  VkPipelineRasterizationLineStateCreateInfoEXT lines_ = {};
  VkPipelineRasterizationStateCreateInfo rasterisation_ = {};
  VkPipelineMultisampleStateCreateInfo samples_ = {};
  VkPipelineDepthStencilStateCreateInfo depth_ = {};
  std::vector<VkPipelineColorBlendAttachmentState> colours_ = {};
  VkPipelineColorBlendStateCreateInfo blending_ = {};
  VkPipelineDynamicStateCreateInfo dynamic_ = {};
};

Pipeline make_pipeline(const Device& device, VkPipelineLayout layout, const PipelineKey& key) {
  Pipeline made = {.render_pass = render_pass_of(device.handle(), key.formats)};
  const ShaderModule vertex = module_of(device.handle(), vertex_shader(key.clip_distances));
  const ShaderModule fragment = module_of(device.handle(), fragment_shader(key));
  const std::array stages = {stage_of(VK_SHADER_STAGE_VERTEX_BIT, vertex),
                             stage_of(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
  const FixedFunctions fixed(key, device.physical());
  VkGraphicsPipelineCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
  info.stageCount = static_cast<std::uint32_t>(stages.size());
  info.pStages = stages.data();
  fixed.fill_in(info);
  info.layout = layout;
  info.renderPass = made.render_pass;
  VkPipeline pipeline = {};
  check(vkCreateGraphicsPipelines(device.handle(), {}, 1, &info, nullptr, &pipeline),
        "vkCreateGraphicsPipelines");
  made.pipeline = {device.handle(), pipeline};
  return made;
}

VulkanObject<VkPipelineLayout, vkDestroyPipelineLayout> make_layout(VkDevice device) {
  const VkPushConstantRange point_size = {VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(float)};
  VkPipelineLayoutCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &point_size;
  return make<vkDestroyPipelineLayout>(device, vkCreatePipelineLayout, info,
                                       "vkCreatePipelineLayout");
}

}  // namespace

PipelineKey key_of(const Pass& pass, const DrawCall& call, const PhysicalDevice& physical) {
  PipelineKey key = {.kind = pass.kind, .reads = pass.reads.to_ulong()};
  for (const Attachment& attachment : pass.attachments) key.formats.push_back(attachment.format);
  key.topology = call.topology;
  // Who has no choice provokes by the first; then no flat value is asked for.
  key.provoking = physical.provoking_last ? call.provoking : ProvokingVertex::first;
  key.minus_one_to_one = call.volume.depth == DepthRange::minus_one_to_one;
  key.depth_clamp = static_cast<bool>(call.volume.depth_clamp);
  key.clip_distances = call.volume.clip_distances;
  return key;
}

Pipelines::Pipelines(const Device& device)
    : device_(&device), layout_(make_layout(device.handle())) {}

const Pipeline& Pipelines::of(const PipelineKey& key) {
  const auto found = pipelines_.find(key);
  if (found != pipelines_.end()) return found->second;
  return pipelines_.emplace(key, make_pipeline(*device_, layout_, key)).first->second;
}

void Pipelines::tidy_up() {
  if (pipelines_.size() > kMostPipelines) pipelines_.clear();
}

}  // namespace clipscope::experiments
