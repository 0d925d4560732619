// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/budget/budget.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "experiments/measure/batches.hpp"

namespace clipscope::experiments {
namespace {

void add(const PartErrors& errors, std::size_t view, std::size_t triangle, BudgetTally& tally) {
  const double total = errors[static_cast<std::size_t>(BudgetPart::total)].px;
  const auto& totals = tally.parts[static_cast<std::size_t>(BudgetPart::total)].px;
  if (tally.triangles == 0 || total > totals.max()) {
    tally.worst_view = view;
    tally.worst_triangle = triangle;
  }
  ++tally.triangles;
  for (std::size_t p = 0; p < errors.size(); ++p) {
    tally.parts[p].px.add(errors[p].px);
    tally.parts[p].ulp.add(errors[p].ulp);
  }
}

template <class T>
void add_contestant(const Contestant<T>& contestant, const StagedView<T>& staged, std::size_t view,
                    std::size_t stride, BudgetTally& tally) {
  PolygonStream<T, kSceneAttributes> answers;
  contestant.view(staged.projection(), staged.triangles(), answers);
  std::vector<std::optional<PartErrors>> errors(staged.triangles().size());
  tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t i) {
    if (staged.is_visible(i)) errors[i] = staged.errors(contestant, i, answers[i]);
  });
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!staged.is_visible(i)) continue;
    if (errors[i]) {
      add(*errors[i], view, i * stride, tally);
    } else {
      ++tally.left_out;
    }
  }
}

template <class T>
void add_scalar(const Scene& scene, std::size_t view, const Sample& sample,
                std::span<const AnyContestant> contestants, std::span<BudgetTally> tallies,
                Progress& progress) {
  const auto is_of_scalar = [](const AnyContestant& c) {
    return std::holds_alternative<const Contestant<T>*>(c);
  };
  if (std::none_of(contestants.begin(), contestants.end(), is_of_scalar)) return;
  const StagedView<T> staged(
      scene.views[view], sampled_view_triangles(scene, scene.views[view], sample, 0, sample.count));
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    if (!is_of_scalar(contestants[c])) continue;
    add_contestant(*std::get<const Contestant<T>*>(contestants[c]), staged, view, sample.stride,
                   tallies[c]);
    progress.advance(sample.count);
  }
}

}  // namespace

std::vector<AnyContestant> budget_contestants(std::string_view clipper_pattern,
                                              const std::vector<std::string>& scalars) {
  std::vector<std::string> rounding;
  for (const char* scalar : {"float", "double"}) {
    if (std::find(scalars.begin(), scalars.end(), scalar) != scalars.end()) {
      rounding.push_back(scalar);
    }
  }
  if (rounding.empty()) return {};
  std::vector<AnyContestant> contestants = select_contestants(clipper_pattern, rounding);
  std::erase_if(contestants, [](const AnyContestant& any) {
    return std::visit(
        [](const auto* c) { return stage_order(c->name, c->promise) == StageOrder::none; }, any);
  });
  return contestants;
}

std::vector<BudgetTally> measure_budget(const Scene& scene,
                                        std::span<const AnyContestant> contestants,
                                        std::size_t triangles_per_view, Progress& progress) {
  std::vector<BudgetTally> tallies(contestants.size());
  const Sample sample = sample_of(scene, triangles_per_view);
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    add_scalar<float>(scene, view, sample, contestants, tallies, progress);
    add_scalar<double>(scene, view, sample, contestants, tallies, progress);
  }
  return tallies;
}

}  // namespace clipscope::experiments
