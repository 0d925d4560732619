// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/camera/matrix_meaning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "experiments/camera/exact_rows.hpp"

namespace clipscope::experiments {
namespace {

using camera::Exact3;
using camera::Exact4;
using camera::ExactRows;
using camera::Rational;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr std::size_t kX = 0, kY = 1, kZ = 2, kW = 3;

double ulp_of(double x, bool in_float) {
  if (in_float) {
    const auto f = static_cast<float>(std::abs(x));
    return double{std::nextafter(f, HUGE_VALF)} - double{f};
  }
  const double magnitude = std::abs(x);
  return std::nextafter(magnitude, kInfinity) - magnitude;
}

// What rounding may have moved an entry by. 0 and ±1 stand in a matrix since they are meant.
double half_ulp(double x, bool in_float) {
  return x == 0 || std::abs(x) == 1 ? 0 : ulp_of(x, in_float) / 2;
}

double unit_roundoff(bool in_float) { return in_float ? 0x1p-24 : 0x1p-53; }

// ---- The camera of the rows ---------------------------------------------------------------------

// What all else is made of, exactly.
struct Frame {
  bool perspective = true;
  Exact4 eye;      // (x, y, z, 1), or for parallel matrices the view direction (x, y, z, 0)
  Exact3 along;    // the view direction, of any length
  Rational scale;  // perspective: w at eye + along; parallel: w
};

Frame frame_of(const ExactRows& rows, DepthRange depth) {
  Frame f;
  f.eye = camera::common_point(rows[kX], rows[kY], rows[kW]);
  f.perspective = f.eye[3] != 0;
  if (f.perspective) {
    const Rational w = f.eye[3];
    for (Rational& x : f.eye) x /= w;
    f.along = camera::direction(rows[kW]);
    f.scale = camera::dot(f.along, f.along);
    return f;
  }
  f.along = camera::direction(f.eye);
  f.scale = rows[kW][3];
  // Depth grows away from the eye, or falls where it is reversed.
  const Rational growth = camera::dot(camera::direction(rows[kZ]), f.along) * f.scale;
  if ((growth < 0) != (depth == DepthRange::reversed)) {
    for (Rational& x : f.along) x = -x;
  }
  return f;
}

// The distance at which depth is v, in units of the frame's `along`; nothing at infinity.
std::optional<Rational> steps_to_depth(const ExactRows& rows, const Frame& f, int v) {
  const Rational growth = camera::dot(camera::direction(rows[kZ]), f.along);
  const Rational at_start = f.perspective ? camera::dot(rows[kZ], f.eye) : rows[kZ][3];
  const Rational rest = f.perspective ? Rational(v * f.scale - growth) : growth;
  const Rational wanted = f.perspective ? at_start : Rational(v * f.scale - at_start);
  if (rest == 0) return {};
  return Rational(wanted / rest);
}

double distance_to_depth(const ExactRows& rows, DepthRange depth, int v) {
  const Frame f = frame_of(rows, depth);
  const std::optional<Rational> steps = steps_to_depth(rows, f, v);
  return steps ? camera::to_double(*steps) * camera::length(f.along) : kInfinity;
}

// ---- Depth ------------------------------------------------------------------------------------

// Calls f(rows) with each entry that is not exact moved to its two neighbours.
template <class F>
void for_each_neighbour(const CameraMatrix& matrix, const F& f) {
  for (std::size_t i = 0; i < 16; ++i) {
    const int column = static_cast<int>(i % 4);
    const double entry = matrix.rows[i / 4][column];
    if (half_ulp(entry, matrix.in_float) == 0) continue;
    for (const double side : {-kInfinity, kInfinity}) {
      MatrixRows<double> rows = matrix.rows;
      rows[i / 4][column] =
          matrix.in_float
              ? double{std::nextafter(static_cast<float>(entry), static_cast<float>(side))}
              : std::nextafter(entry, side);
      if (std::isfinite(rows[i / 4][column])) f(camera::exact(rows));
    }
  }
}

// A distance that leaves infinity in sight, or is beyond it, has no upper bound.
void widen(Ranged& r, double distance, bool may_be_infinite) {
  if (may_be_infinite && !(distance > 0 && std::isfinite(distance))) {
    r.high = kInfinity;
    return;
  }
  r.low = std::min(r.low, distance);
  r.high = std::max(r.high, distance);
}

DepthReading reading_by(const CameraMatrix& matrix, DepthRange depth) {
  const int near = depth == DepthRange::minus_one_to_one ? -1 : depth == DepthRange::reversed;
  const int far = depth == DepthRange::reversed ? 0 : 1;
  const ExactRows rows = camera::exact(matrix.rows);
  DepthReading r{.depth = depth};
  const auto set = [&](Ranged& to, int v) {
    const double value = distance_to_depth(rows, depth, v);
    to = {value, value, value};
  };
  set(r.near, near);
  set(r.far, far);
  const bool perspective = frame_of(rows, depth).perspective;
  // A far plane behind the eye has everything in front of near on its inner side.
  if (perspective && r.near.value > 0 && r.far.value < 0) r.far = {kInfinity, kInfinity, kInfinity};
  for_each_neighbour(matrix, [&](const ExactRows& moved) {
    if (camera::rank(moved) < 4) return;
    widen(r.near, distance_to_depth(moved, depth, near), false);
    widen(r.far, distance_to_depth(moved, depth, far), perspective);
  });
  r.encloses_volume = r.near.value < r.far.value && (!perspective || r.near.value > 0);
  return r;
}

// ---- Planes -----------------------------------------------------------------------------------

// One row, or the sum or difference of two.
struct RowSum {
  Vec4<double> a, b;
  double sign;  // of b
};

RowSum row_sum_of(const MatrixRows<double>& m, DepthRange depth, Plane plane) {
  const Vec4<double> nothing(0, 0, 0, 0);
  const bool reversed = depth == DepthRange::reversed;
  const RowSum low = {depth == DepthRange::minus_one_to_one ? m[kW] : nothing, m[kZ], 1};
  const RowSum high = {m[kW], m[kZ], -1};
  switch (plane) {
    case Plane::left: return {m[kW], m[kX], 1};
    case Plane::right: return {m[kW], m[kX], -1};
    case Plane::bottom: return {m[kW], m[kY], 1};
    case Plane::top: return {m[kW], m[kY], -1};
    case Plane::near: return reversed ? high : low;
    case Plane::far: return reversed ? low : high;
  }
  return low;
}

PlaneReading plane_of(const CameraMatrix& matrix, DepthRange depth, Plane plane) {
  const RowSum s = row_sum_of(matrix.rows, depth, plane);
  PlaneReading r{.plane = plane};
  double normal = 0, unknown = 0;
  for (int i = 0; i < 4; ++i) {
    const double b = s.sign * s.b[i];
    double& sum = r.rounded[static_cast<std::size_t>(i)];
    sum = matrix.in_float ? double{static_cast<float>(s.a[i]) + static_cast<float>(b)} : s.a[i] + b;
    const Rational exact = Rational(s.a[i]) + Rational(b);
    r.is_exact = r.is_exact && exact == Rational(sum);
    if (i == 3) break;
    const double h = half_ulp(s.a[i], matrix.in_float) + half_ulp(b, matrix.in_float);
    normal = std::hypot(normal, camera::to_double(exact));
    unknown = std::hypot(unknown, h);
  }
  r.at_infinity = normal == 0;
  r.digits = unknown == 0 ? kInfinity : normal == 0 ? 0 : std::log10(normal / unknown);
  return r;
}

// ---- The picture ------------------------------------------------------------------------------

// One axis of the picture: its direction, and where its two sides are.
struct PictureAxis {
  glm::dvec3 direction = {};
  double low = 0, high = 0;
};

// Perspective: coordinate = size X + offset Z and w = length Z, at X along the axis and Z along the
// view direction. Parallel: coordinate = size X + offset.
PictureAxis picture_axis(const Exact4& row, const Frame& f) {
  const Exact3 own = camera::direction(row);
  const Exact3 across = f.perspective ? camera::without_part_along(own, f.along) : own;
  const double size = camera::length(across);
  const double offset = f.perspective
                            ? camera::to_double(camera::dot(own, f.along)) / camera::length(f.along)
                            : camera::to_double(row[3] / f.scale);
  const double edge = f.perspective ? camera::length(f.along) : 1;
  const double scale = f.perspective ? size : size / camera::to_double(f.scale);
  const double low = (-edge - offset) / scale, high = (edge - offset) / scale;
  return {camera::unit(across), std::min(low, high), std::max(low, high)};
}

void set_picture(const ExactRows& rows, const Frame& f, MatrixMeaning& m) {
  const PictureAxis x = picture_axis(rows[kX], f), y = picture_axis(rows[kY], f);
  const double turn = f.perspective || f.scale > 0 ? 1 : -1;  // a parallel w < 0 turns the picture
  m.forward = camera::unit(f.along);
  m.right = turn * x.direction;
  m.up = turn * y.direction;
  m.left = x.low, m.right_side = x.high, m.bottom = y.low, m.top = y.high;
  const glm::dvec3 side(m.right.y * m.up.z - m.right.z * m.up.y,
                        m.right.z * m.up.x - m.right.x * m.up.z,
                        m.right.x * m.up.y - m.right.y * m.up.x);
  m.right_handed = side.x * m.forward.x + side.y * m.forward.y + side.z * m.forward.z < 0;
  const double cosine = m.right.x * m.up.x + m.right.y * m.up.y + m.right.z * m.up.z;
  m.skew_degrees = 90 - std::acos(std::clamp(cosine, -1.0, 1.0)) * kDegrees;
  m.is_skewed = std::abs(cosine) > 8 * unit_roundoff(m.matrix.in_float);
}

// Whether depth grows off the view direction by more than four roundings of its row.
bool is_oblique(const ExactRows& rows, const Frame& f, bool in_float) {
  const Exact3 depth = camera::direction(rows[kZ]);
  const double off = camera::length(camera::without_part_along(depth, f.along));
  const double large = camera::length(depth);
  return off > 4 * unit_roundoff(in_float) * large;
}

bool is_projection_alone(const MatrixRows<double>& m, const Frame& f) {
  const auto is_zero = [&](std::size_t row, std::initializer_list<int> columns) {
    return std::ranges::all_of(columns, [&](int c) { return m[row][c] == 0; });
  };
  const bool axes =
      is_zero(kX, {1}) && is_zero(kY, {0}) && is_zero(kZ, {0, 1}) && is_zero(kW, {0, 1});
  return axes && (!f.perspective || (f.eye[0] == 0 && f.eye[1] == 0 && f.eye[2] == 0));
}

}  // namespace

double MatrixMeaning::horizontal_degrees() const {
  return (std::atan(right_side) - std::atan(left)) * kDegrees;
}
double MatrixMeaning::vertical_degrees() const {
  return (std::atan(top) - std::atan(bottom)) * kDegrees;
}
double MatrixMeaning::aspect() const { return (right_side - left) / (top - bottom); }

MatrixMeaning meaning_of(const CameraMatrix& matrix, std::optional<DepthRange> depth) {
  MatrixMeaning m{.matrix = matrix};
  const ExactRows rows = camera::exact(matrix.rows);
  if (const int rank = camera::rank(rows); rank < 4) {
    m.singular = Singular{rank, camera::lost_point(rows)};
    return m;
  }
  for (const DepthRange d :
       {DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed}) {
    m.readings.push_back(reading_by(matrix, d));
  }
  const auto fits = std::ranges::find_if(m.readings, &DepthReading::encloses_volume);
  m.depth = depth.value_or(fits == m.readings.end() ? DepthRange::minus_one_to_one : fits->depth);
  const Frame f = frame_of(rows, m.depth);
  m.perspective = f.perspective;
  m.has_negative_w = !f.perspective && f.scale < 0;
  m.is_projection_alone = is_projection_alone(matrix.rows, f);
  if (f.perspective) {
    m.eye = {camera::to_double(f.eye[0]), camera::to_double(f.eye[1]), camera::to_double(f.eye[2])};
  }
  set_picture(rows, f, m);
  m.is_oblique = is_oblique(rows, f, matrix.in_float);
  for (const Plane plane : kAllPlanes) m.planes.push_back(plane_of(matrix, m.depth, plane));
  return m;
}

}  // namespace clipscope::experiments
