// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/near_tie.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "experiments/table/row.hpp"

namespace clipscope::experiments::worst_cases {
namespace {

using reference::ExactVertex;
using reference::Fraction;

constexpr std::size_t kMarks = 1;  // the first of the barycentric coordinates

Place place_of(const ExactVertex& vertex) {
  const auto first = vertex.attributes.begin() + kMarks;
  const auto away =
      std::count_if(first, first + 3, [](const Fraction& l) { return l.sign() != 0; });
  return static_cast<Place>(away - 1);
}

std::vector<const Fraction*> numbers_of(const ExactVertex& v, Quantity quantity) {
  switch (quantity) {
    case Quantity::xy: return {&v.x, &v.y};
    case Quantity::z: return {&v.z};
    case Quantity::inv_w: return {&v.inv_w};
    case Quantity::attribute: return {&v.attributes.front()};
  }
  return {};
}

// Between the highest and the lowest bit of all of them; 0 where all are 0.
class Bits {
 public:
  void add(double x) {
    if (x == 0) return;
    int exponent = 0;
    auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    exponent -= 53;
    for (; digits % 2 == 0; digits /= 2) ++exponent;
    low_ = std::min(low_, exponent);
    high_ = std::max(high_, std::ilogb(x) + 1);
  }
  int count() const { return high_ == std::numeric_limits<int>::min() ? 0 : high_ - low_; }

 private:
  int low_ = std::numeric_limits<int>::max(), high_ = std::numeric_limits<int>::min();
};

}  // namespace

std::vector<TieKind> all_tie_kinds() {
  std::vector<TieKind> kinds;
  for (const Space space : {Space::clip, Space::view}) {
    for (const Place place : {Place::vertex, Place::edge, Place::corner}) {
      for (const Quantity q : {Quantity::xy, Quantity::z, Quantity::inv_w, Quantity::attribute}) {
        if (place == Place::vertex && q == Quantity::attribute) continue;
        kinds.push_back({space, place, q});
      }
    }
  }
  return kinds;
}

std::string name_of(const TieKind& kind) {
  constexpr std::array kWords = {"xy", "z", "inv_w", "attribute"};
  return fmt::format("{}_{}_{}", kind.space == Space::view ? "view" : "clip",
                     experiments::name_of(kind.place),
                     kWords[static_cast<std::size_t>(kind.quantity)]);
}

std::optional<double> distance_to_tie(const Fraction& value) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float nearest = reference::round_to<float>(value);
  if (std::isinf(nearest)) return std::nullopt;
  const double beyond = reference::error_of(nearest, value);
  if (beyond == 0) return std::nullopt;
  const float other = std::nextafter(nearest, beyond > 0 ? -kInfinity : kInfinity);
  if (std::isinf(other)) return std::nullopt;
  const double tie = (double{nearest} + double{other}) / 2;  // exact: 25 bits
  const double off = std::abs(reference::error_of(tie, value));
  if (off > 0) return off / std::abs(double{nearest} - double{other});
  // Too near for a double to say how near.
  if (!(value == Fraction{tie, 1})) return std::numeric_limits<double>::denorm_min();
  return 0;
}

HardCase marked(HardCase hard_case) {
  hard_case.attribute_count = kMarks;
  fill_attributes(hard_case, kMarks);
  return hard_case;
}

TieTally& TieTally::operator+=(const TieTally& next) {
  numbers += next.numbers;
  ties += next.ties;
  if (!nearest_ulp || (next.nearest_ulp && *next.nearest_ulp < *nearest_ulp)) {
    nearest_ulp = next.nearest_ulp;
  }
  return *this;
}

TieTally tie_tally(const TieKind& kind, const reference::ExactPolygon& polygon) {
  TieTally tally;
  for (const ExactVertex& v : polygon.vertices) {
    if (place_of(v) != kind.place) continue;
    for (const Fraction* number : numbers_of(v, kind.quantity)) {
      const std::optional<double> ulp = distance_to_tie(*number);
      if (!ulp) continue;
      tally += *ulp == 0 ? TieTally{1, 1, {}} : TieTally{1, 0, ulp};
    }
  }
  return tally;
}

double least_distance_ulp(const TieKind& kind) {
  constexpr double kM = 0x1p24 - 1;
  const bool is_of_weights = kind.quantity == Quantity::attribute;
  switch (kind.place) {
    case Place::vertex: return 1 / (2 * kM);
    case Place::edge: return 1 / (2 * (is_of_weights ? 4 * kM - 1 : kM * (2 * kM - 1)));
    case Place::corner: return 1 / (2 * (is_of_weights ? 16 * kM * kM : 4 * kM * kM * kM));
  }
  return 0;
}

bool has_one_exponent(const HardCase& hard_case) {
  constexpr int kDigits = 24;
  Bits coordinates, attributes;
  const std::size_t dimension = hard_case.space == Space::view ? 3 : 4;
  for (const reference::InputVertex& v : hard_case.vertices) {
    for (const double x : std::span(v.position).first(dimension)) coordinates.add(x);
    attributes.add(v.attributes.front());
  }
  return coordinates.count() <= kDigits && attributes.count() <= kDigits;
}

}  // namespace clipscope::experiments::worst_cases
