// SPDX-License-Identifier: GPL-3.0-or-later
//
// Guard band: scenes x bands, what is cut, what it costs, what the rasteriser gets, and the
// picture.
#include <fmt/format.h>

#include <cmath>

#include "experiments/guard_band/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"

namespace clipscope::experiments::guard_band {
namespace {

constexpr std::array kBands = {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, kNoSides};
constexpr std::array kPictureBands = {2.0, 16.0, 64.0, kNoSides};
constexpr GuardBand kScissoredBand{16, 16};     // of homogeneous/guard_band
constexpr int kLeastBits = 12, kMostBits = 20;  // 11 bits do not span 3840 px
constexpr int kSubpixelBits = 8;

double quotient(double a, double b) { return b == 0 ? 0 : a / b; }

// The half width of a band; nothing where no side is ever cut.
std::optional<double> width_of(const GuardBand& band) {
  return std::isfinite(band.x) ? std::optional(band.x) : std::nullopt;
}

// What the tally is against that of full clipping.
WorkRow work_row(const std::string& scene, Method method, const GuardBand& band, const Tally& tally,
                 const Tally& full, const Timing& timing) {
  WorkRow row{.scene = scene,
              .method = method,
              .band = width_of(band),
              .triangles = tally.triangles,
              .reach_percent = quotient(100.0 * static_cast<double>(tally.passed()),
                                        static_cast<double>(tally.triangles)),
              .cut_percent = tally.cut_percent(),
              .vertices_per_polygon = quotient(static_cast<double>(tally.vertices),
                                               static_cast<double>(tally.polygons)),
              .visited_ratio = quotient(tally.visited_px, full.visited_px),
              .area_ratio = quotient(tally.area_px2, full.area_px2),
              .timing = if_timed(timing)};
  // The scissored polygons are those of full clipping; what was cut is not seen from outside.
  if (method == Method::scissored) row.cut_percent.reset();
  return row;
}

void measure_bands(const std::string& scene, std::span<const SampledView> views, int rounds,
                   TableOf<WorkRow>& table, PieceRecord& record) {
  std::vector<GuardBand> bands;
  for (const double band : kBands) bands.push_back({band, band});
  const Times times = time_bands(views, bands, rounds);
  const Tally full = tally_full(views);
  const auto add = [&](Method method, const GuardBand& band, const Tally& tally,
                       const Timing& timing) {
    table.add(work_row(scene, method, band, tally, full, timing));
    record.add(fmt::format("{} {} {}", scene, name_of(method), band.x), timing);
  };
  add(Method::full, {1, 1}, full, times.full);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    add(Method::band, bands[i], tally_band(views, bands[i]), times.bands[i]);
  }
  add(Method::scissored, kScissoredBand, full, times.scissored);
}

void measure_fixed_point(const std::string& scene, std::span<const SampledView> views,
                         TableOf<FixedRow>& table) {
  for (int bits = kLeastBits; bits <= kMostBits; ++bits) {
    const FixedPoint format{bits};
    const GuardBand band = format.band();
    const Tally tally = tally_band(views, band);
    table.add({scene, bits, format.band_px(), band.x, band.y, tally.side_cut, tally.cut_percent(),
               format.edge_function_bits(kSubpixelBits)});
  }
}

void measure_pictures(const Scene& scene, const PictureSize& size, TableOf<PictureRow>& table) {
  const View& view = scene.views.front();
  const FrameBuffer exact = draw_exact(scene, view, size);
  for (const bool snapped : {false, true}) {
    const FrameBuffer full = draw(scene, view, size, {{}, snapped});
    const auto add = [&](Method method, const GuardBand& band, const FrameBuffer& drawn) {
      const HeatMapCounts counts = compare(drawn, exact).counts;
      table.add({scene.name, method, width_of(band), snapped ? "1/256 px" : "float",
                 static_cast<std::int64_t>(counts[PixelFate::hole]),
                 static_cast<std::int64_t>(counts[PixelFate::extra]), unlike_pixels(drawn, full),
                 counts.max_error, counts.median_error});
    };
    add(Method::full, {1, 1}, full);
    for (const double width : kPictureBands) {
      const GuardBand band{width, width};
      add(Method::band, band, draw(scene, view, size, {band, snapped}));
    }
  }
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  TableOf<WorkRow> work;
  TableOf<FixedRow> fixed;
  TableOf<PointsRow> points;
  TableOf<PictureRow> pictures;
  // A game-like mix, sides crossed in front of the eye, triangles from behind it, and huge ones.
  const auto names = selection.scenes_or(
      {"soup", "soup_straddling", "soup_behind", "floor", "corridor", "terrain"});
  const auto drawn = selection.scenes_or({"floor", "corridor", "teapot"});
  Progress progress("guard_band", names.size() + drawn.size());
  for (const std::string& name : names) {
    const Scene scene = load_selected_scene(selection, name);
    context.piece(scene.name, {&work, &fixed, &points}, [&](PieceRecord& record) {
      const auto views = sampled_views(scene, selection.quick ? 4000 : 20000);
      measure_bands(scene.name, views, selection.quick ? 7 : 31, work, record);
      measure_fixed_point(scene.name, views, fixed);
      points.add({scene.name, tally_points(sampled_views(scene, 4000))});
    });
    progress.advance();
  }
  for (const std::string& name : drawn) {
    const Scene scene = load_selected_scene(selection, name);
    context.piece(scene.name + " picture", {&pictures}, [&](PieceRecord&) {
      measure_pictures(scene, selection.quick ? PictureSize{480, 270} : PictureSize{}, pictures);
    });
    progress.advance();
  }
  work.add_note(timing_description());
  context.emit(work, fixed, points, pictures);
  context.emit(cut_plot(work.rows()), time_plot(work.rows()));
  context.finding(finding(work.rows(), pictures.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "guard_band", "What does it save to cut near and far only and leave the sides to scissoring?",
    run};

}  // namespace clipscope::experiments::guard_band
