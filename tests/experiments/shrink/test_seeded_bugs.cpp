// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of each seeded bug (reference/mutants.hpp): a case with at most 12 significant bits.
#include <algorithm>
#include <limits>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/guests/seeded.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/shrink/shrink.hpp"
#include "experiments/shrink/simpler_cases.hpp"
#include "experiments/survey/verdicts.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

// The guests round each number once: what is farther off than that is the bug.
struct Class {
  Outcome outcome = Outcome::exact;  // where that is a failure; else numbers are off
  bool is_of_attributes = false;

  double operator()(const HardCase&, const PolygonView&, const Comparison& c) const {
    if (is_failure(outcome)) {
      return c.visible && c.outcome == outcome ? std::numeric_limits<double>::infinity() : 0;
    }
    if (c.outcome > Outcome::visible) return 0;
    return is_of_attributes ? c.attribute / 0x1p-20 : c.position_ulp;
  }
};

// The class of the failure; `exact` where there is none.
Class class_of(const Comparison& c) {
  if (!c.visible) return {};
  if (is_failure(c.outcome)) return {c.outcome};
  return {Outcome::exact, c.attribute > 0x1p-18};
}

bool fails(const Comparison& c) {
  return c.visible && (is_failure(c.outcome) || c.position_ulp > 4 || c.attribute > 0x1p-18);
}

// The longest of the first cases on which it fails: what has most to lose.
const HardCase& failing_case(const Contestant& contestant) {
  const HardCase* longest = nullptr;
  int found = 0;
  for (const HardCase& c : builtin_catalogue()) {
    if (c.primitive != Primitive::triangle) continue;
    if (!fails(judge_case(contestant, c, truth_polygon(c)))) continue;
    if (longest == nullptr || significant_bits(c) > significant_bits(*longest)) longest = &c;
    if (++found == 12) break;
  }
  REQUIRE(longest != nullptr);
  return *longest;
}

}  // namespace

TEST_CASE("shrink: of each seeded bug at most 12 significant bits are left, which fail likewise") {
  for (const std::string_view name : seeded_names()) {
    const Contestant& contestant = find_contestant(name, "float");
    const HardCase& given = failing_case(contestant);
    const Class failure = class_of(judge_case(contestant, given, truth_polygon(given)));
    const Shrunk shrunk = shrink(given, failing_by(contestant, failure));
    CAPTURE(name, given.name, significant_bits(given), shrunk.asked, shrunk.rounds);
    INFO(case_text(shrunk.hard_case));
    CHECK(significant_bits(shrunk.hard_case) <= 12);
    CHECK(shrunk.excess >= kComfortableExcess);
    // What a file of cases makes of it fails in the same class.
    const std::vector<HardCase> read = read_cases("shrunk.cases", case_text(shrunk.hard_case));
    const Failing failing = failing_by(contestant, failure);
    CHECK(failing(read).front() >= kComfortableExcess);
  }
}
