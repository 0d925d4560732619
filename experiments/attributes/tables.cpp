// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/attributes/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<std::string_view, kTreatments> kTreatmentNames = {"smooth", "a*w", "as is",
                                                                       "flat"};

double percent(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

Table error_table() {
  Table table("attributes", "Errors of attributes by planes crossed (k) and mode",
              {{"mode", "mode"},
               {"planes", "k"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"triangles", "n"},
               {"median_abs", "median"},
               {"max_abs", "max"},
               {"median_ulp", "ulp"},
               {"max_ulp", "max ulp"},
               {"inside_max_abs", "inside"}});
  table.add_note(
      "Attributes in [0, 1]. Median, max: at vertices, absolute, then in ulp of the scalar at the "
      "exact "
      "value; inside: the largest at points inside, drawn without rounding from the clipper's "
      "vertices. "
      "barycentric/* makes each vertex from the original three, the others in a chain of cuts.");
  table.add_note(
      "smooth: perspective-correct. a*w: noperspective, carried through the clipper times w and "
      "divided "
      "by it again. as is: noperspective, handed to the clipper as if it were smooth. flat: the "
      "provoking "
      "vertex's value at all three.");
  return table;
}

Table flat_table() {
  Table table("attributes_flat", "Flat attributes taken from the clipped polygon",
              {{"planes", "k"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"triangles", "triangles"},
               {"wrong_vertices", "wrong"},
               {"first_changed_percent", "first [%]"},
               {"last_changed_percent", "last [%]"},
               {"constant_changed_percent", "constant [%]"}});
  table.add_note(
      "Triangles whose flat value changes if it is read from the polygon. First: its first vertex "
      "isn't "
      "the triangle's, to the bit. Last: some triangle of its fan ends in another vertex than the "
      "triangle "
      "did. Constant: one value at all three vertices comes out with another bit somewhere.");
  table.add_note("Wrong: triangles that are not judged, since their vertices are others.");
  return table;
}

struct RowKey {
  std::string_view mode, clipper, scalar;

  bool holds(const RowView& row) const {
    return row.text("mode") == mode && row.text("clipper") == clipper &&
           row.text("scalar") == scalar;
  }
};

Series series_of(const Table& errors, const RowKey& key, std::string_view measure,
                 std::string name) {
  Series series{.name = std::move(name), .x = {}, .y = {}};
  for (const RowView& row : rows_of(errors)) {
    if (!key.holds(row)) continue;
    series.x.push_back(static_cast<double>(row.count("planes")));
    series.y.push_back(row.number(measure));
  }
  return series;
}

// The largest value over all numbers of planes, or over one of them; nothing without such rows.
std::optional<double> largest(const Table& errors, const RowKey& key, std::string_view measure,
                              std::int64_t planes = 0) {
  std::optional<double> most;
  for (const RowView& row : rows_of(errors)) {
    if (!key.holds(row) || (planes != 0 && row.count("planes") != planes)) continue;
    most = std::max(most.value_or(0), row.number(measure));
  }
  return most;
}

Plot plot_over_planes(std::string name, std::string title, std::string caption, Axis y) {
  return {.name = std::move(name),
          .title = std::move(title),
          .caption = std::move(caption),
          .x = {.label = "planes crossed", .from = 0.5, .to = 6.5},
          .y = std::move(y),
          .series = {}};
}

// Every clipper in float and double but those that would be drawn on top of another, or so far off that
// all others became one line; all of the table if no other is left.
std::vector<Series> smooth_series(const Table& errors, std::string_view measure) {
  static constexpr std::array<std::string_view, 3> kLeftOut = {"textbook", "homogeneous/pipeline",
                                                               "cvv/naive"};
  std::vector<Series> shown, left_out;
  std::set<std::pair<std::string, std::string>> seen;
  for (const RowView& row : rows_of(errors)) {
    const std::string &clipper = row.text("clipper"), &scalar = row.text("scalar");
    if (!seen.emplace(clipper, scalar).second) continue;
    const bool keep = (scalar == "float" || scalar == "double") &&
                      std::ranges::find(kLeftOut, clipper) == kLeftOut.end();
    (keep ? shown : left_out)
        .push_back(series_of(errors, {"smooth", clipper, scalar}, measure,
                             fmt::format("{}, {}", clipper, scalar)));
  }
  return shown.empty() ? left_out : shown;
}

// Chain against originals: what grows with the cuts, and what does not.
std::string chain_sentence(const Table& errors) {
  static constexpr RowKey kChain = {"smooth", "homogeneous/sutherland_hodgman", "float"};
  static constexpr RowKey kOriginals = {"smooth", "barycentric/distance_matrix", "float"};
  const auto chain_1 = largest(errors, kChain, "median_ulp", 1);
  const auto chain_6 = largest(errors, kChain, "median_ulp", 6);
  const auto originals_1 = largest(errors, kOriginals, "median_ulp", 1);
  const auto originals_6 = largest(errors, kOriginals, "median_ulp", 6);
  if (!chain_1 || !chain_6 || !originals_1 || !originals_6) return "";
  return fmt::format(
      "From one plane crossed to six the median error of a smooth attribute goes from {:.2f} to "
      "{:.2f} ulp "
      "in a chain of cuts and from {:.2f} to {:.2f} ulp made from the original vertices (float); "
      "the "
      "largest one is {:.1e} and {:.1e} at a vertex, {:.1e} and {:.1e} inside.",
      *chain_1, *chain_6, *originals_1, *originals_6, *largest(errors, kChain, "max_abs"),
      *largest(errors, kOriginals, "max_abs"), *largest(errors, kChain, "inside_max_abs"),
      *largest(errors, kOriginals, "inside_max_abs"));
}

std::string mode_sentence(const Table& errors) {
  static constexpr std::string_view kClipper = "homogeneous/sutherland_hodgman";
  const auto as_is = largest(errors, {"as is", kClipper, "float"}, "max_abs");
  const auto times_w = largest(errors, {"a*w", kClipper, "float"}, "max_abs");
  if (!as_is || !times_w) return "";
  return fmt::format(
      " A noperspective attribute clipped as a smooth one is off by up to {:.2g}, carried as a*w "
      "by {:.1e}.",
      *as_is, *times_w);
}

std::string flat_sentence(const Table& flat) {
  double first = 0, last = 0, triangles = 0;
  std::set<std::string> changing;
  for (const RowView& row : rows_of(flat)) {
    const auto n = static_cast<double>(row.count("triangles"));
    triangles += n;
    first += n * row.number("first_changed_percent");
    last += n * row.number("last_changed_percent");
    if (row.number("constant_changed_percent") > 0) changing.insert(row.text("clipper"));
  }
  if (triangles == 0) return "";
  return fmt::format(
      " Read from the clipped polygon a flat value is wrong in {:.3g} % (first vertex) and {:.3g} "
      "% (last) of the triangles; "
      "given to all three vertices beforehand it stays the same to the bit in {}.",
      first / triangles, last / triangles,
      changing.empty() ? "every clipper"
                       : fmt::format("all clippers but {}", fmt::join(changing, ", ")));
}

}  // namespace

