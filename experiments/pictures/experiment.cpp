// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures: what each float clipper shows of scenes that cross the near plane, beside its error.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/pictures/rows.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/survey/draw_scene.hpp"
#include "experiments/survey/sweep.hpp"

namespace clipscope::experiments::pictures {
namespace {

constexpr std::size_t kAtOnce = 8;  // pictures in work at once

std::string file_name(const std::string& scene, std::string_view clipper) {
  std::string name = fmt::format("{}-{}", std::filesystem::path(scene).stem().string(), clipper);
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

struct Drawing {
  std::string stem;  // of its files
  Row row;
};

Drawing draw_one(const ExperimentContext& context, const Scene& scene, const Contestant& contestant,
                 const FrameBuffer& exact, const PictureSize& size) {
  const View& view = scene.views.front();
  const std::string clipper(contestant.clipper), stem = file_name(scene.name, clipper);
  const FrameBuffer tested = draw_with(contestant, scene, view, size);
  const HeatMap heat_map = compare(tested, exact);
  const Figure figure{
      &tested, &heat_map, {fmt::format("{}, {}", scene.name, view.label), clipper, "float"}, {}};
  write_image(context.out() / (stem + ".png"), figure);
  write_image(context.out() / (stem + ".exr"), figure);
  const HeatMapCounts& counts = heat_map.counts;
  return {stem,
          {scene.name, clipper, counts[PixelFate::hole], counts[PixelFate::extra],
           counts[PixelFate::flipped], counts.max_error, 100.0 * counts.share_above_one}};
}

void draw(const ExperimentContext& context, const Scene& scene, const PictureSize& size,
          TableOf<Row>& table, PieceRecord& record) {
  const Contestants contestants = select_contestants(context.selection(), {"float"});
  Progress progress(fmt::format("pictures of {}", scene.name), contestants.size());
  const FrameBuffer exact = draw_exact(scene, scene.views.front(), size);
  work_in_order(
      contestants.size(), kAtOnce, progress,
      [&](std::size_t i) { return draw_one(context, scene, *contestants[i], exact, size); },
      [&](const Drawing& drawing) {
        record.pictures.push_back(
            {drawing.stem + ".png", fmt::format("{} in float on {}, and its error beside it",
                                                drawing.row.clipper, scene.name)});
        table.add(drawing.row);
      });
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const PictureSize size = selection.quick ? PictureSize{320, 180} : PictureSize{};
  TableOf<Row> table(std::string(Row::kName),
                     fmt::format("Pixels of {} x {} pictures, float clippers against exact",
                                 size.width, size.height));
  for (const std::string& name : selection.scenes_or({"floor", "corridor"})) {
    context.piece(name, {&table}, [&](PieceRecord& record) {
      draw(context, load_selected_scene(selection, name), size, table, record);
    });
  }
  table.add_note(machine_description());
  context.emit(table);
  context.finding(finding(table.rows(), static_cast<std::uint64_t>(size.width) *
                                            static_cast<std::uint64_t>(size.height)));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "pictures", "What does each clipper show on screen, and where is it wrong?", run};

}  // namespace clipscope::experiments::pictures
