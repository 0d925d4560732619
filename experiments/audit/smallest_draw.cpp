// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/smallest_draw.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "experiments/audit/draw_simpler.hpp"
#include "experiments/shrink/simpler_cases.hpp"

namespace clipscope::experiments {
namespace {

// Of more the numbers are left: there are too many to be asked.
constexpr std::size_t kMostVertices = 12;

using StillFails = std::function<bool(const DrawCall&)>;

double cost_of_settings(const DrawCall& call) {
  constexpr double kPrimitive = 400, kIndices = 60, kStrip = 30, kQuantity = 50, kBinade = 8,
                   kViewport = 200, kProvoking = 5;
  double cost = kPrimitive * static_cast<double>(primitives_of(call).size());
  cost += call.indices.empty() ? 0 : kIndices + static_cast<double>(call.indices.size());
  cost += list_of(call.topology) == call.topology ? 0 : kStrip;
  cost += kQuantity * static_cast<double>(call.quantities.count());
  cost += kBinade * (std::log2(call.width) + std::log2(call.height) + std::log2(call.point_size));
  if (!has_whole_viewport(call)) {
    cost +=
        kViewport + kBinade * (std::log2(call.viewport.width) + std::log2(call.viewport.height));
  }
  return cost + (call.provoking == ProvokingVertex::first ? kProvoking : 0);
}

class DrawShrinker {
 public:
  DrawShrinker(DrawCall failing, const StillFails& still_fails, const ShrinkLimits& limits)
      : call_(std::move(failing)), still_fails_(still_fails), limits_(limits) {}

  DrawCall smallest() {
    for (std::size_t round = 0; round < limits_.rounds && asked_ < limits_.asked; ++round) {
      const double before = cost_of(call_);
      drop_primitives();
      while (take_cheapest(simpler_settings(call_))) {
      }
      if (call_.vertices.size() <= kMostVertices) simplify_numbers();
      if (cost_of(call_) >= before) break;
    }
    return std::move(call_);
  }

 private:
  // Whether it is smaller and fails; the call is then that one.
  bool take(DrawCall&& smaller) {
    if (asked_ >= limits_.asked || cost_of(smaller) >= cost_of(call_)) return false;
    ++asked_;
    if (!still_fails_(smaller)) return false;
    call_ = std::move(smaller);
    return true;
  }

  // The cheapest of those that fail; of more than can be asked at once some of each price.
  bool take_cheapest(std::vector<DrawCall> calls) {
    const double cost = cost_of(call_);
    std::vector<std::pair<double, std::size_t>> priced;
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const double price = cost_of(calls[i]);
      if (price < cost) priced.emplace_back(price, i);
    }
    std::ranges::sort(priced);
    const std::size_t count = std::min(priced.size(), limits_.at_once);
    for (std::size_t i = 0; i < count; ++i) {
      if (take(std::move(calls[priced[i * priced.size() / count].second]))) return true;
    }
    return false;
  }

  // Half of them, quarters, ... and what is left without them, until none can go.
  void drop_primitives() {
    std::vector<std::size_t> all(primitives_of(call_).size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    take(with_primitives(call_, all));
    std::size_t parts = 2;
    while (parts <= primitives_of(call_).size() && asked_ < limits_.asked) {
      if (keep_part(parts)) {
        parts = 2;
      } else if (drop_part(parts)) {
        parts = std::max<std::size_t>(2, parts - 1);
      } else if (parts == primitives_of(call_).size()) {
        break;
      } else {
        parts = std::min(2 * parts, primitives_of(call_).size());
      }
    }
  }

  bool keep_part(std::size_t parts) {
    return try_parts(parts, [](bool is_in_part) { return is_in_part; });
  }
  bool drop_part(std::size_t parts) {
    return parts > 2 && try_parts(parts, [](bool is_in_part) { return !is_in_part; });
  }

  template <class Keeps>
  bool try_parts(std::size_t parts, const Keeps& keeps) {
    const std::size_t count = primitives_of(call_).size();
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t first = part * count / parts, end = (part + 1) * count / parts;
      std::vector<std::size_t> kept;
      for (std::size_t i = 0; i < count; ++i) {
        if (keeps(first <= i && i < end)) kept.push_back(i);
      }
      if (take(with_primitives(call_, kept))) return true;
    }
    return false;
  }

  void simplify_numbers() {
    simplify_values();
    take_cheapest(simpler_as_a_whole());
    simplify_coordinates();
  }

  // Channels of the varying to 0 for all vertices, then each of its values to 0 or 1.
  void simplify_values() {
    for (std::size_t k = 0; k < 4; ++k) {
      DrawCall without = call_;
      for (DrawVertex& v : without.vertices) v.varying[k] = 0;
      take(std::move(without));
    }
    for (std::size_t vertex = 0; vertex < call_.vertices.size(); ++vertex) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (const float value : {0.0f, 1.0f}) {
          DrawCall simpler = call_;
          simpler.vertices[vertex].varying[k] = value;
          if (take(std::move(simpler))) break;
        }
      }
    }
  }

  std::vector<DrawCall> simpler_as_a_whole() const {
    std::vector<DrawCall> calls;
    for (const HardCase& c : simpler_wholes(numbers_of(call_))) {
      // Drivers clamp both planes of depth or none, and close all sides.
      const bool is_drawable = c.volume.depth_clamp.near == c.volume.depth_clamp.far;
      if (is_drawable) calls.push_back(with_numbers(call_, c));
    }
    return calls;
  }

  // Each coordinate in turn to the cheapest number that fails, and then nearer to 1.
  void simplify_coordinates() {
    for (std::size_t vertex = 0; vertex < call_.vertices.size(); ++vertex) {
      for (std::size_t i = 0; i < 4; ++i) {
        const HardCase numbers = numbers_of(call_);
        std::vector<DrawCall> calls;
        for (const CoordinateChange& change : simpler_coordinates(numbers)) {
          const bool is_this = change.vertex == vertex && change.coordinate == i;
          if (is_this) calls.push_back(with_numbers(call_, change.of(numbers)));
        }
        take_cheapest(std::move(calls));
        while (take_nearer_to_one(vertex, i)) {
        }
      }
    }
  }

  // By half of its exponent, or by one.
  bool take_nearer_to_one(std::size_t vertex, std::size_t coordinate) {
    const float x = call_.vertices[vertex].position[coordinate];
    const int exponent = x == 0 ? 0 : std::ilogb(x);
    if (exponent == 0) return false;
    for (const int step : {exponent / 2, exponent > 0 ? 1 : -1}) {
      DrawCall nearer = call_;
      nearer.vertices[vertex].position[coordinate] = std::ldexp(x, -step);
      if (take(std::move(nearer))) return true;
    }
    return false;
  }

  DrawCall call_;
  const StillFails& still_fails_;
  const ShrinkLimits& limits_;
  std::size_t asked_ = 0;
};

}  // namespace

double cost_of(const DrawCall& call) {
  return cost_of_settings(call) + (call.vertices.empty() ? 0 : cost_of(numbers_of(call)));
}

DrawCall smallest_draw(DrawCall failing, const StillFails& still_fails,
                       const ShrinkLimits& limits) {
  if (failing.vertices.empty() || !still_fails(failing)) return failing;
  return DrawShrinker(std::move(failing), still_fails, limits).smallest();
}

}  // namespace clipscope::experiments
