// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random clip-space triangles of floats that are hard to get right to the last bit, by kind.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>

#include "spaces/vertex.hpp"
#include "spaces/volume.hpp"
#include "tests/spaces/volumes.hpp"

namespace clipscope::reference {

inline constexpr int kAttributes = 3;
using FloatTriangle = ClipTriangle<float, kAttributes>;

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kSmallest = std::numeric_limits<float>::denorm_min();

struct Case {
  ClipVolume volume;
  FloatTriangle triangle;
};

inline std::string describe(const Case& c) {
  std::ostringstream s;
  s << std::hexfloat << "depth " << static_cast<int>(c.volume.depth) << " clamp "
    << c.volume.depth_clamp.near << c.volume.depth_clamp.far << " distances "
    << c.volume.clip_distances << '\n';
  for (const ClipVertex<float, kAttributes>& v : c.triangle) {
    for (int i = 0; i < 4; ++i) s << v.position[i] << ' ';
    for (const float a : v.attributes.values) s << a << ' ';
    s << '\n';
  }
  return s.str();
}

// A position's coordinates, then the attributes.
template <class Number>
Case make_case(Random& random, Number&& number) {
  Case c;
  c.volume.depth = static_cast<DepthRange>(random() % 3);
  c.volume.depth_clamp = {random() % 4 == 0, random() % 4 == 0};
  c.volume.clip_distances = random() % 3 == 0 ? static_cast<int>(random() % 3) : 0;
  c.volume.open_sides = random() % 4 == 0;
  for (ClipVertex<float, kAttributes>& v : c.triangle) {
    for (int i = 0; i < 4; ++i) v.position[i] = number();
    for (float& a : v.attributes.values) a = number();
  }
  return c;
}

// About one vertex in six keeps a w of any sign.
inline void turn_to_front(Random& random, Case& c) {
  for (ClipVertex<float, kAttributes>& v : c.triangle) {
    if (random() % 6 != 0) v.position[3] = std::abs(v.position[3]);
  }
}

inline Case scattered(Random& random) {
  const double scale = std::pow(10, uniform(random, -6, 6));
  Case c = make_case(random, [&] { return static_cast<float>(uniform(random, -scale, scale)); });
  turn_to_front(random, c);
  return c;
}

// Halves from -3 to 3: vertices on planes, on each other, on a line, and at 0.
inline Case on_lattice(Random& random) {
  return make_case(random,
                   [&] { return static_cast<float>(static_cast<int>(random() % 13) - 6) / 2; });
}

// Coordinates next to w or -w, or equal to them; sometimes two vertices next to each other.
inline Case grazing(Random& random) {
  Case c = scattered(random);
  const auto nudge = [&](float v) {
    const int steps = static_cast<int>(random() % 5) - 2;
    for (int i = 0; i < std::abs(steps); ++i) {
      v = std::nextafter(v, steps > 0 ? kInfinity : -kInfinity);
    }
    return v;
  };
  if (random() % 2 == 0) {
    c.triangle[1].position = c.triangle[0].position;
    for (int i = 0; i < 4; ++i) c.triangle[1].position[i] = nudge(c.triangle[1].position[i]);
  }
  for (ClipVertex<float, kAttributes>& v : c.triangle) {
    for (int i = 0; i < 3; ++i) {
      if (random() % 2 == 0) {
        v.position[i] = nudge(random() % 2 == 0 ? v.position[3] : -v.position[3]);
      }
    }
  }
  return c;
}

inline Case of_wide_exponents(Random& random) {
  Case c = make_case(random, [&] { return over_magnitudes<float>(random, -38, 38); });
  turn_to_front(random, c);
  return c;
}

// At most 2^-126 in magnitude, many of a few units only.
inline Case subnormal(Random& random) {
  const int bits = 3 + static_cast<int>(random() % 21);
  Case c = make_case(random, [&] {
    const auto units = static_cast<float>(random() >> (64 - bits));
    return static_cast<float>(sign_of(random)) * units * kSmallest;
  });
  turn_to_front(random, c);
  return c;
}

// The third vertex between the first two, or one vertex twice: no area.
inline Case without_area(Random& random) {
  Case c = on_lattice(random);
  for (int i = 0; i < 4; ++i) {
    const float a = c.triangle[0].position[i], b = c.triangle[1].position[i];
    c.triangle[2].position[i] = random() % 4 == 0 ? b : 0.5f * (a + b);
  }
  return c;
}

// Without a negative zero: the reference knows but one.
inline void add_zero(Case& c) {
  for (ClipVertex<float, kAttributes>& v : c.triangle) {
    for (float& a : v.attributes.values) a += 0.0f;
  }
}

struct CaseSet {
  const char* name;
  Case (*make)(Random&);
};
inline constexpr std::array<CaseSet, 6> kCaseSets = {{{"scattered", scattered},
                                                      {"lattice", on_lattice},
                                                      {"grazing", grazing},
                                                      {"wide exponents", of_wide_exponents},
                                                      {"subnormal", subnormal},
                                                      {"without area", without_area}}};

}  // namespace clipscope::reference
