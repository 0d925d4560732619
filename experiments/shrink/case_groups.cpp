// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shrink/case_groups.hpp"

#include <algorithm>

#include "experiments/catalogue/catalogue.hpp"

namespace clipscope::experiments {
namespace {

Batch empty_batch(const HardCase& c) {
  return {.space = c.space,
          .frustum = c.frustum,
          .matrix = c.matrix,
          .volume = c.volume,
          .vertices = static_cast<int>(vertices_of(c.primitive)),
          .attributes = c.attribute_count,
          .planes = c.planes};
}

bool same_matrix(const std::optional<MatrixRows<double>>& a,
                 const std::optional<MatrixRows<double>>& b) {
  if (!a || !b) return !a && !b;
  for (std::size_t row = 0; row < 4; ++row) {
    for (int k = 0; k < 4; ++k) {
      if ((*a)[row][k] != (*b)[row][k]) return false;
    }
  }
  return true;
}

bool belongs(const HardCase& c, const Batch& batch) {
  return batch.space == c.space && batch.volume == c.volume &&
         batch.attributes == c.attribute_count && batch.planes == c.planes &&
         same_matrix(batch.matrix, c.matrix) && (!has_frustum(c) || batch.frustum == c.frustum);
}

}  // namespace

std::deque<CaseGroup> grouped(std::span<const HardCase> cases) {
  std::deque<CaseGroup> groups;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const HardCase& c = cases[i];
    if (!is_finite(c)) continue;
    auto group = std::ranges::find_if(groups, [&](const auto& g) { return belongs(c, g.batch); });
    if (group == groups.end()) {
      groups.push_back({empty_batch(c), {}, {}});
      group = groups.end() - 1;
    }
    group->places.push_back(i);
    for (const auto& [position, values] : c.vertices) {
      std::vector<double>& numbers = group->numbers;
      numbers.insert(numbers.end(), position.begin(), position.begin() + group->batch.dimension());
      numbers.insert(numbers.end(), values.begin(), values.begin() + c.attribute_count);
    }
  }
  for (CaseGroup& group : groups) group.batch.numbers = std::span<const double>(group.numbers);
  return groups;
}

}  // namespace clipscope::experiments
