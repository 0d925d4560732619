// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/depth/measure.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <limits>

#include "experiments/contestants/scalars.hpp"
#include "experiments/machine/errors.hpp"

namespace clipscope::experiments::depth {
namespace {

using reference::Rational;
using reference::to_rational;

constexpr int kPairs = 64;
// The pairs lie within 1/64 of the distance, over which no convention's resolution changes by more
// than 4 %.
constexpr double kNeighbourhood = 1.0 / 64;

Frustum<double> frustum_of(const Convention& convention, double near, double far) {
  return {
      .near = near, .far = far, .infinite_far = convention.infinite_far, .depth = convention.range};
}

// The largest code of a fixed-point format.
double largest_code(Stored format) { return format == Stored::unorm16 ? 0xffff : 0xffffff; }

template <class T>
std::function<double(float)> window_depth(const Frustum<double>& frustum) {
  return [projection = projection_from<T>(frustum)](float distance) {
    const Vec4<T> clip = to_clip(projection, Vec3<T>(T(0), T(0), -T(distance)));
    const T ndc = clip[2] / clip[3];
    return projection.volume.depth == DepthRange::minus_one_to_one ? T(0.5) * ndc + T(0.5) : ndc;
  };
}

// Whether pairs that are `gap` metres apart are told apart.
bool are_separated(const Buffer& buffer, float distance, bool away, double gap) {
  for (int i = 0; i < kPairs; ++i) {
    const double shift = kNeighbourhood * i / kPairs * distance;
    const float first = static_cast<float>(away ? distance + shift : distance - shift);
    const float second = static_cast<float>(away ? first + gap : first - gap);
    const std::int64_t a = buffer.code(first), b = buffer.code(second);
    if (!(away ? a < b : b < a)) return false;
  }
  return true;
}

// A form between two planes.
struct Setting {
  Form form;
  float near, far;

