// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shrink/shrink.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/shrink/simpler_cases.hpp"

namespace clipscope::experiments {
namespace {

class Shrinker {
 public:
  Shrinker(const Failing& failing, const ShrinkLimits& limits, Shrunk& shrunk)
      : failing_(failing), limits_(limits), shrunk_(shrunk) {
    shrunk_.excess = failing_(std::span(&shrunk_.hard_case, 1)).front();
    floor_ = std::min(shrunk_.excess, kComfortableExcess);
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
      if (!(excess[i] >= floor_)) continue;
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
      if (excess[i] >= floor_) keep_cheaper({together[i], excess[i]}, best);
    }
  }

  const Failing& failing_;
  const ShrinkLimits& limits_;
  Shrunk& shrunk_;
  double floor_ = 0;
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
