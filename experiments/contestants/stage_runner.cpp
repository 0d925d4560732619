// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/stage_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

namespace clipscope::experiments {

void StageRunner::clip(std::size_t, std::size_t first, std::size_t count) {
  first_ = first;
  count_ = count;
  clip_stage(first, count);
}

Answers StageRunner::answers() const {
  const StageAnswer a = answer();
  Answers answers(kFormat<float>, input_.stride());
  const auto add = [&](const float* vertex) {
    for (std::size_t i = 0; i < input_.stride(); ++i) answers.add(vertex[i]);
  };
  std::size_t inside = 0, polygon = 0, vertex = 0;
  for (std::size_t t = 0; t < count_; ++t) {
    if (inside < a.inside.size() && a.inside[inside] == t) {
      ++inside;
      answers.listed.push_back(t);
      for (std::size_t v = 0; v < 3; ++v) add(input_.vertex(contract_, first_ + t, v));
    } else if (polygon < a.polygons.size() && a.polygons[polygon].triangle == t) {
      const std::size_t end = a.polygons[polygon++].end;
      for (; vertex < end; ++vertex) add(a.vertices.data() + vertex * input_.stride());
    }
    answers.end_polygon();
  }
  return answers;
}

std::size_t StageRunner::bytes_written() const {
  const StageAnswer a = answer();
  return a.inside.size_bytes() + a.polygons.size_bytes() + a.vertices.size_bytes();
}

std::string StageRunner::malformed() const {
  const StageAnswer a = answer();
  const std::size_t vertices = a.polygons.empty() ? 0 : a.polygons.back().end;
  if (a.vertices.size() != vertices * input_.stride()) {
    return fmt::format("{} floats for {} vertices of {}", a.vertices.size(), vertices,
                       input_.stride());
  }
  std::vector<std::uint32_t> drawn, both;
  for (const batch::PolygonEnd& p : a.polygons) drawn.push_back(p.triangle);
  const auto ascends = [&](const auto& numbers) {
    return std::ranges::adjacent_find(numbers, std::greater_equal()) == numbers.end() &&
           (numbers.empty() || numbers.back() < count_);
  };
  if (!ascends(a.inside) || !ascends(drawn)) {
    return "the numbers of triangles do not ascend, or are not of the input";
  }
  std::ranges::set_intersection(a.inside, drawn, std::back_inserter(both));
  if (both.empty()) return "";
  return fmt::format("triangle {} is listed as inside and drawn", first_ + both.front());
}

}  // namespace clipscope::experiments
