// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/depth/depth_precision.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/contestants/scalars.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kPairs = 64;
// The pairs lie within 1/64 of the distance, over which no convention's resolution changes by more than
// 4 %.
constexpr double kNeighbourhood = 1.0 / 64;

// Whether pairs that are `gap` metres apart are told apart.
bool are_separated(const DepthBuffer& buffer, float distance, bool away, double gap) {
  for (int i = 0; i < kPairs; ++i) {
    const double shift = kNeighbourhood * i / kPairs * distance;
    const float first = static_cast<float>(away ? distance + shift : distance - shift);
    const float second = static_cast<float>(away ? first + gap : first - gap);
    const std::int64_t a = buffer.code(first), b = buffer.code(second);
    if (!(away ? a < b : b < a)) return false;
  }
  return true;
}

}  // namespace

std::vector<float> spread_distances(float near, float far, std::size_t count, Random& random) {
  std::vector<float> distances;
  const double octaves = std::log2(double{far} / near);
  for (std::size_t i = 0; i < count; ++i) {
    const double place = (static_cast<double>(i) + random.uniform()) / static_cast<double>(count);
    const double distance = near * std::exp2(octaves * place);
    const float d = std::clamp(static_cast<float>(distance), near, far);
    if (distances.empty() || distances.back() < d) distances.push_back(d);
  }
  return distances;
}

NeighbourOrder neighbour_order(const DepthBuffer& buffer, std::span<const float> distances) {
  NeighbourOrder order;
  for (std::size_t i = 1; i < distances.size(); ++i) {
    const std::int64_t nearer = buffer.code(distances[i - 1]), farther = buffer.code(distances[i]);
    ++order.pairs;
    order.misordered += farther < nearer;
    order.tied += farther == nearer;
  }
  return order;
}

std::size_t distinct_values(const DepthBuffer& buffer, std::span<const float> distances) {
  std::vector<std::int64_t> codes;
  for (const float d : distances) codes.push_back(buffer.code(d));
  std::ranges::sort(codes);
  return static_cast<std::size_t>(std::unique(codes.begin(), codes.end()) - codes.begin());
}

LargestError largest_error(const DepthBuffer& buffer, std::span<const float> distances,
                           std::size_t stride) {
  LargestError largest;
  for (std::size_t i = 0; i < distances.size(); i += stride) {
    const double error = buffer.error_ulp(distances[i]);
    if (error > largest.ulp) largest = {error, distances[i]};
  }
  return largest;
}

std::optional<double> resolution(const DepthBuffer& buffer, float distance) {
  const bool away = distance == buffer.near();
  const double spacing = ulp_at<float>(distance);
  // What leaves every pair within the range of distances.
  const double room = away ? buffer.far() - (1 + kNeighbourhood) * distance
                           : (1 - kNeighbourhood) * distance - buffer.near();
  const auto most = std::max(std::int64_t{1}, static_cast<std::int64_t>(room / spacing));
  const auto enough_at = [&](std::int64_t steps) {
    return are_separated(buffer, distance, away, static_cast<double>(steps) * spacing);
  };
  std::int64_t too_small = 0, enough = 1;
  while (!enough_at(enough)) {
    if (enough == most) return std::nullopt;
    too_small = enough;
    enough = std::min(2 * enough, most);
  }
  while (enough - too_small > 1) {
    const std::int64_t middle = too_small + (enough - too_small) / 2;
    (enough_at(middle) ? enough : too_small) = middle;
  }
  return static_cast<double>(enough) * spacing;
}

}  // namespace clipscope::experiments
