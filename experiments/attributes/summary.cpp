// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/attributes/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

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

// Chain against originals: what grows with the cuts, and what does not.
std::string chain_sentence(const Rows& errors) {
  const Rows chain = in_float(errors, Treatment::smooth, kChain);
  const Rows originals = in_float(errors, Treatment::smooth, kOriginals);
  const ErrorRow* chain_1 = find_row(chain, &ErrorRow::planes, 1);
  const ErrorRow* chain_6 = find_row(chain, &ErrorRow::planes, 6);
  const ErrorRow* originals_1 = find_row(originals, &ErrorRow::planes, 1);
  const ErrorRow* originals_6 = find_row(originals, &ErrorRow::planes, 6);
  if (!chain_1 || !chain_6 || !originals_1 || !originals_6) return "";
  return fmt::format(
      "From one plane crossed to six the median error of a smooth attribute goes from {:.2f} to {:.2f} ulp in a chain of cuts and from {:.2f} to {:.2f} ulp made from the original vertices (float); the largest one is {:.1e} and {:.1e} at a vertex, {:.1e} and {:.1e} inside.",
      chain_1->median_ulp, chain_6->median_ulp, originals_1->median_ulp, originals_6->median_ulp,
      largest(chain, &ErrorRow::max_abs), largest(originals, &ErrorRow::max_abs),
      largest(chain, &ErrorRow::inside_max_abs), largest(originals, &ErrorRow::inside_max_abs));
}

std::string mode_sentence(const Rows& errors) {
  const Rows as_is = in_float(errors, Treatment::noperspective, kChain);
  const Rows times_w = in_float(errors, Treatment::times_w, kChain);
  if (as_is.empty() || times_w.empty()) return "";
  return fmt::format(
      " A noperspective attribute clipped as a smooth one is off by up to {:.2g}, carried as a*w by {:.1e}.",
      largest(as_is, &ErrorRow::max_abs), largest(times_w, &ErrorRow::max_abs));
}

std::string flat_sentence(const std::vector<FlatRow>& flat) {
  double first = 0, last = 0, triangles = 0;
  std::set<std::string> changing;
  for (const FlatRow& row : flat) {
    const auto n = static_cast<double>(row.triangles);
    triangles += n;
    first += n * row.first_changed_percent;
    last += n * row.last_changed_percent;
    if (row.constant_changed_percent > 0) changing.insert(row.clipper);
  }
  if (triangles == 0) return "";
  return fmt::format(
      " Read from the clipped polygon a flat value is wrong in {:.3g} % (first vertex) and {:.3g} % (last) of the triangles; given to all three vertices beforehand it stays the same to the bit in {}.",
      first / triangles, last / triangles,
      changing.empty() ? "every clipper"
                       : fmt::format("all clippers but {}", fmt::join(changing, ", ")));
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
  return chain_sentence(errors) + mode_sentence(errors) + flat_sentence(flat);
}

}  // namespace clipscope::experiments::attributes
