// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/measure.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "experiments/judge/cycle.hpp"
#include "experiments/survey/contest_clock.hpp"
#include "spaces/homogeneous/divide.hpp"

namespace clipscope::experiments::bounds {
namespace {

using reference::Verdict;

constexpr double kMillisecondsPerRun = 0.3;  // some 10000 triangles: small scenes go by again
constexpr std::size_t kChecked = 64;         // triangles of a view, against the promise

// Cutting is needed only to learn whether anything is left of what the vertices do not settle.
Verdict verdict_on(const reference::Truth& truth, const SceneTriangle& triangle) {
  const reference::InputTriangle input = reference::input_triangle(triangle);
  const Verdict by_vertices = reference::classify(truth, input);
  if (by_vertices != Verdict::clipped) return by_vertices;
  return reference::clip(truth, input).verdict;
}

// In the order of the objects.
std::vector<SceneTriangle> ordered_triangles(const Scene& scene, const View& view,
                                             const Objects& objects) {
  std::vector<SceneTriangle> in_order(objects.order.size()), triangles(objects.order.size());
  view_triangles(scene, view, 0, triangles);
  for (std::size_t i = 0; i < in_order.size(); ++i) in_order[i] = triangles[objects.order[i]];
  return in_order;
}

// Adds a view's time to the mean over `views` of them.
void add_view(const Timing& timing, const std::string& label, std::size_t views, Timing& mean) {
  if (!mean.is_timed()) return;
  if (!timing.is_timed()) {
    mean = {};
    mean.refused = timing.refused + " seen from " + label;
    return;
  }
  mean.samples_ns.resize(timing.samples_ns.size());
  for (std::size_t i = 0; i < mean.samples_ns.size(); ++i) {
    mean.samples_ns[i] += timing.samples_ns[i] / static_cast<double>(views);
  }
}

}  // namespace

Visibility ExactView::object(const TriangleRange& range) const {
  const auto first = verdict.begin() + range.first;
  const auto all = [&](Verdict wanted) {
    return std::all_of(first, first + range.count, [&](Verdict v) { return v == wanted; });
  };
  if (all(Verdict::rejected)) return Visibility::rejected;
  return all(Verdict::accepted) ? Visibility::accepted : Visibility::look_closer;
}

ExactView judge_view(const Objects& objects, std::span<const SceneTriangle> triangles,
                     const Frustum<float>& frustum, std::size_t limit) {
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(frustum));
  const std::size_t stride =
      limit == 0 ? 1 : std::max<std::size_t>(1, (triangles.size() + limit - 1) / limit);
  ExactView exact;
  exact.is_judged.assign(objects.ranges.size(), false);
  for (std::size_t i = 0; i < objects.ranges.size(); i += stride) exact.is_judged[i] = true;
  exact.verdict.assign(triangles.size(), Verdict::clipped);
  tbb::parallel_for(std::size_t{0}, objects.ranges.size(), [&](std::size_t object) {
    if (!exact.is_judged[object]) return;
    const auto [first, count] = objects.ranges[object];
    for (std::size_t i = first; i < std::size_t{first} + count; ++i) {
      exact.verdict[i] = verdict_on(truth, triangles[i]);
    }
  });
  return exact;
}

void add(const Objects& objects, std::span<const Visibility> answers, const ExactView& exact,
         CullTally& tally) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const TriangleRange& range = objects.ranges[i];
    const bool rejected = answers[i] == Visibility::rejected;
    const bool accepted = answers[i] == Visibility::accepted;
    ++tally.objects;
    tally.rejected += rejected;
    tally.accepted += accepted;
    tally.triangles += range.count;
    tally.triangles_rejected += rejected ? range.count : 0;
    tally.triangles_accepted += accepted ? range.count : 0;
    if (!exact.is_judged[i]) continue;
    ++tally.judged_objects;
    tally.judged += range.count;
    tally.settled += rejected || accepted;
    tally.settleable += exact.object(range) != Visibility::look_closer;
    const auto first = exact.verdict.begin() + range.first;
    for (auto v = first; v != first + range.count; ++v) {
      tally.visible_lost += rejected && *v != Verdict::rejected;
      tally.accepted_cut += accepted && *v != Verdict::accepted;
    }
  }
}

CulledView::CulledView(const Contestant& clipper, const View& view, const Objects& objects,
                       std::span<const SceneTriangle> triangles)
    : clipper_(clipper),
      view_(view),
      objects_(objects),
      triangles_(triangles),
      batch_(batch_of(view, triangles)),
      projection_(view.frustum),
      runner_(clipper.prepare(std::span(&batch_, 1))),
      answers_(objects.ranges.size()) {}

