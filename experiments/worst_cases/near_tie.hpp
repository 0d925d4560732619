// SPDX-License-Identifier: GPL-3.0-or-later
//
// How near the exact numbers of a polygon are to a tie, the middle of two neighbouring floats: what
// makes a number hard to round.
//
// Source: Lefevre and Muller, "Worst Cases for Correct Rounding of the Elementary Functions in
// Double Precision", 2001, who call the distance that of the hardest-to-round case.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments::worst_cases {

// Where a vertex of the polygon comes from: one of the triangle; its edge and a plane; two planes.
enum class Place : std::uint8_t { vertex, edge, corner };
constexpr std::array<std::string_view, 3> names_of(Place) { return {"vertex", "edge", "corner"}; }

// Whether there is an exact tie among normal floats. A quotient of two floats is none: m w = 2^k x
// with m odd and of 25 bits asks for more bits than x has.
inline bool has_ties(Place place) { return place != Place::vertex; }

enum class Quantity : std::uint8_t { xy, z, inv_w, attribute };
constexpr std::array<std::string_view, 4> names_of(Quantity) {
  return {"x or y", "z", "1/w", "attribute"};
}

struct TieKind {
  Space space = Space::clip;
  Place place = Place::vertex;
  Quantity quantity = Quantity::xy;
};

// All but the attributes of the triangle's own vertices, which are not rounded.
std::vector<TieKind> all_tie_kinds();

// "clip_edge_xy".
std::string name_of(const TieKind& kind);

// How far the value is from the middle of the two floats around it, in their distance, the ulp;
// 0 alone where it is that middle. Nothing where it is a float or rounds to infinity.
std::optional<double> distance_to_tie(const reference::Fraction& value);

// The triangle with one attribute of its own, behind which its barycentric coordinates tell where a
// vertex comes from.
HardCase marked(HardCase hard_case);

// The numbers of one kind in an exact polygon.
struct TieTally {
  std::size_t numbers = 0, ties = 0;       // that are no floats; of them, exact ties
  std::optional<double> nearest_ulp = {};  // of those that are no ties

  TieTally& operator+=(const TieTally& next);
};

// Pre-condition: the polygon is that of a marked triangle.
TieTally tie_tally(const TieKind& kind, const reference::ExactPolygon& polygon);

// Coordinates are of one exponent where they are multiples of one power of two and smaller than
// 2^24 times it. Then no number of the kind that is no tie is nearer to one than this, in ulp.
//
// A number is N / Q. Times powers of two, N and Q are whole numbers, a tie is m / 2^k with m odd
// and an ulp is 2^(1-k); so the distance is |2^k N - m Q| / (2 Q) ulp, and the numerator is at
// least 1. With M = 2^24 - 1, Q is, the power of two in it aside, at most
//   M                of a vertex: w;
//   M (2 M - 1)      of an edge a b: d_a w_b - d_b w_a = +-(x_a w_b - x_b w_a) for w - x, both
//                    products at most M^2; were both M^2, Q would be even;
//   4 M^3            of a corner: the determinant of the rows x, y and w (Hadamard, 1893: one of
//                    order 3 with numbers in [-1, 1] is at most 4);
// and where the sum of the weights is the divisor, of an attribute,
//   4 M - 1          of an edge: d_a - d_b, with distances at most 2 M, and 4 M is even;
//   16 M^2           of a corner: the determinant of rows of distances and of the row 1 1 1.
// In view space x, y and -z are such numbers, the frustum is symmetric with right angles.
double least_distance_ulp(const TieKind& kind);

// Whether the case's coordinates are of one exponent, and its first attributes are.
bool has_one_exponent(const HardCase& hard_case);

}  // namespace clipscope::experiments::worst_cases
