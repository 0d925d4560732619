// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace clipscope::experiments::guard_band {
namespace {

constexpr double kShownBand = 16;  // the band that the finding speaks of

// One series per scene of the rows of the bands. y: a number or an interval, an optional of it.
template <class F>
std::vector<Series> series_by_scene(const std::vector<WorkRow>& work, F&& y) {
  std::vector<Series> series;
  for (const WorkRow& row : work) {
    const auto value = y(row);
    if (row.method != Method::band || !row.band || !value) continue;
    if (series.empty() || series.back().name != row.scene) series.push_back({row.scene});
    series.back().add(*row.band, *value);
  }
  return series;
}

}  // namespace

Plot cut_plot(const std::vector<WorkRow>& work) {
  return {
      .name = "guard_band_cut",
      .title = "Triangles that a guard band can't pass on",
      .caption =
          "Share of the triangles not outside one plane that leave the band and must be cut at a side.",
      .x = {.label = "half width of the band [half screens]", .logarithmic = true},
      .y = {.label = "cut at a side [%]", .from = 0.0},
      .series = series_by_scene(work, [](const WorkRow& row) { return row.cut_percent; })};
}

Plot time_plot(const std::vector<WorkRow>& work) {
  return {
      .name = "guard_band_time",
      .title = "What a guard band saves the geometry stage",
      .caption =
          "Full clipping's time over that with a guard band, 95 % intervals of the ratio in the same round; above 1 the band is faster.",
      .x = {.label = "half width of the band [half screens]", .logarithmic = true},
      .y = {.label = "times as fast as full clipping"},
      .series = series_by_scene(work, [](const WorkRow& row) {
        return row.timing ? row.timing->speedup : std::nullopt;
      })};
}

std::string finding(const std::vector<WorkRow>& work, const std::vector<PictureRow>& pictures) {
  std::vector<std::string> scenes;
  for (const WorkRow& row :
       rows_where(work, &WorkRow::method, Method::band, &WorkRow::band, kShownBand)) {
    if (!row.timing || !row.timing->speedup) continue;
    scenes.push_back(
        fmt::format("{}: {} % still cut, {} times as fast, {} times the pixels visited", row.scene,
                    format_number(row.cut_percent.value_or(0)),
                    format_number(row.timing->speedup->median), format_number(row.visited_ratio)));
  }
  std::int64_t full = 0, band = 0;
  for (const PictureRow& row : rows_where(pictures, &PictureRow::vertices, "float")) {
    const std::int64_t wrong = row.holes_px + row.extra_px;
    if (row.method == Method::full) full += wrong;
    if (row.method == Method::band && row.band == kShownBand) band += wrong;
  }
  return fmt::format(
      "With a guard band of {:g} half screens, against full clipping: {}. Pixels covered otherwise than in the exact pictures: {} with full clipping, {} with the band.",
      kShownBand, fmt::join(scenes, "; "), full, band);
}

}  // namespace clipscope::experiments::guard_band
