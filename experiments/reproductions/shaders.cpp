// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproductions/shaders.hpp"

#include <fmt/format.h>

#include <array>

namespace clipscope::experiments {
namespace {

constexpr std::array<char, 4> kComponents = {'x', 'y', 'z', 'w'};

// How the varying is interpolated; empty where the quantity is none.
std::string_view interpolation(Quantity quantity) {
  switch (quantity) {
    case Quantity::smooth: return "smooth";
    case Quantity::noperspective: return "noperspective";
    case Quantity::flat: return "flat";
    default: return {};
  }
}

std::string location(Dialect dialect, std::size_t number) {
  return dialect == Dialect::vulkan ? fmt::format("layout(location = {}) ", number) : "";
}

std::string_view version(Dialect dialect) {
  return dialect == Dialect::vulkan ? "#version 450\n" : "#version 330\n";
}

// "smooth out vec4 value;" or its like, if there is one.
std::string varying_text(const Check& check, Dialect dialect, std::string_view direction) {
  const std::string_view kind = interpolation(check.quantity);
  if (kind.empty()) return {};
  return fmt::format("{}{} {} vec4 value;\n", location(dialect, 0), kind, direction);
}

std::string distances_text(const DrawCall& call, std::string_view direction) {
  return fmt::format("{} float gl_ClipDistance[{}];\n", direction, call.volume.clip_distances);
}

std::string vertex_shader(const DrawCall& call, const Check& check, Dialect dialect) {
  std::string text(version(dialect));
  const std::vector<VertexInput> inputs = inputs_of(call, check);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    text += fmt::format("{}in vec4 {};\n", location(dialect, i), inputs[i].name);
  }
  text += varying_text(check, dialect, "out");
  if (call.volume.clip_distances > 0) text += distances_text(call, "out");
  text += "\nvoid main() {\n  gl_Position = position;\n";
  if (!interpolation(check.quantity).empty()) text += "  value = values;\n";
  for (std::size_t i = 0; i < static_cast<std::size_t>(call.volume.clip_distances); ++i) {
    text += fmt::format("  gl_ClipDistance[{}] = {}.{};\n", i,
                        i < 4 ? "distances" : "more_distances", kComponents[i % 4]);
  }
  if (call.topology == Topology::points) {
    text += fmt::format("  gl_PointSize = {};\n", decimal_text(call.point_size));
  }
  return text + "}\n";
}

// What the shader reads, as a float; empty where it reads nothing.
std::string read_text(const Check& check, Dialect dialect) {
  const char component = kComponents[check.channel % 4];
  switch (check.quantity) {
    case Quantity::smooth:
    case Quantity::noperspective:
    case Quantity::flat: return fmt::format("value.{}", component);
    case Quantity::frag_coord: return fmt::format("gl_FragCoord.{}", component);
    // Amber calls counter-clockwise in a window front whose y points down.
    case Quantity::facing:
      return dialect == Dialect::vulkan ? "gl_FrontFacing ? -1.0 : 1.0"
                                        : "gl_FrontFacing ? 1.0 : -1.0";
    case Quantity::primitive_id: return "float(gl_PrimitiveID)";
    case Quantity::clip_distances: return fmt::format("gl_ClipDistance[{}]", check.channel);
    default: return {};
  }
}

// The colour by what was read: `it`.
std::string judging_text(const Check& check) {
  return fmt::format(R"(  bool is_number = (floatBitsToUint(it) & 0x7f800000u) != 0x7f800000u;
  bool is_right = is_number && it >= {} && it <= {};
  colour = is_right ? {} : {};
)",
                     decimal_text(check.least), decimal_text(check.greatest), kGreen, kRed);
}

std::string counting_text(const Check& check, Dialect dialect) {
  const std::string_view count = dialect == Dialect::opengl ? "atomicCounterIncrement(fragments);\n"
                                                            : "atomicAdd(fragments, 1u);\n";
  switch (check.region) {
    case Check::Region::pixel:
      return fmt::format("  if (ivec2(gl_FragCoord.xy) == ivec2({}, {})) {}", check.x, check.y,
                         count);
    case Check::Region::column:
      return fmt::format("  if (int(gl_FragCoord.x) == {}) {}", check.x, count);
    case Check::Region::row:
      return fmt::format("  if (int(gl_FragCoord.y) == {}) {}", check.y, count);
    case Check::Region::target: return fmt::format("  {}", count);
  }
  return {};
}

