// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "experiments/measure/machine.hpp"
#include "experiments/measure/outcome.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kCutPercent = 5;  // its place among the cells of work_cells
constexpr int kSubpixelBits = 8;
constexpr double kShownBand = 16;  // the band that the finding speaks of

// An unlimited band is an empty cell.
Cell band_cell(double band) {
  if (std::isfinite(band)) return band;
  return {};
}

double quotient(double a, double b) { return b == 0 ? 0 : a / b; }

void finish_row(Table& table, CellRecord& record, std::vector<Cell> cells, const BandTime& time,
                std::string series) {
  if (time.refused.empty()) {
    cells.insert(cells.end(), {time.ns.median, time.ns.low, time.ns.high, time.speedup.median,
                               time.speedup.low, time.speedup.high});
  }
  cells.resize(table.columns().size());
  record.samples.push_back({std::move(series), "ns_per_triangle", time.samples_ns});
  table.add_row(std::move(cells));
}

std::vector<Cell> work_cells(const std::string& scene, const std::string& method, double band,
                             const BandTally& tally, const BandTally& full) {
  return {
      scene,
      method,
      band_cell(band),
      tally.triangles,
      quotient(100.0 * static_cast<double>(tally.passed()), static_cast<double>(tally.triangles)),
      tally.cut_percent(),
      quotient(static_cast<double>(tally.vertices), static_cast<double>(tally.polygons)),
      quotient(tally.visited_px, full.visited_px),
      quotient(tally.area_px2, full.area_px2)};
}

// One series per scene of the rows of the bands, with its interval if there is one.
std::vector<Series> series_by_scene(const Table& work, std::string_view key,
                                    std::string_view low = "", std::string_view high = "") {
  std::vector<Series> series;
  for (const RowView& row : rows_of(work)) {
    const auto band = row.find_number("band"), y = row.find_number(key);
    if (row.text("method") != "band" || !band || !y) continue;
    const std::string& scene = row.text("scene");
    if (series.empty() || series.back().name != scene) {
      series.push_back({.name = scene, .x = {}, .y = {}});
    }
    series.back().x.push_back(*band);
    series.back().y.push_back(*y);
    if (low.empty()) continue;
    series.back().low.push_back(row.number(low));
    series.back().high.push_back(row.number(high));
  }
  return series;
}

std::int64_t wrong_pixels(const RowView& row) {
  return row.count("holes_px") + row.count("extra_px");
}

}  // namespace

Table band_work_table() {
  Table table("guard_band", "Sides left to the rasteriser beyond a guard band, float",
              {{"scene", "scene"},
               {"method", "method"},
               {"band", "band"},
               {"triangles", "triangles"},
               {"reach_percent", "reach [%]"},
               {"cut_percent", "cut [%]"},
               {"vertices_per_polygon", "vertices"},
               {"visited_ratio", "visited x"},
               {"area_ratio", "area x"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"speedup_to_full", "x full"},
               {"speedup_low", "95 % low"},
               {"speedup_high", "high"}});
  table.add_note(
      "Band: half width in half widths of the screen; -: no side is ever cut. Full: "
      "homogeneous/sutherland_hodgman; scissored: homogeneous/guard_band, which also scissors. "
      "Reach: triangles not outside one plane; cut: of those, cut at a side of the band.");
  table.add_note(
      "Visited, area: pixels in the bounding boxes (within 3840 x 2160) of what is drawn, and its "
      "area with what reaches beyond the screen, over those of full clipping. x full: full "
      "clipping's time over this one's in the same round; band 1 is full clipping by the bands' "
      "code.");
  table.add_note(machine_description());
  return table;
}

void add_band_work_row(Table& table, CellRecord& record, const std::string& scene,
                       const std::string& method, double band, const BandTally& tally,
                       const BandTally& full, const BandTime& time) {
  finish_row(table, record, work_cells(scene, method, band, tally, full), time,
             fmt::format("{} {} {}", scene, method, band));
}

void add_band_scissored_row(Table& table, CellRecord& record, const std::string& scene,
                            const BandTally& full, const BandTime& time) {
  std::vector<Cell> cells = work_cells(scene, "scissored", kShownBand, full, full);
  cells[kCutPercent] = Cell();
  finish_row(table, record, std::move(cells), time, scene + " scissored");
}

Table band_fixed_table() {
  Table table("guard_band_fixed", "Triangles that leave what fixed-point vertices can address",
              {{"scene", "scene"},
               {"integer_bits", "integer bits"},
               {"band_px", "band [px]"},
               {"band_x", "band in x"},
               {"band_y", "band in y"},
               {"cut_triangles", "cut"},
               {"cut_percent", "cut [%]"},
               {"edge_function_bits", "edge function [bit]"}});
  table.add_note(
      "Signed coordinates with so many integer bits, counted from the middle of 3840 x 2160 px. "
      "Cut: "
      "of the triangles not outside one plane. Edge function: bits without overflow at 8 sub-pixel "
      "bits.");
  return table;
}

