// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/replay_text.hpp"

#include <fmt/format.h>

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
  return fmt::format("--{} {:a},{:a},{:a},{:a},{:a},{}",
                     f.kind == ProjectionKind::perspective ? "frustum" : "ortho", f.left, f.right,
                     f.bottom, f.top, f.near, f.infinite_far ? "inf" : fmt::format("{:a}", f.far));
}

std::string hex_line(std::span<const reference::InputVertex> vertices, int dimension,
                     int attribute_count) {
  std::string text;
  const auto add = [&](double value) {
    text += fmt::format("{}{:a}", text.empty() ? "" : " ", value);
  };
  for (const reference::InputVertex& v : vertices) {
    for (int c = 0; c < dimension; ++c) add(v.position[static_cast<std::size_t>(c)]);
    for (int k = 0; k < attribute_count; ++k) add(v.attributes[static_cast<std::size_t>(k)]);
  }
  return text;
}

}  // namespace clipscope::experiments
