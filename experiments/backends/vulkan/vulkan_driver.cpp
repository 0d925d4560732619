// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/vulkan/vulkan_driver.hpp"

#include <algorithm>
#include <cstdint>
#include <list>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiments/backends/vulkan/device.hpp"
#include "experiments/backends/vulkan/passes.hpp"
#include "experiments/backends/vulkan/pipelines.hpp"

namespace clipscope::experiments {
namespace {

using Framebuffer = VulkanObject<VkFramebuffer, vkDestroyFramebuffer>;

VkExtent2D size_of(const DrawCall& call) {
  return {static_cast<std::uint32_t>(call.width), static_cast<std::uint32_t>(call.height)};
}

bool reaches_too_far(const Viewport& viewport, const VkPhysicalDeviceLimits& limits) {
  const auto [least, most] = limits.viewportBoundsRange;
  const auto x = static_cast<float>(viewport.x), y = static_cast<float>(viewport.y);
  return x < least || y < least || x + static_cast<float>(viewport.width) > most ||
         y + static_cast<float>(viewport.height) > most;
}

// The images of one size. Passes with attachments of one format share them.
class Images {
 public:
  explicit Images(const Device& device) : device_(&device) {}

  // One for each attachment, in their order.
  std::vector<const Image*> of(const Pass& pass, const DrawCall& call) {
    if (size_of(call).width != size_.width || size_of(call).height != size_.height) images_.clear();
    size_ = size_of(call);
    std::vector<const Image*> chosen;
    for (const Attachment& attachment : pass.attachments) {
      const auto is_free = [&](const Entry& entry) {
        return entry.format == attachment.format &&
               std::find(chosen.begin(), chosen.end(), &entry.image) == chosen.end();
      };
      auto entry = std::find_if(images_.begin(), images_.end(), is_free);
      if (entry == images_.end()) {
        images_.push_back({attachment.format, Image(*device_, attachment.format, size_)});
        entry = std::prev(images_.end());
      }
      chosen.push_back(&entry->image);
    }
    return chosen;
  }

 private:
  struct Entry {
    VkFormat format;
    Image image;
  };
  const Device* device_;
  VkExtent2D size_ = {};
  std::list<Entry> images_ = {};
};

Framebuffer framebuffer_of(VkDevice device, VkRenderPass render_pass,
                           const std::vector<const Image*>& images, VkExtent2D size) {
  std::vector<VkImageView> views;
  for (const Image* image : images) views.push_back(image->view());
  VkFramebufferCreateInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
  info.renderPass = render_pass;
  info.attachmentCount = static_cast<std::uint32_t>(views.size());
  info.pAttachments = views.data();
  info.width = size.width;
  info.height = size.height;
  info.layers = 1;
  return make<vkDestroyFramebuffer>(device, vkCreateFramebuffer, info, "vkCreateFramebuffer");
}

void begin_render_pass(VkCommandBuffer commands, VkRenderPass render_pass,
                       VkFramebuffer framebuffer, const Pass& pass, VkExtent2D size) {
  std::vector<VkClearValue> clear(pass.attachments.size());
  if (pass.kind == PassKind::values) clear[0].color.float32[kTexelOfId] = -1;
  if (is_depth(pass.attachments.back().format)) clear.back().depthStencil.depth = kNoDepth;
  VkRenderPassBeginInfo info = {};
  info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
  info.renderPass = render_pass;
  info.framebuffer = framebuffer;
  info.renderArea.extent = size;
  info.clearValueCount = static_cast<std::uint32_t>(clear.size());
  info.pClearValues = clear.data();
  vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
}

void copy(VkCommandBuffer commands, const Image& image, VkFormat format, VkExtent2D size,
          VkBuffer to, VkDeviceSize offset) {
  VkBufferImageCopy region = {};
  region.bufferOffset = offset;
  region.imageSubresource = {aspect_of(format), 0, 0, 1};
  region.imageExtent = {size.width, size.height, 1};
  vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1,
                         &region);
}

void let_host_read(VkCommandBuffer commands) {
  VkMemoryBarrier barrier = {};
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                       &barrier, 0, nullptr, 0, nullptr);
}

}  // namespace

