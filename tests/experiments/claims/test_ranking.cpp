// SPDX-License-Identifier: GPL-3.0-or-later
//
// Published rankings are judged by the times alone.
#include "experiments/claims/ranking.hpp"
#include "experiments/contestants/spoken.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/claims/fabricated.hpp"

namespace clipscope::experiments::claims {
namespace {

Timing timing(double speedup) {
  Timing t;
  t.ns = {100 / speedup, 100 / speedup, 100 / speedup};
  t.speedup = {speedup, speedup * 0.99, speedup * 1.01};
  return t;
}

// The winner so many times as fast as every other in one case, and in another.
using Leads = std::array<double, 2>;
const std::array<std::string, 2> kMixes = {"box_2", "inside"};
constexpr std::array<std::int64_t, 2> kEdges = {4, 64};

template <class MixRow>
MixRow timed_row(std::size_t mix, std::string_view clipper, double speedup) {
  return row_with<MixRow>(&MixRow::mix, kMixes[mix], &MixRow::clipper, clipper, &MixRow::scalar,
                          "float", &MixRow::timing, timing(speedup));
}
template <>
segments::ConvexRow timed_row(std::size_t mix, std::string_view clipper, double speedup) {
  using R = segments::ConvexRow;
  return row_with<R>(&R::edges, kEdges[mix], &R::method, clipper, &R::timing, timing(speedup));
}

template <>
cost::StageRow timed_row(std::size_t mix, std::string_view clipper, double speedup) {
  using R = cost::StageRow;
  return row_with<R>(&R::mix, kMixes[mix], &R::clipper, clipper, &R::scalar, "float", &R::build,
                     "simd", &R::contract, "copy", &R::timing, cost::StageFigures{timing(speedup)});
}

template <class MixRow>
Fabricated times_of(const Ranking& ranking, const Leads& leads) {
  std::vector<MixRow> rows;
  for (std::size_t mix = 0; mix < leads.size(); ++mix) {
    rows.push_back(timed_row<MixRow>(mix, ranking.method, 2 * leads[mix]));
    for (const std::string_view other : ranking.others) {
      rows.push_back(timed_row<MixRow>(mix, other, 2));
    }
  }
  Fabricated run;
  run.set(rows);
  return run;
}

Fabricated fabricated(const Ranking& ranking, const Leads& leads) {
  switch (ranking.field) {
    case Field::plane: return times_of<segments::PlaneRow>(ranking, leads);
    case Field::convex_windows: return times_of<segments::ConvexRow>(ranking, leads);
    case Field::stage: return times_of<cost::StageRow>(ranking, leads);
    case Field::segments: return times_of<segments::TimeRow>(ranking, leads);
    default: return times_of<cost::Row>(ranking, leads);
  }
}

Judgement judged(const Ranking& ranking, double first, double second) {
  return judge(ranking, fabricated(ranking, {first, second}).results());
}

}  // namespace

TEST_CASE(
    "rankings: a winner that wins by enough everywhere is confirmed, somewhere or nowhere not") {
  for (const Ranking& ranking : published_rankings()) {
    INFO("claim " << ranking.number);
    const double enough = ranking.times_as_fast * 1.1, little = ranking.times_as_fast * 0.9;
    CHECK(judged(ranking, enough, enough).verdict == Verdict::confirmed);
    const Judgement mixed = judged(ranking, enough, little);
    CHECK(mixed.verdict == Verdict::conditional);
    const std::string where = ranking.field == Field::convex_windows ? "4 edges" : "box_2";
    CHECK(mixed.evidence.at(0).of == where);
    CHECK(mixed.evidence.at(0).holds == true);
    CHECK(mixed.evidence.at(1).holds == false);
    CHECK(judged(ranking, little, little).verdict == Verdict::refuted);
  }
}

TEST_CASE("rankings: a lead within the intervals is none") {
  for (const Ranking& ranking : published_rankings()) {
    const double bare = ranking.times_as_fast * 1.005;
    CHECK(judged(ranking, bare, bare).verdict == Verdict::refuted);
  }
}

TEST_CASE("rankings: the sentence says where the method wins, and by how much") {
  const Ranking ranking = published_rankings().front();
  REQUIRE(ranking.field == Field::plane);
  CHECK(
      judged(ranking, 3, 3).because ==
      "Liang-Barsky wins everywhere: it is 3 times as fast as Cohen-Sutherland where it gains least.");
  CHECK(
      judged(ranking, 3, 0.5).because ==
      "The input consists of lines in a box of 2 windows; there Liang-Barsky is up to 3 times as fast as Cohen-Sutherland.");
  CHECK(
      judged(ranking, 1.25, 0.5).because ==
      "Liang-Barsky wins by less than published: at its best it is 25 % faster than Cohen-Sutherland.");
  CHECK(judged(ranking, 0.8, 0.5).because ==
        "Liang-Barsky wins nowhere: at its best it takes 25 % longer than Cohen-Sutherland.");
}

TEST_CASE("rankings: a condition that counts names where the method gains most") {
  const Ranking ranking = published_rankings().front();
  std::vector<segments::PlaneRow> rows;
  const auto add = [&](const char* mix, double speedup) {
    for (const auto& [clipper, its] :
         {std::pair{ranking.method, speedup}, {ranking.others[0], 1}}) {
      rows.push_back(row_with<segments::PlaneRow>(
          &segments::PlaneRow::mix, mix, &segments::PlaneRow::clipper, clipper,
          &segments::PlaneRow::scalar, "float", &segments::PlaneRow::timing, timing(its)));
    }
  };
  for (const char* mix : {"box_1", "box_4", "inside", "past_corner"}) add(mix, 2);
  for (const char* mix : {"box_2", "box_10", "beside", "one_end_out"}) add(mix, 0.5);
  add("both_ends_out", 3);
  Fabricated run;
  run.set(rows);
  CHECK(judge(ranking, run.results()).because ==
        "The input suits it, as 5 of 9 cases do; it gains most on lines with both ends out.");
}

TEST_CASE("rankings: a verdict is one sentence of two figures at most") {
  for (const Ranking& ranking : published_rankings()) {
    for (const double lead : {0.3, 0.8, 1.001, 1.2, 7.0}) {
      for (const double other : {0.3, 0.8, 1.001, 1.2, 7.0}) {
        const std::string because = judged(ranking, lead, other).because;
        INFO("claim " << ranking.number << ": " << because);
        CHECK(faults_of_prose(because, {.figures = 2, .sentences = 1}).empty());
      }
    }
  }
}

TEST_CASE("rankings: the rival that is beaten least clearly decides") {
  for (const Ranking& ranking : published_rankings()) {
    if (ranking.field != Field::plane || ranking.others.size() < 2) continue;
    const auto timed = [](std::string_view clipper, double speedup) {
      return timed_row<segments::PlaneRow>(0, clipper, speedup);
    };
    std::vector<segments::PlaneRow> rows = {timed(ranking.method, 4)};
    for (const std::string_view other : ranking.others) rows.push_back(timed(other, 1));
    rows.back().timing = timing(2);
    Fabricated run;
    run.set(rows);
    const Evidence evidence = judge(ranking, run.results()).evidence.at(0);
    CHECK(evidence.figure == Approx(2));
    CHECK(evidence.what == "speed over that of " + spoken_clipper(ranking.others.back()));
  }
}

TEST_CASE(
    "rankings: nobody competes with himself, and every claim of the literature has a number") {
  for (const Ranking& ranking : published_rankings()) {
    CHECK_FALSE(ranking.others.empty());
    for (const std::string_view other : ranking.others) CHECK(other != ranking.method);
    CHECK(ranking.times_as_fast >= 1);
  }
}

TEST_CASE("rankings: a time that is not there is named") {
  const Ranking ranking = published_rankings().front();
  Fabricated run;
  run.set<segments::PlaneRow>({timed_row<segments::PlaneRow>(0, ranking.method, 2)});
  CHECK_THROWS_WITH(judge(ranking, run.results()),
                    Catch::Contains("no table has a time of window/cohen_sutherland on box_2"));
}

// Published rankings and other claims, so many of each verdict.
std::vector<Row> verdicts(const std::array<int, 3>& of_rankings, const std::array<int, 3>& others) {
  std::vector<Row> claims;
  const std::vector<Ranking> rankings = published_rankings();
  int next = 0;
  for (std::size_t v = 0; v < 3; ++v) {
    const auto verdict = static_cast<Verdict>(v);
    for (int i = 0; i < of_rankings[v]; ++i) {
      claims.push_back({rankings.at(static_cast<std::size_t>(next++)).number, "", verdict, "", ""});
    }
    for (int i = 0; i < others[v]; ++i) claims.push_back({0, "", verdict, "", ""});
  }
  return claims;
}

TEST_CASE("claims: the finding says how much holds, and of which kind") {
  CHECK(
      finding_text(verdicts({1, 2, 3}, {3, 2, 1})) ==
      "Less than half of what is said about clipping holds as it stands: 4 of 12 claims are confirmed. Some of the others hold under a condition that the figures show. It depends on the kind of claim: published rankings of speed are refuted more often than the rest, and their winners most often win nowhere.");
  CHECK(
      finding_text(verdicts({4, 2, 1}, {3, 0, 2})) ==
      "Most of what is said about clipping holds as it stands: 7 of 12 claims are confirmed. Some of the others hold under a condition that the figures show. It depends on the kind of claim: published rankings of speed are refuted less often than the rest, and their winners most often win everywhere.");
  CHECK(finding_text({}) == "No claim could be judged, for want of figures.");
}

TEST_CASE("claims: the finding can be read at once, whatever the verdicts") {
  for (const std::array<int, 3>& a : {std::array{3, 2, 1}, {1, 3, 2}, {0, 0, 3}, {0, 0, 0}}) {
    for (const std::array<int, 3>& b : {std::array{3, 2, 1}, {0, 3, 2}, {0, 0, 3}, {0, 0, 0}}) {
      const std::string text = finding_text(verdicts(a, b));
      INFO(text);
      CHECK(faults_of_prose(text).empty());
    }
  }
}

}  // namespace clipscope::experiments::claims
