// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "experiments/contestants/columns.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::hunt {

// A contestant hunted by one measure.
struct HuntRow {
  std::string clipper, scalar, measure;
  double worst = 0;                              // of the measure
  std::int64_t evaluations = 0;                  // triangles, of `crack` pairs of them
  std::optional<double> evaluations_per_second;  // nothing of a hunt that is spread
  std::string failing;                           // outcomes that are failures
  std::string replay;                            // the command that shows the worst
  double shrunk = 0;                             // what the measure is on the shrunk case
  std::string shrunk_replay;
  std::string worst_case, shrunk_case;  // as files of cases have them
  std::string hunt;                     // the command that finds the same
  std::int64_t hunts = 1;               // the worst of so many
  std::int64_t seed = 0;                // of the one that found it

  static constexpr std::string_view kName = "hunt";
  static constexpr std::string_view kTitle = "The worst that was found";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "A search: every figure is a lower bound of the worst. Units of the measures: px on a screen of 3840 x 2160; ulp of the scalar at the exact value, depth in ulp at 1; attribute relative to the largest of the triangle; containment in NDC; crack in px; crash is 1 where there is no answer."};
  static constexpr auto columns() {
    using R = HuntRow;
    return std::tuple(
        contestant_columns(&R::clipper, &R::scalar), column("measure", &R::measure),
        column("worst", &R::worst), column("evaluations", &R::evaluations),
        column("evaluations_per_second", "per second", &R::evaluations_per_second),
        column("failing", &R::failing), column("replay", &R::replay), column("shrunk", &R::shrunk),
        column("shrunk_replay", "replay of the shrunk", &R::shrunk_replay),
        column("worst_case", "as a case", &R::worst_case),
        column("shrunk_case", "shrunk, as a case", &R::shrunk_case),
        column("hunt", "found by", &R::hunt), column("hunts", &R::hunts), column("seed", &R::seed));
  }
  // Of the same contestant by the same measure from another seed: of equals that of the lower.
  HuntRow& operator+=(const HuntRow& other);
};

bool same_subject(const HuntRow& a, const HuntRow& b);
// A hunt that was not made.
inline bool is_empty(const HuntRow& row) { return row.hunts == 0; }

}  // namespace clipscope::experiments::hunt
