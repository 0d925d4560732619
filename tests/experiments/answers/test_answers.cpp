// SPDX-License-Identifier: GPL-3.0-or-later
//
// The answers turn with the figures that they are decided from.
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/answers/sample_run.hpp"

namespace clipscope::experiments::answers {
namespace {

std::string answer_to(const Fabricated& run, const std::string& id) {
  const std::vector<Row> rows = answers(run.results());
  const Row* row = find_row(rows, &Row::id, id);
  REQUIRE(row != nullptr);
  return row->answer;
}

bool says(const std::string& text, const std::string& words) {
  INFO(text);
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("answers: every answer is prose and has its evidence") {
  for (const Row& row : answers(sample_run().results())) {
    INFO(row.answer);
    CHECK(faults_of_prose(row.answer).empty());
    CHECK(row.question.ends_with('?'));
    CHECK_FALSE(row.experiment.empty());
    CHECK_FALSE(row.table.empty());
    CHECK_FALSE(says(row.answer, "does not say"));
  }
}

TEST_CASE("answers: the fastest space is the answer, whichever it is") {
  Fabricated run = sample_run();
  CHECK(says(answer_to(run, "space"), "In homogeneous clip space:"));
  CHECK(says(answer_to(run, "space"), "1.5 times as long in the view volume after the divide"));
  run.alter<cost::Row>([](cost::Row& r) { r.timing = timing(30); }, &cost::Row::clipper, kView);
  CHECK(says(answer_to(run, "space"), "In view space:"));
  run.alter<cost::Row>([](cost::Row& r) { r.timing = timing(30); }, &cost::Row::clipper, kClip);
  CHECK(says(answer_to(run, "space"), "which take the same time"));
}

TEST_CASE("answers: the most accurate space is named, or that there is none") {
  Fabricated run = sample_run();
  CHECK(says(answer_to(run, "accuracy"), "the most accurate is view space"));
  run.alter<frontier::Row>([](frontier::Row& r) { r.max_px = 3.0; }, &frontier::Row::set, kGameLike,
                           &frontier::Row::clipper, kView);
  CHECK(says(answer_to(run, "accuracy"), "err alike"));
}

TEST_CASE("answers: the price is that of the fastest that makes no mistake") {
  Fabricated run = sample_run();
  CHECK(says(answer_to(run, "price"), "takes 25 % more time"));
  CHECK(says(answer_to(run, "price"), "makes no mistake"));
  CHECK(says(answer_to(run, "price"), "gets hard triangles wrong"));
  run.alter<frontier::Row>(
      [](frontier::Row& r) {
        r.timing->ns = {20, 16, 24};
      },
      &frontier::Row::set, kGameLike, &frontier::Row::contract, Contract::copy,
      &frontier::Row::clipper, kRoundedBatch);
  CHECK(says(answer_to(run, "price"), "Nothing that this run can measure"));
  run.alter<frontier::Row>([](frontier::Row& r) { r.wrong_percent = 0; }, &frontier::Row::set,
                           kHard, &frontier::Row::contract, Contract::copy, &frontier::Row::clipper,
                           kBatch);
  CHECK(says(answer_to(run, "price"), "misses nearest floats"));
  run.alter<frontier::Row>([](frontier::Row& r) { r.wrong_percent = 5.0; }, &frontier::Row::set,
                           kHard, &frontier::Row::contract, Contract::copy, &frontier::Row::clipper,
                           kRoundedBatch);
  CHECK(says(answer_to(run, "price"), "every clipper makes mistakes"));
}

TEST_CASE("answers: the price names the mix where correct rounding costs the most") {
  Fabricated run = sample_run();
  using R = cost::CertaintyRow;
  const auto price = [](const char* mix, double times) {
    return row_with<R>(&R::mix, mix, &R::contract, Contract::number, &R::from, InputFrom::cache,
                       &R::price, MedianInterval{times, times - 0.1, times + 0.1});
  };
  run.set(std::vector{price("game_like", 1.0), price("several_planes", 1.5)});
  const std::string answer = answer_to(run, "price");
  CHECK(faults_of_prose(answer).empty());
  CHECK(says(answer, "takes 25 % more time with"));
  CHECK(says(
      answer,
      "At its worst, on triangles across several planes by number, from cache, correct rounding takes 50 % more time."));
  run.set(std::vector{price("game_like", 1.02), price("several_planes", 1.08)});
  CHECK(says(answer_to(run, "price"), "is as fast as the fastest on every mix"));
}

TEST_CASE("answers: the price is that of the same rounds, where there were such") {
  Fabricated run = sample_run();
  using R = cost::CertaintyRow;
  const auto price = [](MedianInterval times) {
    return row_with<R>(&R::mix, cost::kGameLikeStage, &R::contract, Contract::copy, &R::from,
                       InputFrom::memory, &R::price, times);
  };
  run.set(std::vector{price({1.1, 1.04, 1.13})});
  CHECK(says(answer_to(run, "price"), "takes 10 % more time with"));
  run.set(std::vector{price({1.02, 0.98, 1.05})});
  CHECK(says(answer_to(run, "price"), "Nothing that this run can measure"));
}

TEST_CASE("answers: dividing first does harm only where it fails more often") {
  Fabricated run = sample_run();
  CHECK(says(answer_to(run, "w"), "dividing first fails on 60 % of the hard cases"));
  std::vector<hard_cases::VerdictRow> rows = verdicts();
  for (hard_cases::VerdictRow& r : rows) r.outcome = Outcome::exact;
  run.set(rows);
  CHECK(says(answer_to(run, "w"), "does no harm"));
  CHECK(says(answer_to(run, "stability"), "All triangle clippers"));
}

TEST_CASE("answers: who gets every hard case right is named, or that nobody does") {
  Fabricated run = sample_run();
  CHECK(says(answer_to(run, "stability"),
             "In float only the correctly rounded clipper of 3 triangle clippers"));
  run.alter<hard_cases::VerdictRow>([](hard_cases::VerdictRow& r) { r.outcome = Outcome::extra; },
                                    &hard_cases::VerdictRow::clipper, kRounded);
  CHECK(says(answer_to(run, "stability"), "In float none of 3"));
  CHECK(says(answer_to(run, "stability"), "the best fails on 1"));
}

TEST_CASE("answers: what leaving out effects saves, and whether it did harm") {
  Fabricated run = sample_run();
  CHECK(says(answer_to(run, "effects"), "takes 25 % less time"));
  CHECK(says(answer_to(run, "effects"), "changes nothing"));
  run.alter<effects::Row>([](effects::Row& r) { r.harm.changed = 3; });
  CHECK(says(answer_to(run, "effects"), "changes polygons"));
  const std::vector<EffectRow> rows = effect_rows(run.results());
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].left_out == 1);
  CHECK(rows[0].saved_percent == Approx(25));
}

TEST_CASE("answers: what a run lacks is said in place of an answer") {
  Fabricated run;
  for (const Row& row : answers(run.results())) {
    CHECK(says(row.answer, "This run does not say: table"));
  }
  run.set(frontier_rows());
  CHECK(says(answer_to(run, "price"), "takes 25 % more time"));
  CHECK(says(answer_to(run, "stability"), "This run does not say"));
}

}  // namespace clipscope::experiments::answers
