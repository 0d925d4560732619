// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the budget's table, and what is said of them at the end.
#pragma once

#include "experiments/budget/stages.hpp"
#include "experiments/contestants/columns.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::budget {

struct Row {
  std::string scene, clipper, scalar;
  Part part = Part::total;
  std::optional<Spread> px, ulp;  // nothing where no triangle has a budget
  std::int64_t triangles = 0, left_out = 0;

  static constexpr std::string_view kName = "budget";
  static constexpr std::string_view kTitle = "Error by the step that it comes from";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "A triangle's way from the exact answer to the clipper's: rounding the matrix, transforming, cutting, dividing, each in the clipper's own order, with everything after it exact. The parts sum to the total by vertex and coordinate; the largest over a triangle's vertices is what counts here. px on 3840 x 2160; ulp of the scalar over x, y, z and 1/w. Left out: visible triangles with other vertices at some stage, and of CVV clippers those that cross the near plane."};
  static constexpr auto columns() {
    using R = Row;
    return std::tuple(column("scene", &R::scene), contestant_columns(&R::clipper, &R::scalar),
                      column("part", &R::part), spread("px", "px", &R::px),
                      spread("ulp", "ulp", &R::ulp), column("triangles", &R::triangles),
                      column("left_out", "left out", &R::left_out));
  }
};

// A row for each part.
inline void add_rows(const std::string& scene, const Contestant& contestant, const Tally& tally,
                     TableOf<Row>& table) {
  for (const Part part : kParts) {
    const Tally::Errors& errors = tally.part(part);
    table.add({scene, std::string(contestant.clipper), std::string(contestant.scalar()), part,
               spread_of(errors.px), spread_of(errors.ulp), tally.triangles, tally.left_out});
  }
}

// Parts by clipper on one scene in one scalar, one clipper of each space.
Plot plot(const std::vector<Row>& rows, const std::string& scene, const std::string& scalar);

// The largest part by clipper, in the median and at the most, on the first scene.
std::string finding(const std::vector<Row>& rows);

}  // namespace clipscope::experiments::budget
