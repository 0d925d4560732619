// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/draw_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "experiments/table/row.hpp"

namespace clipscope::experiments {
namespace {

std::string vertices_text(const DrawCall& call, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, call.vertices.size()); ++i) {
    const auto& p = call.vertices[i].position;
    text += fmt::format("{}({},{},{},{})", i == 0 ? "" : " ", p[0], p[1], p[2], p[3]);
    const auto& d = call.vertices[i].clip_distances;
    if (call.volume.clip_distances == 0) continue;
    text += fmt::format("[{}]", fmt::join(d.begin(), d.begin() + call.volume.clip_distances, ","));
  }
  if (call.vertices.size() > most) {
    text += fmt::format(" and {} more vertices", call.vertices.size() - most);
  }
  return text;
}

std::string clamped_text(DepthClamp clamp) {
  if (!clamp) return "";
  return clamp.near && clamp.far ? ", depth clamp" : ", depth clamp of one plane";
}

std::string viewport_text(const DrawCall& call) {
  const Viewport& v = call.viewport;
  const std::string text = fmt::format(", {} x {} px", call.width, call.height);
  if (has_whole_viewport(call)) return text;
  return text + fmt::format(", viewport {} x {} at ({}, {})", v.width, v.height, v.x, v.y);
}

}  // namespace

std::string draw_text(const DrawCall& call, std::size_t most_vertices) {
  std::string text =
      fmt::format("{} {}", name_of(call.topology), vertices_text(call, most_vertices));
  if (!call.indices.empty() && call.indices.size() <= 2 * most_vertices) {
    text += fmt::format(", indices {}", fmt::join(call.indices, " "));
  } else if (!call.indices.empty()) {
    text += fmt::format(", {} indices", call.indices.size());
  }
  if (call.volume.depth == DepthRange::zero_to_one) text += ", depth 0 to 1";
  text += clamped_text(call.volume.depth_clamp);
  if (primitive_of(call.topology) == Primitive::point && call.point_size != 1) {
    text += fmt::format(", size {}", call.point_size);
  }
  return text + viewport_text(call);
}

std::string pixel_text(const Violation& violation) {
  const WorstPixel& worst = violation.worst;
  const std::string returned =
      std::isnan(worst.returned) ? "NaN" : fmt::format("{:.9g}", worst.returned);
  return fmt::format("pixel ({}, {}) is {}, exact {:.9g}", worst.x, worst.y, returned, worst.exact);
}

std::string section_text(const Clause& clause) {
  return fmt::format("{}, section {}", clause.document, clause.section);
}

std::string api_text(const DriverInfo& info) {
  const std::string_view name = name_of(info.api);
  if (info.api_version.starts_with(name)) return info.api_version;
  return fmt::format("{} {}", name, info.api_version);
}

std::string driver_text(const DriverInfo& info) {
  std::string text = info.renderer;
  if (!info.version.empty()) text += ", " + info.version;
  return text + fmt::format(", {}, {} sub-pixel bits", api_text(info), info.subpixel_bits);
}

std::string finding_text(const FindingKey& key) {
  return fmt::format("{} {}: {}", name_of(key.quantity), name_of(key.kind),
                     to_string(key.circumstances));
}

std::string file_stem(std::string finding_text) {
  std::erase_if(finding_text, [](char c) { return c == ',' || c == ':'; });
  std::ranges::replace(finding_text, ' ', '_');
  return finding_text;
}

}  // namespace clipscope::experiments
