// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the tables about attributes, and what is said of them at the end.
#pragma once

#include "experiments/attributes/measure.hpp"
#include "experiments/contestants/columns.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::attributes {

// The errors of a contestant on triangles that cross so many planes.
struct ErrorRow {
  Treatment treatment = Treatment::smooth;
  int planes = 0;
  std::string clipper, scalar;
  std::int64_t triangles = 0;
  double median_abs = 0, max_abs = 0, median_ulp = 0, max_ulp = 0, inside_max_abs = 0;

  static constexpr std::string_view kName = "attributes";
  static constexpr std::string_view kTitle = "Errors of attributes by planes crossed (k) and mode";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Attributes in [0, 1]. Median, max: at vertices, absolute, then in ulp of the scalar at the exact value; inside: the largest at points inside, drawn without rounding from the clipper's vertices. barycentric/* makes each vertex from the original three, the others in a chain of cuts.",
      "smooth: perspective-correct. a*w: noperspective, carried through the clipper times w and divided by it again. as is: noperspective, handed to the clipper as if it were smooth. flat: the provoking vertex's value at all three."};
  static constexpr auto columns() {
    using R = ErrorRow;
    return std::tuple(
        column("mode", &R::treatment), column("planes", "k", &R::planes),
        contestant_columns(&R::clipper, &R::scalar), column("triangles", "n", &R::triangles),
        column("median_abs", "median", &R::median_abs), column("max_abs", "max", &R::max_abs),
        column("median_ulp", "ulp", &R::median_ulp), column("max_ulp", "max ulp", &R::max_ulp),
        column("inside_max_abs", "inside", &R::inside_max_abs));
  }
};

// What becomes of flat values, in percent of the triangles that are judged.
struct FlatRow {
  int planes = 0;
  std::string clipper, scalar;
  std::int64_t triangles = 0, wrong_vertices = 0;
  double first_changed_percent = 0, last_changed_percent = 0, constant_changed_percent = 0;

  static constexpr std::string_view kName = "attributes_flat";
  static constexpr std::string_view kTitle = "Flat attributes taken from the clipped polygon";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Triangles whose flat value changes if it is read from the polygon. First: its first vertex isn't the triangle's, to the bit. Last: some triangle of its fan ends in another vertex than the triangle did. Constant: one value at all three vertices comes out with another bit somewhere.",
      "Wrong: triangles that are not judged, since their vertices are others."};
  static constexpr auto columns() {
    using R = FlatRow;
    return std::tuple(
        column("planes", "k", &R::planes), contestant_columns(&R::clipper, &R::scalar),
        column("triangles", &R::triangles), column("wrong_vertices", "wrong", &R::wrong_vertices),
        column("first_changed_percent", "first [%]", &R::first_changed_percent),
        column("last_changed_percent", "last [%]", &R::last_changed_percent),
        column("constant_changed_percent", "constant [%]", &R::constant_changed_percent));
  }
};

// The median error of smooth attributes at vertices, and the largest one inside, over the planes
// crossed.
Plot error_plot(const std::vector<ErrorRow>& errors);
Plot inside_plot(const std::vector<ErrorRow>& errors);

// The largest error of each treatment over the planes crossed, in float: the right ones and the
// wrong ones.
Plot treatments_plot(const std::vector<ErrorRow>& errors);

std::string finding(const std::vector<ErrorRow>& errors, const std::vector<FlatRow>& flat);

}  // namespace clipscope::experiments::attributes
