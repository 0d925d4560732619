// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/promise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "experiments/judge/cycle.hpp"
#include "experiments/table/hex_float.hpp"

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

bool is_repeated(const Row& row, const std::vector<Row>& exact, Likeness likeness) {
  constexpr std::size_t kPlace = 3;
  return std::ranges::any_of(exact,
                             [&](const Row& e) { return same_vertex(row, e, kPlace, likeness); });
}

std::string name(std::size_t i) {
  constexpr std::array kNames = {"x", "y", "z", "1/w"};
  return i < kNames.size() ? kNames[i] : fmt::format("attribute {}", i - kNames.size());
}

std::string complaint(std::size_t vertex, const Row& is, const Row& nearest, Likeness likeness) {
  std::size_t i = 0;
  while (same_number(is[i], nearest[i], likeness)) ++i;
  return fmt::format("not correctly rounded: vertex {}, {} is {}, the nearest float {}", vertex,
                     name(i), hex_float(is[i]), hex_float(nearest[i]));
}

std::string complaint_about(const std::vector<Row>& exact, const PolygonView& polygon,
                            Likeness likeness) {
  if (polygon.empty() && exact.size() < 3) return {};
  if (polygon.size() < exact.size()) {
    return fmt::format("not correctly rounded: {} vertices, exactly {}", polygon.size(),
                       exact.size());
  }
  std::size_t found = 0;
  for (std::size_t v = 0; v < polygon.size(); ++v) {
    const Row row = floats_of(polygon[v]);
    if (found < exact.size() && same_vertex(row, exact[found], likeness)) {
      ++found;
      continue;
    }
    const bool is_spare = polygon.size() - v > exact.size() - found;
    if (is_spare && is_repeated(row, exact, likeness)) continue;
    return found < exact.size()
               ? complaint(v, row, exact[found], likeness)
               : fmt::format("not correctly rounded: vertex {} is not of the exact polygon", v);
  }
  return {};
}

}  // namespace

std::string misrounded(const reference::Truth& truth,
                       std::span<const reference::InputVertex> vertices, int attribute_count,
                       const PolygonView& polygon) {
  return complaint_about(rounded(reference::clip(truth, vertices, attribute_count)), polygon,
                         Likeness::by_bits);
}

std::string misrounded_in_any_order(const reference::ExactPolygon& exact,
                                    const PolygonView& polygon) {
  std::vector<Row> rows = rounded(exact);
  const std::string first = complaint_about(rows, polygon, Likeness::by_value);
  for (std::size_t i = 1; i < rows.size() && !first.empty(); ++i) {
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    if (complaint_about(rows, polygon, Likeness::by_value).empty()) return {};
  }
  return first;
}

}  // namespace clipscope::experiments
