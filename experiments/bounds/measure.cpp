// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/measure.hpp"

#include <fmt/format.h>

#include <functional>
#include <memory>

#include "experiments/bounds/culling_time.hpp"
#include "experiments/bounds/world_planes.hpp"
#include "experiments/measure/timing.hpp"

namespace clipscope::experiments {
namespace {

// In the order of the objects.
std::vector<SceneTriangle> ordered_triangles(const Scene& scene, const View& view,
                                             const Objects& objects) {
  std::vector<SceneTriangle> in_order(objects.order.size()), triangles(objects.order.size());
  view_triangles(scene, view, 0, triangles);
  for (std::size_t i = 0; i < in_order.size(); ++i) in_order[i] = triangles[objects.order[i]];
  return in_order;
}

void add_to(std::vector<double>& sums, const std::vector<double>& samples, double share) {
  sums.resize(samples.size(), 0.0);
  for (std::size_t i = 0; i < samples.size(); ++i) sums[i] += samples[i] * share;
}

// The cullers and what they came to so far, side by side.
struct Contest {
  std::vector<std::unique_ptr<Culler>> cullers;
  std::vector<BoundResult> results;
};

Contest make_contest(const Mesh& mesh, const Objects& objects) {
  Contest contest;
  for (const BoundKind& kind : bound_kinds()) {
    std::unique_ptr<Culler> culler = kind.make(mesh, objects);
    if (!culler) continue;
    contest.cullers.push_back(std::move(culler));
    BoundResult& result = contest.results.emplace_back();
    result.bound = kind.name;
  }
  return contest;
}

// Adds the answers of a view and holds them against the exact verdicts and the clipper's polygons.
void judge(const View& view, const Objects& objects, const ExactView& exact, CulledView& culled,
           Contest& contest) {
  const CullingPlanes<double> planes = world_planes(view);
  std::vector<Visibility> answers(objects.ranges.size());
  for (std::size_t i = 0; i < contest.cullers.size(); ++i) {
    contest.cullers[i]->query(planes, answers);
    BoundResult& result = contest.results[i];
    add(objects, answers, exact, result.tally);
    if (result.difference.empty()) result.difference = culled.first_difference(answers);
    if (!result.difference.empty()) result.difference += " seen from " + view.label;
  }
}

void time_view(CulledView& culled, int rounds, double share, Contest& contest) {
  std::vector<std::function<double()>> tasks = {[&] { return culled.clip_all(); }};
  for (const auto& culler : contest.cullers) {
    tasks.push_back([&culled, &culler] { return culled.clip_culled(*culler); });
  }
  for (const auto& task : tasks) task();
  const std::vector<std::vector<double>> samples = run_in_turn(tasks, rounds);
  for (std::size_t i = 0; i < contest.results.size(); ++i) {
    add_to(contest.results[i].ns_without, samples[0], share);
    add_to(contest.results[i].ns_with, samples[i + 1], share);
  }
}

}  // namespace

std::vector<BoundResult> measure_bounds(const ObjectScene& scene, const Contestant<float>& clipper,
                                        const BoundsOptions& options) {
  const Objects objects = scene.objects();
  Contest contest = make_contest(scene.scene.mesh, objects);
  const double share = 1.0 / static_cast<double>(scene.scene.views.size());
  for (const View& view : scene.scene.views) {
    const auto triangles = ordered_triangles(scene.scene, view, objects);
    CulledView culled(clipper, view, objects, triangles);
    judge(view, objects, judge_view(objects, triangles, view.frustum, options.judged_triangles),
          culled, contest);
    time_view(culled, options.rounds, share, contest);
  }
  for (BoundResult& result : contest.results) {
    if (result.difference.empty()) {
      result.speedup = median_interval(ratios(result.ns_without, result.ns_with));
    } else {
      result.ns_without.clear();
      result.ns_with.clear();
    }
  }
  return std::move(contest.results);
}

}  // namespace clipscope::experiments