// A device with all that it draws with. Errors: VulkanError.
class VulkanDrawing {
 public:
  explicit VulkanDrawing(const PhysicalDevice& physical) : device_(physical) {}
  ~VulkanDrawing() { vkDeviceWaitIdle(device_.handle()); }
  VulkanDrawing(const VulkanDrawing&) = delete;

  Pixels draw(const DrawCall& call) {
    const std::size_t most = device_.physical().limits.maxColorAttachments;
    const std::vector<Pass> passes = passes_of(call, most);
    vertices_.write(std::as_bytes(std::span(call.vertices)));
    indices_.write(std::as_bytes(std::span(call.indices)));
    std::size_t bytes = 0;
    for (const Pass& pass : passes) {
      for (const Attachment& attachment : pass.attachments) bytes += bytes_of(attachment, call);
    }
    read_back_.reserve(bytes);
    pipelines_.tidy_up();
    std::vector<Framebuffer> framebuffers;
    device_.run([&](VkCommandBuffer commands) {
      VkDeviceSize offset = 0;
      for (const Pass& pass : passes) {
        const Pipeline& pipeline = pipelines_.of(key_of(pass, call, device_.physical()));
        const std::vector<const Image*> images = images_.of(pass, call);
        framebuffers.push_back(
            framebuffer_of(device_.handle(), pipeline.render_pass, images, size_of(call)));
        begin_render_pass(commands, pipeline.render_pass, framebuffers.back(), pass, size_of(call));
        draw_pass(commands, pipeline.pipeline, call);
        vkCmdEndRenderPass(commands);
        for (std::size_t i = 0; i < images.size(); ++i) {
          const Attachment& attachment = pass.attachments[i];
          if (attachment.parts.empty()) continue;
          copy(commands, *images[i], attachment.format, size_of(call), read_back_.handle(), offset);
          offset += bytes_of(attachment, call);
        }
      }
      let_host_read(commands);
    });
    return pixels_of(passes, call, read_back_.bytes());
  }

 private:
  void draw_pass(VkCommandBuffer commands, VkPipeline pipeline, const DrawCall& call) const {
    const Viewport& window = call.viewport;
    const VkViewport viewport = {static_cast<float>(window.x),
                                 static_cast<float>(window.y),
                                 static_cast<float>(window.width),
                                 static_cast<float>(window.height),
                                 0,
                                 1};
    const VkRect2D scissor = {{0, 0}, size_of(call)};
    const VkBuffer vertices = vertices_.handle();
    const VkDeviceSize first = 0;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
    vkCmdPushConstants(commands, pipelines_.layout(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(float),
                       &call.point_size);
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &first);
    if (call.indices.empty()) {
      vkCmdDraw(commands, static_cast<std::uint32_t>(call.vertices.size()), 1, 0, 0);
    } else {
      vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
      vkCmdDrawIndexed(commands, static_cast<std::uint32_t>(call.indices.size()), 1, 0, 0, 0);
    }
  }

  Device device_;
  Pipelines pipelines_{device_};
  Images images_{device_};
  Buffer vertices_{device_, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT};
  Buffer indices_{device_, VK_BUFFER_USAGE_INDEX_BUFFER_BIT};
  Buffer read_back_{device_, VK_BUFFER_USAGE_TRANSFER_DST_BIT};
};

VulkanDriver::VulkanDriver(PhysicalDevice physical) : physical_(std::move(physical)) {}
VulkanDriver::~VulkanDriver() = default;

Drawn VulkanDriver::draw(const DrawCall& call) {
  using Kind = DrawFailure::Kind;
  std::string reason = inability(physical_.info, call);
  if (reason.empty() && reaches_too_far(call.viewport, physical_.limits)) {
    reason = "has no viewport that reaches so far";
  }
  if (!reason.empty()) return DrawFailure{Kind::unable, reason};
  try {
    if (!drawing_) drawing_ = std::make_unique<VulkanDrawing>(physical_);
    return drawing_->draw(call);
  } catch (const VulkanError& error) {
    drawing_.reset();
    return DrawFailure{Kind::refused, error.what()};
  } catch (const std::bad_alloc&) {
    return DrawFailure{Kind::refused, "out of memory"};
  }
}

}  // namespace clipscope::experiments
