// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage's part of cost: mixes x clippers x contracts, and how the time grows with the number of
// triangles, of attributes, of planes that a triangle crosses, and with threads.
//
//   triangles   lists of n of a game-like soup, each time others, until it was gone through; from
//               memory, and small ones from cache, too
//   attributes  game-like soups with so many floats beside the position
//   planes      every triangle is cut by exactly n planes
//   threads     a game-like soup in n parts, one per thread, from memory and from cache; wall time
//               of all threads, in the same rounds
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "experiments/cost/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/scenes/builtin.hpp"

namespace clipscope::experiments::cost {
namespace {

constexpr std::size_t kStageTriangles = 1'000'000, kQuickStageTriangles = 40'000;

// An input of the stage, made when its piece of work is.
struct StageMix {
  std::string name;
  Contract contract;  // copy stands for both contracts of a soup
  std::function<StageInput()> make;
};

// The view in which the share of straddling triangles comes nearest to what is usual in games.
StageInput usual_view(const Scene& scene) {
  constexpr double kUsualPercent = 1;
  StageInput best;
  double least = HUGE_VAL;
  for (const View& view : scene.views) {
    StageInput input = mesh_input(scene, view);
    const double percent = shares_of(input, Contract::indexed).straddling;
    const double off = std::abs(std::log(std::max(percent, 1e-3) / kUsualPercent));
    if (off >= least) continue;
    least = off;
    best = std::move(input);
  }
  best.name = scene.name;
  return best;
}

// Soups and a terrain as a mesh; each scene that was chosen comes as a soup and as a mesh.
std::vector<StageMix> stage_mixes(const Selection& selection) {
  const std::size_t triangles = selection.quick ? kQuickStageTriangles : kStageTriangles;
  const int levels = selection.quick ? 7 : 9;  // of the terrain
  std::vector<StageMix> mixes;
  for (const std::string& name : selection.scenes) {
    mixes.push_back({name, Contract::copy,
                     [=] { return scene_input(load_selected_scene(selection, name), triangles); }});
    mixes.push_back({name, Contract::indexed,
                     [=] { return usual_view(load_selected_scene(selection, name)); }});
  }
  if (!mixes.empty()) return mixes;
  const auto soup = [&](std::string name, const SoupShares& shares) {
    return StageMix{name, Contract::copy, [=, seed = selection.seed] {
                      return random_input(name, shares, triangles, kSceneAttributes, seed);
                    }};
  };
  return {soup(kGameLikeStage, {.inside = 58, .outside = 37, .straddling = 5}),
          soup("straddling", {.straddling = 1}),
          soup("several_planes", {.several_planes = 1}),
          soup("inside", {.inside = 1}),
          soup("outside", {.outside = 1}),
          {"terrain", Contract::indexed, [levels, seed = selection.seed] {
             Scene scene = terrain_of_levels(levels, seed);
             scene.name = "terrain";
             return usual_view(scene);
           }}};
}

// The baseline, and those whose clipper is among the selected.
Contestants selected_for_stage(const StageInput& input, const Selection& selection) {
  Contestants selected = select_contestants(selection.clipper, {"float"});
  std::ranges::copy(stage_only_contestants(selection.clipper), std::back_inserter(selected));
  Contestants contestants = stage_contestants(input);
  std::erase_if(contestants, [&, baseline = contestants.front()](const Contestant* c) {
    return c != baseline && !has_clipper(selected, c->clipper);
  });
  return contestants;
}

}  // namespace

StageClock stage_clock(bool quick) {
  if (!quick) return {.milliseconds_per_run = 7};
  return {.rounds = 5, .milliseconds_per_run = 0.5, .check = {.triangles = 8192, .exact = 24}};
}

std::string run_stage(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  StageTables tables;
  auto& [shares, stage, certainty, refused] = tables;
  const std::vector<StageMix> mixes = stage_mixes(selection);
  Progress progress("cost of the stage", mixes.size());
  for (const StageMix& mix : mixes) {
    const std::string cell = fmt::format("stage {} {}", mix.name, name_of(mix.contract));
    context.piece(cell, {&stage, &shares, &certainty, &refused}, [&](PieceRecord& record) {
      const StageInput input = mix.make();
      tables.mixes.add(mix_row(input, mix.contract));
      for (const StageMeasurement& measured : measure_stage(
               input, selected_for_stage(input, selection), stage_clock(selection.quick))) {
        tables.add(input.name, measured, record);
      }
    });
    progress.advance();
  }
  stage.add_note(timing_description());
  certainty.add_note(timing_description());
  context.emit(shares, certainty, stage);
  if (!refused.rows().empty()) context.emit(refused);
  for (const Contract contract : kStageContracts) {
    for (const InputFrom from : {InputFrom::memory, InputFrom::cache}) {
      const Plot plot = stage_plot(stage.rows(), contract, from);
      if (!plot.series.empty()) context.emit(plot);
    }
  }
  return certainty_finding(certainty.rows());
}

}  // namespace clipscope::experiments::cost
