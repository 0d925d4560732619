// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/replay_text.hpp"

#include <fmt/format.h>

#include "experiments/hex_float.hpp"

namespace clipscope::experiments {

std::string_view depth_option(DepthRange depth) {
  switch (depth) {
    case DepthRange::minus_one_to_one: return "gl";
    case DepthRange::zero_to_one: return "zero_to_one";
    case DepthRange::reversed: return "reversed";
  }
  return "";
}

std::string frustum_options(const Frustum<float>& f) {
  return fmt::format("--{} {},{},{},{},{},{}",
                     f.kind == ProjectionKind::perspective ? "frustum" : "ortho", hex_float(f.left),
                     hex_float(f.right), hex_float(f.bottom), hex_float(f.top), hex_float(f.near),
                     f.infinite_far ? "inf" : hex_float(f.far));
}

std::string hex_line(std::span<const reference::InputVertex> vertices, int dimension,
                     int attribute_count) {
  std::string text;
  const auto add = [&](double value) { text += (text.empty() ? "" : " ") + hex_float(value); };
  for (const reference::InputVertex& v : vertices) {
    for (int c = 0; c < dimension; ++c) add(v.position[static_cast<std::size_t>(c)]);
    for (int k = 0; k < attribute_count; ++k) add(v.attributes[static_cast<std::size_t>(k)]);
  }
  return text;
}

}  // namespace clipscope::experiments
