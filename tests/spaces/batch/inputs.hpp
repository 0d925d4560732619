// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles for batch clippers in all three layouts, and answers compared bit for bit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "spaces/batch/methods.hpp"

namespace clipscope::batch::tests {

using Random = std::mt19937_64;

inline float uniform(Random& random, float low, float high) {
  return low + (high - low) * (static_cast<float>(random() >> 40) * 0x1p-24f);
}

// How coordinates are chosen.
enum class Numbers {
  near_volume,  // within a few times the volume
  lattice,      // multiples of 1/4: many vertices lie on planes, at w = 0 or at the origin
  wide,         // exponents from -140 to 127
  special       // now and then NaN, infinity, the largest and smallest floats, zeros of both signs
};
inline constexpr std::array kNumbers = {Numbers::near_volume, Numbers::lattice, Numbers::wide,
                                        Numbers::special};

inline float number(Random& random, Numbers numbers) {
  constexpr float kSpecial[] = {std::numeric_limits<float>::quiet_NaN(),
                                std::numeric_limits<float>::infinity(),
                                -std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::max(),
                                -std::numeric_limits<float>::max(),
                                std::numeric_limits<float>::denorm_min(),
                                -std::numeric_limits<float>::min(),
                                0.0f,
                                -0.0f};
  switch (numbers) {
    case Numbers::lattice: return (static_cast<float>(random() % 25) - 12) / 4;
    case Numbers::wide: {
      const int exponent = static_cast<int>(random() % 268) - 140;
      return std::ldexp(uniform(random, -1, 1), exponent);
    }
    case Numbers::special:
      if (random() % 8 == 0) return kSpecial[random() % std::size(kSpecial)];
      [[fallthrough]];
    default: return uniform(random, -1.5f, 1.5f);
  }
}

// A soup in the layouts of the three contracts; `mesh` shares every vertex among several triangles.
struct Soup {
  int attributes;
  std::vector<float> vertices;                  // 4 + attributes floats each
  std::vector<std::vector<float>> coordinates;  // twelve
  std::vector<float> attribute_values;
  std::vector<std::uint32_t> indices;

  std::size_t triangles() const { return coordinates[0].size(); }

  VertexArray array() const { return {vertices.data(), 3 * triangles(), attributes}; }
  TriangleStreams streams() const {
    TriangleStreams r{{}, triangles(), attribute_values.data(), attributes};
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t c = 0; c < 4; ++c) r.positions[v][c] = coordinates[4 * v + c].data();
    }
    return r;
  }
  IndexedMesh mesh() const { return {array(), indices}; }
};

// Attributes: chosen as the positions are, unless they are given a choice of their own.
inline Soup make_soup(Random& random, Numbers numbers, int attributes, std::size_t triangles,
                      std::optional<Numbers> of_attributes = {}) {
  Soup soup{attributes, {}, std::vector<std::vector<float>>(12), {}, {}};
  for (std::size_t t = 0; t < triangles; ++t) {
    const bool in_front = random() % 4 != 0;
    const float size = random() % 2 == 0 ? 1.0f : 0.25f;  // some are inside
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t c = 0; c < 4; ++c) {
        float x = number(random, numbers);
        if (numbers == Numbers::near_volume && c < 3) x *= size;
        if (c == 3 && in_front) x = std::abs(x);
        soup.vertices.push_back(x);
        soup.coordinates[4 * v + c].push_back(x);
      }
      for (int k = 0; k < attributes; ++k) {
        const float a = number(random, of_attributes.value_or(numbers));
        soup.vertices.push_back(a);
        soup.attribute_values.push_back(a);
      }
      soup.indices.push_back(static_cast<std::uint32_t>(random() % (3 * triangles)));
    }
  }
  return soup;
}

// Equal bits, a NaN's apart.
inline bool same_bits(float a, float b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

// The same polygon, from whichever vertex on.
inline bool same_cycle(std::span<const float> a, std::span<const float> b, std::size_t stride) {
  if (a.size() != b.size()) return false;
  for (std::size_t shift = 0; shift < std::max<std::size_t>(a.size(), 1); shift += stride) {
    bool equal = true;
    for (std::size_t i = 0; i < a.size() && equal; ++i) {
      equal = same_bits(a[i], b[(i + shift) % b.size()]);
    }
    if (equal) return true;
  }
  return false;
}

// The number of the first triangle that two answers differ in; none: an empty optional.
inline std::optional<std::uint32_t> first_difference(const Output& a, const Output& b) {
  if (!std::ranges::equal(a.inside(), b.inside())) {
    const auto [at, other] = std::ranges::mismatch(a.inside(), b.inside());
    if (at != a.inside().end()) return *at;
    return other != b.inside().end() ? *other : 0;
  }
  const std::size_t common = std::min(a.polygons().size(), b.polygons().size());
  for (std::size_t i = 0; i < common; ++i) {
    const std::uint32_t t = std::min(a.polygons()[i].triangle, b.polygons()[i].triangle);
    if (a.polygons()[i].triangle != b.polygons()[i].triangle) return t;
    if (!same_cycle(a.polygon(i), b.polygon(i), a.stride())) return t;
  }
  if (a.polygons().size() > common) return a.polygons()[common].triangle;
  if (b.polygons().size() > common) return b.polygons()[common].triangle;
  return std::nullopt;
}

}  // namespace clipscope::batch::tests