AttributeTables::AttributeTables() : errors(error_table()), flat(flat_table()) {}

void add_tally(AttributeTables& tables, int planes, const AnyContestant& contestant,
               const AttributeTally& tally) {
  const std::string clipper(clipper_name(contestant)), scalar(scalar_name(contestant));
  for (std::size_t t = 0; t < kTreatments; ++t) {
    const TreatmentErrors& e = tally.errors[t];
    tables.errors.add_row({std::string(kTreatmentNames[t]), std::int64_t{planes}, clipper, scalar,
                           tally.triangles, e.absolute.quantile(0.5), e.absolute.max(),
                           e.ulp.quantile(0.5), e.ulp.max(), e.inside});
  }
  tables.flat.add_row({std::int64_t{planes}, clipper, scalar, tally.triangles, tally.wrong,
                       percent(tally.first_changed, tally.triangles),
                       percent(tally.last_changed, tally.triangles),
                       percent(tally.constant_changed, tally.triangles)});
}

Plot error_over_planes(const AttributeTables& tables) {
  Plot plot = plot_over_planes(
      "attributes", "Smooth attributes: chains of cuts, and vertices from the originals",
      "Median error of a smooth attribute at a clipped vertex over the number of planes that the "
      "triangle "
      "crosses. A chain of cuts interpolates what it has interpolated before; "
      "barycentric/distance_matrix goes back to the three vertices.",
      {.label = "median error [ulp]", .from = 0});
  plot.series = smooth_series(tables.errors, "median_ulp");
  return plot;
}

Plot error_inside(const AttributeTables& tables) {
  Plot plot = plot_over_planes(
      "attributes_inside", "Smooth attributes inside the clipped polygon",
      "The largest error of a smooth attribute at points inside, over the number of planes that "
      "the "
      "triangle crosses: vertices whose values are right, in the wrong place, bend what lies "
      "between.",
      {.label = "largest error inside [attributes in 0 to 1]", .logarithmic = true});
  plot.series = smooth_series(tables.errors, "inside_max_abs");
  return plot;
}

Plot error_of_treatments(const AttributeTables& tables) {
  Plot plot = plot_over_planes(
      "attributes_modes", "Interpolation modes: the clipper must know them",
      "Largest error in float. A clipper in homogeneous space is right for smooth attributes and "
      "wrong for "
      "noperspective ones, unless they are carried times w; an affine clipper in NDC the other way "
      "round.",
      {.label = "largest error at a vertex [attributes in 0 to 1]", .logarithmic = true});
  static constexpr std::string_view kHomogeneous = "homogeneous/sutherland_hodgman";
  static constexpr std::string_view kAffine = "cvv/naive";
  const std::array<std::pair<RowKey, std::string>, 5> all = {
      {{{"as is", kHomogeneous, "float"}, "noperspective clipped as smooth"},
       {{"smooth", kAffine, "float"}, "smooth clipped as noperspective"},
       {{"a*w", kHomogeneous, "float"}, "noperspective carried as a*w"},
       {{"smooth", kHomogeneous, "float"}, "smooth clipped as smooth"},
       {{"as is", kAffine, "float"}, "noperspective clipped in NDC"}}};
  for (const auto& [key, name] : all) {
    Series series = series_of(tables.errors, key, "max_abs", name);
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

std::string attributes_finding(const AttributeTables& tables) {
  return chain_sentence(tables.errors) + mode_sentence(tables.errors) + flat_sentence(tables.flat);
}

}  // namespace clipscope::experiments
