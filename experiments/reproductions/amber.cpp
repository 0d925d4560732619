// SPDX-License-Identifier: GPL-3.0-or-later
//
// Amber has depths of 0 to 1 and, as Vulkan by itself, flat values of the first vertex. What it
// draws to has 8 bits of a colour.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "experiments/reproductions/formats.hpp"
#include "experiments/reproductions/shaders.hpp"

namespace clipscope::experiments {
namespace {

std::string_view amber_name(Topology topology) {
  constexpr std::array<std::string_view, names_of(Topology{}).size()> kNames = {
      "POINT_LIST", "LINE_LIST", "LINE_STRIP", "TRIANGLE_LIST", "TRIANGLE_STRIP", "TRIANGLE_FAN"};
  return kNames[static_cast<std::size_t>(topology)];
}

// What the device has to be asked for.
std::string features(const DrawCall& call, const Check& check) {
  std::string text;
  if (call.volume.depth_clamp) text += "DEVICE_FEATURE depthClamp\n";
  if (call.volume.clip_distances > 0) text += "DEVICE_FEATURE shaderClipDistance\n";
  if (check.quantity == Quantity::primitive_id) text += "DEVICE_FEATURE geometryShader\n";
  if (check.counts()) text += "DEVICE_FEATURE fragmentStoresAndAtomics\n";
  if (call.topology == Topology::points && call.point_size != 1) {
    text += "DEVICE_FEATURE largePoints\n";
  }
  return text.empty() ? text : text + "\n";
}

std::string shader(std::string_view stage, std::string_view name, std::string_view source) {
  return fmt::format("SHADER {} {} GLSL\n{}END\n\n", stage, name, source);
}

// One buffer for each input, their names with a suffix.
std::string vertex_buffers(const std::vector<DrawVertex>& vertices,
                           const std::vector<VertexInput>& inputs, std::string_view suffix) {
  std::string text;
  for (const VertexInput& input : inputs) {
    text += fmt::format("BUFFER {}{} DATA_TYPE vec4<float> DATA\n", input.name, suffix);
    for (const DrawVertex& vertex : vertices) text += input_text(input, vertex) + "\n";
    text += "END\n\n";
  }
  return text;
}

// A pipeline into the same images. Its suffix is that of the shader's and the buffers' names.
struct Pipeline {
  std::string_view name, fragment_shader, suffix;
  std::string_view depth_compare;  // empty: no depth buffer
  bool is_indexed = false;
};

std::string pipeline_text(const DrawCall& call, const Check& check, const Pipeline& pipeline) {
  const Viewport& at = call.viewport;
  std::string text = fmt::format(
      "PIPELINE graphics {}\n  ATTACH vertex_shader\n  ATTACH {}\n  FRAMEBUFFER_SIZE {} {}\n"
      "  VIEWPORT {}.0 {}.0 SIZE {}.0 {}.0\n  BIND BUFFER target AS color LOCATION 0\n",
      pipeline.name, pipeline.fragment_shader, call.width, call.height, at.x, at.y, at.width,
      at.height);
  const std::vector<VertexInput> inputs = inputs_of(call, check);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    text += fmt::format("  VERTEX_DATA {}{} LOCATION {}\n", inputs[i].name, pipeline.suffix, i);
  }
  if (pipeline.is_indexed) text += "  INDEX_DATA indices\n";
  if (check.counts()) text += "  BIND BUFFER fragments AS storage DESCRIPTOR_SET 0 BINDING 0\n";
  const bool has_depth = !pipeline.depth_compare.empty();
  if (has_depth) text += "  BIND BUFFER depth AS depth_stencil\n";
  if (has_depth || call.volume.depth_clamp) {
    text += fmt::format(
        "  DEPTH\n    TEST {0}\n    WRITE {0}\n    COMPARE_OP {1}\n    CLAMP {2}\n  END\n",
        has_depth ? "on" : "off", has_depth ? pipeline.depth_compare : "always",
        call.volume.depth_clamp ? "on" : "off");
  }
  return text + "END\n\n";
}

std::string images(const Check& check) {
  std::string text = "BUFFER target FORMAT R8G8B8A8_UNORM\n";
  if (check.kind == Check::Kind::depth) text += "BUFFER depth FORMAT D32_SFLOAT\n";
  if (check.counts()) text += "BUFFER fragments DATA_TYPE uint32 DATA\n0\nEND\n";
  return text + "\n";
}

std::string index_buffer(const DrawCall& call) {
  if (call.indices.empty()) return {};
  return fmt::format("BUFFER indices DATA_TYPE uint32 DATA\n{}\nEND\n\n",
                     fmt::join(call.indices, " "));
}

std::string clear(const Check& check) {
  const bool is_right = check.kind == Check::Kind::fragments && check.fragments == 0;
  const std::string_view colour = is_right ? "0 255 0 255" : "255 0 0 255";
  const bool has_depth = check.kind == Check::Kind::depth;
  return fmt::format("CLEAR_COLOR drawing {}\n{}CLEAR drawing\n", colour,
                     has_depth ? fmt::format("CLEAR_DEPTH drawing {}\n", kNoDepth) : "");
}

std::string run(const DrawCall& call) {
  const std::size_t count = call.indices.empty() ? call.vertices.size() : call.indices.size();
  return fmt::format("RUN drawing DRAW_ARRAY AS {}{} START_IDX 0 COUNT {}\n",
                     amber_name(call.topology), call.indices.empty() ? "" : " INDEXED", count);
}

std::string expectation(const Check& check) {
  if (check.kind == Check::Kind::ends) return {};
  if (check.counts()) {
    const std::string_view comparison = check.comparison() == "=="   ? "EQ"
                                        : check.comparison() == ">=" ? "GE"
                                                                     : "LE";
    return fmt::format("EXPECT fragments IDX 0 {} {}\n", comparison, check.fragments);
  }
  return fmt::format("EXPECT target IDX {} {} SIZE 1 1 EQ_RGBA 0 255 0 255\n", check.x, check.y);
}

// What lies behind the greatest right depth or in front of the least one is painted over in red.
struct DepthBounds {
  std::string buffers, pipelines, runs;
};
DepthBounds depth_bounds(const DrawCall& call, const Check& check) {
  const std::vector<VertexInput> inputs = inputs_of(call, check);
  const Pipeline beyond = {"beyond", "red_shader", "_of_greatest", "less"};
  const Pipeline before = {"before", "red_shader", "_of_least", "greater"};
  const DepthRange range = call.volume.depth;
  return {
      shader("fragment", "red_shader", shaders_of(call, check, Dialect::vulkan, kRed).fragment) +
          vertex_buffers(cover(check.greatest, range), inputs, beyond.suffix) +
          vertex_buffers(cover(check.least, range), inputs, before.suffix),
      pipeline_text(call, check, beyond) + pipeline_text(call, check, before),
      "RUN beyond DRAW_ARRAY AS TRIANGLE_LIST START_IDX 0 COUNT 6\n"
      "RUN before DRAW_ARRAY AS TRIANGLE_LIST START_IDX 0 COUNT 6\n"};
}

// Vulkan by itself takes flat values from the first vertex.
bool can_be_said(const DrawCall& call, const Check& check) {
  return check.quantity != Quantity::flat || call.provoking == ProvokingVertex::first;
}

}  // namespace

std::string amber_script(const Case& it) {
  const std::optional<DrawCall> converted = in_depth_range(it.call, DepthRange::zero_to_one);
  const Check& check = it.check;
  if (!converted || !can_be_said(*converted, check)) return {};
  const DrawCall& call = *converted;
  const bool has_depth = check.kind == Check::Kind::depth;
  const Shaders shaders = shaders_of(call, check, Dialect::vulkan, has_depth ? kGreen : "");
  const DepthBounds bounds = has_depth ? depth_bounds(call, check) : DepthBounds{};
  const Pipeline drawing = {"drawing", "fragment_shader", "", has_depth ? "always" : "",
                            !call.indices.empty()};
  return "#!amber\n" + comment(it, "#") + "\n" + features(call, check) +
         shader("vertex", "vertex_shader", shaders.vertex) +
         shader("fragment", "fragment_shader", shaders.fragment) +
         vertex_buffers(call.vertices, inputs_of(call, check), "") + index_buffer(call) +
         bounds.buffers + images(check) + pipeline_text(call, check, drawing) + bounds.pipelines +
         clear(check) + run(call) + bounds.runs + expectation(check);
}

}  // namespace clipscope::experiments
