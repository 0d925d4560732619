// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the tables of `perspective`. r is w_max / w_min of a triangle or an edge.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

#include "experiments/contestants/columns.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::perspective {

struct RatioRow {
  double ratio = 1;                     // r
  double on_edges = 0, inside = 0;      // the largest errors found
  double bound = 0;                     // b(r), see affine_error.hpp
  bool attained = false;                // an error equals the bound
  std::int64_t points = 0, beyond = 0;  // tried; and those where the error is above the bound

  double above_one() const { return ratio - 1; }
  double texels_256() const { return bound * 256; }
  double texels_1024() const { return bound * 1024; }
  double texels_4096() const { return bound * 4096; }

  static constexpr std::string_view kName = "perspective";
  static constexpr std::string_view kTitle =
      "Largest error of affine interpolation by r = w_max/w_min";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Errors in shares of the attribute's range along an edge. Bound: (sqrt(r) - 1) / (sqrt(r) + 1). Measured max: on evenly spaced points of the edge; inside: strictly inside of random triangles, in rationals. Attained: at the edge's worst point the error is the bound, exactly. Beyond: points with a larger error, decided exactly. Texels: the bound, for a texture that is laid once along the edge."};
  static constexpr auto columns() {
    using R = RatioRow;
    return std::tuple(column("w_ratio", "r", &R::ratio),
                      derived("ratio_above_one", "r - 1", &R::above_one),
                      column("measured_max", "measured max", &R::on_edges),
                      column("inside_max", "inside", &R::inside), column("bound", &R::bound),
                      column("attained", &R::attained), column("beyond", &R::beyond),
                      derived("texels_256", "256 texels", &R::texels_256),
                      derived("texels_1024", "1024", &R::texels_1024),
                      derived("texels_4096", "4096", &R::texels_4096));
  }
};

struct ThresholdRow {
  std::string criterion;
  int texels = 0;
  double error = 0;
  double ratio = 1;               // by the closed form
  double measured_above_one = 0;  // without it
  bool exact = false;

  double above_one() const { return ratio - 1; }

  static constexpr std::string_view kName = "perspective_threshold";
  static constexpr std::string_view kTitle =
      "The w_max/w_min at which the affine error can be seen";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "A texture of so many texels is laid once along an edge. Half a texel: the nearest texel is another one. Half a level (1/510): the smallest error that changes a rounded 8-bit value; of a ramp from 0 to 255 along the whole edge, or of a checkerboard, where linear filtering goes from 0 to 255 within one texel, the steepest that 8 bits can be.",
      "r: ((1 + e) / (1 - e))^2. Measured: by bisection, the largest error sought along the edge. Exact: at that ratio the largest error is e, in rationals."};
  static constexpr auto columns() {
    using R = ThresholdRow;
    return std::tuple(column("criterion", &R::criterion),
                      column("texture_texels", "texels", &R::texels), column("error", &R::error),
                      column("w_ratio", "r = w_max/w_min", &R::ratio),
                      derived("ratio_above_one", "r - 1", &R::above_one),
                      column("measured_above_one", "measured r - 1", &R::measured_above_one),
                      column("exact", &R::exact));
  }
};

struct SceneRow {
  std::string scene;
  std::int64_t triangles = 0;
  double ratio_median = 1, ratio_p99 = 1, ratio_max = 1;
  double above_256 = 0, above_1024 = 0, above_4096 = 0, split_above_1024 = 0;  // percent

  static constexpr std::string_view kName = "perspective_scenes";
  static constexpr std::string_view kTitle =
      "How much perspective correction the visible triangles need";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "r: w_max/w_min over the exact clipped polygons. 256, 1024, 4096: the share of them somewhere more than half a texel off without perspective correction, with a texture of so many texels per unit of u and v, drawn as a fan. Split: 1024 texels, each fan triangle cut into 16 in view space first."};
  static constexpr auto columns() {
    using R = SceneRow;
    return std::tuple(column("scene", &R::scene), column("triangles", "visible", &R::triangles),
                      column("ratio_median", "r median", &R::ratio_median),
                      column("ratio_p99", "r 99 %", &R::ratio_p99),
                      column("ratio_max", "r max", &R::ratio_max),
                      column("above_256_percent", "256 [%]", &R::above_256),
                      column("above_1024_percent", "1024 [%]", &R::above_1024),
                      column("above_4096_percent", "4096 [%]", &R::above_4096),
                      column("split_above_1024_percent", "split [%]", &R::split_above_1024));
  }
};

struct CutRow {
  double ratio = 1;
  std::string clipper, scalar;
  std::int64_t triangles = 0;  // with the right vertices
  double max_error = 0;        // of an attribute at a vertex, absolute
  double bound = 0;            // b(r)
  std::string worst = "";      // in no column: the triangle with it, as replay_text has it

  static constexpr std::string_view kName = "perspective_clip";
  static constexpr std::string_view kTitle =
      "Attributes of the vertices that clipping makes, by w_max/w_min";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Attributes lie in [0, 1]; every vertex is in front of the near plane; triangles with the right vertices only. Affine bound: what an attribute that is linear in NDC can be off."};
  static constexpr auto columns() {
    using R = CutRow;
    return std::tuple(
        column("w_ratio", "w_max/w_min", &R::ratio), contestant_columns(&R::clipper, &R::scalar),
        column("triangles", &R::triangles), column("max_error", "max error", &R::max_error),
        column("bound", "affine bound", &R::bound));
  }
};

// The pieces that a triangle is drawn in.
enum class Pieces {
  near_cut,  // what the near plane leaves of it, however far it reaches beyond the screen
  clipped,   // what all planes leave of it
  split      // that, each triangle of the fan cut into 64 by halving its edges three times
};
constexpr std::array<std::string_view, 3> names_of(Pieces) {
  return {"near cut", "clipped", "split"};
}

struct PictureRow {
  std::string scene;
  Pieces pieces = Pieces::near_cut;
  double max_texel = 0, median_texel = 0, above_one_texel_percent = 0;

  static constexpr std::string_view kName = "perspective_pictures";
  static constexpr std::string_view kTitle = "Pictures without perspective correction";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Texels of a 1024-texel texture per unit of u and v. Near cut: what the near plane leaves of each triangle; clipped: what all planes leave; split: that, each fan triangle cut into 64. Pictures: perspective-<scene>-<drawn as>.png."};
  static constexpr auto columns() {
    using R = PictureRow;
    return std::tuple(
        column("scene", &R::scene), column("pieces", "drawn as", &R::pieces),
        column("max_texel", "max error [texel]", &R::max_texel),
        column("median_texel", "median [texel]", &R::median_texel),
        column("above_one_texel_percent", "above 1 texel [%]", &R::above_one_texel_percent));
  }
};

struct Tables {
  TableOf<RatioRow> ratios;
  TableOf<ThresholdRow> thresholds;
  TableOf<SceneRow> scenes;
  TableOf<CutRow> cuts;
  TableOf<PictureRow> pictures;
};

// What is said of perspective correction at the end, from the rows of the tables alone.

// Error over w_max / w_min - 1: the bound, what was measured, and lines at errors that can be seen.
Plot error_plot(const Tables& tables);

// The answer to the experiment's question. Rows that were not asked for are not spoken of.
std::string finding(const Tables& tables);

}  // namespace clipscope::experiments::perspective
