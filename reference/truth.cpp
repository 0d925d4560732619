// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace clipscope::reference {
namespace {

enum Coordinate { kX, kY, kZ, kW };

double coordinate(const InputVertex& vertex, int i) {
  if (i < kOne) return vertex.position[i];
  return i == kOne ? 1 : vertex.attributes[i - kFirstAttribute];
}

// Higham, "Accuracy and Stability of Numerical Algorithms", 2002, lemma 3.1. The unit roundoff is
// the one of directed rounding, so that no rounding mode can break the bound.
constexpr double gamma(int n) {
  constexpr double u = std::numeric_limits<double>::epsilon();
  return n * u / (1 - n * u);
}

// a + b, a - b: forms as lists of terms.
LinearForm operator+(LinearForm a, const LinearForm& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
LinearForm operator-(const LinearForm& a, LinearForm b) {
  for (Term& term : b) term.coefficient = -term.coefficient;
  return a + b;
}

// The six half-spaces of the volume in clip coordinates x, y, z, w.
std::vector<Truth::HalfSpace> clip_half_spaces(DepthRange depth, const LinearForm& x,
                                               const LinearForm& y, const LinearForm& z,
                                               const LinearForm& w) {
  const LinearForm above_low = depth == DepthRange::minus_one_to_one ? w + z : z;
  const LinearForm below_high = w - z;
  const bool reversed = depth == DepthRange::reversed;
  return {{w + x},
          {w - x},
          {w + y},
          {w - y},
          {reversed ? below_high : above_low},
          {reversed ? above_low : below_high}};
}

void require_valid(const Frustum<double>& f) {
  const bool perspective = f.kind == ProjectionKind::perspective;
  bool finite = f.infinite_far || std::isfinite(f.far);
  for (const double v : {f.left, f.right, f.bottom, f.top, f.near, f.shear_x, f.shear_y}) {
    finite = finite && std::isfinite(v);
  }
  const bool sides = f.left < f.right && f.bottom < f.top;
  const bool depth = perspective ? f.near > 0 && (f.infinite_far || f.near < f.far)
                                 : !f.infinite_far && f.near < f.far;
  if (finite && sides && depth) return;
  std::ostringstream message;
  message << "frustum left " << f.left << " right " << f.right << " bottom " << f.bottom << " top "
          << f.top << " near " << f.near << " far " << f.far
          << (f.infinite_far ? " (infinite)" : "")
          << ": expected finite numbers with left < right, bottom < top, near < far"
          << (perspective ? ", 0 < near" : " and a finite far plane");
  throw std::invalid_argument(message.str());
}

void require_finite(const char* what, double number) {
  if (std::isfinite(number)) return;
  throw std::invalid_argument(std::string(what) + ": expected finite numbers, one is " +
                              std::to_string(number));
}

void require_valid(const ClipVolume& volume) {
  if (volume.clip_distances < 0 || volume.clip_distances > kMaxClipDistances) {
    throw std::invalid_argument("clip volume: expected 0 to 8 clip distances, there are " +
                                std::to_string(volume.clip_distances));
  }
}

// Truth::HalfSpace of the frustum, and their factors to the clip-space forms:
// w + x = 2 (near x + left z) / (right - left), and so on for the other planes.
std::vector<Truth::HalfSpace> perspective_volume(const Frustum<double>& f) {
  const double x_scale = 2 / (f.right - f.left);
  const double y_scale = 2 / (f.top - f.bottom);
  const double length = f.infinite_far ? 1 : f.far - f.near;
  const double z_scale = f.depth == DepthRange::minus_one_to_one ? 2 : 1;
  const double near_scale = f.infinite_far ? z_scale : z_scale * (f.far / length);
  std::vector<Truth::HalfSpace> r = {
      {{{f.near, kX}, {f.left, kZ}}, x_scale},   {{{-f.near, kX}, {-f.right, kZ}}, x_scale},
      {{{f.near, kY}, {f.bottom, kZ}}, y_scale}, {{{-f.near, kY}, {-f.top, kZ}}, y_scale},
      {{{-1, kZ}, {-f.near, kOne}}, near_scale},
  };
  if (!f.infinite_far) r.push_back({{{1, kZ}, {f.far, kOne}}, z_scale * (f.near / length)});
  return r;
}

// 1 + x = 2 (x + shear z - left) / (right - left), and so on.
std::vector<Truth::HalfSpace> parallel_volume(const Frustum<double>& f) {
  const double x_scale = 2 / (f.right - f.left);
  const double y_scale = 2 / (f.top - f.bottom);
  const double z_scale = (f.depth == DepthRange::minus_one_to_one ? 2 : 1) / (f.far - f.near);
  return {
      {{{1, kX}, {f.shear_x, kZ}, {-f.left, kOne}}, x_scale},
      {{{-1, kX}, {-f.shear_x, kZ}, {f.right, kOne}}, x_scale},
      {{{1, kY}, {f.shear_y, kZ}, {-f.bottom, kOne}}, y_scale},
      {{{-1, kY}, {-f.shear_y, kZ}, {f.top, kOne}}, y_scale},
      {{{-1, kZ}, {-f.near, kOne}}, z_scale},
      {{{1, kZ}, {f.far, kOne}}, z_scale},
  };
}

// The rows of glFrustum and its kin, times the divisors of their quotients.
std::array<ProjectionForm, 3> perspective_projection(const Frustum<double>& f) {
  const Dyadic left = f.left, right = f.right, bottom = f.bottom, top = f.top, near = f.near;
  const Dyadic two = 2;
  std::array<ProjectionForm, 3> r;
  r[kX].coefficients[kX] = two * near;
  r[kX].coefficients[kZ] = right + left;
  r[kX].scale = right - left;
  r[kY].coefficients[kY] = two * near;
  r[kY].coefficients[kZ] = top + bottom;
  r[kY].scale = top - bottom;

  // Depth: z_clip = (a z + b) / (far - near); with an infinite far plane the limit of that.
  const Dyadic far = f.infinite_far ? 1 : f.far;
  const Dyadic far_weight = f.infinite_far ? 0 : 1;  // near / far -> 0
  Dyadic& a = r[kZ].coefficients[kZ];
  Dyadic& b = r[kZ].coefficients[kOne];
  switch (f.depth) {
    case DepthRange::minus_one_to_one:
      a = -(far + far_weight * near);
      b = -(two * far * near);
      break;
    case DepthRange::zero_to_one:
      a = -far;
      b = -(far * near);
      break;
    case DepthRange::reversed:
      a = far_weight * near;
      b = far * near;
      break;
  }
  r[kZ].scale = far - far_weight * near;
  return r;
}

std::array<ProjectionForm, 3> parallel_projection(const Frustum<double>& f) {
  const Dyadic left = f.left, right = f.right, bottom = f.bottom, top = f.top;
  const Dyadic near = f.near, far = f.far;
  const Dyadic two = 2;
  std::array<ProjectionForm, 3> r;
  r[kX].coefficients[kX] = two;
  r[kX].coefficients[kZ] = two * Dyadic(f.shear_x);
  r[kX].coefficients[kOne] = -(right + left);
  r[kX].scale = right - left;
  r[kY].coefficients[kY] = two;
  r[kY].coefficients[kZ] = two * Dyadic(f.shear_y);
  r[kY].coefficients[kOne] = -(top + bottom);
  r[kY].scale = top - bottom;

  Dyadic& a = r[kZ].coefficients[kZ];
  Dyadic& b = r[kZ].coefficients[kOne];
  switch (f.depth) {
    case DepthRange::minus_one_to_one:
      a = -2;
      b = -(far + near);
      break;
    case DepthRange::zero_to_one:
      a = -1;
      b = -near;
      break;
    case DepthRange::reversed:
      a = 1;
      b = far;
      break;
  }
  r[kZ].scale = far - near;
  return r;
}

// A row given by its terms, with the scale 1.
ProjectionForm projection_form(const LinearForm& form) {
  ProjectionForm r;
  for (const Term& term : form) r.coefficients[term.coordinate] += Dyadic(term.coefficient);
  return r;
}

template <class T>
LinearForm row(const ProjectionRow<T>& row, Coordinate own) {
  return {{row.own, own}, {row.z, kZ}, {row.one, kOne}};
}

template <class T>
LinearForm depth_row(const ProjectionRow<T>& row) {
  return {{row.z, kZ}, {row.one, kOne}};
}

void drop_zero_terms(LinearForm& form) {
  std::erase_if(form, [](const Term& term) { return term.coefficient == 0; });
}

}  // namespace

bool is_finite(std::span<const InputVertex> vertices, int attribute_count) {
  const auto finite = [](double v) { return std::isfinite(v); };
  return std::ranges::all_of(vertices, [&](const InputVertex& v) {
    return std::ranges::all_of(v.position, finite) &&
           std::all_of(v.attributes.begin(), v.attributes.begin() + attribute_count, finite);
  });
}

bool is_finite(const InputTriangle& triangle) {
  return is_finite(triangle.vertices, triangle.attribute_count);
}

Dyadic value(const LinearForm& form, const InputVertex& vertex) {
  Dyadic sum = 0;
  for (const Term& term : form) {
    sum += Dyadic(term.coefficient) * Dyadic(coordinate(vertex, term.coordinate));
  }
  return sum;
}

// With n terms t_i: n products and n - 1 sums lose at most gamma(n) sum |t_i|, and at most the
// smallest normal number per product if it underflows (even where subnormals are flushed to zero).
// sum |t_i| is itself known up to a factor 1 + gamma(n) and the bound's own rounding. An overflow
// leaves an infinity or a NaN, with which both comparisons are false.
int sign(const LinearForm& form, const InputVertex& vertex) {
  double sum = 0, magnitude = 0;
  for (const Term& term : form) {
    const double product = term.coefficient * coordinate(vertex, term.coordinate);
    sum += product;
    magnitude += std::abs(product);
  }
  const int n = static_cast<int>(form.size());
  const double bound = gamma(2 * n + 4) * magnitude + 2 * n * std::numeric_limits<double>::min();
  if (sum > bound) return 1;
  if (sum < -bound) return -1;
  return static_cast<int>(value(form, vertex).sign());
}

Dyadic ProjectionForm::value(const InputVertex& vertex) const {
  Dyadic sum = 0;
  for (int i = 0; i <= kOne; ++i) {
    if (!coefficients[i].is_zero()) sum += coefficients[i] * Dyadic(coordinate(vertex, i));
  }
  return sum;
}

// The six in the order of Plane, an infinite far plane missing.
void Truth::set_half_spaces(std::vector<HalfSpace> six) {
  constexpr int kNear = 4, kFar = 5;
  half_spaces_ = std::move(six);
  const OpenSides& open = volume_.open_sides;
  const std::array is_open = {open.left, open.right, open.bottom, open.top};
  for (std::size_t side = 0; side < is_open.size(); ++side) {
    half_spaces_[side].is_open = is_open[side];
  }
  if (volume_.depth_clamp.far) half_spaces_.resize(kFar);
  if (volume_.depth_clamp.near) half_spaces_.erase(half_spaces_.begin() + kNear);
  for (HalfSpace& half_space : half_spaces_) drop_zero_terms(half_space.form);
  for (int i = 0; i < volume_.clip_distances; ++i) {
    half_spaces_.push_back({{{1, kFirstAttribute + i}}});
  }
}

Truth Truth::of_frustum(const Frustum<double>& frustum) {
  return of_frustum(frustum, {.depth = frustum.depth});
}

Truth Truth::of_frustum(const Frustum<double>& frustum, const ClipVolume& volume) {
  require_valid(frustum);
  require_valid(volume);
  if (volume.depth != frustum.depth) {
    throw std::invalid_argument("frustum and clip volume differ in depth range");
  }
  Truth truth;
  truth.kind_ = TruthKind::frustum;
  truth.volume_ = volume;
  if (frustum.kind == ProjectionKind::perspective) {
    truth.set_half_spaces(perspective_volume(frustum));
    truth.projection_ = perspective_projection(frustum);
    truth.w_ = {{-1, kZ}};
  } else {
    truth.set_half_spaces(parallel_volume(frustum));
    truth.projection_ = parallel_projection(frustum);
    truth.w_ = {{1, kOne}};
  }
  return truth;
}

Truth Truth::of_rows(const ClipVolume& volume, const std::array<LinearForm, 4>& rows) {
  for (const LinearForm& form : rows) {
    for (const Term& term : form) require_finite("projection matrix", term.coefficient);
  }
  require_valid(volume);
  Truth truth;
  truth.kind_ = TruthKind::matrix;
  truth.volume_ = volume;
  truth.set_half_spaces(clip_half_spaces(volume.depth, rows[0], rows[1], rows[2], rows[3]));
  truth.w_ = rows[3];
  for (int i = 0; i < 3; ++i) truth.projection_[i] = projection_form(rows[i]);
  return truth;
}

Truth Truth::of_matrix(const Projection<float>& p) {
  return of_rows(p.volume, {row(p.x, kX), row(p.y, kY), depth_row(p.z), depth_row(p.w)});
}

Truth Truth::of_matrix(const Projection<double>& p) {
  return of_rows(p.volume, {row(p.x, kX), row(p.y, kY), depth_row(p.z), depth_row(p.w)});
}

Truth Truth::of_matrix(const MatrixRows<double>& rows, const ClipVolume& volume) {
  const auto form = [](const Vec4<double>& r) {
    return LinearForm{{r[0], kX}, {r[1], kY}, {r[2], kZ}, {r[3], kOne}};
  };
  return of_rows(volume, {form(rows[0]), form(rows[1]), form(rows[2]), form(rows[3])});
}

Truth Truth::with_planes(std::span<const std::array<double, 4>> planes) const {
  Truth truth = *this;
  for (const auto& [a, b, c, d] : planes) {
    for (const double x : {a, b, c, d}) require_finite("user plane", x);
    // The fourth coordinate is 1 in view space.
    HalfSpace& plane =
        truth.half_spaces_.emplace_back(HalfSpace{{{a, kX}, {b, kY}, {c, kZ}, {d, kW}}});
    drop_zero_terms(plane.form);
  }
  return truth;
}

Truth Truth::of_clip(DepthRange depth) { return of_clip(ClipVolume{.depth = depth}); }

Truth Truth::of_clip(const ClipVolume& volume) {
  require_valid(volume);
  const LinearForm x = {{1, kX}}, y = {{1, kY}}, z = {{1, kZ}}, w = {{1, kW}};
  Truth truth;
  truth.volume_ = volume;
  truth.set_half_spaces(clip_half_spaces(volume.depth, x, y, z, w));
  truth.w_ = w;
  truth.projection_ = {projection_form(x), projection_form(y), projection_form(z)};
  return truth;
}

Truth Truth::inset(double distance, double attribute_distance) const {
  Truth truth = *this;
  for (HalfSpace& half_space : truth.half_spaces_) {
    const LinearForm& form = half_space.form;
    const bool is_clip_distance = !form.empty() && form.front().coordinate >= kFirstAttribute;
    half_space.form.push_back(
        {is_clip_distance ? -attribute_distance : -distance / half_space.clip_scale, kOne});
  }
  if (distance < 0) truth.half_spaces_.push_back({w_});
  return truth;
}

std::array<Rational, 4> Truth::clip_position(const InputVertex& vertex) const {
  std::array<Rational, 4> r;
  for (int i = 0; i < 3; ++i) {
    r[i] = to_rational(Fraction{projection_[i].value(vertex), projection_[i].scale});
  }
  r[3] = to_rational(value(w_, vertex));
  return r;
}

}  // namespace clipscope::reference
