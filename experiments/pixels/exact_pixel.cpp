// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/exact_pixel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/fraction.hpp"

namespace clipscope::experiments {
namespace {

// x, y and w of each vertex as integers times 2^exponent.
struct IntegerVertices {
  std::vector<std::array<mpz_class, 3>> xyw;
  int exponent = 0;
};

constexpr std::array<std::size_t, 3> kXyw = {0, 1, 3};

// The exponent of a float's last bit.
int last_bit(float v) { return v == 0 ? std::numeric_limits<int>::max() : std::ilogb(v) - 23; }

IntegerVertices integers(const DrawCall& call, std::span<const std::uint32_t> vertices) {
  IntegerVertices result;
  result.exponent = std::numeric_limits<int>::max();
  for (const std::uint32_t number : vertices) {
    for (const std::size_t c : kXyw) {
      result.exponent = std::min(result.exponent, last_bit(call.vertices[number].position[c]));
    }
  }
  if (result.exponent == std::numeric_limits<int>::max()) result.exponent = 0;
  for (const std::uint32_t number : vertices) {
    std::array<mpz_class, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      const double exact = call.vertices[number].position[kXyw[k]];
      v[k] = std::ldexp(exact, -result.exponent);
    }
    result.xyw.push_back(v);
  }
  return result;
}

std::array<mpz_class, 3> cross(const std::array<mpz_class, 3>& a,
                               const std::array<mpz_class, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The centre of pixel (0, 0) as integers, and P_w; a px further to the right x grows by 2 height.
struct Grid {
  long x, y, w, step_x, step_y;
  explicit Grid(const Viewport& port)
      : x((1L - 2L * port.x - port.width) * port.height),
        y((1L - 2L * port.y - port.height) * port.width),
        w(long{port.width} * port.height),
        step_x(2L * port.height),
        step_y(2L * port.width) {}
};

template <class Integer>
Integer at_pixel(const Integer& a, const Integer& b, const Integer& c, int x, int y) {
  return a * x + b * y + c;
}

Int128 to_128(const mpz_class& v) {
  const mpz_class magnitude = abs(v), high = magnitude >> 64;
  const mpz_class low = magnitude - (high << 64);
  const Int128 joined = (static_cast<Int128>(high.get_ui()) << 64) + low.get_ui();
  return v < 0 ? -joined : joined;
}

// Toward 0: within 2^-52, which `enclosed` counts with.
double near(const mpz_class& v) { return mpz_get_d(v.get_mpz_t()); }

void set_inverses(PixelWeights& r) {
  r.inverse_sum = 1 / r.sum;
  r.inverse_det = 1 / r.det;
}

std::size_t bits(const mpz_class& v) { return mpz_sizeinbase(v.get_mpz_t(), 2); }

mpq_class times_power(const mpq_class& v, int exponent) {
  mpq_class r;
  const auto size = static_cast<mp_bitcnt_t>(std::abs(exponent));
  if (exponent >= 0) {
    mpq_mul_2exp(r.get_mpq_t(), v.get_mpq_t(), size);
  } else {
    mpq_div_2exp(r.get_mpq_t(), v.get_mpq_t(), size);
  }
  return r;
}

}  // namespace

ExactPrimitive::ExactPrimitive(const DrawCall& call, std::span<const std::uint32_t> vertices) {
  if (vertices.size() == 3) {
    set_triangle(call, vertices);
  } else {
    set_line(call, vertices);
  }
  orientation_ = sgn(det_);
  if (orientation_ < 0) {
    for (auto& plane : planes_) {
      plane.a = -plane.a;
      plane.b = -plane.b;
      plane.c = -plane.c;
    }
    det_ = -det_;
  }
  unit_ = std::ldexp(1.0, exponent_);
  det_double_ = std::ldexp(near(det_), det_exponent_);
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    by_x_[i] = near(planes_[i].a) * unit_;
    by_y_[i] = near(planes_[i].b) * unit_;
  }
  shorten(call);
}

void ExactPrimitive::set_triangle(const DrawCall& call, std::span<const std::uint32_t> vertices) {
  const IntegerVertices v = integers(call, vertices);
  const Grid grid(call.viewport);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto n = cross(v.xyw[(i + 1) % 3], v.xyw[(i + 2) % 3]);
    planes_.push_back(
        {n[0] * grid.step_x, n[1] * grid.step_y, n[0] * grid.x + n[1] * grid.y + n[2] * grid.w});
    if (i == 0) det_ = n[0] * v.xyw[0][0] + n[1] * v.xyw[0][1] + n[2] * v.xyw[0][2];
  }
  det_ *= grid.w;
  exponent_ = 2 * v.exponent;
  det_exponent_ = 3 * v.exponent;
}

// With d = (x_b w_a - x_a w_b, y_b w_a - y_a w_b), in px times w_a w_b by the squares of the
// viewport's sides, and N_v = (P w_v - V P_w) . d of an end V: t / w_b = N_a / D and
// (1 - t) / w_a = -N_b / D, D = P_w d . d.
void ExactPrimitive::set_line(const DrawCall& call, std::span<const std::uint32_t> vertices) {
  const IntegerVertices v = integers(call, vertices);
  const Grid grid(call.viewport);
  const auto& a = v.xyw[0];
  const auto& b = v.xyw[1];
  const mpz_class dx = b[0] * a[2] - a[0] * b[2], dy = b[1] * a[2] - a[1] * b[2];
  const mpz_class width = call.viewport.width, height = call.viewport.height;
  const mpz_class along_x = width * width * dx, along_y = height * height * dy;
  const auto plane_of = [&](const std::array<mpz_class, 3>& end, int sign) {
    const mpz_class x = along_x * end[2] * sign, y = along_y * end[2] * sign;
    const mpz_class w = -(along_x * end[0] + along_y * end[1]) * sign;
    planes_.push_back({x * grid.step_x, y * grid.step_y, x * grid.x + y * grid.y + w * grid.w});
  };
  plane_of(b, -1);
  plane_of(a, 1);
  det_ = (along_x * dx + along_y * dy) * grid.w;
  exponent_ = 3 * v.exponent;
  det_exponent_ = 4 * v.exponent;
}

