// SPDX-License-Identifier: MIT
//
// Lines in the barycentric plane of a triangle of floats, their meetings, and what is asked of
// them: the sign of a determinant, and a quotient rounded to the nearest float.
//
// Each answer comes from doubles if a proved bound of their error settles it, and from expansions
// else. A double-double stage between the two would have nothing to gain: of triangles that
// straddle a frustum the filter leaves over less than one quotient in 10^5
// (CorrectlyRounded::count_stages), most of them exact ties, and on lattices ties and zeros, which
// no precision short of exact settles.
//
// Source: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates", 1997; filters for homogeneous points: Melquiond and Pion, "Formally certified
// floating-point filters for homogeneous geometric predicates", 2007; predicates on points that are
// kept as the lines that define them: Attene, "Indirect predicates for geometric constructions",
// 2020.
//
// Range. A float is a multiple of 2^-149 below 2^128, hence a sum of products of k of them is a
// multiple of 2^(-149 k), and so is every rounded partial result and every rounding error on the
// way (rounding keeps multiples of a smaller power of two). Degrees, and bounds of magnitudes:
//
//   a line's entry                            2   2^257   n x + l z; in clip space 1 and 2^129
//   lambda                                    4   2^515   a difference of two products of entries
//   lambda . floats                           5   2^645
//   lambda . line, and numerators             6   2^775   in view space up to two such, times
//                                             floats
//   a denominator times a midpoint of floats      2^903   a multiple of 2^-1044 (midpoints: of
//                                                 2^-150)
//
// All are multiples of 2^-1074 below 2^1024: nothing under- or overflows, and nothing needs to be
// scaled.
//
// Lemma (filter). Let v be a sum of products, and let every product pass through at most k
// roundings of its factors, itself and sums in double, u = 2^-53. Let M be computed by the same
// operations on magnitudes, differences turned into sums. Then |computed v - v| <= (k + 1) u M for
// k <= 1000: each product is off by a factor between (1 - u)^k and (1 + u)^k, so the error is at
// most ((1 + u)^k - 1) times the exact sum of magnitudes, which is at most M (1 - u)^-k.
// Counts: a line's entry 2 (in clip space, and unless sheared, 1); lambda: two entries, the
// product, the difference 6; its dot product with an exact vector 6 + 1 + 2 = 9, with a line 11,
// with numerators at the vertices, which have 3 themselves, 12. One more u covers the rounding of
// the bound: 14 u M.
//
// Range, filter and the certificate of rounded_quotient are proved by scripts with the constants
// below: reference/proofs/.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "spaces/expansion.hpp"
#include "spaces/planes.hpp"
#include "spaces/rounding.hpp"

namespace clipscope::barycentric {

// What settled an answer.
enum class Stage : std::uint8_t {
  sign_filtered,      // a sign, by double
  sign_exact,         // a sign, by expansions
  quotient_filtered,  // a rounded quotient, by double
  quotient_exact,     // by the quotient of the exact numerator and denominator, rounded
  quotient_midpoint,  // by comparing with the midpoint of two floats
  quotient_tie        // it is such a midpoint
};
inline constexpr int kStages = 6;

// Called with the stage of each answer; this one costs nothing.
struct CountNothing {
  constexpr void operator()(Stage) const {}
};
struct CountStages {
  std::array<std::int64_t, kStages> counts{};

  constexpr void operator()(Stage stage) { ++counts[static_cast<int>(stage)]; }
  constexpr std::int64_t operator[](Stage stage) const { return counts[static_cast<int>(stage)]; }
};

// Numbers at the three vertices, exact.
using Values = std::array<double, 3>;

// line . lambda >= 0 is inside; 0, on the line, is inside. The entries are rounded + error + rest
// exactly, components of an expansion, `rounded` being within 2 u of them, relatively. `plane` is
// no bit for an edge of the triangle.
struct Line {
  Values rounded{}, error{};
  Outcode plane = 0;
  Values rest{};
};

// lambda = a x b, times no more than a positive factor the point where the polygon's boundary goes
// over from line a to line b; its entries are >= 0 and their sum is > 0 if that is so.
struct Meeting {
  const Line *a, *b;
  Values lambda;     // rounded
  Values magnitude;  // M of the lemma; 0 only if the entry is 0
};

inline Meeting meet(const Line& a, const Line& b) {
  Meeting r{&a, &b, {}, {}};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double first = a.rounded[j] * b.rounded[k], second = a.rounded[k] * b.rounded[j];
    r.lambda[i] = first - second;
    r.magnitude[i] = std::abs(first) + std::abs(second);
  }
  return r;
}

// |value - exact value| <= error.
struct Bounded {
  double value, error;
};

inline constexpr double kFilterError = 14 * 0x1p-53;

