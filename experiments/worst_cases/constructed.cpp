// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/constructed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "experiments/worst_cases/diophantine.hpp"

namespace clipscope::experiments::worst_cases {
namespace {

constexpr std::int64_t kM = (1 << 24) - 1;  // the largest coordinate
constexpr int kUnit = -23;                  // coordinates are whole numbers times 2^kUnit
constexpr int kTieBits = 25;                // a tie is m / 2^k, m odd and of so many bits

bool fits(const Ints& v) {
  return std::ranges::all_of(v, [](const Int& x) { return abs(x) <= kM; });
}

// --- Attempts ------------------------------------------------------------------------------------

// Of the vertices that take part, in units of 2^kUnit.
struct Shape {
  Ints w, x, y;     // y: of a corner; where `near` is given, the plane in front takes its place
  Int near = 0;     // of a corner of a side and the near plane
  Ints value = {};  // of the quantity

  std::vector<Ints> rows() const {
    if (w.size() == 1) return {};
    std::vector<Ints> rows = {difference(w, x)};
    if (w.size() == 3) rows.push_back(difference(w, near == 0 ? y : Ints(3, near)));
    return rows;
  }
};

// In reversed depth z is near / w where far is infinite.
bool is_inverse(const TieKind& kind) {
  return kind.quantity == Quantity::inv_w ||
         (kind.quantity == Quantity::z && kind.space == Space::view);
}

// In view space x or y of a corner is to be rounded where the near plane makes it.
bool is_beside_near(const TieKind& kind) {
  return kind.place == Place::corner && kind.quantity == Quantity::xy && kind.space == Space::view;
}

class Attempts {
 public:
  Attempts(const TieKind& kind, Aim aim, Random& random)
      : kind_(kind), aim_(aim), random_(random), count_(static_cast<std::size_t>(kind.place) + 1) {}

  // best: what was made before, to change; nothing where it does not come out.
  std::optional<Shape> next(const std::optional<Shape>& best) {
    return is_inverse(kind_) ? with_inverse() : with_value(best);
  }

 private:
  bool is_of_attribute() const { return kind_.quantity == Quantity::attribute; }

  std::int64_t below(std::int64_t n) {
    return static_cast<std::int64_t>(random_.below(static_cast<std::uint64_t>(n)));
  }
  Int within(std::int64_t size) { return Int(below(2 * size + 1) - size); }

  Int odd_of_25_bits() {
    const std::int64_t top = std::int64_t{1} << (kTieBits - 1);
    // Most of them small, so that w is large.
    const std::int64_t reach = std::int64_t{1} << (1 + below(kTieBits - 1));
    return Int(top + (below(reach) | 1));
  }

  // Mostly close to the largest, of either sign.
  Int large() {
    if (random_.chance(0.25)) return within(kM);
    const std::int64_t size = kM - below((kM >> (1 + below(20))) + 1);
    return random_.chance(0.5) ? Int(size) : Int(-size);
  }
  Ints all_large() {
    Ints v(count_);
    for (Int& x : v) x = large();
    return v;
  }
  Ints beside(Ints v) {
    const std::int64_t reach = std::int64_t{1} << below(24);
    for (Int& x : v) {
      x += within(reach);
      x = std::clamp<Int>(x, Int(-kM), Int(kM));
    }
    return v;
  }

  // With the largest divisor: that of an edge is known (near_tie.hpp).
  Shape largest() {
    if (kind_.place == Place::vertex) return {{kM}, {0}, {0}};
    if (kind_.place == Place::edge) {
      return is_of_attribute() ? Shape{{kM, -kM}, {1 - kM, kM}, {0, 0}}
                               : Shape{{kM, kM - 1}, {-kM, kM}, {0, 0}};
    }
    return {all_large(), all_large(), all_large()};
  }

  Shape shape_beside(const std::optional<Shape>& best) {
    Shape shape = largest();
    if (best && random_.chance(0.5)) shape = {beside(best->w), beside(best->x), beside(best->y)};
    if (is_beside_near(kind_)) shape.near = aim_ == Aim::tie ? Int(1 << 23) : Int(abs(large()) | 1);
    return shape;
  }

  // Distances whose weights have a sum that is `rest` modulo m.
  std::optional<Weights> weights_with_sum(const Int& rest, const Int& m) {
    const std::int64_t size = (2 * kM) >> below(4);
    if (count_ == 2) {
      const Int sum = rest + m * below(2);
      if (sum < 2 || sum > 4 * kM) return std::nullopt;
      const Int behind = 1 + below(std::min<std::int64_t>(sum.get_si() - 1, 1 << (1 + below(25))));
      return weights_of({{sum - behind, -behind}});
    }
    Ints a(3), b(3);
    for (Int& d : a) d = within(size);
    for (const int i : {0, 1}) b[static_cast<std::size_t>(i)] = within(size);
    // The sum is b . (a_2 - a_1, a_0 - a_2, a_1 - a_0).
    const std::optional<Int> last = inverse(modulo(a[1] - a[0], m), m);
    if (!last) return std::nullopt;
    b[2] = modulo((rest - b[0] * (a[2] - a[1]) - b[1] * (a[0] - a[2])) * *last, m);
    if (random_.chance(0.5)) b[2] -= m;
    if (abs(b[2]) > 2 * kM) return std::nullopt;
    return weights_of({a, b});
  }

