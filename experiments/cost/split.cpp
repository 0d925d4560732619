// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a clipper's time goes: transform, cut, divide.
//
// Three runs side by side, on the same triangles in the same rounds, each doing one step more:
//
//   view space   cut | cut and transform | all
//   clip space   transform | transform and cut | all
//   CVV          transform | transform and divide | all
//
// The transform alone is the three positions of every triangle to clip space (no attributes);
// transform and divide likewise. A run up to a cut is the clipper's own `cut`. A part's time is the
// difference of two runs of the same round. What a run leaves is checked before it is timed:
// finished by the steps that it leaves out, it has the bits of the clipper's answer.
// Does not guarantee: that the parts are what the whole would spend. A processor overlaps one step
// with the next, which a run of the first alone can't; a part may then come out too small, even
// negative. The near cut of cvv/near_first is counted to the cut, though it comes before the
// divide. Clippers whose cut and divide are one pass (barycentric) or that do not cut (whole) have
// no split, nor have homogeneous/pipeline and homogeneous/blinn_newell, of which the compiler makes
// slower code without the divide.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/cost/rows.hpp"
#include "experiments/cost/steps.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/contest_clock.hpp"

namespace clipscope::experiments::cost {
namespace {

constexpr std::size_t kChecked = 64;  // triangles of each view

constexpr std::array<std::string_view, 4> kClippers = {
    "textbook", "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first"};

// A clipper's parts in its own order, and the runs up to the first and up to the second.
struct Steps {
  std::array<std::string_view, 3> parts;
  std::array<Contestant, 2> runs;

  bool does(std::size_t run, std::string_view part) const {
    return parts[0] == part || (run == 1 && parts[1] == part);
  }
};

template <class T>
Steps steps_of(const Contestant& whole) {
  const Contestant transformed = transforming<T>(Space::clip);
  if (whole.clipper.starts_with("cvv/")) {
    return {{"transform", "divide", "cut"}, {transformed, transforming<T>(Space::ndc)}};
  }
  const Contestant& cut = *find_in_contract(whole.clipper, whole.scalar(), Contract::cut);
  if (whole.clipper.starts_with("view/")) {
    return {{"cut", "transform", "divide"}, {cut, cutting_and_transforming<T>()}};
  }
  return {{"transform", "cut", "divide"}, {transformed, cut}};
}

// Between what a run leaves, finished by the other steps, and the clipper's answer. Without a cut
// the two have only triangles inside in common.
template <class T>
std::string first_difference(const Steps& steps, std::size_t run, const Contestant& whole,
                             const SampledView& view) {
  const Projection<T> projection(frustum_cast<T>(view.view.frustum));
  const std::size_t count = std::min(kChecked, view.triangles.size());
  const Batch batch = batch_of(view.view, std::span(view.triangles).first(count));
  const Answers found = clip(steps.runs[run], batch), expected = clip(whole, batch);
  const auto is_same = [&](const VertexView& u, const VertexView& v) {
    Vec4<T> p(u[0].value, u[1].value, u[2].value, u[3].value);
    if (!steps.does(run, "transform")) p = to_clip(projection, Vec3<T>(p));
    if (!steps.does(run, "divide")) p = to_ndc(p);
    return p == Vec4<T>(v[0].value, v[1].value, v[2].value, v[3].value);
  };
  const auto is_outside = [&](const auto& vertex) {
    const Vec4<T> p = to_clip(projection, Vec3<T>(vertex.position));
    return clip_outcode(projection.volume.depth, p) != 0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const bool crosses = std::ranges::any_of(view.triangles[i], is_outside);
    if (crosses && !steps.does(run, "cut")) continue;
    if (std::ranges::equal(found[i], expected[i], is_same)) continue;
    return fmt::format("triangle {}: a step leaves other bits than the clipper", i);
  }
  return "";
}

// Each over all triangles.
template <class T>
std::vector<Timing> time_runs(const Steps& steps, const Contestant& whole,
                              std::span<const SampledView> views, int rounds) {
  const std::vector<Batch> batches = batches_of(views);
  std::vector<Task> tasks = {contest_task(steps.runs[0], batches, 0),
                             contest_task(steps.runs[1], batches, 0),
                             contest_task(whole, batches, kChecked)};
  for (const std::size_t run : {0u, 1u}) {
    tasks[run].check = [&, run] {
      std::string difference;
      for (const SampledView& view : views) {
        if (difference.empty()) difference = first_difference<T>(steps, run, whole, view);
      }
      return difference;
    };
  }
  for (Task& task : tasks) task.least_share = 1;
  return time_in_turn(tasks, {.rounds = rounds});
}

// What the later run takes more, round by round.
std::vector<double> difference(const Timing& later, const Timing& earlier) {
  std::vector<double> result = later.samples_ns;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= earlier.samples_ns[i];
  return result;
}

// The parts of one clipper, if no run is refused.
template <class T>
void add_split(const Row& whole, std::span<const SampledView> views, int rounds,
               TableOf<SplitRow>& table, PieceRecord& record) {
  const Contestant& contestant = find_contestant(whole.clipper, whole.scalar);
  const Steps steps = steps_of<T>(contestant);
  const std::vector<Timing> runs = time_runs<T>(steps, contestant, views, rounds);
  if (!std::ranges::all_of(runs, &Timing::is_timed)) return;
  const auto add = [&](std::string_view part, const std::vector<double>& ns) {
    std::vector<double> shares = ratios(ns, runs[2].samples_ns);
    for (double& share : shares) share *= 100;
    table.add({whole.mix, whole.clipper, whole.scalar, std::string(part), median_interval(ns),
               median_interval(shares)});
    Timing timing;
    timing.samples_ns = ns;
    record.add(fmt::format("{} {} {} {}", whole.mix, whole.clipper, whole.scalar, part), timing);
  };
  add(steps.parts[0], runs[0].samples_ns);
  add(steps.parts[1], difference(runs[1], runs[0]));
  add(steps.parts[2], difference(runs[2], runs[1]));
  add("whole", runs[2].samples_ns);
}

}  // namespace

void measure_split(std::span<const SampledView> views, const std::vector<Row>& times, int rounds,
                   TableOf<SplitRow>& table, PieceRecord& record) {
  for (const Row& row : times) {
    if (!row.timing || std::ranges::count(kClippers, row.clipper) == 0) continue;
    if (row.scalar == "float") add_split<float>(row, views, rounds, table, record);
    if (row.scalar == "double") add_split<double>(row, views, rounds, table, record);
  }
}

}  // namespace clipscope::experiments::cost
