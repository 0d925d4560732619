// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/trophy.hpp"

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/hunt/evaluation.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/shrink/simpler_cases.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::hunt;

namespace {

Prey prey_of_pair(const std::vector<HardCase>& pair) {
  Prey prey;
  for (std::size_t v = 0; v < Prey::kVertices; ++v) {
    const auto& position = (v < 3 ? pair[0].vertices[v] : pair[1].vertices[2]).position;
    for (std::size_t i = 0; i < 4; ++i) prey.position[v][i] = static_cast<float>(position[i]);
  }
  set_attributes(prey, 0);
  return prey;
}

}  // namespace

TEST_CASE("trophy: what is shrunk keeps half of the worst, with fewer bits") {
  const Contestant& contestant = find_contestant("homogeneous/sutherland_hodgman", "float");
  for (const Measure measure : {Measure::px, Measure::ulp, Measure::depth, Measure::attribute,
                                Measure::containment, Measure::crack}) {
    const Hunted hunted = hunt::hunt(contestant, {.measure = measure, .evaluations = 16'000});
    CAPTURE(name_of(measure));
    REQUIRE(hunted.worst);
    const Trophy small = shrunk(contestant, measure, *hunted.worst);
    CHECK(small.value >= hunted.worst->value / 2);
    REQUIRE(small.cases.size() == hunted.worst->cases.size());
    CHECK(cost_of(small.cases[0]) <= cost_of(hunted.worst->cases[0]));
    CHECK(significant_bits(small.cases[0]) <= significant_bits(hunted.worst->cases[0]));
  }
}

TEST_CASE("trophy: a pair that is shrunk still shares its edge and has its crack") {
  const Contestant& contestant = find_contestant("homogeneous/sutherland_hodgman", "float");
  const Hunted hunted = hunt::hunt(contestant, {.measure = Measure::crack, .evaluations = 16'000});
  REQUIRE(hunted.worst);
  const Trophy small = shrunk(contestant, Measure::crack, *hunted.worst);
  REQUIRE(small.cases.size() == 2);
  const HardCase &a = small.cases[0], &b = small.cases[1];
  CHECK(a.vertices[0].position == b.vertices[1].position);
  CHECK(a.vertices[1].position == b.vertices[0].position);
  const Setting setting{a.space, frustum_cast<float>(a.frustum), a.volume};
  const Prey prey = prey_of_pair(small.cases);
  const Evaluator evaluator(contestant, Measure::crack);
  CHECK(evaluator.exact_values(setting, std::span(&prey, 1)).front() ==
        Approx(small.value).epsilon(1e-9));
}

TEST_CASE("trophy: words and commands say what it is and how to see it") {
  const Contestant& contestant = find_contestant("cvv/near_first", "float");
  Trophy trophy{3, {find_case(builtin_catalogue(), "w_sign/w_3_to_minus_3")}};
  const std::string replay = replay_command(contestant, trophy.cases);
  CHECK(replay.starts_with("echo '-0x1p+1 0x0p+0 "));
  CHECK(replay.find("' | clipscope explain --space clip --depth gl --attributes 4 ") !=
        std::string::npos);
  CHECK(replay.ends_with(" --clipper cvv/near_first --scalar float"));
  trophy.cases.push_back(trophy.cases.front());
  CHECK(replay_command(contestant, trophy.cases).starts_with("printf '"));
  const Trophy named = described(contestant, Measure::crack, trophy, "a hunt");
  const std::string text = cases_text(named);
  CHECK(text.find("case cvv_near_first_float_crack\n") != std::string::npos);
  CHECK(text.find("case cvv_near_first_float_crack_neighbour\n") != std::string::npos);
  CHECK(read_cases("hunted.cases", text).size() == 2);
}
