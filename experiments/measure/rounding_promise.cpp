// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/rounding_promise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "experiments/hex_float.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {
namespace {

using Row = std::vector<float>;  // x, y, z, 1/w, attributes

std::vector<Row> rounded(const reference::ExactPolygon& exact) {
  using reference::round_to;
  std::vector<Row> r;
  for (const reference::ExactVertex& v : exact.vertices) {
    Row& row = r.emplace_back(Row{round_to<float>(v.x), round_to<float>(v.y), round_to<float>(v.z),
                                  round_to<float>(v.inv_w)});
    if (std::isinf(row[2])) return {};
    for (const reference::Fraction& a : v.attributes) row.push_back(round_to<float>(a));
  }
  return r;
}

template <int K>
Row row_of(const NdcVertex<float, K>& v) {
  Row row;
  for (int i = 0; i < 4; ++i) row.push_back(v.position[i]);
  for (int k = 0; k < v.attributes.size(); ++k) row.push_back(v.attributes[k]);
  return row;
}

// The first of the first `count` coordinates in which two rows differ, else count.
std::size_t difference(const Row& a, const Row& b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i])) return i;
  }
  return count;
}

bool is_repeated(const Row& row, const std::vector<Row>& exact) {
  constexpr std::size_t kPlace = 3;
  return std::ranges::any_of(exact,
                             [&](const Row& e) { return difference(row, e, kPlace) == kPlace; });
}

std::string name(std::size_t i) {
  constexpr std::array kNames = {"x", "y", "z", "1/w"};
  return i < kNames.size() ? kNames[i] : fmt::format("attribute {}", i - kNames.size());
}

std::string complaint(std::size_t vertex, const Row& is, const Row& nearest) {
  const std::size_t i = difference(is, nearest, is.size());
  return fmt::format("not correctly rounded: vertex {}, {} is {}, the nearest float {}", vertex,
                     name(i), hex_float(is[i]), hex_float(nearest[i]));
}

}  // namespace

template <int K>
std::string misrounded(const reference::Truth& truth, const reference::InputTriangle& triangle,
                       std::span<const NdcVertex<float, K>> polygon) {
  const std::vector<Row> exact = rounded(reference::clip(truth, triangle));
  if (polygon.empty() && exact.size() < 3) return {};
  if (polygon.size() < exact.size()) {
    return fmt::format("not correctly rounded: {} vertices, exactly {}", polygon.size(),
                       exact.size());
  }
  std::size_t found = 0;
  for (std::size_t v = 0; v < polygon.size(); ++v) {
    const Row row = row_of<K>(polygon[v]);
    if (found < exact.size() && difference(row, exact[found], row.size()) == row.size()) {
      ++found;
      continue;
    }
    const bool is_spare = polygon.size() - v > exact.size() - found;
    if (is_spare && is_repeated(row, exact)) continue;
    return found < exact.size()
               ? complaint(v, row, exact[found])
               : fmt::format("not correctly rounded: vertex {} is not of the exact polygon", v);
  }
  return {};
}

template std::string misrounded(const reference::Truth&, const reference::InputTriangle&,
                                std::span<const NdcVertex<float, kSceneAttributes>>);
template std::string misrounded(const reference::Truth&, const reference::InputTriangle&,
                                std::span<const NdcVertex<float, kRunTime>>);

}  // namespace clipscope::experiments
