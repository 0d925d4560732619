// SPDX-License-Identifier: GPL-3.0-or-later
//
// Guard band: scenes x bands, what is cut, what it costs, what the rasterizer gets, and the picture.
#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/guard_band/band_picture.hpp"
#include "experiments/guard_band/band_time.hpp"
#include "experiments/guard_band/band_work.hpp"
#include "experiments/guard_band/tables.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array kBands = {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, kNoSides};
constexpr std::array kPictureBands = {2.0, 16.0, 64.0, kNoSides};
constexpr int kLeastBits = 12, kMostBits = 20;  // 11 bits do not span 3840 px

// A game-like mix, sides crossed in front of the eye, triangles from behind it, and huge ones.
std::vector<std::string> mixes(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  return {"soup", "soup_straddling", "soup_behind", "floor", "corridor", "terrain"};
}

std::vector<std::string> pictured(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  return {"floor", "corridor", "teapot"};
}

void measure_bands(const Scene& scene, const Selection& selection, Table& table,
                   CellRecord& record) {
  const auto batches = timed_batches(scene, selection.quick ? 4000 : 20000);
  std::vector<GuardBand> bands;
  for (const double band : kBands) bands.push_back({band, band});
  const BandTimes times = time_bands(batches, bands, selection.quick ? 7 : 31);
  const BandTally full = tally_full(batches);
  add_band_work_row(table, record, scene.name, "full", 1.0, full, full, times.full);
  for (std::size_t i = 0; i < kBands.size(); ++i) {
    add_band_work_row(table, record, scene.name, "band", kBands[i], tally_band(batches, bands[i]),
                      full, times.bands[i]);
  }
  add_band_scissored_row(table, record, scene.name, full, times.scissored);
}

void measure_fixed_point(const Scene& scene, const Selection& selection, Table& table) {
  const auto batches = timed_batches(scene, selection.quick ? 4000 : 20000);
  for (int bits = kLeastBits; bits <= kMostBits; ++bits) {
    const FixedPoint format{bits};
    add_band_fixed_row(table, scene.name, format, tally_band(batches, format.band()));
  }
}

void measure_pictures(const Scene& scene, const Selection& selection, Table& table) {
  const View& view = scene.views.front();
  const PictureSize size = selection.quick ? PictureSize{480, 270} : PictureSize{};
  const FrameBuffer exact = draw_exact(scene, view, size);
  for (const bool snapped : {false, true}) {
    const FrameBuffer full = draw_in_band(scene, view, size, {{}, snapped});
    add_band_picture_row(table, scene.name, {{}, snapped}, compare_band(full, full, exact));
    for (const double band : kPictureBands) {
      const BandDrawing drawing{GuardBand{band, band}, snapped};
      add_band_picture_row(table, scene.name, drawing,
                           compare_band(draw_in_band(scene, view, size, drawing), full, exact));
    }
  }
}

}  // namespace

void run_guard_band(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table work = band_work_table(), fixed = band_fixed_table(), points = band_points_table();
  Table pictures = band_pictures_table();
  const auto names = mixes(selection), drawn = pictured(selection);
  Progress progress("guard_band", names.size() + drawn.size());
  for (const std::string& name : names) {
    const Scene scene = load_selected_scene(selection, name);
    context.cell(scene.name, {&work, &fixed, &points}, [&](CellRecord& record) {
      measure_bands(scene, selection, work, record);
      measure_fixed_point(scene, selection, fixed);
      add_band_points_row(points, scene.name, tally_points(timed_batches(scene, 4000)));
    });
    progress.advance();
  }
  for (const std::string& name : drawn) {
    const Scene scene = load_selected_scene(selection, name);
    context.cell(scene.name + " picture", {&pictures},
                 [&](CellRecord&) { measure_pictures(scene, selection, pictures); });
    progress.advance();
  }
  for (const Table* table : {&work, &fixed, &points, &pictures}) context.emit(*table);
  context.emit(band_cut_plot(work));
  context.emit(band_time_plot(work));
  context.finding(guard_band_finding(work, pictures));
}

}  // namespace clipscope::experiments
