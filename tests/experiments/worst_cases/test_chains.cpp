// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/chains.hpp"

#include <algorithm>

#include "experiments/catalogue/catalogue.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::worst_cases;

namespace {

ChainKind textbook(Inputs inputs, hunt::Measure measure) {
  return {&find_contestant("textbook", "float"), inputs, measure};
}

}  // namespace

TEST_CASE("chains: they are all clippers but those that compute from the original vertices") {
  const Contestants chains = chain_contestants({}, "float");
  CHECK(has_clipper(chains, "textbook"));
  CHECK(has_clipper(chains, "view/sutherland_hodgman"));
  CHECK_FALSE(has_clipper(chains, "barycentric/distance_matrix"));
  CHECK_FALSE(has_clipper(chains, "barycentric/correctly_rounded"));
  CHECK_FALSE(has_clipper(chains, "whole/any_outside"));
}

TEST_CASE("chains: kinds have names of their own") {
  std::vector<std::string> names;
  for (const ChainKind& kind : chain_kinds(chain_contestants({}, "float"))) {
    names.push_back(name_of(kind));
  }
  std::ranges::sort(names);
  CHECK(std::ranges::adjacent_find(names) == names.end());
}

TEST_CASE("chains: a search keeps the record unless it finds worse") {
  const ChainKind kind = textbook(Inputs::in_domain, hunt::Measure::px);
  const ChainResult first = searched(kind, nullptr, {.seed = 1, .sample = 4000});
  CHECK(first.standing == Standing::added);
  REQUIRE(first.worst);
  CHECK(figure_of(kind, first.worst->hard_case) == first.worst->figure);
  const ChainResult poor = searched(kind, &*first.worst, {.seed = 2, .sample = 16});
  CHECK(poor.standing == Standing::kept);
  CHECK(poor.worst->figure == first.worst->figure);
  CHECK(case_text(poor.worst->hard_case) == case_text(first.worst->hard_case));
  const ChainResult longer = searched(kind, &*first.worst, {.seed = 3, .sample = 40'000});
  REQUIRE(longer.standing == Standing::improved);
  CHECK(longer.worst->figure > first.worst->figure);
}

TEST_CASE("chains: a record whose figure is another now has moved") {
  const ChainKind kind = textbook(Inputs::any, hunt::Measure::depth);
  Record record = *searched(kind, nullptr, {.seed = 1, .sample = 2000}).worst;
  record.figure *= 2;
  const ChainResult result = searched(kind, &record, {.seed = 1, .sample = 16});
  CHECK(result.standing == Standing::moved);
  CHECK(result.worst->figure == record.figure / 2);
}