std::string body_text(const Check& check, Dialect dialect, std::string_view paint) {
  const std::string read = read_text(check, dialect);
  std::string text = read.empty() ? "" : fmt::format("  float it = {};\n", read);
  if (check.kind == Check::Kind::value) return text + judging_text(check);
  std::string colour(paint.empty() ? check.fragments > 0 ? kGreen : kRed : paint);
  if (check.counts()) text += counting_text(check, dialect);
  // What is read has to matter, or the compiler leaves it out.
  if (!read.empty()) colour = fmt::format("it == -12345.0 ? vec4(0.0, 0.0, 1.0, 1.0) : {}", colour);
  return text + fmt::format("  colour = {};\n", colour);
}

std::string fragment_shader(const DrawCall& call, const Check& check, Dialect dialect,
                            std::string_view paint) {
  std::string text(version(dialect));
  const bool is_opengl = dialect == Dialect::opengl;
  if (check.counts() && is_opengl) text += "#extension GL_ARB_shader_atomic_counters : require\n";
  text += varying_text(check, dialect, "in");
  if (check.quantity == Quantity::clip_distances) text += distances_text(call, "in");
  if (check.counts()) {
    text += is_opengl ? "layout(binding = 0, offset = 0) uniform atomic_uint fragments;\n"
                      : "layout(set = 0, binding = 0) buffer Count { uint fragments; };\n";
  }
  if (paint == "paint") text += "uniform vec4 paint;\n";
  text += fmt::format("{}out vec4 colour;\n\nvoid main() {{\n", location(dialect, 0));
  return text + body_text(check, dialect, paint) + "}\n";
}

}  // namespace

Shaders shaders_of(const DrawCall& call, const Check& check, Dialect dialect,
                   std::string_view paint) {
  return {vertex_shader(call, check, dialect), fragment_shader(call, check, dialect, paint)};
}

std::vector<VertexInput> inputs_of(const DrawCall& call, const Check& check) {
  std::vector<VertexInput> inputs = {
      {"position", [](const DrawVertex& vertex) { return vertex.position; }}};
  if (!interpolation(check.quantity).empty()) {
    inputs.push_back({"values", [](const DrawVertex& vertex) { return vertex.varying; }});
  }
  using Four = std::array<float, 4>;
  if (call.volume.clip_distances > 0) {
    inputs.push_back({"distances", [](const DrawVertex& vertex) {
                        const auto& d = vertex.clip_distances;
                        return Four{d[0], d[1], d[2], d[3]};
                      }});
  }
  if (call.volume.clip_distances > 4) {
    inputs.push_back({"more_distances", [](const DrawVertex& vertex) {
                        const auto& d = vertex.clip_distances;
                        return Four{d[4], d[5], d[6], d[7]};
                      }});
  }
  return inputs;
}

std::string input_text(const VertexInput& input, const DrawVertex& vertex) {
  const std::array<float, 4> values = input.of(vertex);
  return fmt::format("{} {} {} {}", decimal_text(values[0]), decimal_text(values[1]),
                     decimal_text(values[2]), decimal_text(values[3]));
}

std::vector<DrawVertex> cover(float window_depth, DepthRange range) {
  const float z = range == DepthRange::minus_one_to_one ? 2 * window_depth - 1 : window_depth;
  std::vector<DrawVertex> vertices;
  for (const auto& [x, y] :
       {std::pair{-1.f, -1.f}, {1.f, -1.f}, {-1.f, 1.f}, {1.f, -1.f}, {-1.f, 1.f}, {1.f, 1.f}}) {
    DrawVertex& vertex = vertices.emplace_back();
    vertex.position = {x, y, z, 1};
    vertex.clip_distances.fill(1);
  }
  return vertices;
}

}  // namespace clipscope::experiments
