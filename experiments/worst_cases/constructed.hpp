// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles whose numbers are as near to a tie as whole numbers allow, by number theory instead of
// search: coordinates of one exponent (near_tie.hpp), a residual of 1, and a divisor Q as large as
// was found.
//
// A number of the polygon is sum l_i v_i / sum l_i w_i, where the weights l are made of the signed
// distances to one plane or two, and n of the triangle's vertices take part (1, 2, 3).
//   z, x or y, attribute   Choose l and w, hence Q, at random beside its largest value. The tie
//                          m / 2^25 that is meant follows from m Q = +-1 mod 2^25, and
//                          l . v = (m Q +- 1) / 2^25 is a linear Diophantine equation for v.
//   1/w                    Choose the tie's m and the distances so that 2^48 sum l = +-1 mod m;
//                          then l . w = (2^48 sum l -+ 1) / m is one for w.
// A solution becomes a small one by taking multiples of the distances off, which the weights are
// orthogonal to: Babai, "On Lovasz' Lattice Reduction and the Nearest Lattice Point Problem", 1986.
// An exact tie is made likewise, with 0 in place of +-1.
//
// Where exponents differ, a tie in which some number is 0 becomes a near tie when that number
// becomes the smallest float and all others are large.
#pragma once

#include <optional>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/worst_cases/near_tie.hpp"

namespace clipscope::experiments::worst_cases {

enum class Aim : std::uint8_t { near_tie, tie };  // with one exponent

// The best of so many attempts, marked; nothing where none succeeded. It has one exponent.
// Pre-condition: has_ties of the kind's place where a tie is the aim.
std::optional<HardCase> constructed(const TieKind& kind, Aim aim, std::size_t attempts,
                                    Random& random);

// Beside a tie of small whole numbers, with exponents far apart. Pre-condition: has_ties of the
// kind's place.
HardCase beside_a_tie(const TieKind& kind);

}  // namespace clipscope::experiments::worst_cases
