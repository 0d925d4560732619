// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/hunt.hpp"

#include <tbb/global_control.h>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/hunt/evaluation.hpp"
#include "experiments/hunt/trophy.hpp"
#include "experiments/judge/questions.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/shrink/case_groups.hpp"
#include "experiments/survey/verdicts.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::hunt;

namespace {

const Contestant& textbook_chain() {
  return find_contestant("homogeneous/sutherland_hodgman", "float");
}

std::string text_of(const Hunted& hunted) {
  std::string text;
  if (hunted.worst) {
    for (const HardCase& c : hunted.worst->cases) text += case_text(c);
  }
  for (const auto& c : hunted.failing) text += c ? case_text(*c) : "none\n";
  return text;
}

Hunted in_threads(std::size_t threads, const HuntOptions& options) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return hunt::hunt(textbook_chain(), options);
}

}  // namespace

TEST_CASE("hunt: the same seed and count of evaluations find the same, whatever the threads") {
  const Measure measure = GENERATE(Measure::px, Measure::ulp, Measure::depth, Measure::attribute,
                                   Measure::containment, Measure::crack);
  const HuntOptions options{.measure = measure, .seed = 7, .evaluations = 20'000};
  const Hunted one = in_threads(1, options), two = in_threads(2, options);
  CAPTURE(name_of(measure));
  CHECK(one.evaluations == 20'000);
  CHECK(text_of(one) == text_of(two));
  HuntOptions other = options;
  other.seed = 8;
  CHECK(text_of(in_threads(2, other)) != text_of(one));
}

TEST_CASE("hunt: the worst is as bad as is said, by the exact reference") {
  const Hunted hunted =
      hunt::hunt(textbook_chain(), {.measure = Measure::px, .evaluations = 30'000});
  REQUIRE(hunted.worst);
  const HardCase& c = hunted.worst->cases.front();
  const Comparison comparison = judge_case(textbook_chain(), c, truth_polygon(c));
  CHECK(comparison.outcome <= Outcome::visible);
  CHECK(comparison.position_px == hunted.worst->value);
}

TEST_CASE("hunt: it begins with the hard cases unless told not to") {
  const Contestant& contestant = find_contestant("seeded/w_plane_epsilon", "float");
  const auto found_early = [&](bool catalogue) {
    return hunt::hunt(contestant,
                      {.measure = Measure::px, .evaluations = 256, .catalogue = catalogue});
  };
  CHECK(text_of(found_early(true)) != text_of(found_early(false)));
}

TEST_CASE("hunt: who never fails by a measure has no worst") {
  const Contestant& contestant = find_contestant("barycentric/correctly_rounded", "float");
  for (const Measure measure : {Measure::containment, Measure::crash}) {
    const Hunted hunted = hunt::hunt(contestant, {.measure = measure, .evaluations = 20'000});
    CHECK_FALSE(hunted.worst);
    for (const auto& failing : hunted.failing) CHECK_FALSE(failing);
  }
  const Hunted px = hunt::hunt(contestant, {.measure = Measure::px, .evaluations = 20'000});
  REQUIRE(px.worst);
  CHECK(px.worst->value < 1e-3);
}

TEST_CASE("hunt: in the domain of the bounds errors are small, and what is shrunk stays there") {
  const Contestant& contestant = textbook_chain();
  const HuntOptions options{.measure = Measure::px, .evaluations = 30'000, .in_domain = true};
  const Hunted inside = hunt::hunt(contestant, options);
  REQUIRE(inside.worst);
  const Trophy small = shrunk(contestant, Measure::px, *inside.worst, true);
  for (const HardCase& c : {inside.worst->cases[0], small.cases[0]}) {
    const auto groups = grouped(std::span(&c, 1));
    CHECK(examine(contestant, groups[0].batch, {Question::covers})[0].in_domain);
  }
  CHECK(small.value >= inside.worst->value / 2);
  CHECK(inside.worst->value < kScreenWidth);
}
