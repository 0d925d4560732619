// SPDX-License-Identifier: GPL-3.0-or-later
//
// The largest errors known of clippers that cut edge after edge, each new vertex from the vertices
// of the cut before. A search gives a lower bound of the worst.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/hunt/measure.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/worst_cases/kept.hpp"

namespace clipscope::experiments::worst_cases {

inline constexpr std::array kChainMeasures = {hunt::Measure::px, hunt::Measure::ulp,
                                              hunt::Measure::depth, hunt::Measure::attribute};

// Any triangle; or those that the bounds of `covers` speak of (judge/questions.hpp): their numbers
// stay in the format, and what is visible keeps away from the eye.
enum class Inputs : std::uint8_t { any, in_domain };
constexpr std::array<std::string_view, 2> names_of(Inputs) { return {"any", "in domain"}; }

// What a record is of.
struct ChainKind {
  const Contestant* contestant = nullptr;
  Inputs inputs = Inputs::any;
  hunt::Measure measure = hunt::Measure::px;
};

// "homogeneous_sutherland_hodgman_px_in_domain".
std::string name_of(const ChainKind& kind);
std::string_view unit_of(hunt::Measure measure);

// Those selected that compute in the scalar and cut chain after chain: all but the folders
// barycentric and whole.
Contestants chain_contestants(const Selection& selection, std::string_view scalar);

// All there are of the contestants: by contestant, inputs, measure.
std::vector<ChainKind> chain_kinds(const Contestants& contestants);

// The error on a case, exact. Pre-condition: the contestant takes it.
double figure_of(const ChainKind& kind, const HardCase& hard_case);

struct ChainResult {
  std::optional<Record> worst;  // nothing if no error was found
  Standing standing = Standing::kept;
};

// The kept record judged anew, then a hunt of so many triangles that begins with it.
ChainResult searched(const ChainKind& kind, const Record* kept, const Search& search);

}  // namespace clipscope::experiments::worst_cases
