// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random view-space triangles of floats, and frusta, that are hard to get right to the last bit, by
// kind.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "spaces/projection.hpp"
#include "tests/spaces/barycentric/clip_cases.hpp"

namespace clipscope::reference {

struct ViewCase {
  Frustum<float> frustum;
  ClipVolume volume;
  ViewTriangle<float, kAttributes> triangle;
};

inline std::string describe(const ViewCase& c) {
  const Frustum<float>& f = c.frustum;
  std::ostringstream s;
  s << std::hexfloat << (f.kind == ProjectionKind::parallel ? "parallel " : "perspective ")
    << f.left << ' ' << f.right << ' ' << f.bottom << ' ' << f.top << ' ' << f.near << ' ' << f.far
    << (f.infinite_far ? " (infinite)" : "") << " shear " << f.shear_x << ' ' << f.shear_y
    << " depth " << static_cast<int>(f.depth) << " clamp " << c.volume.depth_clamp.near
    << c.volume.depth_clamp.far << " distances " << c.volume.clip_distances << '\n';
  for (const ViewVertex<float, kAttributes>& v : c.triangle) {
    for (int i = 0; i < 3; ++i) s << v.position[i] << ' ';
    for (const float a : v.attributes.values) s << a << ' ';
    s << '\n';
  }
  return s.str();
}

// The frustum is to be valid.
template <class Number>
ViewCase make_view_case(Random& random, const Frustum<float>& f, Number&& number) {
  ViewCase c;
  c.frustum = f;
  c.volume.depth = f.depth;
  c.volume.depth_clamp = {random() % 4 == 0, random() % 4 == 0};
  c.volume.clip_distances = random() % 3 == 0 ? static_cast<int>(random() % 3) : 0;
  c.volume.open_sides = random() % 4 == 0;
  for (ViewVertex<float, kAttributes>& v : c.triangle) {
    for (int i = 0; i < 3; ++i) v.position[i] = number();
    for (float& a : v.attributes.values) a = number();
  }
  return c;
}

// Around the volume, and about as large.
inline ViewCase scattered_in_view(Random& random) {
  Frustum<float> f = random_frustum<float>(random);
  while (!is_valid(f)) f = random_frustum<float>(random);
  const double depth = f.infinite_far ? 20 * f.near : f.far;
  ViewCase c =
      make_view_case(random, f, [&] { return static_cast<float>(uniform(random, -1, 1)); });
  for (ViewVertex<float, kAttributes>& v : c.triangle) {
    const double z = -uniform(random, -0.2, 1.2) * depth;
    const double widening = f.kind == ProjectionKind::perspective ? std::abs(z) / f.near : 1;
    const double at = uniform(random, -1, 2), up = uniform(random, -1, 2);
    v.position[0] = static_cast<float>(widening * (f.left + at * (double{f.right} - f.left)));
    v.position[1] = static_cast<float>(widening * (f.bottom + up * (double{f.top} - f.bottom)));
    v.position[2] = static_cast<float>(z);
  }
  return c;
}

// All numbers of a frustum from one source.
template <class Number>
Frustum<float> make_frustum(Random& random, Number&& number) {
  Frustum<float> f;
  do {
    f.kind = random() % 2 == 0 ? ProjectionKind::parallel : ProjectionKind::perspective;
    f.depth = static_cast<DepthRange>(random() % 3);
    f.infinite_far = f.kind == ProjectionKind::perspective && random() % 3 == 0;
    for (float* v : {&f.left, &f.right, &f.bottom, &f.top, &f.near, &f.far}) *v = number();
    f.shear_x = f.shear_y = 0;
    if (f.kind == ProjectionKind::perspective) {
      f.near = std::abs(f.near);
    } else if (random() % 2 == 0) {
      f.shear_x = number();
      f.shear_y = number();
    }
    if (f.right < f.left) std::swap(f.left, f.right);
    if (f.top < f.bottom) std::swap(f.bottom, f.top);
    if (f.far < f.near) std::swap(f.near, f.far);
  } while (!is_valid(f));
  return f;
}

inline void turn_to_front(Random& random, ViewCase& c) {
  for (ViewVertex<float, kAttributes>& v : c.triangle) {
    if (random() % 6 != 0) v.position[2] = -std::abs(v.position[2]);
  }
}

// Halves from -3 to 3.
inline ViewCase on_view_lattice(Random& random) {
  const auto number = [&] { return static_cast<float>(static_cast<int>(random() % 13) - 6) / 2; };
  ViewCase c = make_view_case(random, make_frustum(random, number), number);
  turn_to_front(random, c);
  return c;
}

// Vertices on planes as well as floats can say it, or some ulps beside.
inline ViewCase grazing_in_view(Random& random) {
  ViewCase c = scattered_in_view(random);
  const Frustum<float>& f = c.frustum;
  const auto nudge = [&](double v) {
    float r = static_cast<float>(v);
    const int steps = static_cast<int>(random() % 5) - 2;
    for (int i = 0; i < std::abs(steps); ++i) {
      r = std::nextafter(r, steps > 0 ? kInfinity : -kInfinity);
    }
    return r;
  };
  if (random() % 2 == 0) {
    for (int i = 0; i < 3; ++i) c.triangle[1].position[i] = nudge(c.triangle[0].position[i]);
  }
  const bool perspective = f.kind == ProjectionKind::perspective;
  for (ViewVertex<float, kAttributes>& v : c.triangle) {
    const double z = v.position[2];
    const double scale = perspective ? -z / f.near : 1;
    const double x = perspective ? 0 : -f.shear_x * z, y = perspective ? 0 : -f.shear_y * z;
    if (random() % 3 == 0) {
      v.position[0] = nudge(x + scale * (random() % 2 == 0 ? f.left : f.right));
    }
    if (random() % 3 == 0) {
      v.position[1] = nudge(y + scale * (random() % 2 == 0 ? f.bottom : f.top));
    }
    if (random() % 4 == 0) {
      v.position[2] = nudge(random() % 2 == 0 || f.infinite_far ? -f.near : -f.far);
    }
  }
  return c;
}

// Exponents of any float, or of a narrower range around one of them so that something is visible.
inline ViewCase of_wide_exponents_in_view(Random& random) {
  const double width = random() % 3 == 0 ? 76 : uniform(random, 0, 12);
  const double centre = uniform(random, -38 + width / 2, 38 - width / 2);
  const auto number = [&] {
    return over_magnitudes<float>(random, centre - width / 2, centre + width / 2);
  };
  ViewCase c = make_view_case(random, make_frustum(random, number), number);
  turn_to_front(random, c);
  return c;
}

// At most 2^-126 in magnitude, many of a few units only, in a frustum of such numbers or of some
// near 1.
inline ViewCase subnormal_in_view(Random& random) {
  const int bits = 3 + static_cast<int>(random() % 21);
  const auto number = [&] {
    const auto units = static_cast<float>(random() >> (64 - bits));
    return static_cast<float>(sign_of(random)) * units * kSmallest;
  };
  const auto ordinary = [&] { return static_cast<float>(uniform(random, -2, 2)); };
  const Frustum<float> f =
      random() % 2 == 0 ? make_frustum(random, number) : make_frustum(random, ordinary);
  ViewCase c = make_view_case(random, f, number);
  if (random() % 2 == 0) {
    for (ViewVertex<float, kAttributes>& v : c.triangle) v.position[2] = -std::abs(ordinary());
  }
  turn_to_front(random, c);
  return c;
}

// The third vertex between the first two, or one vertex twice: no area. The clip distances are not
// those of one line.
inline ViewCase without_area_in_view(Random& random) {
  ViewCase c = on_view_lattice(random);
  const bool twice = random() % 4 == 0;
  for (int i = 0; i < 3; ++i) {
    const float a = c.triangle[0].position[i], b = c.triangle[1].position[i];
    c.triangle[2].position[i] = twice ? b : 0.5f * (a + b);
  }
  return c;
}

inline void add_zero(ViewCase& c) {
  for (ViewVertex<float, kAttributes>& v : c.triangle) {
    for (float& a : v.attributes.values) a += 0.0f;
  }
}

struct ViewCaseSet {
  const char* name;
  ViewCase (*make)(Random&);
};
inline constexpr std::array<ViewCaseSet, 6> kViewCaseSets = {
    {{"scattered", scattered_in_view},
     {"lattice", on_view_lattice},
     {"grazing", grazing_in_view},
     {"wide exponents", of_wide_exponents_in_view},
     {"subnormal", subnormal_in_view},
     {"without area", without_area_in_view}}};

}  // namespace clipscope::reference
