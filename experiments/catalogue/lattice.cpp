// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/lattice.hpp"

#include <cassert>
#include <limits>
#include <utility>

namespace clipscope::experiments {
namespace {

constexpr std::string_view kNames[] = {"small", "medium", "full"};

constexpr float kFive[] = {-2, -1, 0, 1, 2};
constexpr float kSeven[] = {-2, -1, -0.5f, 0, 0.5f, 1, 2};
constexpr float kThreeWs[] = {-1, 0, 1};
constexpr float kFiveWs[] = {-1, 0, 0.5f, 1, 2};

// Bits 0 to 2 negate x, y and z, bit 3 exchanges x and y.
constexpr unsigned kNegateZ = 4, kExchange = 8, kSymmetries = 16;

LatticePoint transformed(LatticePoint p, unsigned symmetry) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if ((symmetry >> axis & 1u) != 0) {
      p[axis] = 0 - p[axis];  // never -0
    }
  }
  if ((symmetry & kExchange) != 0) std::swap(p[0], p[1]);
  return p;
}

// How many multisets of three points a permutation maps to themselves: three fixed points, a pair
// that it exchanges with a fixed point, or a cycle of three.
std::uint64_t fixed_multisets(std::span<const std::uint16_t> permutation) {
  std::uint64_t fixed = 0, in_pairs = 0, in_triples = 0;
  for (std::size_t i = 0; i < permutation.size(); ++i) {
    const std::size_t second = permutation[i], third = permutation[second];
    if (second == i) {
      ++fixed;
    } else if (third == i) {
      ++in_pairs;
    } else if (permutation[third] == i) {
      ++in_triples;
    }
  }
  return fixed * (fixed + 1) * (fixed + 2) / 6 + fixed * (in_pairs / 2) + in_triples / 3;
}

}  // namespace

Lattice::Lattice(std::span<const float> coordinates, std::span<const float> ws, DepthRange depth)
    : depth_(depth) {
  for (const float x : coordinates) {
    for (const float y : coordinates) {
      for (const float z : coordinates) {
        for (const float w : ws) points_.push_back({x, y, z, w});
      }
    }
  }
  std::ranges::sort(points_);
  assert(std::ranges::adjacent_find(points_) == points_.end());
  assert(points_.size() <= std::numeric_limits<Index>::max());
  add_symmetries();
  for (std::size_t a = 0; a < points_.size(); ++a) {
    for (std::size_t b = a; b < points_.size(); ++b) {
      if (lowest_image_[a] == a && lowest_image_[b] >= a) {
        chunks_.push_back({static_cast<Index>(a), static_cast<Index>(b)});
      }
    }
  }
}

void Lattice::add_symmetries() {
  for (Index i = 0; i < points_.size(); ++i) lowest_image_.push_back(i);
  for (unsigned symmetry = 0; symmetry < kSymmetries; ++symmetry) {
    if ((symmetry & kNegateZ) != 0 && depth_ != DepthRange::minus_one_to_one) continue;
    std::vector<Index>& permutation = symmetries_.emplace_back();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const LatticePoint image = transformed(points_[i], symmetry);
      const auto found = std::ranges::lower_bound(points_, image);
      assert(found != points_.end() && *found == image);
      permutation.push_back(static_cast<Index>(found - points_.begin()));
      lowest_image_[i] = std::min(lowest_image_[i], permutation.back());
    }
  }
}

std::uint64_t Lattice::triangles() const {
  const std::uint64_t n = points_.size();
  return n * (n + 1) * (n + 2) / 6;
}

std::uint64_t Lattice::classes() const {
  std::uint64_t sum = 0;
  for (const std::vector<Index>& symmetry : symmetries_) sum += fixed_multisets(symmetry);
  return sum / symmetries_.size();
}

std::span<const std::string_view> lattice_names() { return kNames; }

Lattice named_lattice(std::string_view name) {
  assert(std::ranges::find(kNames, name) != std::end(kNames));
  using Numbers = std::span<const float>;
  return Lattice(name == "full" ? Numbers(kSeven) : Numbers(kFive),
                 name == "small" ? Numbers(kThreeWs) : Numbers(kFiveWs),
                 DepthRange::minus_one_to_one);
}

}  // namespace clipscope::experiments
