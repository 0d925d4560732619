// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/w_sign/patterns.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <span>

#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {
namespace {

using PatternVertex = ClipVertex<float, kSceneAttributes>;

float random_w(WKind kind, Random& random) {
  switch (kind) {
    case WKind::negative: return -static_cast<float>(random.across_magnitudes(0.1, 10));
    case WKind::minus_zero: return -0.0f;
    case WKind::zero: return 0.0f;
    case WKind::tiny:
      return static_cast<float>(
          random.across_magnitudes(double{std::numeric_limits<float>::min()}, 1e-5));
    case WKind::positive: break;
  }
  return static_cast<float>(random.across_magnitudes(0.1, 10));
}

PatternVertex random_vertex(WKind kind, Random& random) {
  PatternVertex v;
  const float w = random_w(kind, random);
  const bool is_direction = w == 0 || random.chance(0.5);
  const bool is_origin = w == 0 && random.chance(0.125);
  const double size = is_origin ? 0.0 : is_direction ? 1.0 : std::abs(double{w});
  for (int i = 0; i < 3; ++i) v.position[i] = static_cast<float>(random.uniform(-1.5, 1.5) * size);
  v.position[3] = w;
  for (int k = 0; k < kSceneAttributes; ++k) {
    v.attributes[k] = static_cast<float>(random.uniform(-1, 1));
  }
  return v;
}

}  // namespace

std::vector<WPattern> all_patterns() {
  std::vector<WPattern> patterns;
  for (int a = 0; a < 5; ++a) {
    for (int b = a; b < 5; ++b) {
      for (int c = b; c < 5; ++c) {
        patterns.push_back({static_cast<WKind>(a), static_cast<WKind>(b), static_cast<WKind>(c)});
      }
    }
  }
  return patterns;
}

std::string pattern_name(const WPattern& pattern) {
  static constexpr std::array<const char*, 5> kNames = {"-", "-0", "+0", "tiny", "+"};
  const auto name = [](WKind kind) { return kNames[static_cast<std::size_t>(kind)]; };
  return fmt::format("{} {} {}", name(pattern[0]), name(pattern[1]), name(pattern[2]));
}

SweepChunk pattern_chunk(const WPattern& pattern, std::size_t triangles, std::uint64_t seed) {
  Random random(seed);
  SweepChunk chunk;
  for (std::size_t i = 0; i < triangles; ++i) {
    ClipTriangle<float, kSceneAttributes> triangle;
    for (std::size_t v = 0; v < 3; ++v) triangle[v] = random_vertex(pattern[v], random);
    random.shuffle(std::span<PatternVertex>(triangle));
    chunk.clip.push_back(triangle);
  }
  return chunk;
}

}  // namespace clipscope::experiments
