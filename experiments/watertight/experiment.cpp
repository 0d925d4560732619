// SPDX-License-Identifier: GPL-3.0-or-later
//
// Watertight: shared edges of meshes x clippers x scalars; the pieces that two neighbours keep.
#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/pictures/draw_scene.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/watertight/crack_picture.hpp"
#include "experiments/watertight/grazing.hpp"
#include "experiments/watertight/measure.hpp"
#include "experiments/watertight/plane_views.hpp"
#include "experiments/watertight/tables.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kByPlane = " by plane";

// Meshes whose triangles have neighbours (the soups have none), each as the scene has it and by plane.
std::vector<std::string> cases(const Selection& selection) {
  std::vector<std::string> names = selection.scenes;
  if (names.empty()) names = {"teapot", "floor", "corridor", "terrain"};
  std::vector<std::string> all;
  for (const std::string& name : names) {
    all.push_back(name);
    all.push_back(name + std::string(kByPlane));
  }
  if (selection.scenes.empty()) all.emplace_back(kGrazing);
  return all;
}

Scene make_case(const Selection& selection, const std::string& name) {
  if (name == kGrazing) return make_grazing_scene(selection.quick ? 2000 : 20000, selection.seed);
  if (!name.ends_with(kByPlane)) return load_selected_scene(selection, name);
  return cut_by_every_plane(
      load_selected_scene(selection, name.substr(0, name.size() - kByPlane.size())));
}

WatertightOptions options_of(const Selection& selection, const std::string& name) {
  const std::size_t usual = selection.quick ? 150 : 1500;
  std::size_t edges = selection.sample != 0 ? selection.sample : usual;
  if (name == kGrazing) edges = 0;  // one view, made for this
  return {.edges_per_view = edges, .exact_edges_per_view = usual / 16};
}

// The pair of triangles that a row of the worst table names.
CrackPicture crack_of(const Selection& selection, const RowView& row) {
  const Scene scene = make_case(selection, row.text("scene"));
  const View& view = find_view(scene, row.text("view"));
  const auto number = [&](const char* key) { return static_cast<std::uint32_t>(row.count(key)); };
  const SharedEdge edge = {
      {number("first_triangle"), number("second_triangle")},
      {static_cast<int>(number("first_corner")), static_cast<int>(number("second_corner"))}};
  const CutEdge cut = cut_edges(scene, view, {edge}, 0).front();
  const AnyContestant contestant = find_contestant(row.text("clipper"), row.text("scalar"));
  return {clipped_pair(contestant, view, neighbours_of(scene, view, edge), cut),
          fmt::format("{} in {}: {}, {}", row.text("clipper"), row.text("scalar"),
                      row.text("scene"), row.text("view"))};
}

void draw_widest(const ExperimentContext& context, const Table& worst, CellRecord& record) {
  const std::optional<RowView> row = widest_crack(worst);
  if (!row) return;
  const CrackPicture picture = crack_of(context.selection(), *row);
  for (const char* extension : {".svg", ".png"}) {
    const std::string file = std::string("watertight_crack") + extension;
    write_crack_picture(context.out() / file, picture);
    record.pictures.push_back({file, "The widest crack: " + picture.title});
    context.emit_file(context.out() / file);
  }
}

}  // namespace

void run_watertight(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::vector<AnyContestant> contestants = selected_contestants(selection);
  Table table = watertight_table(), planes = planes_table(), worst = worst_table();
  const std::vector<std::string> names = cases(selection);
  Progress progress("watertight", names.size());
  for (const std::string& name : names) {
    context.cell(name, {&table, &planes, &worst}, [&](CellRecord& record) {
      const Scene scene = make_case(selection, name);
      const auto tallies = measure_watertight(scene, contestants, options_of(selection, name));
      add_scene(scene.name, contestants, tallies, table);
      add_planes(scene.name, contestants, tallies, planes);
      add_worst(scene, contestants, tallies, worst, record);
    });
    progress.advance();
  }
  context.cell("widest crack", {},
               [&](CellRecord& record) { draw_widest(context, worst, record); });
  const Table summary = summary_table(table);
  for (Table* t : {&table, &planes, &worst}) {
    t->add_note(fmt::format("Seed {}. {}", selection.seed, machine_description()));
    context.emit(*t);
  }
  context.emit(summary);
  context.emit(crack_plot(summary));
  context.finding(watertight_finding(summary));
}

}  // namespace clipscope::experiments
