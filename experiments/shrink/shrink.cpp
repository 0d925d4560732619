// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shrink/shrink.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/shrink/simpler_cases.hpp"

namespace clipscope::experiments {
namespace {

// The determinant of three of a vertex's homogeneous coordinates, all but `left_out`.
Exact minor_without(int left_out, const HardCase& c) {
  std::array<std::array<Exact, 3>, 3> m;
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t i = 0, k = 0; k < 4; ++k) {
      if (static_cast<int>(k) != left_out) m[v][i++] = Exact(c.vertices[v].position[k]);
    }
  }
  return Exact(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

// Whether it is a triangle whose vertices lie on a line of projective space.
bool is_degenerate(const HardCase& c) {
  if (c.primitive != Primitive::triangle || c.vertices.size() != 3) return false;
  for (int left_out = 0; left_out < 4; ++left_out) {
    if (minor_without(left_out, c) != Exact(0)) return false;
  }
  return true;
}

class Shrinker {
 public:
  Shrinker(const Failing& failing, const ShrinkLimits& limits, Shrunk& shrunk)
      : failing_(failing),
        limits_(limits),
        shrunk_(shrunk),
        may_degenerate_(is_degenerate(shrunk.hard_case)) {
    shrunk_.excess = failing_(std::span(&shrunk_.hard_case, 1)).front();
    floor_ = std::min(shrunk_.excess, kComfortableExcess);
    has_threshold_ = std::isfinite(shrunk_.excess);
  }

  // Whether the case became smaller.
  bool make_round() {
    ++shrunk_.rounds;
    const std::vector<CoordinateChange> changes = simpler_coordinates(shrunk_.hard_case);
    std::vector<HardCase> cases;
    for (const CoordinateChange& change : changes) cases.push_back(change.of(shrunk_.hard_case));
    for (HardCase& whole : simpler_wholes(shrunk_.hard_case)) cases.push_back(std::move(whole));
    const std::vector<std::size_t> order = cheapest_of(cases);
    const std::vector<double> excess = ask(cases, order);
    std::optional<Found> best;
    std::vector<CoordinateChange> good;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (!fails_likewise(cases[order[i]], excess[i])) continue;
      keep_cheaper({cases[order[i]], excess[i]}, best);
      if (order[i] < changes.size()) good.push_back(changes[order[i]]);
    }
    if (!best) return false;
    take_together(good, best);
    shrunk_.hard_case = std::move(best->hard_case);
    shrunk_.excess = best->excess;
    return true;
  }

  bool is_allowed() const {
    return shrunk_.rounds < limits_.rounds && shrunk_.asked < limits_.asked;
  }

 private:
  struct Found {
    HardCase hard_case;
    double excess;
  };

  // A failure that has no threshold, such as a NaN, is another one than what is beyond a threshold,
  // and what becomes of a triangle without area is not what was asked.
  bool fails_likewise(const HardCase& c, double excess) const {
    return excess >= floor_ && std::isfinite(excess) == has_threshold_ &&
           (may_degenerate_ || !is_degenerate(c));
  }

  static void keep_cheaper(Found found, std::optional<Found>& best) {
    if (!best || cost_of(found.hard_case) < cost_of(best->hard_case)) best = std::move(found);
  }

  // The places of those to be asked, the cheapest first. Where not all can be, some of each price
  // are: the cheapest are the least likely to fail.
  std::vector<std::size_t> cheapest_of(const std::vector<HardCase>& cases) const {
    std::vector<std::pair<double, std::size_t>> priced;
    for (std::size_t i = 0; i < cases.size(); ++i) priced.emplace_back(cost_of(cases[i]), i);
    std::ranges::sort(priced);
    const std::size_t count =
        std::min({cases.size(), limits_.at_once, limits_.asked - shrunk_.asked});
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < count; ++i) {
      order.push_back(priced[i * cases.size() / count].second);
    }
    return order;
  }

  std::vector<double> ask(const std::vector<HardCase>& cases,
                          const std::vector<std::size_t>& order) {
    std::vector<HardCase> chosen;
    for (const std::size_t i : order) chosen.push_back(cases[i]);
    return ask(chosen);
  }
  std::vector<double> ask(const std::vector<HardCase>& cases) {
    shrunk_.asked += cases.size();
    return cases.empty() ? std::vector<double>() : failing_(cases);
  }

  // The cheapest change of each coordinate; then the best of the first of them together, the first
  // two, and so on.
  void take_together(const std::vector<CoordinateChange>& good, std::optional<Found>& best) {
    std::vector<CoordinateChange> steps;  // `good` has the cheapest first
    for (const CoordinateChange& change : good) {
      const bool is_known = std::ranges::any_of(steps, [&](const CoordinateChange& s) {
        return s.vertex == change.vertex && s.coordinate == change.coordinate;
      });
      if (!is_known) steps.push_back(change);
    }
    std::vector<HardCase> together;
    HardCase c = shrunk_.hard_case;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      c = steps[i].of(std::move(c));
      if (i > 0) together.push_back(c);
    }
    const std::vector<double> excess = ask(together);
    for (std::size_t i = 0; i < together.size(); ++i) {
      if (fails_likewise(together[i], excess[i])) keep_cheaper({together[i], excess[i]}, best);
    }
  }

  const Failing& failing_;
  const ShrinkLimits& limits_;
  Shrunk& shrunk_;
  double floor_ = 0;
  bool has_threshold_ = false, may_degenerate_;
};

}  // namespace

Shrunk shrink(const HardCase& hard_case, const Failing& failing, const ShrinkLimits& limits) {
  Shrunk shrunk{.hard_case = hard_case};
  shrunk.hard_case.by_hand.clear();
  Shrinker shrinker(failing, limits, shrunk);
  while (shrunk.excess > 0 && shrinker.is_allowed() && shrinker.make_round()) {
  }
  // A class may speak of more than one primitive.
  const bool is_one = shrunk.hard_case.vertices.size() == vertices_of(shrunk.hard_case.primitive);
  if (is_one) shrunk.hard_case.expected = exact_outcome(shrunk.hard_case);
  return shrunk;
}

HardCase shrink(const Contestant& contestant, const HardCase& hard_case, Question question) {
  const bool is_costly = contestant.is_guest && question == Question::total;
  return shrink(hard_case, failing_at(contestant, question),
                is_costly ? kCostlyFailures : ShrinkLimits{})
      .hard_case;
}

}  // namespace clipscope::experiments