  template <class N>
  N depth(const N& d) const {
    return depth_ndc<N>(form, d, N(near), N(far));
  }
  // The inverse.
  Rational distance_of(const Rational& depth) const {
    const Rational n(near), f(far);
    if (form == Form::linear) return Rational(2 * f * n / (f + n - depth * (f - n)));
    return Rational((depth * (f - n) + f + n) / 2);
  }
  float random_distance(Random& random) const {
    return std::clamp(static_cast<float>(random.across_magnitudes(near, far)), near, far);
  }
};

template <class N>
void check_order(const Setting& setting, float nearer, float farther, FormRow& row) {
  const N a = setting.depth(N(nearer)), b = setting.depth(N(farther));
  ++row.samples;
  row.violations += std::same_as<N, Rational> ? !(a < b) : b < a;
  const N drop = a - b;
  row.max_deviation_ndc = std::max(row.max_deviation_ndc, nearest_double(drop));
}

// Where an edge is seen: how far its point is, and the depth that a rasterizer interpolates there.
struct Seen {
  Rational distance, depth;
};

// An edge by the distances of its ends, seen at s in [0, 1] between their images on the screen.
Seen see_edge(const Setting& setting, const Rational& from, const Rational& to, const Rational& s) {
  const Rational inverse = (1 - s) / from + s / to;  // 1/d is linear on the screen
  const Rational a = setting.depth(from), b = setting.depth(to);
  return {1 / inverse, (1 - s) * a + s * b};
}

double magnitude(const Rational& difference) { return std::abs(nearest_double(difference)); }

void check_straight(const Setting& setting, const Seen& seen, FormRow& row) {
  const Rational right = setting.depth(seen.distance);
  ++row.samples;
  row.violations += seen.depth != right;
  row.max_deviation_ndc = std::max(row.max_deviation_ndc, magnitude(seen.depth - right));
  row.max_deviation_m =
      std::max(row.max_deviation_m, magnitude(setting.distance_of(seen.depth) - seen.distance));
}

void check_nearer_wins(const Seen& a, const Seen& b, FormRow& row) {
  if (a.distance == b.distance) return;
  ++row.samples;
  if ((a.distance < b.distance) == (a.depth < b.depth) && a.depth != b.depth) return;
  ++row.violations;
  row.max_deviation_m = std::max(row.max_deviation_m, magnitude(a.distance - b.distance));
}

void check_form(const Setting& setting, std::size_t samples, Random& random,
                std::vector<FormRow>& rows) {
  const auto [form, near, far] = setting;
  const double ratio = double{far} / near, root = std::sqrt(ratio);
  FormRow exact_order{form, "monotone", "exact", ratio},
      float_order{form, "monotone", "float", ratio},
      double_order{form, "monotone", "double", ratio},
      straight{form, "lines stay straight", "exact", ratio},
      wins{form, "nearer wins", "exact", ratio};
  // The edge that goes all the way, at the point where the deviation is largest, comes first.
  check_straight(setting,
                 see_edge(setting, Rational(near), Rational(far), to_rational(root / (1 + root))),
                 straight);
  for (std::size_t i = 0; i < samples; ++i) {
    const float nearer = std::min(setting.random_distance(random), std::nextafter(far, 0.0f));
    const float farther = std::nextafter(nearer, std::numeric_limits<float>::infinity());
    check_order<Rational>(setting, nearer, farther, exact_order);
    check_order<float>(setting, nearer, farther, float_order);
    check_order<double>(setting, nearer, farther, double_order);
    std::array<Rational, 4> ends;
    for (Rational& end : ends) end = Rational(setting.random_distance(random));
    const Rational s = to_rational(random.uniform()), t = to_rational(random.uniform());
    const Seen a = see_edge(setting, ends[0], ends[1], s),
               b = see_edge(setting, ends[2], ends[3], t);
    check_straight(setting, a, straight);
    check_nearer_wins(a, b, wins);
  }
  rows.insert(rows.end(), {exact_order, float_order, double_order, straight, wins});
}

template <class Clip>
EyePlaneRow eye_plane_row(const std::string& arithmetic, const Clip& p) {
  return {arithmetic,           nearest_double(p[0]), nearest_double(p[1]),
          nearest_double(p[2]), nearest_double(p[3]), p[3] != 0};
}

}  // namespace

std::vector<Arithmetic> arithmetics_of(const std::vector<std::string>& scalars) {
  std::vector<Arithmetic> chosen;
  for (const Arithmetic a : {Arithmetic::in_float, Arithmetic::in_double}) {
    if (std::ranges::find(scalars, name_of(a)) != scalars.end()) chosen.push_back(a);
  }
  if (chosen.empty()) throw UsageError("--scalar: experiment depth takes float and double");
  return chosen;
}

Buffer::Buffer(const Convention& convention, Stored format, Arithmetic arithmetic, float near,
               float far)
    : convention_(convention),
      format_(format),
      near_(near),
      far_(far),
      window_depth_((arithmetic == Arithmetic::in_float
                         ? window_depth<float>
                         : window_depth<double>)(frustum_of(convention, near, far))),
      truth_(reference::Truth::of_frustum(frustum_of(convention, near, far))) {}

double Buffer::stored(float distance) const {
  const double depth = std::clamp(window_depth_(distance), 0.0, 1.0);
  if (format_ == Stored::float32) return static_cast<float>(depth);
  const double largest = largest_code(format_);
  return std::nearbyint(depth * largest) / largest;
}

std::int64_t Buffer::code(float distance) const {
  const double depth = stored(distance);
  // The bits of floats >= 0 are in the order of their values.
  const std::int64_t place = format_ == Stored::float32
                                 ? std::bit_cast<std::int32_t>(static_cast<float>(depth) + 0.0f)
                                 : std::llround(depth * largest_code(format_));
  return convention_.range == DepthRange::reversed ? -place : place;
}

Rational Buffer::exact(float distance) const {
  reference::InputVertex vertex;
  vertex.position = {0, 0, -double{distance}, 1};
  const auto clip = truth_.clip_position(vertex);
  const Rational ndc = clip[2] / clip[3];
  if (convention_.range != DepthRange::minus_one_to_one) return ndc;
  const Rational window = (ndc + 1) / 2;
  return window;
}

double Buffer::error_ulp(float distance) const {
  const Rational right = exact(distance);
  const Rational difference = to_rational(stored(distance)) - right;
  const double error = std::abs(nearest_double(difference));
  if (format_ != Stored::float32) return error * largest_code(format_);
  return error / kFormat<float>.ulp_at(nearest_double(right));
}

std::vector<float> spread_distances(float near, float far, std::size_t count, Random& random) {
  std::vector<float> distances;
  const double octaves = std::log2(double{far} / near);
  for (std::size_t i = 0; i < count; ++i) {
    const double place = (static_cast<double>(i) + random.uniform()) / static_cast<double>(count);
    const double distance = near * std::exp2(octaves * place);
    const float d = std::clamp(static_cast<float>(distance), near, far);
    if (distances.empty() || distances.back() < d) distances.push_back(d);
  }
  return distances;
}

Order order_of(const Buffer& buffer, std::span<const float> distances) {
  std::vector<std::int64_t> codes;
  for (const float d : distances) codes.push_back(buffer.code(d));
  Order order;
  for (std::size_t i = 1; i < codes.size(); ++i) {
    ++order.pairs;
    order.misordered += codes[i] < codes[i - 1];
    order.tied += codes[i] == codes[i - 1];
  }
  std::ranges::sort(codes);
  order.distinct =
      static_cast<std::size_t>(std::unique(codes.begin(), codes.end()) - codes.begin());
  return order;
}

std::optional<double> resolution(const Buffer& buffer, float distance) {
  const bool away = distance == buffer.near();
  const double spacing = kFormat<float>.ulp_at(distance);
  // What leaves every pair within the range of distances.
  const double room = away ? buffer.far() - (1 + kNeighbourhood) * distance
                           : (1 - kNeighbourhood) * distance - buffer.near();
  const auto most = std::max(std::int64_t{1}, static_cast<std::int64_t>(room / spacing));
  const auto enough_at = [&](std::int64_t steps) {
    return are_separated(buffer, distance, away, static_cast<double>(steps) * spacing);
  };
  std::int64_t too_small = 0, enough = 1;
  while (!enough_at(enough)) {
    if (enough == most) return std::nullopt;
    too_small = enough;
    enough = std::min(2 * enough, most);
  }
  while (enough - too_small > 1) {
    const std::int64_t middle = too_small + (enough - too_small) / 2;
    (enough_at(middle) ? enough : too_small) = middle;
  }
  return static_cast<double>(enough) * spacing;
}

std::vector<FormRow> check_forms(float near, float far, std::size_t samples, Random& random) {
  std::vector<FormRow> rows;
  for (const Form form : {Form::linear, Form::quadratic}) {
    check_form({form, near, far}, samples, random, rows);
  }
  return rows;
}

std::vector<EyePlaneRow> point_beside_the_eye() {
  const Frustum<double> frustum;
  reference::InputVertex point;
  point.position = {1, 1, 0, 1};
  const auto clip = reference::Truth::of_frustum(frustum).clip_position(point);
  return {
      eye_plane_row("exact", clip),
      eye_plane_row("float", to_clip(projection_from<float>(frustum), Vec3<float>(1, 1, 0))),
      eye_plane_row("double", to_clip(projection_from<double>(frustum), Vec3<double>(1, 1, 0)))};
}

}  // namespace clipscope::experiments::depth
