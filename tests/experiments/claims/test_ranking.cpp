// SPDX-License-Identifier: GPL-3.0-or-later
//
// Published rankings are judged by the times alone.
#include "experiments/claims/ranking.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"
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
                     "simd", &R::contract, "copy", &R::timing, timing(speedup));
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
    CHECK(mixed.because.find("The mix is " + where + ".") != std::string::npos);
    CHECK(judged(ranking, little, little).verdict == Verdict::refuted);
  }
}

TEST_CASE("rankings: a lead within the intervals is none") {
  for (const Ranking& ranking : published_rankings()) {
    const double bare = ranking.times_as_fast * 1.005;
    CHECK(judged(ranking, bare, bare).verdict == Verdict::refuted);
  }
}

TEST_CASE("rankings: in the plane the papers' boxes and mixes of one kind are told apart") {
  const Ranking ranking = published_rankings().front();
  REQUIRE(ranking.field == Field::plane);
  CHECK(judged(ranking, 3, 0.5).because.find("on 1 of 1 boxes") != std::string::npos);
  CHECK(judged(ranking, 3, 0.5).because.find("on 0 of 1 mixes of one kind") != std::string::npos);
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

TEST_CASE("rankings: winners are counted by what became of their claims") {
  std::vector<Row> claims;
  for (const Ranking& ranking : published_rankings()) {
    claims.push_back({ranking.number, "", Verdict::refuted, "", ""});
  }
  claims[0].verdict = Verdict::confirmed;
  claims[1].verdict = Verdict::conditional;
  const std::string text = winners_text(claims);
  CHECK(text.find(fmt::format("Of {} published rankings", claims.size())) != std::string::npos);
  CHECK(text.find("everywhere in 1, on some mixes in 1, nowhere in") != std::string::npos);
  CHECK(winners_text({}).empty());
}

}  // namespace clipscope::experiments::claims
