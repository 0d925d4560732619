// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts on the catalogue: what is known of single cases, what must hold for all of them.
#include <tbb/global_control.h>

#include <algorithm>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/survey/verdicts.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const HardCase& case_named(std::string_view name) {
  const auto& all = builtin_catalogue();
  const auto found = std::ranges::find(all, name, &HardCase::name);
  REQUIRE(found != all.end());
  return *found;
}

Outcome outcome(const std::string& name, const std::string& clipper,
                const std::string& scalar = "double") {
  const HardCase& hard_case = case_named(name);
  const auto contestants = case_contestants(hard_case.primitive, clipper, {scalar});
  REQUIRE(contestants.size() == 1);
  return judge_case(*contestants.front(), hard_case, truth_polygon(hard_case)).outcome;
}

CaseSet set_of(Primitive primitive, const std::vector<std::string>& scalars) {
  CaseSet set{primitive, {}, case_contestants(primitive, "*", scalars)};
  for (const HardCase& c : builtin_catalogue()) {
    if (c.primitive == primitive) set.cases.push_back(&c);
  }
  return set;
}

constexpr std::array kPrimitives = {Primitive::triangle, Primitive::segment, Primitive::point,
                                    Primitive::polygon};

}  // namespace

TEST_CASE("verdicts: what each kind of clipper does with w from 3 to -3") {
  const std::string name = "w_sign/w_3_to_minus_3";
  CHECK_FALSE(is_failure(outcome(name, "homogeneous/sutherland_hodgman")));
  CHECK_FALSE(is_failure(outcome(name, "barycentric/distance_matrix", "float")));
  CHECK(is_failure(outcome(name, "cvv/naive")));
  CHECK(outcome(name, "view/sutherland_hodgman") == Outcome::not_applicable);
  CHECK(outcome(name, "whole/any_outside") == Outcome::missing);
}

TEST_CASE("verdicts: a w-plane empties what is small, a plane at 0 does not") {
  CHECK(outcome("scale/sweep_1e-10", "homogeneous/w_first_1e-5") == Outcome::missing);
  CHECK_FALSE(is_failure(outcome("scale/sweep_1e-10", "homogeneous/w_first_0")));
}

TEST_CASE(
    "verdicts: in exact arithmetic every clipper for any triangle has the whole catalogue right") {
  const CaseSet set = set_of(Primitive::triangle, {"exact"});
  Progress progress("", 0);
  const auto verdicts = judge_cases(set, progress);
  for (std::size_t c = 0; c < set.contestants.size(); ++c) {
    const Promise& promise = set.contestants[c]->promise;
    if (promise.domain != Promise::Domain::any || !promise.covers) continue;
    for (std::size_t i = 0; i < set.cases.size(); ++i) {
      INFO(set.contestants[c]->clipper << " on " << set.cases[i]->name);
      const Outcome o = verdicts[i][c].comparison.outcome;
      CHECK((o == Outcome::exact || o == Outcome::not_applicable));
    }
  }
}

TEST_CASE("verdicts: nobody draws anything of NaN or infinity, whatever the primitive") {
  for (const Primitive primitive : kPrimitives) {
    const CaseSet set = set_of(primitive, {"float", "double"});
    Progress progress("", 0);
    const auto tallies = judge_special_values(set, progress);
    for (std::size_t c = 0; c < tallies.size(); ++c) {
      INFO(name_of(*set.contestants[c]) << ": " << tallies[c].offender);
      CHECK(tallies[c].inputs > 0);
      CHECK(tallies[c].drawn == 0);
    }
  }
}

TEST_CASE("verdicts: every promise is kept on the catalogue and its families") {
  const CaseSet set = set_of(Primitive::triangle, {"float", "double"});
  Progress progress("", 0);
  const auto tallies = judge_families(set, progress);
  for (std::size_t c = 0; c < tallies.size(); ++c) {
    INFO(name_of(*set.contestants[c]) << ": " << tallies[c].offender);
    CHECK(tallies[c].variants > 3000);
    CHECK(tallies[c].broken == 0);
  }
}

TEST_CASE("verdicts: the number of threads changes nothing") {
  CaseSet set = set_of(Primitive::triangle, {"float"});
  set.cases.resize(40);
  const auto tallies = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Progress progress("", 0);
    return judge_families(set, progress);
  };
  const auto one = tallies(1), three = tallies(3);
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i].failures == three[i].failures);
    CHECK(one[i].largest_ulps == three[i].largest_ulps);
    CHECK(one[i].worst == three[i].worst);
  }
}
