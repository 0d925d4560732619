// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/overlap.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

namespace clipscope::reference {
namespace {

// A half-space normal . p + offset >= 0.
struct Plane4 {
  std::array<Dyadic, 3> normal = {Dyadic(0), Dyadic(0), Dyadic(0)};
  Dyadic offset = 0;

  explicit Plane4(const LinearForm& form) {
    for (const Term& term : form) {
      assert(term.coordinate < 3 || term.coordinate == kOne);
      Dyadic& to =
          term.coordinate == kOne ? offset : normal[static_cast<std::size_t>(term.coordinate)];
      to += Dyadic(term.coefficient);
    }
  }
  Dyadic value(const ExactPoint& p) const {
    return normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] + offset;
  }
};

std::vector<Plane4> planes_of(std::span<const LinearForm> half_spaces) {
  return {half_spaces.begin(), half_spaces.end()};
}

using Row = std::vector<Rational>;

// Whether there are l_i >= 0 with sum 1 and s_h = sum of l_i f_h(i) >= 0 for all h.
//
// A row is an equation over the columns l_0, l_1, ..., s_0, s_1, ... and its right-hand side,
// solved for its variable in the basis. The last row, sum of l_i + a = 1, begins with an artificial
// variable a >= 0, which the simplex method makes as small as it gets: there are such l_i exactly
// if that is 0.
class Feasibility {
 public:
  // values[h][i]: half-space h at point i.
  explicit Feasibility(const std::vector<std::vector<Dyadic>>& values)
      : points_(values.front().size()), columns_(points_ + values.size()) {
    for (std::size_t h = 0; h < values.size(); ++h) {
      // s_h - sum of l_i f_h(i) = 0: s_h itself is in the basis, at 0.
      Row row(columns_ + 1, Rational(0));
      for (std::size_t i = 0; i < points_; ++i) row[i] = -to_rational(values[h][i]);
      row[points_ + h] = 1;
      rows_.push_back(std::move(row));
      basis_.push_back(points_ + h);
    }
    Row sum(columns_ + 1, Rational(0));
    std::fill_n(sum.begin(), points_, Rational(1));
    sum.back() = 1;
    rows_.push_back(std::move(sum));
    basis_.push_back(columns_);
  }

  bool is_feasible() {
    while (basis_.back() == columns_ && sgn(rows_.back().back()) > 0) {
      const std::size_t entering = entering_column();
      if (entering == columns_) return false;
      pivot(leaving_row(entering), entering);
    }
    return true;
  }

 private:
  // The first column by which a gets smaller.
  std::size_t entering_column() const {
    std::size_t c = 0;
    while (c < columns_ && sgn(rows_.back()[c]) <= 0) ++c;
    return c;
  }

  // The row of least ratio; of equal ones that of the first variable. Pre-condition: the column
  // makes a smaller, so that there is one.
  std::size_t leaving_row(std::size_t column) const {
    std::optional<std::size_t> best;
    Rational least;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (sgn(rows_[r][column]) <= 0) continue;
      const Rational ratio = rows_[r].back() / rows_[r][column];
      if (!best || ratio < least || (ratio == least && basis_[r] < basis_[*best])) {
        best = r;
        least = ratio;
      }
    }
    assert(best);
    return *best;
  }

  void pivot(std::size_t r, std::size_t column) {
    Row& row = rows_[r];
    const Rational divisor = row[column];
    for (Rational& v : row) v /= divisor;
    for (std::size_t other = 0; other < rows_.size(); ++other) {
      const Rational factor = rows_[other][column];
      if (other == r || sgn(factor) == 0) continue;
      for (std::size_t c = 0; c <= columns_; ++c) {
        if (sgn(row[c]) != 0) rows_[other][c] -= factor * row[c];
      }
    }
    basis_[r] = column;
  }

  std::size_t points_, columns_;
  std::vector<Row> rows_;
  std::vector<std::size_t> basis_;  // by row; columns_: a
};

using Vector = std::array<Rational, 3>;

