// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/proof.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace clipscope::experiments {
namespace {

using reference::Verdict;

// Cutting is needed only to learn whether anything is left of what the vertices do not settle.
Verdict verdict_on(const reference::Truth& truth, const SceneTriangle& triangle) {
  const reference::InputTriangle input = reference::input_triangle(triangle);
  const Verdict by_vertices = reference::classify(truth, input);
  if (by_vertices != Verdict::clipped) return by_vertices;
  return reference::clip(truth, input).verdict;
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

}  // namespace clipscope::experiments