// All of a x + b y + c, and the sum of three of them, stays below 2^126 in magnitude.
void ExactPrimitive::shorten(const DrawCall& call) {
  const std::size_t pixel = bits(mpz_class(std::max(call.width, call.height)));
  for (const auto& plane : planes_) {
    if (std::max({bits(plane.a) + pixel, bits(plane.b) + pixel, bits(plane.c)}) > 122) return;
  }
  for (const auto& plane : planes_) {
    short_planes_.push_back({to_128(plane.a), to_128(plane.b), to_128(plane.c)});
  }
}

std::array<mpz_class, 3> ExactPrimitive::long_weights(int x, int y) const {
  std::array<mpz_class, 3> r;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    r[i] = at_pixel<mpz_class>(planes_[i].a, planes_[i].b, planes_[i].c, x, y);
  }
  return r;
}

PixelWeights ExactPrimitive::weights(int x, int y) const {
  PixelWeights r;
  r.det = det_double_;
  if (short_planes_.empty()) {
    const std::array<mpz_class, 3> e = long_weights(x, y);
    for (std::size_t i = 0; i < 3; ++i) r.weights[i] = near(e[i]) * unit_;
    r.sum = near(mpz_class(e[0] + e[1] + e[2])) * unit_;
    set_inverses(r);
    return r;
  }
  Int128 sum = 0;
  for (std::size_t i = 0; i < short_planes_.size(); ++i) {
    const auto& plane = short_planes_[i];
    const Int128 e = at_pixel<Int128>(plane.a, plane.b, plane.c, x, y);
    r.weights[i] = static_cast<double>(e) * unit_;
    sum += e;
  }
  r.sum = static_cast<double>(sum) * unit_;
  set_inverses(r);
  return r;
}

PixelWeights ExactPrimitive::weights_beside(const PixelWeights& at, double dx, double dy) const {
  PixelWeights r = at;
  for (std::size_t i = 0; i < 3; ++i) {
    const double step = by_x_[i] * dx + by_y_[i] * dy;
    r.weights[i] += step;
    r.sum += step;
  }
  set_inverses(r);
  return r;
}

int ExactPrimitive::sign(int x, int y, const std::array<double, 3>& n) const {
  const std::array<mpz_class, 3> e = long_weights(x, y);
  mpq_class sum = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) sum += mpq_class(e[i]) * mpq_class(n[i]);
  return sgn(sum);
}

mpq_class ExactPrimitive::value(const Interpolant& interpolant, int x, int y) const {
  const std::array<mpz_class, 3> e = long_weights(x, y);
  mpq_class numerator = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    numerator += mpq_class(e[i]) * mpq_class(interpolant.of_vertices[i]);
  }
  const mpq_class sum(mpz_class(e[0] + e[1] + e[2]));
  const mpq_class quotient = interpolant.is_perspective ? mpq_class(numerator / sum)
                                                        : times_power(numerator / mpq_class(det_),
                                                                      exponent_ - det_exponent_);
  return mpq_class(interpolant.offset) + mpq_class(interpolant.scale) * quotient;
}

bool covers(const DrawCall& call, std::span<const std::uint32_t> vertices,
            const ExactPrimitive& primitive, int x, int y) {
  const Viewport& port = call.viewport;
  const bool is_beside =
      x < port.x || y < port.y || x >= port.x + port.width || y >= port.y + port.height;
  if (primitive.orientation() == 0 || is_beside) return false;
  const auto is_at_least_0 = [&](const Interpolant& sum, const Interpolant& other) {
    return sgn(mpq_class(primitive.value(sum, x, y) + primitive.value(other, x, y))) >= 0;
  };
  Interpolant w, z, negative_z;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> only = {};
    only[i] = 1;
    if (primitive.sign(x, y, only) < 0) return false;
    const auto& position = call.vertices[vertices[i]].position;
    w.of_vertices[i] = position[3];
    z.of_vertices[i] = position[2];
    negative_z.of_vertices[i] = -static_cast<double>(position[2]);
  }
  const bool is_symmetric = call.volume.depth == DepthRange::minus_one_to_one;
  const Interpolant nothing;
  if (!call.volume.depth_clamp.near && !is_at_least_0(z, is_symmetric ? w : nothing)) return false;
  if (!call.volume.depth_clamp.far && !is_at_least_0(w, negative_z)) return false;
  for (int c = 0; c < call.volume.clip_distances; ++c) {
    std::array<double, 3> n = {};
    for (std::size_t i = 0; i < 3; ++i) {
      n[i] = call.vertices[vertices[i]].clip_distances[static_cast<std::size_t>(c)];
    }
    if (primitive.sign(x, y, n) < 0) return false;
  }
  return true;
}

}  // namespace clipscope::experiments
