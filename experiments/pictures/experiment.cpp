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

}  // namespace

void run_pictures(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::vector<AnyContestant> contestants = select_contestants(selection.clipper, {"float"});
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
  Progress progress("pictures", names.size() * (contestants.size() + 1));
  for (const std::string& name : names) {
    const Scene scene = load_selected_scene(selection, name);
    const View& view = scene.views.front();
    const FrameBuffer exact = draw_exact(scene, view, size);
    progress.advance();
    for (const AnyContestant& contestant : contestants) {
      const FrameBuffer tested = draw_with(contestant, scene, view, size);
      const HeatMap heat_map = compare(tested, exact);
      const Figure figure{&tested,
                          &heat_map,
                          {fmt::format("{}, {}", scene.name, view.label),
                           std::string(clipper_name(contestant)), "float", "exact"},
                          {}};
      const auto stem =
          context.out() / file_name(scene.name, std::string(clipper_name(contestant)));
      write_image(stem.string() + ".png", figure);
      write_image(stem.string() + ".exr", figure);
      table.add_row(counts_row(scene, contestant, heat_map.counts));
      progress.advance();
    }
  }
  table.add_note(
      "Error: of the texture coordinates, in texels of a 1024-texel texture, where both "
      "pictures show the same side of something. Pictures: <scene>-<clipper>.png and .exr.");
  table.add_note(machine_description());
  context.emit(table);
}

}  // namespace clipscope::experiments
