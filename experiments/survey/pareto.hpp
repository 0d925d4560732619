// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Pareto frontier of contestants that each have a time and an error.
//
// a dominates b if a is not slower, not less accurate, and better in one of the two:
//
//   not slower          median time of a <= median time of b
//   not less accurate   error of a <= error of b
//   better              error of a < error of b, or the time intervals are apart: high of a < low
//                       of b
//
// A time is a measurement, so that a lower median alone makes nobody better: two contestants of the
// same error whose intervals meet are both on the frontier. Errors are taken as they are. The
// relation is transitive and nobody dominates himself, so that whoever is dominated is dominated by
// a member of the frontier.
//
// Source: Pareto dominance as in Kung, Luccio and Preparata, "On Finding the Maxima of a Set of
// Vectors", JACM 22(4), 1975; the interval for times is this project's.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/table/statistics.hpp"

namespace clipscope::experiments {

struct FrontierPoint {
  MedianInterval time;  // any unit, the same for all
  double error = 0;     // >= 0, any unit; may be infinite
};

enum class Standing {
  unranked,  // without a finite time, or with a NaN for an error: it takes no part
  frontier,
  dominated
};
// What a column "on the frontier" says.
constexpr std::array<std::string_view, 3> names_of(Standing) { return {"not timed", "yes", "no"}; }

struct FrontierRank {
  Standing standing = Standing::unranked;
  std::optional<std::size_t> dominated_by = {};  // the fastest member of the frontier that does
};

bool dominates(const FrontierPoint& a, const FrontierPoint& b);

// One rank per point, in their order.
std::vector<FrontierRank> pareto_frontier(std::span<const FrontierPoint> points);

// What one can buy: indices of the frontier's members from the fastest on, each with a smaller
// error than the one before. Of members of the same error the fastest stands for all.
std::vector<std::size_t> frontier_steps(std::span<const FrontierPoint> points,
                                        std::span<const FrontierRank> ranks);

}  // namespace clipscope::experiments
