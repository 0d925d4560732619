// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "experiments/claims/ranking.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/claims/confirmed_run.hpp"

namespace clipscope::experiments::claims {
namespace {

// Those that test_ranking.cpp gives figures to.
std::set<int> rankings() {
  std::set<int> numbers;
  for (const Ranking& ranking : published_rankings()) numbers.insert(ranking.number);
  return numbers;
}

Judgement judged_claim(int number, const Fabricated& run) {
  static const std::vector<Claim> claims = all_claims();
  return judge(claims.at(static_cast<std::size_t>(number) - 1), run.results());
}

// All judgements that the alterations make, and those of the run that confirms all.
std::vector<Judgement> all_judgements() {
  std::vector<Judgement> all;
  for (const Claim& claim : all_claims()) {
    if (!rankings().contains(claim.number)) {
      all.push_back(judged_claim(claim.number, all_confirmed()));
    }
  }
  for (const Alteration& a : alterations()) {
    Fabricated run = all_confirmed();
    a.alter(run);
    all.push_back(judged_claim(a.claim, run));
  }
  return all;
}

bool fails_somewhere(const Judgement& judgement) {
  return std::ranges::any_of(judgement.evidence,
                             [](const Evidence& e) { return !e.holds.value_or(true); });
}

TEST_CASE("claims: they are numbered in order, each with a statement and an experiment") {
  const std::vector<Claim> claims = all_claims();
  REQUIRE(claims.size() > 33);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    CHECK(claims[i].number == static_cast<int>(i) + 1);
    CHECK_FALSE(claims[i].statement.empty());
    CHECK_FALSE(claims[i].experiment.empty());
  }
}

TEST_CASE("claims: figures in favour confirm every claim") {
  const Results results = all_confirmed().results();
  for (const Claim& claim : all_claims()) {
    if (rankings().contains(claim.number)) continue;
    INFO("claim " << claim.number << ": " << judge(claim, results).because);
    CHECK(judge(claim, results).verdict == Verdict::confirmed);
  }
}

TEST_CASE("claims: altered figures turn the verdict, the sentence and the evidence") {
  for (const Alteration& a : alterations()) {
    Fabricated run = all_confirmed();
    a.alter(run);
    const Judgement before = judged_claim(a.claim, all_confirmed());
    const Judgement after = judged_claim(a.claim, run);
    INFO("claim " << a.claim << ": " << after.because);
    CHECK(after.verdict == a.verdict);
    CHECK_FALSE(fails_somewhere(before));
    if (after.verdict == Verdict::confirmed || after.verdict == Verdict::undecided) continue;
    CHECK(after.because != before.because);
    CHECK(fails_somewhere(after));
  }
}

TEST_CASE("claims: every claim has a figure that changes its verdict") {
  std::set<int> altered = rankings();
  for (const Alteration& a : alterations()) altered.insert(a.claim);
  CHECK(altered.size() == all_claims().size());
}

TEST_CASE("claims: a verdict is one sentence of two figures at most, with evidence") {
  const std::vector<Judgement> judgements = all_judgements();
  REQUIRE(judgements.size() > 80);
  for (const Judgement& judgement : judgements) {
    if (judgement.verdict == Verdict::undecided) continue;
    INFO(judgement.because);
    CHECK(faults_of_prose(judgement.because, {.figures = 2, .sentences = 1}) ==
          std::vector<std::string>());
    CHECK(std::ranges::any_of(judgement.evidence,
                              [](const Evidence& e) { return e.holds.has_value(); }));
    for (const Evidence& e : judgement.evidence) {
      CHECK_FALSE(e.of.empty());
      CHECK_FALSE(e.what.empty());
      CHECK(e.bound.has_value() == e.holds.has_value());
    }
  }
}

TEST_CASE("claims: without its figures every claim is undecided and says what is missing") {
  for (const Claim& claim : all_claims()) {
    const Judgement judgement = judge(claim, Fabricated().results());
    INFO("claim " << claim.number);
    CHECK(judgement.verdict == Verdict::undecided);
    CHECK(judgement.because.starts_with("Table "));
    CHECK(judgement.because.ends_with("."));
    CHECK(judgement.evidence.empty());
  }
}

TEST_CASE("claims: what rests on times of a busy machine is not settled, and the rest is") {
  const Fabricated run = all_confirmed();
  const auto tables = [&](const std::string& name) { return run.table(name); };
  const auto busy = [](const std::string&) { return Interruptions{.runs = 10, .redone = 2}; };
  const auto quiet = [](const std::string&) { return Interruptions{.runs = 100, .redone = 2}; };
  std::set<Verdict> verdicts;
  for (const Claim& claim : all_claims()) {
    const Judgement before = judge(claim, run.results()), after = judge(claim, tables, busy);
    CHECK(judge(claim, tables, quiet).verdict == before.verdict);
    CHECK(after.evidence.size() == before.evidence.size());
    verdicts.insert(after.verdict);
    constexpr int kCounts = 19;  // operations, and times nothing
    if (claim.number == kCounts) CHECK(after.verdict == before.verdict);
    if (claim.experiment == "cost" && claim.number != kCounts &&
        before.verdict == Verdict::confirmed) {
      INFO("claim " << claim.number);
      CHECK(after.verdict == Verdict::unsettled);
      CHECK(faults_of_prose(after.because).empty());
    }
    if (claim.experiment == "watertight") CHECK(after.verdict == before.verdict);
  }
  CHECK(verdicts.contains(Verdict::unsettled));
  CHECK(verdicts.contains(Verdict::confirmed));
}

// A claim that is true of half of what it was tried on.
Judgement half_true(const std::vector<std::string>& holding,
                    const std::vector<std::string>& failing) {
  Cases cases(spoken_lines);
  for (const std::string& of : holding) cases.add(decided(of, "speed", 3, "times", above(1)));
  for (const std::string& of : failing) cases.add(decided(of, "speed", 0.5, "times", above(1)));
  return cases.judge({"Always.", cases.where() + ".", "Never."});
}

TEST_CASE("claims: what holds in some cases is true only when the input is one of these") {
  CHECK(half_true({"inside"}, {}).because == "Always.");
  CHECK(half_true({}, {"inside"}).because == "Never.");
  CHECK(half_true({"inside"}, {"beside"}).because == "The input consists of lines inside.");
  CHECK(half_true({"inside"}, {"beside"}).verdict == Verdict::conditional);
}

TEST_CASE("claims: a bound takes all of an interval, but for limits and the benefit of the doubt") {
  const MedianInterval about_one = {1, 0.9, 1.1}, more = {2, 1.5, 2.5};
  CHECK_FALSE(above(1).admits(about_one));
  CHECK(above(1).admits(more));
  CHECK_FALSE(below(1).admits(about_one));
  CHECK_FALSE(at_least(1).admits(about_one));
  CHECK(at_most(2).admits(more));
  CHECK_FALSE(at_most(1.9).admits(more));
  CHECK(not_below(1).admits(about_one));
  CHECK_FALSE(not_below(3).admits(more));
  CHECK_FALSE(exactly(1).admits(about_one));
  CHECK(exactly(1).admits({1, 1, 1}));
  CHECK(at_most(1.5).text() == "at most 1.5");
  CHECK(exactly(0).text() == "0");
}

TEST_CASE("claims: evidence is read back as it was written, counts without a point") {
  TableOf<Evidence> table;
  table.add(decided("soup", "speed", MedianInterval{2, 1.5, 2.5}, "times", above(1)));
  table.add(told("soup", "triangles", 1234567, ""));
  CHECK(format_cell(table.Table::rows()[1][3]) == "1234567");
  const std::vector<Evidence> rows = table.rows();
  CHECK(rows[0].figure == 2.0);
  CHECK(rows[0].ends->high == 2.5);
  CHECK(rows[0].holds == true);
  CHECK(rows[1].figure == 1234567.0);
  CHECK_FALSE(rows[1].ends);
  CHECK_FALSE(rows[1].holds);
}

}  // namespace
}  // namespace clipscope::experiments::claims