  // w of the given weighted sum, all about alike, and the other coordinates from the distances.
  std::optional<Shape> with_w(const Weights& weights, const Int& sum) {
    const Target target{Ints(count_, sum), weights.sum()};
    const std::optional<Ints> w = solution(weights, sum, target, [&](const Ints& w) {
      return fits(w) && std::ranges::all_of(weights.rows,
                                            [&](const Ints& d) { return fits(difference(w, d)); });
    });
    if (!w) return std::nullopt;
    Shape shape{*w, Ints(count_), Ints(count_)};
    if (count_ > 1) shape.x = difference(*w, weights.rows[0]);
    if (count_ > 2) shape.y = difference(*w, weights.rows[1]);
    return shape;
  }

  std::optional<Shape> with_inverse() {
    // 2^48 - 1 = (2^24 - 1) (2^24 + 1).
    if (kind_.place == Place::vertex) return largest();
    const Int power = Int(1) << 48, m = odd_of_25_bits();
    const Int residual = aim_ == Aim::tie ? 0 : random_.chance(0.5) ? 1 : -1;
    const Int rest = modulo(residual * *inverse(modulo(power, m), m), m);
    const std::optional<Weights> weights = weights_with_sum(rest, m);
    if (!weights) return std::nullopt;
    return with_w(*weights, (power * weights->sum() - residual) / m);
  }

  // Weights, and w where it matters, with a divisor that a tie's power of two divides.
  std::optional<Shape> shape_for_tie(int power) {
    const Int modulus = Int(1) << power;
    if (is_of_attribute()) {
      const std::optional<Weights> weights = weights_with_sum(0, modulus);
      return weights ? with_w(*weights, weights->sum() * (kM / 4)) : std::nullopt;
    }
    std::vector<Ints> rows(count_ - 1, Ints(count_));
    for (Ints& row : rows) {
      for (Int& d : row) d = within(kM / 4);
    }
    const std::optional<Weights> weights = weights_of(rows);
    if (!weights) return std::nullopt;
    return with_w(*weights, rounded_quotient(weights->sum() * (kM / 2), modulus) * modulus);
  }

  std::optional<Shape> with_value(const std::optional<Shape>& best) {
    // Attributes have no bound, so that their ties may be larger.
    const int power = aim_ == Aim::tie && is_of_attribute() ? 20 : kTieBits;
    std::optional<Shape> shape = aim_ == Aim::tie && !is_beside_near(kind_)
                                     ? shape_for_tie(power)
                                     : std::optional(shape_beside(best));
    const std::optional<Weights> weights = shape ? weights_of(shape->rows()) : std::nullopt;
    if (!weights) return std::nullopt;
    const Int divisor = is_of_attribute() ? weights->sum() : dot(weights->values, shape->w);
    if (divisor <= 0) return std::nullopt;
    const Int modulus = Int(1) << power;
    const Int residual = aim_ == Aim::tie ? 0 : random_.chance(0.5) ? 1 : -1;
    Int m = odd_of_25_bits();
    if (aim_ == Aim::near_tie) {
      const std::optional<Int> inverted = inverse(modulo(divisor, modulus), modulus);
      if (!inverted) return std::nullopt;
      m = modulo(-residual * *inverted, modulus);
    }
    const Int scaled = m * divisor + residual;
    if (modulo(scaled, modulus) != 0 || 2 * m < modulus) return std::nullopt;
    Target target{is_of_attribute() ? Ints(count_, Int(1)) : shape->w, modulus};
    for (Int& t : target.numerators) t *= m;
    const std::optional<Ints> value = solution(*weights, scaled / modulus, target, fits);
    if (!value) return std::nullopt;
    shape->value = *value;
    return shape;
  }

