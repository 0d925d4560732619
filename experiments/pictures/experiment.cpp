// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures: what each float clipper shows of scenes that cross the near plane, beside its error.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/experiment.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/pictures/draw_scene.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

std::string file_name(std::string scene, std::string clipper) {
  std::string name = fmt::format("{}-{}", std::filesystem::path(scene).stem().string(), clipper);
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

std::vector<Cell> counts_row(const Scene& scene, const AnyContestant& contestant,
                             const HeatMapCounts& counts) {
  std::vector<Cell> cells = {scene.name, std::string(clipper_name(contestant))};
  for (const PixelFate fate : {PixelFate::hole, PixelFate::extra, PixelFate::flipped}) {
    cells.emplace_back(static_cast<std::int64_t>(counts[fate]));
  }
  cells.emplace_back(counts.max_error);
  cells.emplace_back(100.0 * counts.share_above_one);
  return cells;
}

void draw_scene(const ExperimentContext& context, const Scene& scene, const PictureSize& size,
                Table& table, CellRecord& record) {
  const auto contestants = select_contestants(context.selection().clipper, {"float"});
  const View& view = scene.views.front();
  Progress progress(fmt::format("pictures of {}", scene.name), contestants.size() + 1);
  const FrameBuffer exact = draw_exact(scene, view, size);
  progress.advance();
  for (const AnyContestant& contestant : contestants) {
    const FrameBuffer tested = draw_with(contestant, scene, view, size);
    const HeatMap heat_map = compare(tested, exact);
    const std::string clipper(clipper_name(contestant));
    const Figure figure{&tested,
                        &heat_map,
                        {fmt::format("{}, {}", scene.name, view.label), clipper, "float", "exact"},
                        {}};
    const std::string stem = file_name(scene.name, clipper);
    write_image((context.out() / (stem + ".png")).string(), figure);
    write_image((context.out() / (stem + ".exr")).string(), figure);
    record.pictures.push_back(
        {stem + ".png",
         fmt::format("{} in float on {}, and its error beside it", clipper, scene.name)});
    table.add_row(counts_row(scene, contestant, heat_map.counts));
    progress.advance();
  }
}

// Pixels that show nothing, something or a side that they should not.
std::int64_t wrong_pixels(const RowView& row) {
  return row.count("holes_px") + row.count("extra_px") + row.count("flipped_px");
}

std::string finding_of(const Table& table, const PictureSize& size) {
  const std::vector<RowView> rows = rows_of(table);
  const auto worst = std::ranges::max_element(rows, {}, wrong_pixels);
  if (worst == rows.end()) return "No clipper was asked for.";
  const auto right = std::ranges::count(rows, 0, wrong_pixels);
  std::string text = fmt::format("{} of {} pictures show in every pixel the side that is there",
                                 right, rows.size());
  if (wrong_pixels(*worst) == 0) return text + ".";
  return text + fmt::format(
                    "; the worst is {} on {}: {:.0f} % of its pixels are holes, extra or "
                    "show the wrong side.",
                    worst->text("clipper"), worst->text("scene"),
                    100.0 * static_cast<double>(wrong_pixels(*worst)) / (size.width * size.height));
}

}  // namespace

void run_pictures(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::vector<std::string> names =
      selection.scenes.empty() ? std::vector<std::string>{"floor", "corridor"} : selection.scenes;
  const PictureSize size = selection.quick ? PictureSize{480, 270} : PictureSize{};
  Table table("pictures",
              fmt::format("Pixels of {} x {} pictures, float clippers against exact", size.width,
                          size.height),
              {{"scene", "scene"},
               {"clipper", "clipper"},
               {"holes_px", "holes [px]"},
               {"extra_px", "extra [px]"},
               {"flipped_px", "flipped [px]"},
               {"max_error_texel", "max error [texel]"},
               {"above_one_texel_percent", "above 1 texel [%]"}});
  for (const std::string& name : names) {
    context.cell(name, {&table}, [&](CellRecord& record) {
      draw_scene(context, load_selected_scene(selection, name), size, table, record);
    });
  }
  table.add_note(
      "Error: of the texture coordinates, in texels of a 1024-texel texture, where both "
      "pictures show the same side of something. Pictures: <scene>-<clipper>.png and .exr.");
  table.add_note(machine_description());
  context.emit(table);
  context.finding(finding_of(table, size));
}

}  // namespace clipscope::experiments