void CulledView::project(const TriangleRange& range) {
  NdcPolygon<float, kSceneAttributes> polygon;
  projected_.clear();
  for (const SceneTriangle& triangle : triangles_.subspan(range.first, range.count)) {
    const std::array<Vec4<float>, 3> positions = {to_clip(projection_, triangle[0].position),
                                                  to_clip(projection_, triangle[1].position),
                                                  to_clip(projection_, triangle[2].position)};
    divide_inside(projection_.volume, positions, triangle, polygon);
    projected_.append(polygon);
  }
}

Answers CulledView::drawn(const TriangleRange& range, Visibility answer) {
  if (answer == Visibility::look_closer) {
    clip(range);
    return runner_->answers();
  }
  projected_.clear();
  if (answer == Visibility::accepted) project(range);
  Answers drawn(kFormat<float>, 4 + kSceneAttributes);
  for (std::size_t i = 0; i < projected_.size(); ++i) add_polygon(projected_[i], drawn);
  while (drawn.size() < range.count) drawn.end_polygon();
  return drawn;
}

std::string CulledView::first_difference(std::span<const Visibility> answers) {
  const auto same_bits = [](const VertexView& u, const VertexView& v) {
    return same_vertex(u, v, Likeness::by_bits);
  };
  const Answers all = experiments::clip(clipper_, batch_);
  for (std::size_t object = 0; object < answers.size(); ++object) {
    const TriangleRange& range = objects_.ranges[object];
    const Answers found = drawn(range, answers[object]);
    for (std::uint32_t i = 0; i < range.count; ++i) {
      const PolygonView expected = all[range.first + i];
      if (std::ranges::equal(found[i], expected, same_bits)) continue;
      return fmt::format("triangle {} has {} vertices, with bounds {} or other bits",
                         objects_.order[range.first + i], expected.size(), found[i].size());
    }
  }
  return "";
}

Task CulledView::clip_all() {
  const auto clip_objects = [this](double times) {
    for (int i = 0; i < times; ++i) {
      for (const TriangleRange& range : objects_.ranges) clip(range);
    }
    return static_cast<std::size_t>(times) * triangles_.size();
  };
  return {.work = clip_objects,
          .check = contest_task(clipper_, std::span(&batch_, 1), kChecked).check,
          .most_share = kRepeated};
}

Task CulledView::clip_culled(const Culler& culler) {
  const auto clip_some = [this, &culler](double times) {
    for (int i = 0; i < times; ++i) {
      culler(view_, answers_);
      for (std::size_t object = 0; object < answers_.size(); ++object) {
        const TriangleRange& range = objects_.ranges[object];
        if (answers_[object] == Visibility::accepted) project(range);
        if (answers_[object] == Visibility::look_closer) clip(range);
      }
    }
    return static_cast<std::size_t>(times) * triangles_.size();
  };
  const auto check = [this, &culler] {
    culler(view_, answers_);
    return first_difference(answers_);
  };
  return {.work = clip_some, .check = check, .most_share = kRepeated};
}

std::vector<Result> measure(const ObjectScene& scene, const Contestant& clipper,
                            const Options& options) {
  const Objects& objects = scene.objects;
  const std::vector<View>& views = scene.scene.views;
  std::vector<Culler> cullers;
  std::vector<Result> results;
  for (const BoundKind& kind : bound_kinds()) {
    Culler culler = kind.make(scene.scene.mesh, objects);
    if (!culler) continue;
    cullers.push_back(std::move(culler));
    results.emplace_back().bound = kind.name;
  }
  std::vector<Visibility> answers(objects.ranges.size());
  for (const View& view : views) {
    const auto triangles = ordered_triangles(scene.scene, view, objects);
    const auto exact = judge_view(objects, triangles, view.frustum, options.judged_triangles);
    CulledView culled(clipper, view, objects, triangles);
    std::vector<Task> tasks = {culled.clip_all()};
    for (std::size_t i = 0; i < cullers.size(); ++i) {
      cullers[i](view, answers);
      add(objects, answers, exact, results[i].tally);
      tasks.push_back(culled.clip_culled(cullers[i]));
    }
    const std::vector<Timing> timings = time_in_turn(
        tasks, {.rounds = options.rounds, .milliseconds_per_run = kMillisecondsPerRun});
    for (std::size_t i = 0; i < results.size(); ++i) {
      add_view(timings[0], view.label, views.size(), results[i].without);
      add_view(timings[i + 1], view.label, views.size(), results[i].with);
    }
  }
  for (auto& [bound, tally, without, with] : results) {
    if (!without.is_timed()) with = without;
    if (!with.is_timed()) without = with;
    if (!with.is_timed()) continue;
    without.ns = median_interval(without.samples_ns);
    with.ns = median_interval(with.samples_ns);
    with.speedup = median_interval(ratios(without.samples_ns, with.samples_ns));
  }
  return results;
}

}  // namespace clipscope::experiments::bounds
