// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/pixels/accuracy.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments {

Cuts::Cuts(const DrawCall& call, std::span<const std::uint32_t> vertices) {
  std::vector<reference::InputVertex> input(3);
  const auto distances = static_cast<std::size_t>(call.volume.clip_distances);
  for (std::size_t i = 0; i < 3; ++i) {
    const DrawVertex& v = call.vertices[vertices[i]];
    std::copy(v.position.begin(), v.position.end(), input[i].position.begin());
    std::copy_n(v.clip_distances.begin(), distances, input[i].attributes.begin());
    input[i].attributes[distances + i] = 1;
    w_[i] = v.position[3];
  }
  const auto polygon = reference::clip(reference::Truth::of_clip(call.volume), input,
                                       static_cast<int>(distances) + 3);
  for (const reference::ExactVertex& vertex : polygon.vertices) {
    Corner corner;
    for (std::size_t i = 0; i < 3; ++i) {
      corner.weights[i] = reference::approximate(vertex.attributes[distances + i]);
    }
    corner.w = 1 / reference::approximate(vertex.inv_w);
    corners_.push_back(corner);
  }
}

double Cuts::slack(const std::array<double, 3>& d) const {
  const auto [least, greatest] = std::minmax_element(d.begin(), d.end());
  if (*least >= 0 || *greatest < 0) return 0;
  double w = std::numeric_limits<double>::infinity();  // the least of the border
  for (const Corner& corner : corners_) {
    double distance = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      distance += corner.weights[i] * d[i];
      size += corner.weights[i] * std::abs(d[i]);
    }
    if (std::abs(distance) <= 0x1p-40 * size) w = std::min(w, corner.w);
  }
  // Where none of the border is in the volume, the cuts of the edges stand for it.
  const bool is_in_volume = std::isfinite(w);
  for (std::size_t i = 0; i < 3 && !is_in_volume; ++i) {
    const std::size_t j = (i + 1) % 3;
    if ((d[i] < 0) == (d[j] < 0)) continue;
    const double there = (std::abs(d[j]) * w_[i] + std::abs(d[i]) * w_[j]) / std::abs(d[i] - d[j]);
    if (there > 0) w = std::min(w, there);
  }
  return kEpsilon * kClip * (*greatest - *least) / w;
}

}  // namespace clipscope::experiments
