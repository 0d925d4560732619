// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/diophantine.hpp"

#include <algorithm>
#include <utility>

namespace clipscope::experiments::worst_cases {
namespace {

// Some v with weights . v = value; nothing where there is none.
std::optional<Ints> any_solution(const Ints& weights, const Int& value) {
  Ints v = {1};
  Int divisor = weights.front();
  for (std::size_t i = 1; i < weights.size(); ++i) {
    Int next, s, t;
    mpz_gcdext(next.get_mpz_t(), s.get_mpz_t(), t.get_mpz_t(), divisor.get_mpz_t(),
               weights[i].get_mpz_t());
    for (Int& x : v) x *= s;
    v.push_back(t);
    divisor = next;
  }
  if (modulo(value, divisor) != 0) return std::nullopt;
  const Int factor = value / divisor;
  for (Int& x : v) x *= factor;
  return v;
}

// Of two vectors of a lattice the shortest two that span it: Lagrange and Gauss.
void reduce(std::vector<Ints>& rows) {
  if (rows.size() < 2) return;
  while (true) {
    if (dot(rows[0], rows[0]) > dot(rows[1], rows[1])) std::swap(rows[0], rows[1]);
    const Int k = rounded_quotient(dot(rows[0], rows[1]), dot(rows[0], rows[0]));
    if (k == 0) return;
    rows[1] = plus(rows[1], rows[0], -k);
  }
}

// v less multiples of the rows, next to the target. Pre-condition: rows are reduced, and v less the
// target is a combination of them.
Ints moved_next_to(const Target& target, Ints v, const std::vector<Ints>& rows) {
  Ints off = v;
  for (std::size_t i = 0; i < v.size(); ++i) {
    off[i] = target.denominator * v[i] - target.numerators[i];
  }
  if (rows.size() == 1) {
    const Int length = target.denominator * dot(rows[0], rows[0]);
    return plus(v, rows[0], -rounded_quotient(dot(off, rows[0]), length));
  }
  const Int aa = dot(rows[0], rows[0]), ab = dot(rows[0], rows[1]), bb = dot(rows[1], rows[1]);
  const Int a = dot(off, rows[0]), b = dot(off, rows[1]);
  const Int scale = target.denominator * (aa * bb - ab * ab);
  v = plus(v, rows[0], -rounded_quotient(a * bb - b * ab, scale));
  return plus(v, rows[1], -rounded_quotient(b * aa - a * ab, scale));
}

}  // namespace

Int dot(const Ints& a, const Ints& b) {
  Int sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Ints plus(Ints a, const Ints& b, const Int& factor) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
  return a;
}

Ints difference(Ints a, const Ints& b) { return plus(std::move(a), b, -1); }

Int rounded_quotient(const Int& a, const Int& positive) {
  Int q;
  const Int doubled = 2 * a + positive, divisor = 2 * positive;
  mpz_fdiv_q(q.get_mpz_t(), doubled.get_mpz_t(), divisor.get_mpz_t());
  return q;
}

std::optional<Int> inverse(const Int& a, const Int& m) {
  Int r;
  if (mpz_invert(r.get_mpz_t(), a.get_mpz_t(), m.get_mpz_t()) == 0) return std::nullopt;
  return r;
}

Int modulo(const Int& a, const Int& m) {
  Int r;
  mpz_mod(r.get_mpz_t(), a.get_mpz_t(), m.get_mpz_t());
  return r;
}

std::optional<Weights> weights_of(std::vector<Ints> rows) {
  Weights w{std::move(rows), {1}};
  if (w.rows.size() == 1) w.values = {-w.rows[0][1], w.rows[0][0]};
  if (w.rows.size() == 2) {
    const Ints &a = w.rows[0], &b = w.rows[1];
    w.values = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  if (!std::ranges::all_of(w.values, [](const Int& l) { return l > 0; })) return std::nullopt;
  return w;
}

std::optional<Ints> solution(const Weights& weights, const Int& value, const Target& target,
                             const std::function<bool(const Ints&)>& accepted) {
  std::optional<Ints> v = any_solution(weights.values, value);
  if (!v) return std::nullopt;
  std::vector<Ints> rows = weights.rows;
  reduce(rows);
  if (!rows.empty()) v = moved_next_to(target, *v, rows);
  rows.resize(2, Ints(v->size()));  // of zeros
  for (const int i : {0, -1, 1}) {
    for (const int j : {0, -1, 1}) {
      const Ints moved = plus(plus(*v, rows[0], i), rows[1], j);
      if (accepted(moved)) return moved;
    }
  }
  return std::nullopt;
}

}  // namespace clipscope::experiments::worst_cases
