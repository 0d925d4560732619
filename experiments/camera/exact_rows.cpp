// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/camera/exact_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clipscope::experiments::camera {
namespace {

// The reduced row echelon form and the column of each pivot. Exact, hence no choice of pivots.
struct Echelon {
  ExactRows rows;
  std::array<int, 4> pivots{};  // the first `rank` of them
  int rank = 0;
};

Echelon echelon_of(ExactRows rows) {
  Echelon e;
  for (std::size_t column = 0; column < 4 && e.rank < 4; ++column) {
    auto pivot = static_cast<std::size_t>(e.rank);
    while (pivot < 4 && rows[pivot][column] == 0) ++pivot;
    if (pivot == 4) continue;
    const auto top = static_cast<std::size_t>(e.rank);
    std::swap(rows[top], rows[pivot]);
    const Rational lead = rows[top][column];
    for (Rational& x : rows[top]) x /= lead;
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == top || rows[r][column] == 0) continue;
      const Rational factor = rows[r][column];
      for (std::size_t c = 0; c < 4; ++c) rows[r][c] -= factor * rows[top][c];
    }
    e.pivots[top] = static_cast<int>(column);
    ++e.rank;
  }
  e.rows = std::move(rows);
  return e;
}

Rational determinant(const Exact3& a, const Exact3& b, const Exact3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// All entries but one.
Exact3 without(const Exact4& v, std::size_t left_out) {
  Exact3 r;
  for (std::size_t i = 0, next = 0; i < 4; ++i) {
    if (i != left_out) r[next++] = v[i];
  }
  return r;
}

}  // namespace

ExactRows exact(const MatrixRows<double>& rows) {
  ExactRows r;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) r[i][k] = Rational(rows[i][static_cast<int>(k)]);
  }
  return r;
}

double to_double(const Rational& x) { return reference::round_to<double>(x); }

Rational dot(const Exact3& a, const Exact3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Rational dot(const Exact4& a, const Exact4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Exact3 direction(const Exact4& v) { return {v[0], v[1], v[2]}; }

Exact3 without_part_along(const Exact3& a, const Exact3& b) {
  const Rational share = dot(a, b) / dot(b, b);
  Exact3 r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = a[i] - share * b[i];
  return r;
}

double length(const Exact3& v) { return std::sqrt(to_double(dot(v, v))); }

glm::dvec3 unit(const Exact3& v) {
  const double size = length(v);
  return {to_double(v[0]) / size, to_double(v[1]) / size, to_double(v[2]) / size};
}

int rank(const ExactRows& rows) { return echelon_of(rows).rank; }

Exact4 common_point(const Exact4& a, const Exact4& b, const Exact4& c) {
  Exact4 r;
  for (std::size_t i = 0; i < 4; ++i) {
    r[i] = determinant(without(a, i), without(b, i), without(c, i));
    if (i % 2 == 1) r[i] = -r[i];
  }
  return r;
}

std::array<double, 4> lost_point(const ExactRows& rows) {
  const Echelon e = echelon_of(rows);
  const auto end = e.pivots.begin() + e.rank;
  int open = 3;  // the last column without a pivot
  while (std::find(e.pivots.begin(), end, open) != end) --open;
  Exact4 point = {0, 0, 0, 0};
  point[static_cast<std::size_t>(open)] = 1;
  for (int r = 0; r < e.rank; ++r) {
    const auto row = static_cast<std::size_t>(r);
    point[static_cast<std::size_t>(e.pivots[row])] = -e.rows[row][static_cast<std::size_t>(open)];
  }
  Rational scale = point[3];
  for (std::size_t i = 0; i < 3 && point[3] == 0; ++i) {
    if (abs(point[i]) > abs(scale)) scale = point[i];
  }
  std::array<double, 4> r;
  for (std::size_t i = 0; i < 4; ++i) r[i] = to_double(Rational(point[i] / scale));
  return r;
}

}  // namespace clipscope::experiments::camera