  const TieKind kind_;
  const Aim aim_;
  Random& random_;
  const std::size_t count_;
};

// --- As a case -----------------------------------------------------------------------------------

// In units of 2^(kUnit + exponent).
double scaled(const Int& x, int exponent) {
  return std::ldexp(static_cast<double>(x.get_si()), kUnit + exponent);
}

// x, y, z, w of a vertex that takes part, z free where nothing asks for it.
std::array<Int, 4> coordinates(const TieKind& kind, const Shape& s, std::size_t i) {
  const bool has_value = !s.value.empty() && kind.quantity != Quantity::attribute;
  const Int value = has_value ? s.value[i] : Int(0);
  if (kind.quantity == Quantity::xy) return {s.x[i], value, s.y[i], s.w[i]};
  const Int beside = kind.place == Place::vertex ? Int(s.w[i] / 2) : s.y[i];
  return {s.x[i], beside, value, s.w[i]};
}

// The vertices that take no part: in the volume, and away from the others.
std::array<Int, 4> other_vertex(const TieKind& kind, std::size_t i) {
  if (kind.place == Place::edge) {
    return {0, kind.quantity == Quantity::xy ? -kM / 2 : kM / 2, 0, kM};
  }
  return {i == 1 ? 0 : kM / 2, 0, 0, kM};
}

HardCase case_of(const TieKind& kind, const Shape& shape, int exponent = 0) {
  HardCase c;
  c.space = kind.space;
  if (kind.space == Space::view) {
    // Near is a power of two and cuts no vertex that matters, or one of the coordinates.
    const double near =
        std::ldexp(scaled(shape.near == 0 ? 1 : shape.near, exponent), shape.near == 0 ? -4 : 0);
    c.volume.depth = c.frustum.depth = DepthRange::reversed;
    c.frustum.left = c.frustum.bottom = -near;
    c.frustum.right = c.frustum.top = c.frustum.near = near;
    c.frustum.infinite_far = true;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const bool takes_part = i < shape.w.size();
    const std::array<Int, 4> p = takes_part ? coordinates(kind, shape, i) : other_vertex(kind, i);
    reference::InputVertex& v = c.vertices.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) v.position[k] = scaled(p[k], exponent);
    if (kind.space == Space::view) v.position = {v.position[0], v.position[1], -v.position[3], 1};
    const bool has_attribute = takes_part && kind.quantity == Quantity::attribute;
    if (has_attribute) v.attributes[0] = scaled(shape.value[i], exponent);
  }
  return marked(c);
}

// Ties in which vertex 0 has a number that is 0: w where that is divided by, else the value.
//   value: the sum of the weights and w are powers of two, and 3 v has 25 bits and is odd
//   1/w: the sum of the weights has 25 bits and is odd, and the divisor is a power of two
Shape tie_with_zero(const TieKind& kind) {
  const Int large = 1 << 23;
  const bool is_edge = kind.place == Place::edge;
  Shape s;
  std::vector<Ints> rows;
  if (is_inverse(kind)) {
    rows = is_edge ? std::vector<Ints>{{1 << 24, -1}}                // weights 1, 2^24
                   : std::vector<Ints>{{2, -1, 0}, {0, large, -1}};  // 1, 2, 2^24
    s.w = is_edge ? Ints{0, 8} : Ints{0, 0, 8};
  } else {
    rows = is_edge ? std::vector<Ints>{{3, -1}}                   // weights 1, 3
                   : std::vector<Ints>{{1, -1, -1}, {0, 3, -1}};  // 4, 1, 3
    s.w = Ints(rows[0].size(), large);
    s.value = is_edge ? Ints{0, large + 1} : Ints{0, 0, large + 1};
    if (is_beside_near(kind)) {
      s.near = large;
      s.w = plus(s.w, rows[1], 1);
    }
  }
  s.x = difference(s.w, rows[0]);
  s.y = rows.size() == 2 ? difference(s.w, rows[1]) : Ints(s.w.size());
  return s;
}

}  // namespace

std::optional<HardCase> constructed(const TieKind& kind, Aim aim, std::size_t attempts,
                                    Random& random) {
  Attempts all(kind, aim, random);
  std::optional<Shape> best;
  std::optional<HardCase> result;
  double nearest = 1;
  for (std::size_t i = 0; i < attempts; ++i) {
    std::optional<Shape> shape = all.next(best);
    if (!shape) continue;
    const HardCase c = case_of(kind, *shape);
    const TieTally tally = tie_tally(kind, exact_polygon(c));
    if (aim == Aim::tie && tally.ties > 0) return c;
    if (aim == Aim::tie || !tally.nearest_ulp || *tally.nearest_ulp >= nearest) continue;
    nearest = *tally.nearest_ulp;
    best = std::move(shape);
    result = c;
  }
  return result;
}

HardCase beside_a_tie(const TieKind& kind) {
  constexpr int kLarge = 100;  // 2^24 2^kUnit 2^kLarge is a float
  constexpr double kSmallest = std::numeric_limits<float>::denorm_min();
  HardCase c = case_of(kind, tie_with_zero(kind), kLarge);
  reference::InputVertex& v = c.vertices.front();
  if (is_inverse(kind)) {
    const bool is_view = kind.space == Space::view;
    v.position[is_view ? 2 : 3] = is_view ? -kSmallest : kSmallest;
  } else if (kind.quantity == Quantity::attribute) {
    v.attributes[0] = kSmallest;
  } else {
    v.position[kind.quantity == Quantity::xy ? 1 : 2] = kSmallest;
  }
  return c;
}

}  // namespace clipscope::experiments::worst_cases
