// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/rounding_stages.hpp"

#include <initializer_list>
#include <vector>

#include "spaces/barycentric/correctly_rounded.hpp"

namespace clipscope::experiments {
namespace {

using barycentric::CountStages;
using barycentric::Stage;
constexpr int K = kSceneAttributes;

void add(const CountStages& more, CountStages& sum) {
  for (int i = 0; i < barycentric::kStages; ++i) {
    sum.counts[static_cast<std::size_t>(i)] += more.counts[static_cast<std::size_t>(i)];
  }
}

CountStages in_view_space(const TimedBatch& batch) {
  return CorrectlyRounded::count_stages(Projection<float>(batch.view.frustum),
                                        std::span<const SceneTriangle>(batch.triangles));
}

CountStages in_clip_space(const TimedBatch& batch) {
  const Projection<float> projection(batch.view.frustum);
  std::vector<ClipTriangle<float, K>> triangles;
  for (const SceneTriangle& t : batch.triangles) triangles.push_back(to_clip(projection, t));
  return CorrectlyRounded::count_stages(projection.volume,
                                        std::span<const ClipTriangle<float, K>>(triangles));
}

void add_row(const std::string& set, const char* input, const CountStages& count, Table& table) {
  const auto sum = [&](std::initializer_list<Stage> stages) {
    std::int64_t n = 0;
    for (const Stage stage : stages) n += count[stage];
    return n;
  };
  const std::int64_t signs = sum({Stage::sign_filtered, Stage::sign_exact}),
                     quotients = sum({Stage::quotient_filtered, Stage::quotient_exact,
                                      Stage::quotient_midpoint, Stage::quotient_tie});
  const auto percent = [](std::int64_t part, std::int64_t whole) -> Cell {
    if (whole == 0) return std::monostate();
    return 100 * static_cast<double>(part) / static_cast<double>(whole);
  };
  table.add_row({set, std::string(input), signs, percent(count[Stage::sign_exact], signs),
                 quotients, percent(count[Stage::quotient_exact], quotients),
                 percent(count[Stage::quotient_midpoint], quotients),
                 percent(count[Stage::quotient_tie], quotients)});
}

}  // namespace

Table rounding_stages_table() {
  Table table("frontier_rounding", "What settles the correctly rounded clipper's decisions",
              {{"set", "set"},
               {"input", "input"},
               {"signs", "signs"},
               {"signs_exact_percent", "by expansions %"},
               {"quotients", "quotients"},
               {"exact_percent", "by expansions %"},
               {"midpoint_percent", "by a midpoint %"},
               {"tie_percent", "ties %"}});
  table.add_note(
      "The rest is settled by the filter in double. By a midpoint: the exact quotient was compared "
      "with the middle of two floats; a tie is that middle.");
  return table;
}

void add_rounding_stage_rows(const std::string& set, std::span<const TimedBatch> batches,
                             Table& table) {
  CountStages view, clip;
  for (const TimedBatch& batch : batches) {
    add(in_view_space(batch), view);
    add(in_clip_space(batch), clip);
  }
  add_row(set, "view space", view, table);
  add_row(set, "clip space", clip, table);
}

}  // namespace clipscope::experiments
