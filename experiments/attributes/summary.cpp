// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/attributes/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::attributes {
namespace {

using Rows = std::vector<ErrorRow>;
using Figure = double ErrorRow::*;

constexpr const char* kChain = "homogeneous/sutherland_hodgman";
constexpr const char* kOriginals = "barycentric/distance_matrix";
constexpr const char* kAffine = "cvv/naive";

const Axis kPlanesCrossed{.label = "planes crossed", .from = 0.5, .to = 6.5};

Rows in_float(const Rows& errors, Treatment treatment, const char* clipper) {
  return rows_where(errors, &ErrorRow::treatment, treatment, &ErrorRow::clipper, clipper,
                    &ErrorRow::scalar, "float");
}

Series curve(const std::string& name, const Rows& rows, Figure figure) {
  Series series{.name = name};
  for (const ErrorRow& row : rows) series.add(row.planes, row.*figure);
  return series;
}

// Every clipper in float and double but those that would be drawn on top of another, or so far off
// that all others became one line; all of the table if no other is left.
std::vector<Series> smooth_curves(const Rows& errors, Figure figure) {
  const Rows all = rows_where(errors, &ErrorRow::treatment, Treatment::smooth);
  Rows shown = all;
  std::erase_if(shown, [](const ErrorRow& row) {
    return (row.scalar != "float" && row.scalar != "double") || row.clipper == "textbook" ||
           row.clipper == "homogeneous/pipeline" || row.clipper == kAffine;
  });
  if (shown.empty()) shown = all;
  const auto name = [](const ErrorRow& row) {
    return fmt::format("{}, {}", row.clipper, row.scalar);
  };
  std::vector<Series> curves;
  for (const std::string& each : distinct(shown, name)) {
    curves.push_back(curve(each, rows_where(shown, name, each), figure));
  }
  return curves;
}

double largest(const Rows& rows, Figure figure) {
  return std::ranges::max(rows, {}, figure).*figure;
}

// What may well be noise is no difference: a tenth.
bool is_more(double a, double b) { return a > 1.1 * b; }

// Chain against originals: what grows with the cuts, and what does not.
std::string chain_sentence(const Rows& errors) {
  const Rows chain = in_float(errors, Treatment::smooth, kChain);
  const Rows originals = in_float(errors, Treatment::smooth, kOriginals);
  const ErrorRow* chain_6 = find_row(chain, &ErrorRow::planes, 6);
  const ErrorRow* originals_6 = find_row(originals, &ErrorRow::planes, 6);
  if (!chain_6 || !originals_6) return "";
  const double chain_inside = largest(chain, &ErrorRow::inside_max_abs);
  const double originals_inside = largest(originals, &ErrorRow::inside_max_abs);
  return fmt::format(
      "A chain of cuts {} smooth attributes than computing every vertex from the original three: with six planes crossed the median error is {} ulp against {} ulp in float. Inside the polygon, where vertices in the wrong place bend what lies between, the chain is off {}.",
      is_more(chain_6->median_ulp, originals_6->median_ulp) ? "costs more accuracy of"
                                                            : "costs no more accuracy of",
      format_number(chain_6->median_ulp), format_number(originals_6->median_ulp),
      chain_inside > 10 * originals_inside      ? "more than ten times as far"
      : is_more(chain_inside, originals_inside) ? "farther, too"
                                                : "no farther");
}

std::string mode_sentence(const Rows& errors) {
  const Rows as_is = in_float(errors, Treatment::noperspective, kChain);
  const Rows times_w = in_float(errors, Treatment::times_w, kChain);
  if (as_is.empty() || times_w.empty()) return "";
  const bool wrong = largest(as_is, &ErrorRow::max_abs) > 10 * largest(times_w, &ErrorRow::max_abs);
  return wrong
             ? "A noperspective attribute must be carried times w: clipped as a smooth one it is wrong."
             : "A noperspective attribute may be clipped as a smooth one.";
}

std::string flat_sentence(const std::vector<FlatRow>& flat) {
  double changed = 0, triangles = 0;
  std::vector<std::string> changing;
  for (const FlatRow& row : flat) {
    const auto n = static_cast<double>(row.triangles);
    triangles += n;
    changed += n * std::min(row.first_changed_percent, row.last_changed_percent) / 100;
    if (row.constant_changed_percent > 0) changing.push_back(spoken_clipper(row.clipper));
  }
  if (triangles == 0) return "";
  std::ranges::sort(changing);
  changing.erase(std::unique(changing.begin(), changing.end()), changing.end());
  return fmt::format(
      "A flat value read from the clipped polygon is wrong for {} triangles; given to all three vertices beforehand it keeps its bits in {}.",
      quantity(changed / triangles),
      changing.empty() ? "every clipper" : "all clippers but " + listed(changing));
}

}  // namespace

Plot error_plot(const Rows& errors) {
  return {
      .name = "attributes",
      .title = "Smooth attributes: chains of cuts, and vertices from the originals",
      .caption =
          "Median error of a smooth attribute at a clipped vertex over the number of planes that the triangle crosses. A chain of cuts interpolates what it has interpolated before; barycentric/distance_matrix goes back to the three vertices.",
      .x = kPlanesCrossed,
      .y = {.label = "median error [ulp]", .from = 0},
      .series = smooth_curves(errors, &ErrorRow::median_ulp)};
}

Plot inside_plot(const Rows& errors) {
  return {
      .name = "attributes_inside",
      .title = "Smooth attributes inside the clipped polygon",
      .caption =
          "The largest error of a smooth attribute at points inside, over the number of planes that the triangle crosses: vertices whose values are right, in the wrong place, bend what lies between.",
      .x = kPlanesCrossed,
      .y = {.label = "largest error inside [attributes in 0 to 1]", .logarithmic = true},
      .series = smooth_curves(errors, &ErrorRow::inside_max_abs)};
}

Plot treatments_plot(const Rows& errors) {
  const auto curve_of = [&](const char* name, Treatment treatment, const char* clipper) {
    return curve(name, in_float(errors, treatment, clipper), &ErrorRow::max_abs);
  };
  Plot plot{
      .name = "attributes_modes",
      .title = "Interpolation modes: the clipper must know them",
      .caption =
          "Largest error in float. A clipper in homogeneous space is right for smooth attributes and wrong for noperspective ones, unless they are carried times w; an affine clipper in NDC the other way round.",
      .x = kPlanesCrossed,
      .y = {.label = "largest error at a vertex [attributes in 0 to 1]", .logarithmic = true},
      .series = {curve_of("noperspective clipped as smooth", Treatment::noperspective, kChain),
                 curve_of("smooth clipped as noperspective", Treatment::smooth, kAffine),
                 curve_of("noperspective carried as a*w", Treatment::times_w, kChain),
                 curve_of("smooth clipped as smooth", Treatment::smooth, kChain),
                 curve_of("noperspective clipped in NDC", Treatment::noperspective, kAffine)}};
  std::erase_if(plot.series, [](const Series& series) { return series.x.empty(); });
  return plot;
}

std::string finding(const Rows& errors, const std::vector<FlatRow>& flat) {
  std::vector<std::string> sentences = {chain_sentence(errors), mode_sentence(errors),
                                        flat_sentence(flat)};
  std::erase(sentences, "");
  if (sentences.empty()) return "No clipper of a chain of cuts was judged beside the originals.";
  return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace clipscope::experiments::attributes
