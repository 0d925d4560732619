// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/gl/shaders.hpp"

#include <algorithm>
#include <array>

namespace clipscope::experiments {
namespace {

constexpr Output kCovered = {Quantity::covered, "vec4(1)"};
// No more of them than attachments less the one for coverage.
constexpr std::array<Output, 7> kTogether = {
    {{Quantity::smooth, "smooth_value", 4},
     {Quantity::noperspective, "noperspective_value", 4},
     {Quantity::flat, "flat_value", 4},
     {Quantity::frag_coord, "gl_FragCoord", 4},
     {Quantity::facing, "vec4(gl_FrontFacing ? 1.0 : -1.0)"},
     {Quantity::clip_distances, "", 4},  // by their number, see four_distances
     {Quantity::clip_distances, "", 4, 4}}};
constexpr Output kHits = {Quantity::hits, "vec4(1, gl_FrontFacing ? 1 : 0, 0, 0)", 2};
constexpr Output kPrimitive = {Quantity::primitive_id, "vec4(gl_PrimitiveID)", 1, 0, -1};

bool has(const Pass& pass, Quantity quantity) {
  return std::ranges::any_of(pass.outputs,
                             [&](const Output& output) { return output.quantity == quantity; });
}

// The varyings that the pass interpolates, as `direction` ("in" or "out") has them.
std::string varyings(const Pass& pass, const std::string& direction) {
  std::string text;
  for (const Quantity quantity : {Quantity::smooth, Quantity::noperspective, Quantity::flat}) {
    if (!has(pass, quantity)) continue;
    const std::string name(names_of(Quantity{})[bit(quantity)]);
    text += name + " " + direction + " vec4 " + name + "_value;\n";
  }
  return text;
}

std::string distances(const std::string& direction, const ShaderForm& form) {
  return direction + " float gl_ClipDistance[" + std::to_string(form.clip_distances) + "];\n";
}

// A vec4 of those from `first` on; what is beyond their number is 0.
std::string four_distances(std::size_t first, const ShaderForm& form) {
  std::string text;
  for (std::size_t i = first; i < first + 4; ++i) {
    const bool is_there = i < static_cast<std::size_t>(form.clip_distances);
    text += (text.empty() ? "" : ", ") +
            (is_there ? "gl_ClipDistance[" + std::to_string(i) + "]" : std::string("0"));
  }
  return "vec4(" + text + ")";
}

std::string expression(const Output& output, const ShaderForm& form) {
  if (output.quantity == Quantity::clip_distances) return four_distances(output.first, form);
  return std::string(output.expression);
}

}  // namespace

std::vector<Pass> passes_of(const DrawCall& call) {
  Pass together = {{kCovered}, call.quantities[bit(Quantity::depth)]};
  for (const Output& output : kTogether) {
    const bool is_beyond = output.quantity == Quantity::clip_distances &&
                           static_cast<int>(output.first) >= call.volume.clip_distances;
    if (call.quantities[bit(output.quantity)] && !is_beyond) together.outputs.push_back(output);
  }
  std::vector<Pass> passes = {std::move(together), {{kHits}, false, true}};
  if (call.quantities[bit(Quantity::primitive_id)]) passes.push_back({{kPrimitive}});
  return passes;
}

std::string vertex_shader(const Pass& pass, const ShaderForm& form) {
  std::string text = form.head + "layout(location = 0) in vec4 position;\n";
  std::string body = "  gl_Position = position;\n";
  const std::string passed_on = varyings(pass, "out");
  if (!passed_on.empty()) text += "layout(location = 1) in vec4 varying_value;\n" + passed_on;
  for (const Quantity quantity : {Quantity::smooth, Quantity::noperspective, Quantity::flat}) {
    if (!has(pass, quantity)) continue;
    body += "  " + std::string(names_of(Quantity{})[bit(quantity)]) + "_value = varying_value;\n";
  }
  if (form.clip_distances > 0) text += distances("out", form);
  for (int i = 0; i < form.clip_distances; ++i) {
    const std::string half = i < 4 ? "low" : "high";
    if (i % 4 == 0) {
      text += "layout(location = " + std::to_string(2 + i / 4) + ") in vec4 " + half + ";\n";
    }
    body += "  gl_ClipDistance[" + std::to_string(i) + "] = " + half + "[" + std::to_string(i % 4) +
            "];\n";
  }
  if (form.is_point) {
    text += "uniform float point_size;\n";
    body += "  gl_PointSize = point_size;\n";
  }
  return text + "void main() {\n" + body + "}\n";
}

std::string fragment_shader(const Pass& pass, const ShaderForm& form) {
  std::string text = form.head + varyings(pass, "in");
  if (has(pass, Quantity::clip_distances)) text += distances("in", form);
  std::string body;
  for (std::size_t k = 0; k < pass.outputs.size(); ++k) {
    const std::string name = "output_" + std::to_string(k);
    text += "layout(location = " + std::to_string(k) + ") out vec4 " + name + ";\n";
    body += "  " + name + " = " + expression(pass.outputs[k], form) + ";\n";
  }
  return text + "void main() {\n" + body + "}\n";
}

}  // namespace clipscope::experiments
