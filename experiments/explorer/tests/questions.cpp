// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/explorer/tests/questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "experiments/explorer/engine/engine.hpp"

namespace clipscope::explorer {
namespace {

// What a triangle is made of.
enum class Kind {
  scattered,  // around the volume, w of either sign
  on_planes,  // vertices on planes, edges and corners of the volume, or a few ulps beside them
  wide,       // coordinates of all magnitudes
  lattice,    // small whole numbers: vertices coincide and lie on planes all the time
  sliver,     // the third vertex on the edge of the others, or a few ulps beside it
  special     // some numbers are not finite, zeros of either sign, or at the ends of the range
};
constexpr int kKinds = 6;

// Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014 (SplitMix64): the
// library's distributions differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  bool one_in(int n) { return below(n) == 0; }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t state_;
};

struct Camera {
  bool is_parallel = false;
  double left = -1, right = 1, bottom = -1, top = 1, near = 1, far = 10;
  bool is_infinite = false;
  double shear_x = 0, shear_y = 0;
};

double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }

Camera random_camera(Random& random, Kind kind) {
  Camera c;
  c.is_parallel = random.one_in(3);
  c.is_infinite = !c.is_parallel && random.one_in(6);
  if (kind == Kind::lattice) {
    c.far = 2 + random.below(9);
    return c;
  }
  const double scale = std::ldexp(1.0, kind == Kind::wide ? random.below(41) - 20 : 0);
  const auto length = [&](double low, double high) {
    return as_float(random.between(low, high) * scale);
  };
  // A quarter of the frusta do not have the axis between their sides.
  c.left = random.one_in(4) ? length(0.1, 1) : -length(0.1, 1);
  c.bottom = random.one_in(4) ? length(0.1, 1) : -length(0.1, 1);
  c.right = as_float(std::max(c.left, 0.0) + length(0.1, 1));
  c.top = as_float(std::max(c.bottom, 0.0) + length(0.1, 1));
  c.near = length(0.1, 1);
  c.far = as_float(c.near * random.between(1.01, random.one_in(3) ? 1000 : 10));
  if (c.is_parallel && random.one_in(2)) {
    c.shear_x = as_float(random.between(-1, 1));
    c.shear_y = as_float(random.between(-1, 1));
  }
  return c;
}

// The numbers of one triangle: floats in half of them.
class Numbers {
 public:
  Numbers(Random& random, Kind kind)
      : random_(random),
        kind_(kind),
        has_floats_(random.one_in(2)),
        middle_(random.below(201) - 100) {}

  Random& random() const { return random_; }
  Kind kind() const { return kind_; }

  double rounded(double x) const { return has_floats_ ? as_float(x) : x; }

  // Moved by up to two ulps.
  double beside(double x) const {
    x = rounded(x);
    const int steps = random_.below(5) - 2;
    const double to = std::copysign(std::numeric_limits<double>::infinity(), steps);
    for (int i = 0; i < std::abs(steps); ++i) {
      x = has_floats_ ? double{std::nextafterf(static_cast<float>(x), static_cast<float>(to))}
                      : std::nextafter(x, to);
    }
    return x;
  }

  // Of any exponent, or of one near that of the others of this triangle.
  double wide() const {
    const int reach = has_floats_ ? 276 : 2098;
    const int exponent = random_.one_in(4) ? random_.below(reach) - (has_floats_ ? 149 : 1074)
                                           : middle_ + random_.below(41) - 20;
    const double x = std::ldexp(random_.between(1, 2), exponent);
    return rounded(random_.one_in(2) ? x : -x);
  }

  double special() const {
    using Limits = std::numeric_limits<double>;
    constexpr std::array kValues = {Limits::quiet_NaN(),
                                    Limits::infinity(),
                                    0.0,
                                    Limits::denorm_min(),
                                    0x1p-149,
                                    0x1.fffffep-127,
                                    0x1p-126,
                                    0x1.fffffep+127,
                                    Limits::max(),
                                    1.0};
    const double x = kValues[static_cast<std::size_t>(random_.below(kValues.size()))];
    return random_.one_in(2) ? x : -x;
  }

 private:
  Random& random_;
  Kind kind_;
  bool has_floats_;
  int middle_;
};

using Position = std::array<double, 4>;

// One of the values, or any between them.
double one_of(const Numbers& numbers, const std::array<double, 3>& values) {
  const int i = numbers.random().below(4);
  return i < 3 ? numbers.beside(values[static_cast<std::size_t>(i)])
               : numbers.rounded(numbers.random().between(values[0], values[1]));
}

