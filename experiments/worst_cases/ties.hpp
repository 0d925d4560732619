// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inputs of the correctly rounded clipper that are nearest to a tie, by kind: constructed where
// coordinates are of one exponent, bred from these where they are of any.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "experiments/contestants/contestant.hpp"
#include "experiments/worst_cases/kept.hpp"
#include "experiments/worst_cases/near_tie.hpp"

namespace clipscope::experiments::worst_cases {

// The nearest that is no tie among coordinates of one exponent, and of any exponents; an exact tie.
enum class TieRecord : std::uint8_t { one_exponent, any_exponents, tie };
inline constexpr std::array kTieRecords = {TieRecord::one_exponent, TieRecord::any_exponents,
                                           TieRecord::tie};
constexpr std::array<std::string_view, 3> names_of(TieRecord) {
  return {"one_exponent", "any_exponents", "tie"};
}

// "clip_edge_xy_one_exponent".
std::string name_of(const TieKind& kind, TieRecord record);

// How near the case is to a tie, in ulp, and 0 for a tie; nothing where it is no such record.
std::optional<double> figure_of(const TieKind& kind, TieRecord record, const HardCase& hard_case);

struct TieResult {
  std::optional<Record> nearest;  // nothing if none was found
  Standing standing = Standing::kept;
};

// The kept record judged anew, then a search: of any exponents so many triangles are bred, from the
// record or from what is constructed; else there are kAttempts times so many attempts.
inline constexpr std::size_t kAttempts = 20;
TieResult searched(const TieKind& kind, TieRecord record, const Record* kept, const Search& search);

// The clipper that rounds correctly.
const Contestant& correctly_rounded();

// Whether it rounds every number of the triangle right.
bool is_rounded_right(const HardCase& hard_case);

// What chance finds: random triangles, each number of their polygons by kind, in the order of
// all_tie_kinds().
std::vector<TieTally> tallies_of_chance(const Search& search);

// What chance is expected to find nearest, were the distances of so many numbers uniform in [0,
// 1/2] ulp: 1 / (2 (n + 1)).
double expected_nearest_ulp(std::size_t numbers);

}  // namespace clipscope::experiments::worst_cases
