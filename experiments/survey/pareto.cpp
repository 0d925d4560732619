// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace clipscope::experiments {
namespace {

bool takes_part(const FrontierPoint& point) {
  return std::isfinite(point.time.median) && std::isfinite(point.time.low) &&
         std::isfinite(point.time.high) && !std::isnan(point.error);
}

}  // namespace

bool dominates(const FrontierPoint& a, const FrontierPoint& b) {
  if (!takes_part(a) || !takes_part(b)) return false;
  const bool not_worse = a.time.median <= b.time.median && a.error <= b.error;
  return not_worse && (a.error < b.error || is_below(a.time, b.time));
}

std::vector<FrontierRank> pareto_frontier(std::span<const FrontierPoint> points) {
  std::vector<FrontierRank> ranks(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!takes_part(points[i])) continue;
    const bool dominated = std::any_of(points.begin(), points.end(), [&](const FrontierPoint& p) {
      return dominates(p, points[i]);
    });
    ranks[i].standing = dominated ? Standing::dominated : Standing::frontier;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ranks[i].standing != Standing::dominated) continue;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (ranks[j].standing != Standing::frontier || !dominates(points[j], points[i])) continue;
      const auto& best = ranks[i].dominated_by;
      if (!best || points[j].time.median < points[*best].time.median) ranks[i].dominated_by = j;
    }
  }
  return ranks;
}

std::vector<std::size_t> frontier_steps(std::span<const FrontierPoint> points,
                                        std::span<const FrontierRank> ranks) {
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ranks[i].standing == Standing::frontier) members.push_back(i);
  }
  std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(points[a].time.median, points[a].error) <
           std::tie(points[b].time.median, points[b].error);
  });
  std::vector<std::size_t> steps;
  for (const std::size_t i : members) {
    if (steps.empty() || points[i].error < points[steps.back()].error) steps.push_back(i);
  }
  return steps;
}

}  // namespace clipscope::experiments
