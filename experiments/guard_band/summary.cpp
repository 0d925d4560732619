// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guard_band/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::guard_band {
namespace {

constexpr double kShownBand = 16;     // the band that the finding speaks of
constexpr double kNoticeable = 1.05;  // less is neither faster nor slower

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

// On which scenes the band is faster than full clipping, and slower, beyond chance.
std::string time_sentence(const std::vector<WorkRow>& shown) {
  std::vector<std::string> faster, slower, same;
  for (const WorkRow& row : shown) {
    if (!row.timing || !row.timing->speedup) continue;
    const MedianInterval& speedup = *row.timing->speedup;
    const bool is_faster = speedup.low > 1 && speedup.median > kNoticeable;
    const bool is_slower = speedup.high < 1 && speedup.median < 1 / kNoticeable;
    (is_faster ? faster : is_slower ? slower : same).push_back(spoken_set(row.scene));
  }
  const std::string band = fmt::format("guard band of {:g} half screens", kShownBand);
  if (faster.empty() && slower.empty() && same.empty()) {
    return fmt::format("A {} was not timed.", band);
  }
  if (faster.empty()) return fmt::format("A {} makes clipping faster on no scene.", band);
  std::string text = fmt::format("A {} makes clipping faster on {}", band, listed(faster));
  if (!slower.empty()) text += fmt::format(", but slower on {}", listed(slower));
  return text + ".";
}

// What the rasteriser visits beyond the screen.
std::string pixels_sentence(const std::vector<WorkRow>& shown) {
  if (shown.empty()) return "";
  const WorkRow& most = *std::ranges::max_element(shown, {}, &WorkRow::visited_ratio);
  if (most.visited_ratio <= 1) return " The rasteriser visits no more pixels.";
  return fmt::format(" The rasteriser pays for it: on {} it visits {} the pixels.",
                     spoken_set(most.scene), times_text(most.visited_ratio));
}

std::string picture_sentence(const std::vector<PictureRow>& pictures) {
  std::int64_t full = 0, band = 0;
  for (const PictureRow& row : rows_where(pictures, &PictureRow::vertices, "float")) {
    const std::int64_t wrong = row.holes_px + row.extra_px;
    if (row.method == Method::full) full += wrong;
    if (row.method == Method::band && row.band == kShownBand) band += wrong;
  }
  if (pictures.empty()) return "";
  if (band == 0) return " The pictures cover the same pixels as the exact ones.";
  return fmt::format(" The pictures cover {} wrong pixels {} those of full clipping.",
                     band > full   ? "more"
                     : band < full ? "fewer"
                                   : "as many",
                     band == full ? "as" : "than");
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
  const std::vector<WorkRow> shown =
      rows_where(work, &WorkRow::method, Method::band, &WorkRow::band, std::optional(kShownBand));
  return time_sentence(shown) + pixels_sentence(shown) + picture_sentence(pictures);
}

}  // namespace clipscope::experiments::guard_band
