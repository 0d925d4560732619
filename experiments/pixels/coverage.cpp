// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace clipscope::experiments {
namespace {

// Calls each(x, y, coverage) for what is not outside.
template <class Each>
void for_each_pixel(const Region& region, Each&& each) {
  std::vector<Coverage> row;
  for (int y = region.box.bottom; y < region.box.top; ++y) {
    coverage_of_row(region, y, row);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] == Coverage::outside) continue;
      each(region.box.left + static_cast<int>(i), y, row[i]);
    }
  }
}

int hits_at(const Pixels& pixels, int x, int y) {
  const float hits = pixels.at(Quantity::hits, x, y);
  return std::isfinite(hits) ? static_cast<int>(hits) : 0;
}

// A primitive all of whose certain pixels lack a fragment is lost; each pixel's lack is one
// primitive's alone.
class MissingFragments {
 public:
  MissingFragments(const std::vector<JudgedPrimitive>& primitives, std::vector<int> lacking,
                   int width, const Pixels& pixels)
      : primitives_(primitives), lacking_(std::move(lacking)), width_(width), pixels_(pixels) {}

  void accuse(Accusations& accusations) {
    for (std::size_t i = 0; i < primitives_.size(); ++i) {
      bool is_lost = true, has_pixels = false;
      for_each_pixel(primitives_[i].region, [&](int x, int y, Coverage c) {
        if (c != Coverage::covered) return;
        has_pixels = true;
        is_lost = is_lost && lacking(x, y) > 0;
      });
      if (is_lost && has_pixels) take(i, ViolationKind::primitive_lost, accusations);
    }
    // The last one first: it is what lies on top.
    for (std::size_t i = primitives_.size(); i-- > 0;) take(i, ViolationKind::missing, accusations);
  }

 private:
  int& lacking(int x, int y) {
    return lacking_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x)];
  }

  void take(std::size_t i, ViolationKind kind, Accusations& accusations) {
    const Region& region = primitives_[i].region;
    for_each_pixel(region, [&](int x, int y, Coverage c) {
      if (c != Coverage::covered || lacking(x, y) == 0) return;
      --lacking(x, y);
      const int hits = hits_at(pixels_, x, y);
      const Quantity quantity = hits == 0 ? Quantity::covered : Quantity::hits;
      accusations.add(i, quantity, kind, {x, y, 0, hits + 1.0, static_cast<float>(hits)},
                      standing_at(region, x, y));
    });
  }

  const std::vector<JudgedPrimitive>& primitives_;
  std::vector<int> lacking_;
  int width_;
  const Pixels& pixels_;
};

// The primitive that comes nearest to having the pixel.
std::size_t nearest_primitive(const std::vector<JudgedPrimitive>& primitives, int x, int y) {
  std::size_t nearest = 0;
  double best = -1e300;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const double standing = standing_at(primitives[i].region, x, y);
    if (standing <= best) continue;
    best = standing;
    nearest = i;
  }
  return nearest;
}

void accuse_extra(const std::vector<JudgedPrimitive>& primitives, int x, int y,
                  const PixelClaim& claim, int hits, Accusations& accusations) {
  const std::size_t i = nearest_primitive(primitives, x, y);
  const JudgedPrimitive& primitive = primitives[i];
  const bool has_no_area = primitive.is_triangle() && !primitive.has_values();
  const Quantity quantity = claim.covered == 0 ? Quantity::covered : Quantity::hits;
  accusations.add(i, quantity, has_no_area ? ViolationKind::zero_area : ViolationKind::extra,
                  {x, y, 0, static_cast<double>(claim.covered), static_cast<float>(hits)},
                  std::abs(standing_at(primitive.region, x, y)));
}

void count(const PixelClaim& claim, int hits, Judgement& judgement) {
  ++(claim.open == 0 ? judgement.pixels : judgement.undecided);
  if (claim.open != 1) return;
  const bool is_drawn = hits > claim.covered;
  const bool is_inexact = claim.of_open == Coverage::nearly_covered   ? !is_drawn
                          : claim.of_open == Coverage::nearly_outside ? is_drawn
                                                                      : false;
  if (is_inexact) ++judgement.inexact;
}

}  // namespace

void Accusations::add(std::size_t primitive, Quantity quantity, ViolationKind kind,
                      const WorstPixel& pixel, double size) {
  const Found first{Violation{primitive, quantity, kind, 0, pixel, -1}};
  auto& [violation, x, y] = found_.try_emplace({primitive, quantity, kind}, first).first->second;
  if (x != pixel.x || y != pixel.y) ++violation.pixels;
  x = pixel.x;
  y = pixel.y;
  if (size <= violation.size) return;
  violation.size = size;
  violation.worst = pixel;
}

std::vector<Violation> Accusations::violations() const {
  std::vector<Violation> r;
  for (const auto& [key, found] : found_) r.push_back(found.violation);
  return r;
}

CoverageMap coverage_map(const DrawCall& call, const std::vector<JudgedPrimitive>& primitives) {
  CoverageMap map;
  map.width = call.width;
  map.claims.resize(static_cast<std::size_t>(call.width) * static_cast<std::size_t>(call.height));
  map.is_certain.resize(primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    bool has_certain_pixels = false;
    for_each_pixel(primitives[i].region, [&](int x, int y, Coverage c) {
      PixelClaim& claim =
          map.claims[static_cast<std::size_t>(y) * static_cast<std::size_t>(call.width) +
                     static_cast<std::size_t>(x)];
      claim.last = static_cast<std::int32_t>(i);
      if (c == Coverage::covered) {
        ++claim.covered;
        has_certain_pixels = true;
      } else {
        ++claim.open;
        claim.of_open = c;
      }
    });
    map.is_certain[i] = has_certain_pixels;
  }
  return map;
}

void judge_coverage(const std::vector<JudgedPrimitive>& primitives, const CoverageMap& map,
                    const Pixels& pixels, Accusations& accusations, Judgement& judgement) {
  std::vector<int> lacking(map.claims.size());
  bool is_any_lacking = false;
  for (int y = 0; y < pixels.height; ++y) {
    for (int x = 0; x < pixels.width; ++x) {
      const PixelClaim& claim = map.at(x, y);
      const int hits = hits_at(pixels, x, y);
      count(claim, hits, judgement);
      if (hits > claim.covered + claim.open && !primitives.empty()) {
        accuse_extra(primitives, x, y, claim, hits, accusations);
      }
      if (hits >= claim.covered) continue;
      is_any_lacking = true;
      lacking[static_cast<std::size_t>(y * map.width + x)] = claim.covered - hits;
    }
  }
  if (!is_any_lacking) return;
  MissingFragments(primitives, std::move(lacking), map.width, pixels).accuse(accusations);
}

}  // namespace clipscope::experiments
