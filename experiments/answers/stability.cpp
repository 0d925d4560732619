// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "experiments/answers/rows.hpp"
#include "experiments/contestants/spoken.hpp"

namespace clipscope::experiments::answers {
namespace {

// A method by what it is for each kind of primitive; empty where it has none of its own. A batch
// clipper is not among them: the catalogue asks for its scalar form.
struct Method {
  std::string_view triangles, segments, points, polygons;
};

constexpr std::string_view kPoints = "point/pop", kPolygons = "homogeneous/polygon";
constexpr std::array kMethods = {
    Method{"barycentric/correctly_rounded", "", kPoints, ""},
    Method{"barycentric/distance_matrix", "", kPoints, ""},
    Method{"view/sutherland_hodgman", "view/cyrus_beck", "", ""},
    Method{"homogeneous/sutherland_hodgman", "homogeneous/cohen_sutherland", kPoints, kPolygons},
    Method{"homogeneous/guard_band", "", kPoints, ""},
    Method{"homogeneous/w_first_1e-5", "", kPoints, ""},
    Method{"cvv/near_first", "cvv/cohen_sutherland", "", ""},
    Method{"cvv/perspective", "cvv/liang_barsky_naive", "", ""},
    Method{"whole/any_outside", "", "", ""}};

Tally tally_of(const Catalogue& catalogue, const Method& method, const std::string& scalar,
               const std::string& theme) {
  Tally sum;
  for (const std::string_view clipper :
       {method.triangles, method.segments, method.points, method.polygons}) {
    if (!clipper.empty()) sum += catalogue.tally({std::string(clipper), scalar}, theme);
  }
  return sum;
}

std::vector<Column> columns_for(const Catalogue& catalogue) {
  std::vector<Column> columns = {{"method", "method", 26}, {"scalar", "scalar"}, {"all", "all"}};
  for (const std::string& theme : catalogue.themes()) columns.push_back({theme, spoken_set(theme)});
  return columns;
}

std::vector<Cell> case_counts(const Catalogue& catalogue) {
  std::vector<Cell> cells = {"cases", Cell(), Cell()};
  std::int64_t all = 0;
  for (const std::string& theme : catalogue.themes()) {
    cells.emplace_back(catalogue.cases(theme));
    all += catalogue.cases(theme);
  }
  cells[2] = all;
  return cells;
}

}  // namespace

Table stability_table(const Catalogue& catalogue) {
  Table table("answers_stability", "Which methods stay right: failures by theme of the hard cases",
              columns_for(catalogue));
  table.add_note(
      "Failures: not finite, other vertices than the exact ones, or off by 1/256 px or more at 3840 x 2160. Empty: the method takes no such case; a method that takes clip coordinates is asked about more cases than one that starts in view space. Segments, points and polygons are clipped by the method's own form where it has one.");
  table.add_row(case_counts(catalogue));
  for (const std::string scalar : {"float", "double"}) {
    for (const Method& method : kMethods) {
      const std::string triangles(method.triangles);
      if (catalogue.tally({triangles, scalar}).cases == 0) continue;
      std::vector<Cell> cells = {spoken_clipper(triangles), scalar, Cell()};
      Tally all;
      for (const std::string& theme : catalogue.themes()) {
        const Tally tally = tally_of(catalogue, method, scalar, theme);
        cells.push_back(tally.cases == 0 ? Cell() : Cell(tally.failures));
        all += tally;
      }
      cells[2] = all.failures;
      table.add_row(std::move(cells));
    }
  }
  return table;
}

}  // namespace clipscope::experiments::answers
