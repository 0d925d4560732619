// SPDX-License-Identifier: GPL-3.0-or-later
//
// The history of clipping as a table: what was published when, and what this run says of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/contract.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/results.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::history {

// What a method is timed at. A segment clipper that has a form in the plane is timed there, where
// its paper does; the others and the clippers of triangles from view space to NDC.
enum class Field { plane, segments, triangles };
constexpr std::array<std::string_view, 3> names_of(Field) {
  return {"segments in the plane", "segments", "triangles"};
}
// The method that the others of a field are compared with.
std::string_view usual_method(Field field);

struct Row {
  using Figure = std::optional<double>;

  std::int64_t year = 0;
  std::string clipper, idea;
  Field field = Field::plane;
  Figure ns = {}, speedup = {}, fastest_on_percent = {}, divisions = {}, hard_right_percent = {};
  std::string source = {};

  static constexpr std::string_view kName = "history";
  static constexpr std::string_view kTitle =
      "Clipping since 1968: what each method brought (float)";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "ns and x: geometric means over all mixes of the field (tables segments_plane, segments, cost). x: how many times faster than the usual method on the same input in the same round: Cohen-Sutherland for segments, Sutherland-Hodgman in clip space for triangles. Fastest: share of the mixes on which no other method of this table has a lower median.",
      "Divisions: per segment that has both ends out and is visible (plane), per shortened segment of cross_several but for the divide (segments), per triangle over all mixes with the divide (triangles). Hard cases: share that is right, of segments_hard, of the catalogue for triangles. Methods whose source has no year are left out: those of specifications and of this project; so are batch clippers."};
  static constexpr auto columns() {
    return std::tuple(column("year", &Row::year), column("clipper", &Row::clipper),
                      column("idea", "idea", &Row::idea, 30), column("field", &Row::field),
                      column("ns", "ns", &Row::ns), column("speedup", "x", &Row::speedup),
                      column("fastest_on_percent", "fastest on [%]", &Row::fastest_on_percent),
                      column("divisions", "/", &Row::divisions),
                      column("hard_right_percent", "hard right [%]", &Row::hard_right_percent),
                      column("source", &Row::source));
  }
};

// By year, then field and name. A figure that is not among the results is empty.
std::vector<Row> history(const Results& results);

// Speed and share of hard cases right over the years, of one field. Without series if nobody in it
// was timed.
Plot history_plot(const std::vector<Row>& rows, Field field);

// In which fields some method is faster than the usual one, whose gain is the largest and what it
// does to right answers, and who is always right.
std::string finding(const std::vector<Row>& rows);

}  // namespace clipscope::experiments::history
