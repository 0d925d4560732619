// SPDX-License-Identifier: GPL-3.0-or-later
//
// Piglit's shader_runner draws from lists of vertices alone, so vertices that are indexed are
// written as often as they are used, and it has no depth range but that of -1 to 1.
#include <fmt/format.h>

#include "experiments/reproductions/formats.hpp"
#include "experiments/reproductions/shaders.hpp"

namespace clipscope::experiments {
namespace {

std::string_view gl_name(Topology topology) {
  constexpr std::array<std::string_view, names_of(Topology{}).size()> kNames = {
      "GL_POINTS",    "GL_LINES",          "GL_LINE_STRIP",
      "GL_TRIANGLES", "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN"};
  return kNames[static_cast<std::size_t>(topology)];
}

bool has_own_viewport(const DrawCall& call) {
  return call.viewport != Viewport{0, 0, call.width, call.height};
}

bool has_own_provoking_vertex(const DrawCall& call, const Check& check) {
  return check.quantity == Quantity::flat && call.provoking == ProvokingVertex::first;
}

std::string requirements(const DrawCall& call, const Check& check) {
  std::string text =
      fmt::format("[require]\nGL >= 3.3\nGLSL >= 3.30\nSIZE {} {}\n", call.width, call.height);
  if (check.kind == Check::Kind::depth) text += "depthbuffer\n";
  if (check.counts()) text += "GL_ARB_shader_atomic_counters\n";
  if (has_own_viewport(call)) text += "GL_ARB_viewport_array\n";
  if (has_own_provoking_vertex(call, check)) text += "GL_EXT_provoking_vertex\n";
  return text;
}

std::vector<DrawVertex> drawn_vertices(const DrawCall& call) {
  if (call.indices.empty()) return call.vertices;
  std::vector<DrawVertex> vertices;
  for (const std::uint32_t index : call.indices) vertices.push_back(call.vertices[index]);
  return vertices;
}

std::string vertex_data(const std::vector<DrawVertex>& vertices,
                        const std::vector<VertexInput>& inputs) {
  std::string text;
  for (const VertexInput& input : inputs) text += fmt::format("{}/float/vec4 ", input.name);
  text.back() = '\n';
  for (const DrawVertex& vertex : vertices) {
    for (const VertexInput& input : inputs) text += input_text(input, vertex) + "  ";
    text.replace(text.size() - 2, 2, "\n");
  }
  return text;
}

std::string state(const DrawCall& call, const Check& check) {
  std::string text;
  if (has_own_viewport(call)) {
    const Viewport& at = call.viewport;
    text += fmt::format("viewport indexed 0 {} {} {} {}\n", at.x, at.y, at.width, at.height);
  }
  if (call.topology == Topology::points) text += "enable GL_PROGRAM_POINT_SIZE\n";
  if (call.volume.depth_clamp) text += "enable GL_DEPTH_CLAMP\n";
  for (int i = 0; i < call.volume.clip_distances; ++i) {
    text += fmt::format("enable GL_CLIP_PLANE{}\n", i);
  }
  if (has_own_provoking_vertex(call, check)) text += "provoking vertex first\n";
  return text;
}

// Depth that is right leaves the green of the primitive; what lies in front of the least or behind
// the greatest one is painted over in red.
std::string depth_test(const std::string& draw, std::size_t drawn) {
  return fmt::format(R"(enable GL_DEPTH_TEST
depthfunc GL_ALWAYS
uniform vec4 paint 0.0 1.0 0.0 1.0
{}uniform vec4 paint 1.0 0.0 0.0 1.0
depthfunc GL_LESS
draw arrays GL_TRIANGLES {} 6
depthfunc GL_GREATER
draw arrays GL_TRIANGLES {} 6
)",
                     draw, drawn, drawn + 6);
}

std::string probe(const Check& check) {
  if (check.kind == Check::Kind::ends) return {};
  if (check.counts()) {
    return fmt::format("probe atomic counter 0 {} {}\n", check.comparison(), check.fragments);
  }
  return fmt::format("probe rgba {} {} 0.0 1.0 0.0 1.0\n", check.x, check.y);
}

}  // namespace

std::string piglit_test(const Case& it) {
  const std::optional<DrawCall> call = in_depth_range(it.call, DepthRange::minus_one_to_one);
  if (!call) return {};
  const Check& check = it.check;
  const bool is_depth = check.kind == Check::Kind::depth;
  const Shaders shaders = shaders_of(*call, check, Dialect::opengl, is_depth ? "paint" : "");
  std::vector<DrawVertex> vertices = drawn_vertices(*call);
  const std::size_t count = vertices.size();
  std::string draw = fmt::format("draw arrays {} 0 {}\n", gl_name(call->topology), count);
  if (is_depth) {
    draw = depth_test(draw, count);
    for (const float bound : {check.greatest, check.least}) {
      const std::vector<DrawVertex> plane = cover(bound, call->volume.depth);
      vertices.insert(vertices.end(), plane.begin(), plane.end());
    }
  }
  // Where no fragment shall be the clear colour is the right one.
  const bool is_clear_right = check.kind == Check::Kind::fragments && check.fragments == 0;
  return fmt::format(
      "{}\n{}\n[vertex shader]\n{}\n[fragment shader]\n{}\n[vertex data]\n{}\n"
      "[test]\n{}{}clear color {} 1.0\n{}clear\n{}{}",
      comment(it, "#"), requirements(*call, check), shaders.vertex, shaders.fragment,
      vertex_data(vertices, inputs_of(*call, check)), state(*call, check),
      check.counts() ? "atomic counters 1\n" : "", is_clear_right ? "0.0 1.0 0.0" : "1.0 0.0 0.0",
      is_depth ? fmt::format("clear depth {}\n", kNoDepth) : "", draw, probe(check));
}

}  // namespace clipscope::experiments
