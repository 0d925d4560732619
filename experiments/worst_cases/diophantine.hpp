// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small solutions of the linear Diophantine equation weights . v = value, where the weights are
// orthogonal to given rows: any solution, less multiples of the rows.
//
// Source: Babai, "On Lovasz' Lattice Reduction and the Nearest Lattice Point Problem", 1986; in two
// dimensions the reduction is that of Lagrange and Gauss. Does not guarantee: the smallest one.
#pragma once

#include <gmpxx.h>

#include <functional>
#include <optional>
#include <vector>

namespace clipscope::experiments::worst_cases {

using Int = mpz_class;
using Ints = std::vector<Int>;  // one for each vertex that takes part: 1, 2 or 3

Int dot(const Ints& a, const Ints& b);
// a + factor b, and a - b.
Ints plus(Ints a, const Ints& b, const Int& factor);
Ints difference(Ints a, const Ints& b);

// The nearest whole number. Pre-condition: the divisor is positive.
Int rounded_quotient(const Int& a, const Int& divisor);

// In [0, m).
Int modulo(const Int& a, const Int& m);
// The inverse modulo m; nothing where there is none.
std::optional<Int> inverse(const Int& a, const Int& m);

// What whole numbers are wanted next to: numerators / denominator > 0.
struct Target {
  Ints numerators;
  Int denominator;
};

// The distances of the vertices to the planes, and the weights that they make: positive, and
// orthogonal to each row of distances.
struct Weights {
  std::vector<Ints> rows;
  Ints values;

  Int sum() const {
    Int sum = 0;
    for (const Int& l : values) sum += l;
    return sum;
  }
};

// Of no row, one or two; nothing where a weight is not positive.
std::optional<Weights> weights_of(std::vector<Ints> rows);

// A v with weights . v = value, next to the target, that is accepted. Pre-condition: the target
// has that weighted sum.
std::optional<Ints> solution(const Weights& weights, const Int& value, const Target& target,
                             const std::function<bool(const Ints&)>& accepted);

}  // namespace clipscope::experiments::worst_cases
