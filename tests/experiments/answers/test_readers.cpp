// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who needs what gets the fastest clipper that has it, and is told what goes wrong otherwise.
#include <algorithm>

#include "tests/catch.hpp"
#include "tests/experiments/answers/sample_run.hpp"

namespace clipscope::experiments::answers {
namespace {

ReaderRow row_for(const Fabricated& run, const std::string& words) {
  const Results results = run.results();
  const std::vector<ReaderRow> rows =
      readers(results, [](const std::string& file) { return file.starts_with("w_sign/"); });
  const auto found = std::ranges::find_if(
      rows, [&](const ReaderRow& r) { return r.reader.find(words) != std::string::npos; });
  REQUIRE(found != rows.end());
  return *found;
}

}  // namespace

TEST_CASE("readers: the fastest that has what is needed is recommended") {
  const Fabricated run = sample_run();
  CHECK(row_for(run, "graphics card").clipper == kBatch);
  CHECK(row_for(run, "graphics card").over_fastest_percent == 0);
  CHECK(row_for(run, "software rasteriser").clipper == kRoundedBatch);
  CHECK(row_for(run, "software rasteriser").over_fastest_percent == Approx(25));
  CHECK(row_for(run, "CAD").clipper == kRoundedBatch);
  CHECK(row_for(run, "compositor").clipper == kRoundedBatch);
  CHECK(row_for(run, "offline").clipper == kRoundedBatch);
}

TEST_CASE("readers: another run, another recommendation") {
  Fabricated run = sample_run();
  run.alter<frontier::Row>([](frontier::Row& r) { r.max_px = 1.0; }, &frontier::Row::contract,
                           Contract::copy, &frontier::Row::clipper, kBatch);
  CHECK(row_for(run, "graphics card").clipper == kRoundedBatch);
  std::vector<frontier::Row> rows = frontier_rows();
  std::erase_if(rows, [](const frontier::Row& r) { return r.clipper == kRoundedBatch; });
  run.set(rows);
  CHECK(row_for(run, "software rasteriser").recommended == "none of those that were timed");
  CHECK(row_for(run, "CAD").clipper == kClip);
  CHECK(row_for(run, "CAD").scalar == "exact");
}

TEST_CASE("readers: what another does wrong is told from the run") {
  Fabricated run = sample_run();
  CHECK(
      row_for(run, "graphics card").otherwise ==
      "Dropping triangles that reach out in float gets 70000 of a million game-like triangles wrong.");
  CHECK(row_for(run, "software rasteriser").otherwise ==
        "The clip-space batch clipper gets 8000 of a million hard triangles wrong.");
  CHECK(row_for(run, "compositor").otherwise ==
        "Dividing first in float fails on 6 of 10 hard cases of w sign.");
  CHECK(row_for(run, "offline").otherwise == "Textbook float was not timed on soup.");
}

TEST_CASE("readers: order, guard band and picture are those of the run") {
  Fabricated run = sample_run();
  const ReaderRow stage = row_for(run, "graphics card");
  CHECK(stage.order == "near plane first");
  CHECK(stage.guard == "no guard band");
  CHECK(stage.picture.empty());
  CHECK(row_for(run, "compositor").picture == "w_sign/w_sign.png");
  CHECK(row_for(run, "compositor").order == "no order");
  run.alter<plane_order::TimeRow>([](plane_order::TimeRow& r) {
    r.ratio = MedianInterval{0.9, 0.8, 0.95};
  });
  run.alter<guard_band::WorkRow>([](guard_band::WorkRow& r) { r.timing = timing(30, 1.3); });
  CHECK(row_for(run, "graphics card").order == "near plane last");
  CHECK(row_for(run, "graphics card").guard == "a guard band of 16.0 screens");
}

TEST_CASE("stability: failures by theme, nothing where a method takes no case") {
  const Fabricated run = sample_run();
  const Results results = run.results();
  const Table table = stability_table(Catalogue(results));
  const std::size_t scale = place_of(table, "scale"), far = place_of(table, "far"),
                    all = place_of(table, "all");
  const auto row_of = [&](const std::string& method) {
    const auto found = std::ranges::find_if(
        table.rows(), [&](const std::vector<Cell>& row) { return row[0] == Cell(method); });
    REQUIRE(found != table.rows().end());
    return *found;
  };
  CHECK(row_of("cases")[scale] == Cell(std::int64_t{10}));
  CHECK(row_of("clip space")[scale] == Cell(std::int64_t{4}));
  CHECK(row_of("clip space")[all] == Cell(std::int64_t{9}));
  CHECK(row_of("view space")[scale] == Cell(std::int64_t{0}));
  CHECK(row_of("view space")[far] == Cell());
  CHECK(row_of("the correctly rounded clipper")[all] == Cell(std::int64_t{0}));
}

}  // namespace clipscope::experiments::answers