Rational dot(const Vector& a, const Vector& b) {
  return Rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

struct RationalPlane {
  Vector normal;
  Rational offset;

  Rational value(const Vector& p) const { return Rational(dot(normal, p) + offset); }
};

// Solves m x = right by elimination; absent if m is singular. Sizes of at most 3.
std::optional<Row> solve(std::vector<Row> m, Row right) {
  const std::size_t n = right.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && sgn(m[pivot][c]) == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(m[c], m[pivot]);
    std::swap(right[c], right[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const Rational factor = m[r][c] / m[c][c];
      for (std::size_t k = c; k < n; ++k) m[r][k] -= factor * m[c][k];
      right[r] -= factor * right[c];
    }
  }
  for (std::size_t c = 0; c < n; ++c) right[c] /= m[c][c];
  return right;
}

// The point nearest to p of those that lie on all the planes; absent if these are not independent.
std::optional<Vector> foot(const Vector& p, const std::vector<const RationalPlane*>& planes) {
  std::vector<Row> gram;
  Row right;
  for (const RationalPlane* a : planes) {
    Row& row = gram.emplace_back();
    for (const RationalPlane* b : planes) row.push_back(dot(a->normal, b->normal));
    right.push_back(a->value(p));
  }
  const std::optional<Row> factors = solve(std::move(gram), std::move(right));
  if (!factors) return std::nullopt;
  Vector r = p;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) r[i] -= (*factors)[k] * planes[k]->normal[i];
  }
  return r;
}

// The square of the distance between p and the half-spaces; absent if these have no point.
std::optional<Rational> squared_distance(const Vector& p, const std::vector<RationalPlane>& all) {
  std::optional<Rational> least;
  // Bits of a set choose planes; of sets with more than three, none is independent of the others.
  for (std::size_t set = 0; set < std::size_t{1} << all.size(); ++set) {
    std::vector<const RationalPlane*> chosen;
    for (std::size_t h = 0; h < all.size(); ++h) {
      if ((set >> h & 1) != 0) chosen.push_back(&all[h]);
    }
    if (chosen.size() > 3) continue;
    const std::optional<Vector> at = foot(p, chosen);
    const auto contains = [&](const RationalPlane& h) { return sgn(h.value(*at)) >= 0; };
    if (!at || !std::ranges::all_of(all, contains)) continue;
    const Vector d = {Rational((*at)[0] - p[0]), Rational((*at)[1] - p[1]),
                      Rational((*at)[2] - p[2])};
    const Rational square = dot(d, d);
    if (!least || square < *least) least = square;
  }
  return least;
}

RationalPlane rational_plane(const Plane4& plane) {
  return {
      {to_rational(plane.normal[0]), to_rational(plane.normal[1]), to_rational(plane.normal[2])},
      to_rational(plane.offset)};
}

}  // namespace

ExactPoint exact_point(double x, double y, double z) { return {Dyadic(x), Dyadic(y), Dyadic(z)}; }

std::vector<LinearForm> half_spaces_of(const Truth& truth) {
  std::vector<LinearForm> r;
  for (const Truth::HalfSpace& half_space : truth.half_spaces()) r.push_back(half_space.form);
  return r;
}

Overlap overlap(std::span<const LinearForm> half_spaces, std::span<const ExactPoint> points) {
  if (points.empty()) return Overlap::outside;
  bool inside = true;
  std::vector<std::vector<Dyadic>> values;
  for (const Plane4& plane : planes_of(half_spaces)) {
    std::vector<Dyadic>& of_plane = values.emplace_back();
    int most = -1;
    for (const ExactPoint& p : points) {
      const int sign = static_cast<int>(of_plane.emplace_back(plane.value(p)).sign());
      most = std::max(most, sign);
      inside = inside && sign >= 0;
    }
    if (most < 0) return Overlap::outside;
  }
  if (inside || values.empty()) return Overlap::inside;
  return Feasibility(values).is_feasible() ? Overlap::across : Overlap::outside;
}

Overlap overlap(std::span<const LinearForm> half_spaces, const ExactPoint& centre,
                const Dyadic& radius) {
  if (radius.sign() < 0) return Overlap::outside;
  bool inside = true;
  std::vector<RationalPlane> planes;
  const Rational square = to_rational(Dyadic(radius * radius));
  const Vector at = {to_rational(centre[0]), to_rational(centre[1]), to_rational(centre[2])};
  for (const Plane4& plane : planes_of(half_spaces)) {
    const RationalPlane& p = planes.emplace_back(rational_plane(plane));
    const Rational d = p.value(at), reach = Rational(square * dot(p.normal, p.normal));
    inside = inside && sgn(d) >= 0 && Rational(d * d) >= reach;
  }
  if (inside) return Overlap::inside;
  const std::optional<Rational> distance = squared_distance(at, planes);
  return distance && *distance <= square ? Overlap::across : Overlap::outside;
}

}  // namespace clipscope::reference