Position clip_position(const Numbers& numbers) {
  Random& random = numbers.random();
  Position p{};
  switch (numbers.kind()) {
    case Kind::wide:
      for (double& x : p) x = numbers.wide();
      return p;
    case Kind::lattice:
      for (double& x : p) x = random.below(5) - 2;
      return p;
    case Kind::on_planes:
      p[3] = numbers.rounded(random.one_in(8) ? random.between(-2, 0) : random.between(0, 4));
      for (std::size_t k = 0; k < 3; ++k) p[k] = one_of(numbers, {-p[3], p[3], 0});
      return p;
    default:
      p[3] = numbers.rounded(random.one_in(3) ? random.between(-2, 2) : random.between(0.1, 3));
      for (std::size_t k = 0; k < 3; ++k) p[k] = numbers.rounded(random.between(-3, 3));
      return p;
  }
}

Position view_position(const Camera& c, const Numbers& numbers) {
  Random& random = numbers.random();
  if (numbers.kind() == Kind::lattice) {
    return {double(random.below(9) - 4), double(random.below(9) - 4), double(1 - random.below(12)),
            0};
  }
  if (numbers.kind() == Kind::wide && random.one_in(2)) {
    return {numbers.wide(), numbers.wide(), numbers.wide(), 0};
  }
  const double end = c.is_infinite ? 100 * c.near : c.far;
  const bool is_on_planes = numbers.kind() == Kind::on_planes;
  Position p{};
  p[2] = is_on_planes ? one_of(numbers, {-c.near, -end, 0})
                      : numbers.rounded(random.between(random.one_in(2) ? -1.5 * end : -4 * c.near,
                                                       2 * c.near));
  // The sides at that depth.
  const double spread = c.is_parallel ? 1 : -p[2] / c.near;
  const auto across = [&](double low, double high, double shear) {
    const double shift = shear * p[2];
    const double a = low * spread - shift, b = high * spread - shift;
    if (is_on_planes) return one_of(numbers, {a, b, 0});
    const double size = 2 * std::abs(b - a) + c.near;
    return numbers.rounded(random.between(a - size, b + size));
  };
  p[0] = across(c.left, c.right, c.shear_x);
  p[1] = across(c.bottom, c.top, c.shear_y);
  return p;
}

void bring_in_line(const Numbers& numbers, double* vertices) {
  const double t = numbers.random().between(-0.5, 1.5);
  for (int k = 0; k < 4; ++k) {
    const double a = vertices[k], b = vertices[kVertexNumbers + k];
    vertices[2 * kVertexNumbers + k] = numbers.beside(a + (b - a) * t);
  }
}

void set_triangle(const Numbers& numbers, const Camera& camera, bool is_clip) {
  Random& random = numbers.random();
  double* const vertices = clipscope_numbers();
  for (int i = 0; i < 3; ++i) {
    double* to = vertices + i * kVertexNumbers;
    for (const double x : is_clip ? clip_position(numbers) : view_position(camera, numbers)) {
      *to++ = x;
    }
    for (int k = 0; k < kAttributes; ++k) {
      *to++ = numbers.kind() == Kind::lattice ? random.below(5) - 2
                                              : numbers.rounded(random.between(-1, 1));
    }
  }
  if (numbers.kind() == Kind::sliver) bring_in_line(numbers, vertices);
  if (numbers.kind() == Kind::special) {
    for (int n = 1 + random.below(3); n > 0; --n) {
      vertices[random.below(3 * kVertexNumbers)] = numbers.special();
    }
  }
}

}  // namespace

Setting ask(std::uint64_t number) {
  Random random(number);
  const auto kind = static_cast<Kind>(number % kKinds);
  const bool is_clip = random.one_in(2);
  const Camera c = random_camera(random, kind);
  const int depth = random.below(3);
  clipscope_set_frustum(c.is_parallel, c.left, c.right, c.bottom, c.top, c.near, c.far,
                        c.is_infinite, c.shear_x, c.shear_y, depth);
  const bool is_plain = random.one_in(2);
  const int clamp = is_plain ? 0 : random.below(4);
  const int distances = is_plain ? 0 : random.below(kAttributes + 1);
  const int open = is_plain || random.one_in(2) ? 0 : random.below(16);
  clipscope_set_volume(clamp & 1, clamp >> 1, distances, open);
  set_triangle(Numbers(random, kind), c, is_clip);
  return {double(c.is_parallel),
          c.left,
          c.right,
          c.bottom,
          c.top,
          c.near,
          c.far,
          double(c.is_infinite),
          c.shear_x,
          c.shear_y,
          double(depth),
          double(clamp & 1),
          double(clamp >> 1),
          double(distances),
          double(open),
          double(is_clip)};
}

}  // namespace clipscope::explorer
