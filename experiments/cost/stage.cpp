// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "experiments/cost/stage_tables.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/scenes/families.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTriangles = 1'000'000, kQuickTriangles = 40'000;
constexpr int kTerrainLevels = 9, kQuickTerrainLevels = 7;

// An input of the stage, made when its cell is.
struct StageMix {
  std::string name;
  StageContract contract;  // copy stands for both contracts of a soup
  std::function<StageInput()> make;
};

// The view in which the share of straddling triangles comes nearest to what is usual in games.
StageInput usual_view(const Scene& scene) {
  constexpr double kUsualPercent = 1;
  StageInput best;
  double least = HUGE_VAL;
  for (const View& view : scene.views) {
    StageInput input = mesh_input(scene, view);
    const double percent = shares_of(input, StageContract::indexed).straddling;
    const double off = std::abs(std::log(std::max(percent, 1e-3) / kUsualPercent));
    if (off >= least) continue;
    least = off;
    best = std::move(input);
  }
  best.name = scene.name;
  return best;
}

std::vector<StageMix> built_in_mixes(const Selection& selection) {
  const std::size_t triangles = selection.quick ? kQuickTriangles : kTriangles;
  const auto soup = [&](std::string name, const SoupShares& shares) {
    return StageMix{name, StageContract::copy, [=, seed = selection.seed] {
                      return random_input(name, shares, triangles, kSceneAttributes, seed);
                    }};
  };
  const int levels = selection.quick ? kQuickTerrainLevels : kTerrainLevels;
  return {soup("game_like", {.inside = 58, .outside = 37, .straddling = 5}),
          soup("straddling", {.straddling = 1}),
          soup("inside", {.inside = 1}),
          soup("outside", {.outside = 1}),
          {"terrain", StageContract::indexed, [levels, seed = selection.seed] {
             Scene scene = terrain_of_levels(levels, seed);
             scene.name = "terrain";
             return usual_view(scene);
           }}};
}

std::vector<StageMix> mixes(const Selection& selection) {
  if (selection.scenes.empty()) return built_in_mixes(selection);
  const std::size_t limit = selection.quick ? kQuickTriangles : kTriangles;
  std::vector<StageMix> mixes;
  for (const std::string& name : selection.scenes) {
    mixes.push_back({name, StageContract::copy,
                     [=] { return scene_input(load_selected_scene(selection, name), limit); }});
    mixes.push_back({name, StageContract::indexed,
                     [=] { return usual_view(load_selected_scene(selection, name)); }});
  }
  return mixes;
}

StageTimingOptions timing_options(const Selection& selection) {
  if (!selection.quick) return {};
  return {.rounds = 5, .milliseconds_per_run = 0.5, .check = {.triangles = 8192, .exact = 24}};
}

// The baseline, and those whose clipper is among the selected.
StageContestants selected_for_stage(const StageInput& input, const Selection& selection) {
  StageContestants contestants = stage_contestants(input);
  const std::vector<AnyContestant> selected = select_contestants(selection.clipper, {"float"});
  const auto is_left_out = [&](const std::unique_ptr<StageContestant>& c) {
    return std::none_of(selected.begin(), selected.end(),
                        [&](const AnyContestant& any) { return clipper_name(any) == c->method(); });
  };
  contestants.erase(std::remove_if(contestants.begin() + 1, contestants.end(), is_left_out),
                    contestants.end());
  return contestants;
}

void record_stage(const std::string& mix, const StageMeasurement& measured, CellRecord& record) {
  constexpr const char* kUnit = "ns per triangle";
  for (const StageTiming& t : measured.contestants) {
    if (!t.timing.refused.empty()) continue;
    record.samples.push_back(
        {fmt::format("stage {} {} {} {} {}", mix, t.method, t.scalar, t.build, t.contract), kUnit,
         t.timing.samples_ns});
  }
  for (const MemoryTiming& pass : measured.passes) {
    record.samples.push_back(
        {fmt::format("stage {} {}", mix, pass_name(pass.pass)), kUnit, pass.timing.samples_ns});
  }
}

void run_growth(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table growth = cost_growth_table();
  GrowthOptions options{.seed = selection.seed, .timing = timing_options(selection)};
  options.timing.rounds = std::min(options.timing.rounds, 15);
  options.timing.check = {.triangles = 8192, .exact = selection.quick ? 8u : 64u};
  if (selection.quick) {
    options.soup = kQuickTriangles;
    options.most = 100'000;
    options.attribute_soup = 10'000;
    options.crossing = 32;
  }
  for (const Growing growing : kGrowing) {
    context.cell(
        fmt::format("growth {}", growing_name(growing)), {&growth}, [&](CellRecord& record) {
          const auto points = measure_growth(growing, options);
          add_growth_rows(points, growth);
          for (const GrowthPoint& p : points) {
            if (!p.timing.refused.empty()) continue;
            record.samples.push_back({fmt::format("growth {} {} {} {} {}", growing_name(growing),
                                                  p.n, p.clipper, p.build, p.contract),
                                      "ns per triangle", p.timing.samples_ns});
          }
        });
  }
  growth.add_note(machine_description());
  context.emit(growth);
  for (const Growing growing : kGrowing) {
    const Plot plot = growth_plot(growth, growing);
    if (!plot.series.empty()) context.emit(plot);
  }
}

}  // namespace

std::string run_stage(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table stage = cost_stage_table(), shares = cost_stage_mixes_table(),
        refused = cost_stage_refused_table();
  const std::vector<StageMix> all = mixes(selection);
  Progress progress("cost of the stage", all.size());
  for (const StageMix& mix : all) {
    context.cell(fmt::format("stage {} {}", mix.name, contract_name(mix.contract)),
                 {&stage, &shares, &refused}, [&](CellRecord& record) {
                   const StageInput input = mix.make();
                   const StageContestants contestants = selected_for_stage(input, selection);
                   const StageMeasurement measured =
                       measure_stage(input, contestants, timing_options(selection));
                   add_mix_row(input, mix.contract, shares);
                   add_stage_rows(input.name, measured, stage);
                   add_stage_refused_rows(input.name, measured, refused);
                   record_stage(input.name, measured, record);
                 });
    progress.advance();
  }
  stage.add_note(fmt::format("SIMD: {}. {}", batch::target_name(), machine_description()));
  context.emit(shares);
  context.emit(stage);
  if (!refused.rows().empty()) context.emit(refused);
  for (const StageContract contract : kStageContracts) {
    const Plot plot = stage_plot(stage, contract);
    if (!plot.series.empty()) context.emit(plot);
  }
  run_growth(context);
  return stage_finding(stage);
}

}  // namespace clipscope::experiments