void add_band_fixed_row(Table& table, const std::string& scene, const FixedPoint& format,
                        const BandTally& tally) {
  const GuardBand band = format.band();
  table.add_row({scene, std::int64_t{format.integer_bits}, format.band_px(), band.x, band.y,
                 tally.side_cut, tally.cut_percent(),
                 std::int64_t{format.edge_function_bits(kSubpixelBits)}});
}

Table band_points_table() {
  Table table("guard_band_points", "Points tested by near and far alone, the sides by the pixel",
              {{"scene", "scene"},
               {"points", "points"},
               {"kept_full", "kept by all planes"},
               {"kept_near_far", "by near, far"},
               {"drawn", "drawn"},
               {"differ", "differ"}});
  table.add_note(
      "Drawn: kept by near and far, on a pixel of 3840 x 2160. Differ: of these, not kept by all "
      "six "
      "planes. The triangles' vertices as points of one pixel.");
  return table;
}

void add_band_points_row(Table& table, const std::string& scene, const PointTally& tally) {
  table.add_row(
      {scene, tally.points, tally.kept_full, tally.kept_near_far, tally.drawn, tally.differ});
}

Table band_pictures_table() {
  Table table("guard_band_pictures", "The scissored picture against the exact one",
              {{"scene", "scene"},
               {"method", "method"},
               {"band", "band"},
               {"vertices", "vertices"},
               {"holes_px", "holes [px]"},
               {"extra_px", "extra [px]"},
               {"unlike_full_px", "unlike full [px]"},
               {"max_error_texel", "max error [texel]"},
               {"median_error_texel", "median [texel]"}});
  table.add_note(
      "Vertices: float, or rounded to 1/256 px. Holes, extra: pixels covered in one picture only. "
      "Unlike full: another triangle than with full clipping of the same vertices. Error: of "
      "texture "
      "coordinates at pixel centres against exact, in texels of a 1024-texel texture.");
  return table;
}

void add_band_picture_row(Table& table, const std::string& scene, const BandDrawing& drawing,
                          const BandPicture& picture) {
  Cell band = 1.0;
  if (drawing.band) band = band_cell(drawing.band->x);
  table.add_row({scene, drawing.band ? "band" : "full", band,
                 drawing.snapped ? "1/256 px" : "float",
                 static_cast<std::int64_t>(picture.counts[PixelFate::hole]),
                 static_cast<std::int64_t>(picture.counts[PixelFate::extra]),
                 picture.unlike_full_px, picture.counts.max_error, picture.counts.median_error});
}

Plot band_cut_plot(const Table& work) {
  return {.name = "guard_band_cut",
          .title = "Triangles that a guard band can't pass on",
          .caption =
              "Share of the triangles not outside one plane that leave the band and must be cut "
              "at a side.",
          .x = {.label = "half width of the band [half screens]", .logarithmic = true},
          .y = {.label = "cut at a side [%]", .from = 0.0},
          .series = series_by_scene(work, "cut_percent")};
}

Plot band_time_plot(const Table& work) {
  return {.name = "guard_band_time",
          .title = "What a guard band saves the geometry stage",
          .caption =
              "Full clipping's time over that with a guard band, 95 % intervals of the ratio "
              "in the same round; above 1 the band is faster.",
          .x = {.label = "half width of the band [half screens]", .logarithmic = true},
          .y = {.label = "times as fast as full clipping"},
          .series = series_by_scene(work, "speedup_to_full", "speedup_low", "speedup_high")};
}

std::string guard_band_finding(const Table& work, const Table& pictures) {
  std::vector<std::string> scenes;
  for (const RowView& row : rows_of(work)) {
    const auto speedup = row.find_number("speedup_to_full");
    if (row.text("method") != "band" || row.find_number("band") != kShownBand || !speedup) continue;
    scenes.push_back(
        fmt::format("{}: {} % still cut, {} times as fast, {} times the pixels visited",
                    row.text("scene"), format_number(row.number("cut_percent")),
                    format_number(*speedup), format_number(row.number("visited_ratio"))));
  }
  std::int64_t full = 0, band = 0;
  for (const RowView& row : rows_of(pictures)) {
    if (row.text("vertices") != "float") continue;
    if (row.text("method") == "full") full += wrong_pixels(row);
    if (row.text("method") == "band" && row.find_number("band") == kShownBand) {
      band += wrong_pixels(row);
    }
  }
  return fmt::format(
      "With a guard band of {:g} half screens, against full clipping: {}. Pixels covered otherwise "
      "than in the exact pictures: {} with full clipping, {} with the band.",
      kShownBand, fmt::join(scenes, "; "), full, band);
}

}  // namespace clipscope::experiments
