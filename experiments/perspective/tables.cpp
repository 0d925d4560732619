// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/tables.hpp"

#include <algorithm>
#include <cstdint>

#include "experiments/perspective/affine_error.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kLevels = 255;  // steps between black and white in 8 bits

// An error, in shares of the attribute's range, that is large enough to be seen.
struct Criterion {
  std::string name;
  int texels;       // along the edge
  int denominator;  // the error is 1 / denominator
};

std::vector<Criterion> criteria() {
  std::vector<Criterion> all;
  for (const int texels : kTextureSizes) all.push_back({"half a texel", texels, 2 * texels});
  for (const int texels : kTextureSizes) all.push_back({"half a level, ramp", texels, 2 * kLevels});
  for (const int texels : kTextureSizes) {
    all.push_back({"half a level, checkerboard", texels, 2 * kLevels * texels});
  }
  return all;
}

std::string yes_or_no(bool b) { return b ? "yes" : "no"; }

// The share of the values above the limit [%].
template <class Projection>
double percent_above(const std::vector<PolygonNeed>& needs, double limit, Projection projection) {
  const auto above = std::ranges::count_if(
      needs, [&](double x) { return x > limit; }, projection);
  return 100.0 * static_cast<double>(above) / static_cast<double>(needs.size());
}

Table ratio_table() {
  Table table("perspective", "Largest error of affine interpolation by r = w_max/w_min",
              {{"w_ratio", "r"},
               {"ratio_above_one", "r - 1"},
               {"measured_max", "measured max"},
               {"inside_max", "inside"},
               {"bound", "bound"},
               {"attained", "attained"},
               {"beyond", "beyond"},
               {"texels_256", "256 texels"},
               {"texels_1024", "1024"},
               {"texels_4096", "4096"}});
  table.add_note(
      "Errors in shares of the attribute's range along an edge. Bound: (sqrt(r) - 1) / (sqrt(r) + "
      "1). "
      "Measured max: on evenly spaced points of the edge; inside: strictly inside of random "
      "triangles, "
      "in rationals. Attained: at the edge's worst point the error is the bound, exactly. Beyond: "
      "points with a larger error, decided exactly. Texels: the bound, for a texture that is laid "
      "once along the edge.");
  return table;
}

Table threshold_table() {
  Table table("perspective_threshold", "The w_max/w_min at which the affine error can be seen",
              {{"criterion", "criterion"},
               {"texture_texels", "texels"},
               {"error", "error"},
               {"w_ratio", "r = w_max/w_min"},
               {"ratio_above_one", "r - 1"},
               {"measured_above_one", "measured r - 1"},
               {"exact", "exact"}});
  table.add_note(
      "A texture of so many texels is laid once along an edge. Half a texel: the nearest texel is "
      "another one. Half a level (1/510): the smallest error that changes a rounded 8-bit value; "
      "of a "
      "ramp from 0 to 255 along the whole edge, or of a checkerboard, where linear filtering goes "
      "from "
      "0 to 255 within one texel, the steepest that 8 bits can be.");
  table.add_note(
      "r: ((1 + e) / (1 - e))^2. Measured: by bisection, the largest error sought along "
      "the edge. Exact: at that ratio the largest error is e, in rationals.");
  return table;
}

Table scene_table() {
  Table table("perspective_scenes", "How much perspective correction the visible triangles need",
              {{"scene", "scene"},
               {"triangles", "visible"},
               {"ratio_median", "r median"},
               {"ratio_p99", "r 99 %"},
               {"ratio_max", "r max"},
               {"above_256_percent", "256 [%]"},
               {"above_1024_percent", "1024 [%]"},
               {"above_4096_percent", "4096 [%]"},
               {"split_above_1024_percent", "split [%]"}});
  table.add_note(
      "r: w_max/w_min over the exact clipped polygons. 256, 1024, 4096: the share of them "
      "somewhere more "
      "than half a texel off without perspective correction, with a texture of so many texels per "
      "unit of u "
      "and v, drawn as a fan. Split: 1024 texels, each fan triangle cut into 16 in view space "
      "first.");
  return table;
}

Table clip_table() {
  Table table("perspective_clip", "Attributes of the vertices that clipping makes, by w_max/w_min",
              {{"w_ratio", "w_max/w_min"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"triangles", "triangles"},
               {"max_error", "max error"},
               {"bound", "affine bound"}});
  table.add_note(
      "Attributes lie in [0, 1]; every vertex is in front of the near plane; triangles with the "
      "right "
      "vertices only. Affine bound: what an attribute that is linear in NDC can be off.");
  return table;
}

Table picture_table() {
  Table table("perspective_pictures", "Pictures without perspective correction",
              {{"scene", "scene"},
               {"pieces", "drawn as"},
               {"max_texel", "max error [texel]"},
               {"median_texel", "median [texel]"},
               {"above_one_texel_percent", "above 1 texel [%]"}});
  table.add_note(
      "Texels of a 1024-texel texture per unit of u and v. Near cut: what the near plane leaves of "
      "each "
      "triangle; clipped: what all planes leave; split: that, each fan triangle cut into 64. "
      "Pictures: perspective-<scene>-<drawn as>.png.");
  return table;
}

}  // namespace

PerspectiveTables::PerspectiveTables()
    : ratios(ratio_table()),
      thresholds(threshold_table()),
      scenes(scene_table()),
      clip(clip_table()),
      pictures(picture_table()) {}

void add_ratio(Table& table, const EdgeSearch& s) {
  std::vector<Cell> cells = {s.ratio, s.ratio - 1,           s.on_edges, s.inside,
                             s.bound, yes_or_no(s.attained), s.beyond};
  for (const int texels : kTextureSizes) cells.emplace_back(s.bound * texels);
  table.add_row(std::move(cells));
}

void add_thresholds(Table& table) {
  for (const Criterion& c : criteria()) {
    const double error = 1.0 / c.denominator;
    const double ratio = ratio_at_error(error);
    table.add_row({c.name, std::int64_t{c.texels}, error, ratio, ratio - 1,
                   measured_ratio_at_error(error) - 1,
                   yes_or_no(is_error_at_its_ratio(1, c.denominator))});
  }
}

void add_scene(Table& table, const std::string& scene, const std::vector<PolygonNeed>& needs) {
  std::vector<double> ratios;
  for (const PolygonNeed& need : needs) ratios.push_back(need.ratio);
  std::ranges::sort(ratios);
  const auto quantile = [&](double q) {
    return ratios[static_cast<std::size_t>(q * static_cast<double>(ratios.size() - 1))];
  };
  std::vector<Cell> cells = {scene, static_cast<std::int64_t>(needs.size()), quantile(0.5),
                             quantile(0.99), ratios.back()};
  for (const int texels : kTextureSizes) {
    cells.emplace_back(percent_above(needs, 0.5 / texels, &PolygonNeed::error));
  }
  cells.emplace_back(percent_above(needs, 0.5 / 1024, &PolygonNeed::error_split));
  table.add_row(std::move(cells));
}

void add_cut(Table& table, double ratio, const AnyContestant& contestant, const CutError& error) {
  table.add_row({ratio, std::string(clipper_name(contestant)), std::string(scalar_name(contestant)),
                 error.triangles, error.max, affine_bound(ratio, 1)});
}

void add_picture(Table& table, const std::string& scene, Pieces pieces,
                 const HeatMapCounts& counts) {
  table.add_row({scene, std::string(pieces_name(pieces)), counts.max_error, counts.median_error,
                 100 * counts.share_above_one});
}

}  // namespace clipscope::experiments
