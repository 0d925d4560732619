// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/vulkan/passes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace clipscope::experiments {
namespace {

// Each has an attachment of its own.
constexpr std::array kWide = {Quantity::smooth, Quantity::noperspective, Quantity::flat,
                              Quantity::frag_coord};

constexpr VkFormat kHalves = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr std::size_t kAlignment = 16;  // bytes of the largest texel: each copy begins at one

Attachment whole(Quantity quantity) {
  return {.parts = {{.quantity = quantity, .count = channels(quantity)}}};
}

Pass first_of_values(const DrawCall& call) {
  Pass pass = {.attachments = {{.parts = {{.quantity = Quantity::covered}}}}};
  for (const Quantity quantity : {Quantity::facing, Quantity::primitive_id}) {
    const std::size_t texel = quantity == Quantity::facing ? kTexelOfFacing : kTexelOfId;
    if (!call.quantities[bit(quantity)]) continue;
    pass.reads.set(bit(quantity));
    pass.attachments[0].parts.push_back({.quantity = quantity, .of_texel = texel});
  }
  return pass;
}

Pass hits_pass() {
  return {
      .kind = PassKind::hits,
      .attachments = {{.format = kHalves, .parts = {{.quantity = Quantity::hits, .count = 2}}}}};
}

Pass clip_distances_pass() {
  constexpr Part kFirst = {.quantity = Quantity::clip_distances, .count = 4};
  constexpr Part kLast = {.quantity = Quantity::clip_distances, .of_quantity = 4, .count = 4};
  return {.kind = PassKind::clip_distances,
          .attachments = {{.parts = {kFirst}}, {.parts = {kLast}}}};
}

std::size_t bytes_of_texel(VkFormat format) {
  if (format == kHalves) return 8;
  return format == VK_FORMAT_D32_SFLOAT ? 4 : 16;
}

// IEEE 754 binary16; these are small whole numbers or whatever a driver makes of them.
float float_of_half(std::uint16_t half) {
  const int exponent = half >> 10 & 31, fraction = half & 1023;
  const float sign = half >> 15 ? -1.0f : 1.0f;
  if (exponent == 31) return fraction ? NAN : sign * INFINITY;
  if (exponent == 0) return sign * std::ldexp(static_cast<float>(fraction), -24);
  return sign * std::ldexp(static_cast<float>(fraction + 1024), exponent - 25);
}

template <class T>
T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

// read: makes a float of what lies there; `size` bytes each.
template <class Read>
void copy_part(const Attachment& attachment, const Part& part, const std::byte* bytes,
               std::size_t size, Read&& read, std::vector<float>& values) {
  const std::size_t texel = bytes_of_texel(attachment.format), step = channels(part.quantity);
  const std::byte* from = bytes + part.of_texel * size;
  for (std::size_t to = part.of_quantity; to < values.size(); to += step, from += texel) {
    for (std::size_t i = 0; i < part.count; ++i) values[to + i] = read(from + i * size);
  }
}

void unpack(const Attachment& attachment, const std::byte* bytes, std::size_t count,
            Pixels& pixels) {
  for (const Part& part : attachment.parts) {
    std::vector<float>& values = pixels.values[bit(part.quantity)];
    values.resize(count * channels(part.quantity));
    if (attachment.format == kHalves) {
      const auto read = [](const std::byte* from) {
        return float_of_half(load<std::uint16_t>(from));
      };
      copy_part(attachment, part, bytes, sizeof(std::uint16_t), read, values);
    } else {
      copy_part(attachment, part, bytes, sizeof(float), load<float>, values);
    }
  }
}

std::size_t count_of_pixels(const DrawCall& call) {
  return static_cast<std::size_t>(call.width) * static_cast<std::size_t>(call.height);
}

}  // namespace

std::vector<Pass> passes_of(const DrawCall& call, std::size_t most_attachments) {
  std::vector<Pass> passes = {first_of_values(call)};
  for (const Quantity quantity : kWide) {
    if (!call.quantities[bit(quantity)]) continue;
    const bool is_full = passes.back().attachments.size() == most_attachments;
    if (is_full) passes.push_back({.attachments = {{}}});
    passes.back().reads.set(bit(quantity));
    passes.back().attachments.push_back(whole(quantity));
  }
  if (call.quantities[bit(Quantity::depth)]) {
    passes[0].attachments.push_back(whole(Quantity::depth));
    passes[0].attachments.back().format = VK_FORMAT_D32_SFLOAT;
  }
  passes.push_back(hits_pass());
  const bool tells_distances =
      call.quantities[bit(Quantity::clip_distances)] && call.volume.clip_distances > 0;
  if (tells_distances) passes.push_back(clip_distances_pass());
  return passes;
}

std::size_t bytes_of(const Attachment& attachment, const DrawCall& call) {
  if (attachment.parts.empty()) return 0;
  const std::size_t bytes = count_of_pixels(call) * bytes_of_texel(attachment.format);
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

Pixels pixels_of(const std::vector<Pass>& passes, const DrawCall& call,
                 const std::byte* read_back) {
  Pixels pixels{call.width, call.height};
  for (const Pass& pass : passes) {
    for (const Attachment& attachment : pass.attachments) {
      unpack(attachment, read_back, count_of_pixels(call), pixels);
      read_back += bytes_of(attachment, call);
    }
  }
  // Where there are none, the distances are 0, as those beyond the volume's always are.
  if (call.quantities[bit(Quantity::clip_distances)]) {
    pixels.values[bit(Quantity::clip_distances)].resize(count_of_pixels(call) * 8);
  }
  return pixels;
}

}  // namespace clipscope::experiments
