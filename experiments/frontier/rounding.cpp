// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/rows.hpp"

#include <initializer_list>

#include "spaces/barycentric/correctly_rounded.hpp"

namespace clipscope::experiments::frontier {
namespace {

using barycentric::CountStages;
using barycentric::Stage;

void add(const CountStages& more, CountStages& sum) {
  for (int i = 0; i < barycentric::kStages; ++i) {
    sum.counts[static_cast<std::size_t>(i)] += more.counts[static_cast<std::size_t>(i)];
  }
}

RoundingRow row_of(const std::string& set, const std::string& input, const CountStages& count) {
  const auto sum = [&](std::initializer_list<Stage> stages) {
    std::int64_t n = 0;
    for (const Stage stage : stages) n += count[stage];
    return n;
  };
  const std::int64_t signs = sum({Stage::sign_filtered, Stage::sign_exact});
  const std::int64_t quotients = sum({Stage::quotient_filtered, Stage::quotient_exact,
                                      Stage::quotient_midpoint, Stage::quotient_tie});
  const auto percent = [&](Stage stage, std::int64_t whole) -> std::optional<double> {
    if (whole == 0) return std::nullopt;
    return 100 * static_cast<double>(count[stage]) / static_cast<double>(whole);
  };
  return {set,
          input,
          signs,
          percent(Stage::sign_exact, signs),
          quotients,
          percent(Stage::quotient_exact, quotients),
          percent(Stage::quotient_midpoint, quotients),
          percent(Stage::quotient_tie, quotients)};
}

}  // namespace

void add_rows(const std::string& set, std::span<const SampledView> views,
              TableOf<RoundingRow>& table) {
  CountStages view, clip;
  for (const SampledView& v : views) {
    const Projection<float> projection(v.view.frustum);
    std::vector<ClipTriangle<float, kSceneAttributes>> in_clip_space;
    for (const SceneTriangle& t : v.triangles) in_clip_space.push_back(to_clip(projection, t));
    add(CorrectlyRounded::count_stages(projection, std::span(v.triangles)), view);
    add(CorrectlyRounded::count_stages(projection.volume, std::span(std::as_const(in_clip_space))),
        clip);
  }
  table.add(row_of(set, "view space", view));
  table.add(row_of(set, "clip space", clip));
}

}  // namespace clipscope::experiments::frontier
