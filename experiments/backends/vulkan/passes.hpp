// SPDX-License-Identifier: GPL-3.0-or-later
//
// In which passes a draw call is drawn, and where its quantities then are.
//
// All quantities are drawn in one pass, as far as the device has attachments for them, but hits,
// which blends, and the clip distances, whose shader depends on how many there are.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

enum class PassKind : std::uint8_t { values, hits, clip_distances };

// Attachment 0 of the values has covered, facing and primitive_id, which is -1 without a fragment.
inline constexpr std::size_t kTexelOfFacing = 1, kTexelOfId = 2;

// Floats of an attachment that are floats of a quantity.
struct Part {
  Quantity quantity = Quantity::covered;
  std::size_t of_texel = 0, of_quantity = 0, count = 1;
};

struct Attachment {
  VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
  std::vector<Part> parts = {};  // none: not read back
};

struct Pass {
  PassKind kind = PassKind::values;
  Quantities reads = {};                     // by its fragment shader
  std::vector<Attachment> attachments = {};  // the one of depth last
};

// most_attachments: of colour in one pass, at least 4.
std::vector<Pass> passes_of(const DrawCall& call, std::size_t most_attachments);

// Bytes that an attachment takes of what is read back, where they lie one after the other in the
// order of the passes: 0 for one without parts.
std::size_t bytes_of(const Attachment& attachment, const DrawCall& call);

// The pixels of a call from what was read back.
Pixels pixels_of(const std::vector<Pass>& passes, const DrawCall& call, const std::byte* read_back);

}  // namespace clipscope::experiments
