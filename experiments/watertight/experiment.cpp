// SPDX-License-Identifier: GPL-3.0-or-later
//
// Watertight: shared edges of meshes x clippers x scalars; the pieces that two neighbours keep.
#include <fmt/format.h>

#include "experiments/contestants/fewer_attributes.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/watertight/measure.hpp"
#include "experiments/watertight/rows.hpp"
#include "experiments/watertight/scenes.hpp"

namespace clipscope::experiments::watertight {
namespace {

constexpr std::string_view kByPlane = " by plane", kGrazing = name_of(Kind::grazing);

// Meshes whose triangles have neighbours (the soups have none), each as it is seen and by plane.
std::vector<std::string> cases(const Selection& selection) {
  std::vector<std::string> all;
  for (const std::string& name : selection.scenes_or({"teapot", "floor", "corridor", "terrain"})) {
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

// Whether the case shows no mesh of its own: one that another case shows, or none.
bool is_derived(const std::string& name) { return name == kGrazing || name.ends_with(kByPlane); }

Options options_of(const Selection& selection, const std::string& name) {
  // Grazing is one view, made for this.
  return {.edges_per_view = name == kGrazing ? 0 : selection.sample_or(150, 1500),
          .exact_edges_per_view = selection.quick ? 150u / 16 : 1500u / 16};
}

void draw_widest(const ExperimentContext& context, const std::vector<WorstRow>& worst,
                 PieceRecord& record) {
  const std::optional<WorstRow> row = widest_crack(worst);
  if (!row) return;
  const Crack crack = crack_of(make_case(context.selection(), row->scene), *row);
  const std::string title =
      fmt::format("{} in {}: {}, {}", row->clipper, row->scalar, row->scene, row->view);
  for (const char* file : {"watertight_crack.svg", "watertight_crack.png"}) {
    write_picture(context.out() / file, crack, title);
    record.pictures.push_back({file, "The widest crack: " + title});
    context.emit_file(context.out() / file);
  }
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  // What lies on an edge is found by marks in attributes.
  const Contestants contestants =
      with_attributes(selected_contestants(selection), kSceneAttributes);
  TableOf<MeshRow> meshes;
  TableOf<Row> table;
  TableOf<PlaneRow> planes;
  TableOf<WorstRow> worst;
  TableOf<SummaryRow> summary;
  const std::vector<std::string> names = cases(selection);
  Progress progress("watertight", names.size());
  for (const std::string& name : names) {
    context.piece(name, {&meshes, &table, &planes, &worst}, [&](PieceRecord& record) {
      const Scene scene = make_case(selection, name);
      if (!is_derived(name)) {
        meshes.add({scene.name, std::ssize(scene.mesh.triangles), edges_of(scene.mesh)});
      }
      for (const Measured& m : measure(scene, contestants, options_of(selection, name))) {
        table.add(m.row);
        for (const auto& [edges, tally] : m.by_class) {
          planes.add({m.row.scene, m.row.clipper, m.row.scalar, edges.first, edges.second, tally});
        }
        if (m.worst.crack_px == 0) continue;
        worst.add(m.worst);
        record.worst_inputs.push_back(worst_input(scene, m.worst));
      }
    });
    progress.advance();
  }
  context.piece("widest crack", {},
                [&](PieceRecord& record) { draw_widest(context, worst.rows(), record); });
  for (const SummaryRow& row : summary_rows(table.rows())) summary.add(row);
  for (Table* t : std::initializer_list<Table*>{&meshes, &table, &planes, &worst}) {
    t->add_note(fmt::format("Seed {}. {}", selection.seed, machine_description()));
  }
  context.emit(meshes, table, planes, worst, summary, crack_plot(summary.rows()));
  context.finding(finding(meshes.rows(), summary.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "watertight", "Do triangles that share an edge still share it after clipping?", run};

}  // namespace clipscope::experiments::watertight
