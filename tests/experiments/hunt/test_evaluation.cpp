// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/evaluation.hpp"

#include <algorithm>

#include "experiments/hunt/breeding.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/verdicts.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::hunt;

namespace {

std::vector<Prey> litter_of(const Setting& setting, std::size_t size) {
  Random random(2);
  std::vector<Prey> litter;
  for (std::size_t i = 0; i < size; ++i) litter.push_back(random_prey(setting, random));
  return litter;
}

bool is_descending(const std::vector<Prey>& prey) {
  return std::ranges::is_sorted(prey, std::ranges::greater(), &Prey::value);
}

}  // namespace

TEST_CASE("evaluation: the values of what is worst are exact, the largest first, above the floor") {
  const Contestant& contestant = find_contestant("homogeneous/sutherland_hodgman", "float");
  const Setting setting;
  for (const Measure measure : {Measure::px, Measure::ulp, Measure::depth, Measure::attribute,
                                Measure::containment, Measure::crack}) {
    CAPTURE(name_of(measure));
    const Evaluator evaluator(contestant, measure);
    const std::vector<Prey> litter = litter_of(setting, 2000);
    const Evaluated all = evaluator.evaluate(setting, litter, 0, {});
    REQUIRE_FALSE(all.worst.empty());
    CHECK(is_descending(all.worst));
    std::vector<double> values;
    for (const Prey& prey : all.worst) values.push_back(prey.value);
    CHECK(evaluator.exact_values(setting, all.worst) == values);
    const Evaluated above = evaluator.evaluate(setting, litter, all.worst.front().value, {});
    CHECK(above.worst.empty());
  }
}

TEST_CASE("evaluation: px is what the exact comparison says") {
  const Contestant& contestant = find_contestant("homogeneous/sutherland_hodgman", "float");
  const Setting setting;
  const Evaluated e =
      Evaluator(contestant, Measure::px).evaluate(setting, litter_of(setting, 500), 0, {});
  REQUIRE_FALSE(e.worst.empty());
  for (const Prey& prey : e.worst) {
    const HardCase c = case_of(setting, prey, Prey::kAttributes);
    CHECK(judge_case(contestant, c, truth_polygon(c)).position_px == prey.value);
  }
}

TEST_CASE("evaluation: an example of each failure is kept that is not known yet") {
  const Contestant& contestant = find_contestant("seeded/drops_whole", "float");
  const Setting setting;
  const Evaluator evaluator(contestant, Measure::px);
  const std::vector<Prey> litter = litter_of(setting, 500);
  const Evaluated e = evaluator.evaluate(setting, litter, 0, {});
  REQUIRE(e.failing.size() == 1);
  CHECK(e.failing[0].first == Outcome::missing);
  Outcomes known;
  known.set(static_cast<std::size_t>(Outcome::missing));
  CHECK(evaluator.evaluate(setting, litter, 0, known).failing.empty());
}

TEST_CASE("evaluation: vertices that rounding makes one are no failure") {
  const Contestant& contestant = find_contestant("barycentric/correctly_rounded", "float");
  const Setting setting;
  const Evaluator evaluator(contestant, Measure::px);
  Random random(9);
  std::vector<Prey> slivers;
  for (const Prey& prey : litter_of(setting, 200)) {
    for (int i = 0; i < 10; ++i) slivers.push_back(mutated(setting, prey, 0, random));
  }
  CHECK(evaluator.evaluate(setting, slivers, 0, {}).failing.empty());
}
