// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproductions/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace clipscope::experiments {
namespace {

bool is_of_coverage(ViolationKind kind) {
  switch (kind) {
    case ViolationKind::missing:
    case ViolationKind::extra:
    case ViolationKind::zero_area:
    case ViolationKind::shared_edge:
    case ViolationKind::primitive_lost: return true;
    default: return false;
  }
}

bool is_varying(Quantity quantity) {
  return quantity == Quantity::smooth || quantity == Quantity::noperspective ||
         quantity == Quantity::flat;
}

// The least and the greatest value of the vertices, where the quantity is one of theirs.
std::pair<double, double> hull(const DrawCall& call, const Check& check) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const DrawVertex& vertex : call.vertices) {
    const double value = is_varying(check.quantity) ? vertex.varying[check.channel]
                                                    : vertex.clip_distances[check.channel];
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  return {least, greatest};
}

// How far from the exact value is still right: in the middle, by ratio, between what is allowed and
// what came. Where no number came, as far as values of that kind lie apart.
double tolerance_of(const DrawCall& call, const Violation& violation, const Check& check) {
  const double error = std::abs(violation.worst.returned - violation.worst.exact);
  if (std::isfinite(error)) {
    const bool is_measured = std::isfinite(violation.size) && violation.size > 1 &&
                             violation.kind != ViolationKind::outside_hull;
    return is_measured ? error / std::sqrt(violation.size) : error / 2;
  }
  const bool is_of_vertices =
      is_varying(check.quantity) || check.quantity == Quantity::clip_distances;
  const auto [least, greatest] = is_of_vertices ? hull(call, check) : std::pair(0.0, 1.0);
  return std::max({greatest - least, std::abs(violation.worst.exact), 1e-6});
}

void set_bounds(const DrawCall& call, const Violation& violation, Check& check) {
  const double exact = violation.worst.exact;
  const double tolerance = tolerance_of(call, violation, check);
  double least = exact - tolerance, greatest = exact + tolerance;
  if (violation.kind == ViolationKind::outside_hull && is_varying(check.quantity)) {
    // Right is whatever lies between the vertices, and half as far beyond as what came.
    const auto [lowest, highest] = hull(call, check);
    const double returned = violation.worst.returned;
    const double beyond = std::max(returned - highest, lowest - returned);
    const bool is_between = beyond <= 0;  // but not between those of the clipped polygon
    const double slack = std::isfinite(beyond) ? beyond / 2 : tolerance;
    least = is_between ? least : lowest - slack;
    greatest = is_between ? greatest : highest + slack;
  }
  check.least = static_cast<float>(least);
  check.greatest = static_cast<float>(greatest);
}

// See experiments/pixels/lines.hpp for what the channel means there.
Check::Region region_of(const DrawCall& call, const Violation& violation) {
  const bool is_line = call.topology == Topology::lines || call.topology == Topology::line_strip;
  const bool is_lacking =
      violation.kind == ViolationKind::missing || violation.kind == ViolationKind::primitive_lost;
  if (is_line && is_lacking) return Check::Region::target;
  if (!is_line || violation.worst.exact < 1) return Check::Region::pixel;
  return violation.worst.channel == 0 ? Check::Region::column : Check::Region::row;
}

// Whether it is a + b exactly: of the two differences that of the larger one has no error.
bool is_sum(double sum, double a, double b) { return sum - a == b && sum - b == a; }

}  // namespace

Check check_of(const DrawCall& call, const Violation& violation) {
  Check check;
  check.x = violation.worst.x;
  check.y = violation.worst.y;
  check.quantity = violation.quantity;
  check.channel = violation.worst.channel;
  if (violation.kind == ViolationKind::crashed || violation.kind == ViolationKind::timed_out) {
    check.kind = Check::Kind::ends;
  } else if (is_of_coverage(violation.kind)) {
    check.kind = Check::Kind::fragments;
    check.fragments = static_cast<int>(std::lround(violation.worst.exact));
    check.came = static_cast<int>(std::lround(violation.worst.returned));
    check.region = region_of(call, violation);
  } else {
    check.kind = check.quantity == Quantity::depth ? Check::Kind::depth : Check::Kind::value;
    set_bounds(call, violation, check);
  }
  return check;
}

std::string fragments_text(int count) {
  return count == 0 ? "no fragment" : fmt::format("{} fragment{}", count, count == 1 ? "" : "s");
}

std::string place_of(const Check& check) {
  switch (check.region) {
    case Check::Region::pixel: return fmt::format("pixel ({}, {})", check.x, check.y);
    case Check::Region::column: return fmt::format("column {}", check.x);
    case Check::Region::row: return fmt::format("row {}", check.y);
    case Check::Region::target: return "all pixels";
  }
  return {};
}

std::string subject_of(const Check& check) {
  if (check.kind == Check::Kind::ends) return "the end of drawing";
  const std::string place = place_of(check);
  const std::string_view quantity = names_of(Quantity{})[bit(check.quantity)];
  if (check.kind == Check::Kind::fragments) {
    const bool reads = check.quantity != Quantity::covered && check.quantity != Quantity::hits;
    return fmt::format("{}{}", place, reads ? fmt::format(", shader reads {}", quantity) : "");
  }
  const bool is_vector = channels(check.quantity) > 1;
  return fmt::format("{}, {}{}", place, quantity,
                     is_vector ? fmt::format("[{}]", check.channel) : "");
}

std::string demand_of(const Check& check) {
  switch (check.kind) {
    case Check::Kind::ends: return "reached";
    case Check::Kind::fragments:
      return (check.comparison() == ">="   ? "at least "
              : check.comparison() == "<=" ? "at most "
                                           : "") +
             fragments_text(check.fragments);
    default: return fmt::format("between {} and {}", check.least, check.greatest);
  }
}

std::optional<DrawCall> in_depth_range(const DrawCall& call, DepthRange range) {
  DrawCall converted = call;
  converted.volume.depth = range;
  if (range == call.volume.depth) return converted;
  const bool is_to_opengl = range == DepthRange::minus_one_to_one;
  for (DrawVertex& vertex : converted.vertices) {
    const double z = vertex.position[2], w = vertex.position[3];
    const double factor = is_to_opengl ? 2 : 0.5, term = is_to_opengl ? -w : w / 2;
    const auto moved = static_cast<float>(factor * z + term);
    if (!is_sum(moved, factor * z, term)) return {};
    vertex.position[2] = moved;
  }
  return converted;
}

std::string decimal_text(float x) {
  std::string text = fmt::format("{}", static_cast<double>(x));
  const std::size_t exponent = text.find('e');
  const std::size_t end = exponent == std::string::npos ? text.size() : exponent;
  if (text.find('.') == std::string::npos) text.insert(end, ".0");
  return text;
}

}  // namespace clipscope::experiments
