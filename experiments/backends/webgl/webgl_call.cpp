// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/webgl/webgl_call.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "backends/webgl/scripts.hpp"

namespace clipscope::experiments {
namespace {

// WebGL's numbers are those of OpenGL ES 3.0.
int mode_of(Topology topology) {
  constexpr std::array<int, names_of(Topology{}).size()> kModes = {0, 1, 3, 4, 5, 6};
  return kModes[static_cast<std::size_t>(topology)];
}

std::string shader_head(const DrawCall& call, const Pass& pass) {
  std::string text = "#version 300 es\n";
  const bool has_noperspective = std::ranges::any_of(pass.outputs, [](const Output& output) {
    return output.quantity == Quantity::noperspective;
  });
  if (has_noperspective) text += "#extension GL_NV_shader_noperspective_interpolation : require\n";
  if (call.volume.clip_distances > 0) text += "#extension GL_ANGLE_clip_cull_distance : require\n";
  return text + "precision highp float;\n";
}

std::string pass_text(const DrawCall& call, const Pass& pass) {
  const ShaderForm form = {call.volume.clip_distances, call.topology == Topology::points,
                           shader_head(call, pass)};
  std::string outputs;
  for (const Output& output : pass.outputs) {
    outputs += fmt::format("{}{{ quantity: '{}', channels: {}, background: {} }}",
                           outputs.empty() ? "" : ", ", names_of(Quantity{})[bit(output.quantity)],
                           output.channels, output.background);
  }
  return fmt::format(
      "{{\n  outputs: [{}],\n  hasDepth: {},\n  addsUp: {},\n  vertex: `{}`,\n  fragment: `{}`,\n}}",
      outputs, pass.has_depth, pass.adds_up, vertex_shader(pass, form),
      fragment_shader(pass, form));
}

// Exact: JavaScript's numbers are doubles.
void add_numbers(std::string& text, const auto& values) {
  for (const float value : values) {
    text += fmt::format("{}{}", text.ends_with('[') ? "" : ", ", static_cast<double>(value));
  }
}

std::string vertex_text(const DrawVertex& vertex) {
  std::string text = "[";
  add_numbers(text, vertex.position);
  add_numbers(text, vertex.varying);
  add_numbers(text, vertex.clip_distances);
  return text + "]";
}

}  // namespace

std::vector<Pass> webgl_passes(const DrawCall& call, std::size_t most_attachments) {
  std::vector<Pass> passes;
  for (Pass& whole : passes_of(call)) {
    for (std::size_t first = 0; first < whole.outputs.size(); first += most_attachments) {
      const std::size_t end = std::min(first + most_attachments, whole.outputs.size());
      Pass& pass = passes.emplace_back(whole);
      pass.outputs = {whole.outputs.begin() + static_cast<std::ptrdiff_t>(first),
                      whole.outputs.begin() + static_cast<std::ptrdiff_t>(end)};
      pass.has_depth = whole.has_depth && first == 0;
    }
  }
  return passes;
}

std::string webgl_call(const DrawCall& call, const std::vector<Pass>& passes) {
  std::string vertices, drawn;
  for (const DrawVertex& vertex : call.vertices) vertices += vertex_text(vertex) + ",\n";
  for (const Pass& pass : passes) drawn += pass_text(call, pass) + ",\n";
  const Viewport& at = call.viewport;
  return fmt::format(
      "{{\nwidth: {}, height: {}, viewport: [{}, {}, {}, {}],\nmode: {}, indices: [{}],\n"
      "pointSize: {}, depthClamp: {}, zeroToOne: {}, clipDistances: {}, provokesFirst: {}, noDepth: {},\n"
      "// Position, values, and clip distances of each vertex.\nvertices: [\n{}],\npasses: [\n{}],\n}}",
      call.width, call.height, at.x, at.y, at.width, at.height, mode_of(call.topology),
      fmt::join(call.indices, ", "), call.point_size, static_cast<bool>(call.volume.depth_clamp),
      call.volume.depth == DepthRange::zero_to_one, call.volume.clip_distances,
      call.provoking == ProvokingVertex::first, kNoDepth, vertices, drawn);
}

std::string_view webgl_drawing() { return kDrawScript; }
std::string_view webgl_host() { return kHostScript; }

}  // namespace clipscope::experiments
