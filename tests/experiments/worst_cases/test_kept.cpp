// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/kept.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/worst_cases/chains.hpp"
#include "experiments/worst_cases/ties.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::worst_cases;

namespace {

constexpr std::string_view kOne = R"(# a comment
case first
source a search
why 0x1.8p+1 px, about 3
primitive triangle
space clip gl
vertex 0 0 0 1
vertex 1 0 0 1
vertex 0 1 0 1
expect accepted 3
)";

std::string with(std::string_view from, std::string_view to) {
  std::string text(kOne);
  return text.replace(text.find(from), from.size(), to);
}

std::map<std::string, ChainKind> kinds_by_name(std::string_view scalar) {
  std::map<std::string, ChainKind> kinds;
  for (const ChainKind& kind : chain_kinds(chain_contestants({}, scalar))) {
    kinds.emplace(name_of(kind), kind);
  }
  return kinds;
}

}  // namespace

TEST_CASE("kept: a file comes back as it was written") {
  KeptFile file("records.cases", kOne);
  REQUIRE(file.find("first") != nullptr);
  CHECK(file.find("first")->figure == 3);
  CHECK(file.find("second") == nullptr);
  HardCase better = file.find("first")->hard_case;
  better.vertices[1].position[0] = 0.5;
  file.put(0x1.8p+2, "px", better);
  better.name = "second";
  file.put(0.125, "ulp", better);
  const KeptFile again("records.cases", file.text());
  CHECK(again.text() == file.text());
  REQUIRE(again.records().size() == 2);
  CHECK(again.find("first")->figure == 6);
  CHECK(again.find("first")->hard_case.vertices[1].position[0] == 0.5);
  CHECK(again.find("second")->figure == 0.125);
}

TEST_CASE("kept: a case without a figure is refused, with its place") {
  const std::string reason = GENERATE("px, about 3", "3 px", "0x1.8p+1px", "nan");
  CHECK_THROWS_WITH(KeptFile("records.cases", with("0x1.8p+1 px, about 3", reason)),
                    Catch::Contains("records.cases:2") && Catch::Contains("hex float"));
}

TEST_CASE("kept: two cases of one name are refused") {
  CHECK_THROWS_WITH(KeptFile("records.cases", std::string(kOne) + "\n" + std::string(kOne)),
                    Catch::Contains("'first' again"));
}

TEST_CASE("kept: every record of a chain has its figure, to the bit") {
  for (const std::string scalar : {"float", "double"}) {
    const auto kinds = kinds_by_name(scalar);
    const KeptFile file = builtin_kept("chains_" + scalar + ".cases");
    CHECK_FALSE(file.records().empty());
    for (const auto& [figure, hard_case] : file.records()) {
      CAPTURE(scalar, hard_case.name);
      const auto kind = kinds.find(hard_case.name);
      REQUIRE(kind != kinds.end());
      CHECK(figure_of(kind->second, hard_case) == figure);
      CHECK(figure > 0);
    }
  }
}

TEST_CASE("kept: every chain has a record of its error on screen") {
  const KeptFile file = builtin_kept("chains_float.cases");
  for (const auto& [name, kind] : kinds_by_name("float")) {
    CAPTURE(name);
    if (kind.measure == hunt::Measure::px) CHECK(file.find(name) != nullptr);
  }
}

TEST_CASE("kept: every near tie has its distance, to the bit, and is rounded right") {
  const KeptFile file = builtin_kept("near_ties.cases");
  std::set<std::string> known;
  for (const TieKind& kind : all_tie_kinds()) {
    for (const TieRecord which : kTieRecords) {
      if (which == TieRecord::tie && !has_ties(kind.place)) continue;
      const std::string name = name_of(kind, which);
      CAPTURE(name);
      const Record* const record = file.find(name);
      REQUIRE(record != nullptr);
      known.insert(name);
      CHECK(figure_of(kind, which, record->hard_case) == record->figure);
      CHECK((record->figure == 0) == (which == TieRecord::tie));
      CHECK(is_rounded_right(record->hard_case));
    }
  }
  for (const auto& [figure, hard_case] : file.records()) {
    CAPTURE(hard_case.name);
    CHECK(known.contains(hard_case.name));
  }
}