// lambda . v, where v passed through at most three roundings and |v| is `magnitude` in the lemma's
// sense.
inline Bounded dot(const Meeting& m, const Values& v, const Values& magnitude) {
  const double value = m.lambda[0] * v[0] + m.lambda[1] * v[1] + m.lambda[2] * v[2];
  const double bound =
      m.magnitude[0] * magnitude[0] + m.magnitude[1] * magnitude[1] + m.magnitude[2] * magnitude[2];
  return {value, kFilterError * bound};
}

// lambda . v, for exact values and for the entries of a line.
inline Bounded dot(const Meeting& m, const Values& v) {
  return dot(m, v, {std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

using ExactLambda = std::array<Expansion<36>, 3>;

inline Expansion<3> exact_entry(const Line& line, int i) {
  Expansion<3> r;
  r.push(line.rest[i]);
  r.push(line.error[i]);
  r.push(line.rounded[i]);
  return r;
}

inline ExactLambda exact_lambda(const Meeting& m) {
  ExactLambda r;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    r[i] =
        exact_entry(*m.a, j) * exact_entry(*m.b, k) - exact_entry(*m.a, k) * exact_entry(*m.b, j);
  }
  return r;
}

// lambda . line, and numerators and denominators alike, are multiples of 2^kDotLowest below
// 2^kDotHighest: so many components remain when they are compressed.
inline constexpr int kDotLowest = -894, kDotHighest = 775;
using ExactDot = Expansion<(kDotHighest - kDotLowest) / 52 + 2>;

template <int N>
ExactDot compressed_dot(const Expansion<N>& value) {
  return compressed<(kDotHighest - kDotLowest) / 52 + 2>(value);
}

inline ExactDot exact_dot(const ExactLambda& lambda, const Values& v) {
  return compressed_dot(lambda[0] * v[0] + lambda[1] * v[1] + lambda[2] * v[2]);
}

inline ExactDot exact_dot(const ExactLambda& lambda, const Line& line) {
  return compressed_dot(lambda[0] * exact_entry(line, 0) + lambda[1] * exact_entry(line, 1) +
                        lambda[2] * exact_entry(line, 2));
}

// The side of the line that a meeting is on: the sign of lambda . line, -1, 0 or 1.
template <class Count>
int side(const Meeting& m, const Line& line, Count& count) {
  const Bounded d = dot(m, line.rounded);
  if (std::abs(d.value) > d.error || d.error == 0) {
    count(Stage::sign_filtered);
    return (d.value > 0) - (d.value < 0);
  }
  count(Stage::sign_exact);
  return exact_dot(exact_lambda(m), line).sign();
}

// Gives the one of two neighbouring floats, low < high, that is nearest to a value between them,
// ties to even.
// compared: the sign of that value less their midpoint.
template <class Count>
float nearer(float low, float high, int compared, Count& count) {
  count(compared == 0 ? Stage::quotient_tie : Stage::quotient_midpoint);
  const bool low_is_odd = (std::bit_cast<std::uint32_t>(low) & 1) != 0;
  return compared > 0 || (compared == 0 && low_is_odd) ? high : low;
}

// Of a quotient of largest components, see below.
inline constexpr double kLeadingQuotientError = 0x1p-50;

// numerator / denominator rounded to the nearest float, ties to even. Pre-condition: denominator >
// 0.
//
// The largest component of each is within 2^-52 of it, relatively, so their rounded quotient is
// within kLeadingQuotientError of the exact one, with room for the rounding of the two products.
// Between `low` and `high` lies at most one midpoint of floats, since these are at least 2^-25
// apart, relatively.
// Half a unit above the largest float, where rounding goes over to infinity, is a midpoint as well,
// as if the next float were 2^128. Where the quotient leaves the range of double, or of its normal
// numbers, it is far beyond that of float, and both ends are infinite or 0.
template <class Count>
float round_quotient(const ExactDot& numerator, const ExactDot& denominator, Count& count) {
  const int sign = numerator.sign();
  const double q = std::abs(numerator.largest() / denominator.largest());
  const float low = rounded_to_float(q * (1 - kLeadingQuotientError));
  const float high = rounded_to_float(q * (1 + kLeadingQuotientError));
  if (sign == 0 || low == high) {
    count(Stage::quotient_exact);
    return sign < 0 ? -low : low;
  }
  const double above = std::isinf(high) ? 0x1p128 : static_cast<double>(high);
  const double midpoint = 0.5 * (low + above);
  const ExactDot magnitude = sign < 0 ? -numerator : numerator;
  const float r = nearer(low, high, (magnitude - denominator * midpoint).sign(), count);
  return sign < 0 ? -r : r;
}

// lambda . denominator for a quotient. Pre-condition: it is exactly positive.
struct Divisor {
  Values values;
  Bounded dot;
  double reciprocal;      // of dot.value, if that is certain to twenty bits, else NaN
  double relative_error;  // of the quotient for that of the divisor and for roundings, see below
};

// A divisor counts as certain if its value is so many times its error.
inline constexpr double kDivisorCertainty = 0x1p20;
inline constexpr double kQuotientRoundings = 8 * 0x1p-53;
inline constexpr double kQuotientSlack = 0x1p-18;      // of the bound, relatively
inline constexpr double kSmallestFiltered = 0x1p-900;  // quotient

inline Divisor divisor(const Meeting& m, const Values& denominator) {
  const Bounded d = dot(m, denominator);
  const bool is_certain = d.value > kDivisorCertainty * d.error;
  const double reciprocal = is_certain ? 1 / d.value : std::numeric_limits<double>::quiet_NaN();
  return {denominator, d, reciprocal, d.error * reciprocal + kQuotientRoundings};
}

// numerator / (divisor times scale), rounded; exact(low, high) does that where the ends of its
// interval, from doubles, round to different floats. 0 is +0; what rounds to 0 from below is -0.
// inverse_scale is 1 / scale in double, of a scale rounded once, or 1.
//
// With n, d and their bounds En, Ed the quotient is within (En + |n/d| Ed) / (d - Ed) of n/d; it is
// kDivisorCertainty Ed < d. kQuotientRoundings |q| covers the roundings of the scale, the two
// reciprocals, their product, q and the interval's ends, 6 u, and 1 + kQuotientSlack the Ed in the
// divisor and the roundings of this bound. Some of its terms may underflow, by less than 2^-1072
// together: for |q| >= kSmallestFiltered that is within the same slack of the bound.
// Rounding is monotone: where both ends round to the same float, so does all between.
template <class Exact, class Count>
float rounded_quotient(const Bounded& n, const Divisor& by, double inverse_scale, Exact&& exact,
                       Count& count) {
  if (n.error == 0) {  // every product is 0
    count(Stage::quotient_filtered);
    return 0;
  }
  const double reciprocal = by.reciprocal * inverse_scale;
  const double q = n.value * reciprocal, magnitude = std::abs(q);
  const double bound = n.error * reciprocal + magnitude * by.relative_error;
  const double error = bound * (1 + kQuotientSlack);
  const float low = rounded_to_float(q - error), high = rounded_to_float(q + error);
  if (magnitude >= kSmallestFiltered &&
      std::bit_cast<std::uint32_t>(low) == std::bit_cast<std::uint32_t>(high)) {
    count(Stage::quotient_filtered);
    return low;
  }
  return exact(low, high);
}

// Whether lambda is exact as it is: two of its entries are those of a line without errors.
inline bool is_exact(const Meeting& m) {
  const auto is_rounded = [](const Line& line) {
    for (int i = 0; i < 3; ++i) {
      if (line.error[i] != 0 || line.rest[i] != 0) return true;
    }
    return false;
  };
  return (m.a->plane == 0 && !is_rounded(*m.b)) || (m.b->plane == 0 && !is_rounded(*m.a));
}

inline bool are_neighbours(float low, float high) {
  const auto a = std::bit_cast<std::uint32_t>(low), b = std::bit_cast<std::uint32_t>(high);
  return std::isfinite(low) && std::isfinite(high) && (low < 0 ? a - b : b - a) == 1;
}

// The sign of lambda . numerator / lambda . denominator - midpoint, of floats and a midpoint of
// floats; nothing where it takes more than doubles. Pre-condition: lambda is exact, and one entry
// is 0.
//
// A midpoint has 25 bits, times a float 49: exact. The terms of lambda . (numerator - midpoint
// denominator) are exact as head + tail, and heads that don't cancel decide: rounding is monotone.
inline std::optional<int> compare(const Meeting& m, const Values& numerator,
                                  const Values& denominator, double midpoint) {
  double head = 0, tail = 0, lost = 0;
  for (int i = 0; i < 3; ++i) {
    const auto [difference, error] = bounds::two_sum(numerator[i], -midpoint * denominator[i]);
    const double term = m.lambda[i] * difference;
    head += term;
    tail += std::fma(m.lambda[i], difference, -term);
    lost += std::abs(m.lambda[i] * error);
  }
  if (lost != 0) return {};
  const double sum = head != 0 ? head : tail;
  return (sum > 0) - (sum < 0);
}

// lambda . numerator / lambda . denominator, rounded. Most ties lie on an edge, where doubles will
// do.
template <class Count>
float rounded_quotient(const Meeting& m, const Values& numerator, const Divisor& by, Count& count) {
  const auto exact = [&](float low, float high) {
    if (is_exact(m) && are_neighbours(low, high)) {
      const double midpoint = 0.5 * (double{low} + high);
      const auto compared = compare(m, numerator, by.values, midpoint);
      if (compared) return nearer(low, high, *compared, count);
    }
    const ExactLambda lambda = exact_lambda(m);
    return round_quotient(exact_dot(lambda, numerator), exact_dot(lambda, by.values), count);
  };
  return rounded_quotient(dot(m, numerator), by, 1, exact, count);
}

}  // namespace clipscope::barycentric
