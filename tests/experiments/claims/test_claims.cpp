// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <set>

#include "experiments/accuracy/rows.hpp"
#include "experiments/bounds/rows.hpp"
#include "experiments/claims/ranking.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/depth/rows.hpp"
#include "experiments/frontier/rows.hpp"
#include "experiments/guard_band/rows.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/perspective/rows.hpp"
#include "experiments/pictures/rows.hpp"
#include "experiments/plane_order/rows.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/w_sign/rows.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/claims/fabricated.hpp"

namespace clipscope::experiments::claims {
namespace {

// So many ns, and so many times faster than the baseline, to 0.1.
Timing timing(double ns, double speedup) {
  Timing timing;
  timing.ns = {ns, ns, ns};
  timing.speedup = {speedup, speedup - 0.1, speedup + 0.1};
  return timing;
}

std::vector<cost::Row> costs() {
  std::vector<cost::Row> rows;
  const auto add = [&](const char* clipper, double ns, double speedup) {
    rows.push_back({"soup", clipper, "float", timing(ns, speedup)});
  };
  add("view/sutherland_hodgman", 50, 2);
  add("view/exact_sign", 60, 1.6);
  add("homogeneous/sutherland_hodgman", 25, 4);
  add("homogeneous/pipeline", 26, 3.9);
  add("cvv/near_first", 33, 3);
  add("cvv/naive", 30, 3);
  add("cvv/perspective", 33, 3);
  add("barycentric/distance_matrix", 30, 3);
  add("view/batch", 10, 10);
  add("homogeneous/batch", 5, 20);
  add("barycentric/batch", 6, 17);
  add("whole/any_outside", 12, 8);
  return rows;
}

std::vector<frontier::Row> contests() {
  using R = frontier::Row;
  std::vector<R> rows;
  const auto add = [&](Contract contract, const char* clipper, const char* scalar, double ns,
                       double right) {
    rows.push_back(row_with<R>(&R::set, "soup", &R::contract, contract, &R::clipper, clipper,
                               &R::scalar, scalar, &R::timing, timing(ns, 1),
                               &R::correctly_rounded_percent, right, &R::wrong_percent, 0));
  };
  add(Contract::full, "homogeneous/sutherland_hodgman", "float", 25, 80);
  add(Contract::full, "homogeneous/sutherland_hodgman", "exact", 2500, 100);
  add(Contract::full, "homogeneous/from_outside", "float", 25, 80);
  add(Contract::full, "homogeneous/weighted_ends", "float", 25, 79);
  add(Contract::full, "homogeneous/nearer_end", "float", 26, 82);
  add(Contract::copy, "homogeneous/batch", "float", 5, 80);
  add(Contract::copy, "barycentric/correctly_rounded_batch", "float", 50, 100);
  return rows;
}

std::vector<segments::OperationsRow> segment_operations() {
  using R = segments::OperationsRow;
  R small = row_with<R>(&R::mix, "window_1_64", &R::clipper, "homogeneous/cohen_sutherland",
                        &R::rejected_percent, 90, &R::rejected_free_percent, 90,
                        &R::divisions_per_accepted, 0, &R::divisions_per_rejected, 0.1,
                        &R::divisions_per_shortened, 1.2, &R::moved_ends_per_shortened, 1);
  R several = row_with<R>(&R::mix, "cross_several", &R::clipper, "homogeneous/cohen_sutherland",
                          &R::rejected_percent, 0, &R::divisions_per_accepted, 0,
                          &R::divisions_per_shortened, 2.5, &R::moved_ends_per_shortened, 1.5);
  R liang_barsky = small;
  liang_barsky.clipper = "homogeneous/liang_barsky";
  liang_barsky.divisions_per_rejected = 0;
  std::vector<R> rows = {small, several, liang_barsky};
  for (const char* mix : {"window_1_64", "cross_several"}) {
    rows.push_back(
        row_with<R>(&R::mix, mix, &R::clipper, "homogeneous/pruning", &R::cut_divisions, 1));
    rows.push_back(
        row_with<R>(&R::mix, mix, &R::clipper, "homogeneous/cyrus_beck", &R::cut_divisions, 6));
  }
  return rows;
}

std::vector<CountRow> counts() {
  std::vector<CountRow> rows;
  const auto add = [&](const char* quantity, std::int64_t count, std::int64_t cases = 100) {
    rows.push_back({0, "", quantity, cases, count});
  };
  add("disagrees, depth [-1, 1]", 0);
  add("disagrees, depth [0, 1]", 0);
  add("disagrees, depth reversed", 0);
  add("fan triangles wound the other way, cut in clip space", 0);
  add("fan triangles wound the other way, divided first", 0);
  add("leaves 4 vertices", 100);
  add("leaves fewer: another vertex is on the plane", 0);
  add("leaves anything else", 0);
  add("attribute at t in clip space is wrong", 0);
  add("attribute at t after the divide is wrong", 0);
  add("corners off the plane, aspect 1", 0, 5);
  add("corners off the plane, aspect not 1", 0, 20);
  add("a convex polygon leaves one that is not", 0);
  add("a concave polygon leaves several", 30);
  add("t in clip space is not t in view space", 0);
  add("t after the divide is not t in view space", 99);
  add("denominator 0", 0);
  add("denominator overflows", 1);
  add("9 vertices", 5);
  add("more than 9 vertices", 0);
  add("view/sutherland_hodgman differs", 0);
  add("homogeneous/sutherland_hodgman differs", 0);
  add("cvv/near_first differs", 0);
  add("clip coordinates are (1, 1, -20/9, 0)", 1, 1);
  return rows;
}

void add_geometry(Fabricated& run) {
  using Accuracy = accuracy::Row;
  using Cut = perspective::CutRow;
  const auto drawn = [](const char* clipper) {
    Accuracy row = row_with<Accuracy>(&Accuracy::clipper, clipper, &Accuracy::scalar, "float");
    row.figures.px = Spread{0, 0};
    return row;
  };
  run.set<Accuracy>({drawn("view/sutherland_hodgman"), drawn("homogeneous/sutherland_hodgman")});
  run.set<Cut>(
      {row_with<Cut>(&Cut::clipper, "cvv/naive", &Cut::scalar, "exact", &Cut::max_error, 0.4),
       row_with<Cut>(&Cut::clipper, "cvv/perspective", &Cut::scalar, "exact")});
  run.set<pictures::Row>(
      {row_with<pictures::Row>(&pictures::Row::scene, "floor", &pictures::Row::clipper,
                               "whole/any_outside", &pictures::Row::holes_px, 900)});
  guard_band::PointTally points;
  points.drawn = 1000;
  run.set<guard_band::PointsRow>({{"floor", points}});
  run.set<guard_band::PictureRow>(
      {row_with<guard_band::PictureRow>(&guard_band::PictureRow::vertices, "float")});
  run.set<PictureRow>({row_with<PictureRow>(&PictureRow::scene, "floor", &PictureRow::speedup,
                                            MedianInterval{1.5, 1.5, 1.5})});
  run.set(counts());
}

void add_rounding(Fabricated& run) {
  const auto failing = [](const char* clipper, int failures) {
    using R = hard_cases::SummaryRow;
    return row_with<R>(&R::primitive, Primitive::triangle, &R::clipper, clipper, &R::scalar,
                       "float", &R::failures, failures);
  };
  run.set<hard_cases::SummaryRow>({failing("homogeneous/sutherland_hodgman", 20),
                                   failing("homogeneous/w_first_1_16384", 20),
                                   failing("homogeneous/w_first_1e-5", 19)});
  using Prevented = w_sign::PreventedRow;
  const auto dividing = [](const char* clipper, std::int64_t zero_w) {
    Prevented row = row_with<Prevented>(&Prevented::clipper, clipper);
    row.hazards.zero_w = zero_w;
    return row;
  };
  run.set<Prevented>(
      {dividing("homogeneous/sutherland_hodgman", 7), dividing("homogeneous/w_first_1e-5", 0)});
  using Epsilon = w_sign::EpsilonRow;
  run.set<Epsilon>({row_with<Epsilon>(&Epsilon::clipper, "homogeneous/w_first_1e-5")});
  plane_order::OrdersRow orders =
      row_with<plane_order::OrdersRow>(&plane_order::OrdersRow::set, "all");
  orders.exact.triangles = 1000;
  orders.exact.mixed_w = 400;
  orders.exact.wrong = 3;
  orders.in_float.wrong_near_first = orders.in_float.wrong_near_last = 10;
  run.set<plane_order::OrdersRow>({orders});
}

void add_depth(Fabricated& run) {
  const auto precision = [](const char* convention, double misordered, double tied) {
    using R = depth::PrecisionRow;
    return row_with<R>(&R::convention, convention, &R::buffer, depth::Stored::float32,
                       &R::transform, depth::Arithmetic::in_float, &R::far_near_ratio, 1000,
                       &R::misordered_percent, misordered, &R::tied_percent, tied);
  };
  run.set<depth::PrecisionRow>(
      {precision("reversed", 0, 1), precision("zero_to_one", 2, 10), precision("gl", 2, 12)});
  using depth::Form;
  const auto form = [](Form f, const char* property, std::size_t violations) {
    using R = depth::FormRow;
    return row_with<R>(&R::form, f, &R::property, property, &R::arithmetic, "exact", &R::violations,
                       violations);
  };
  run.set<depth::FormRow>(
      {form(Form::linear, "monotone", 0), form(Form::linear, "lines stay straight", 0),
       form(Form::quadratic, "lines stay straight", 99), form(Form::quadratic, "nearer wins", 12)});
}

// A run in which every claim is confirmed, each table as small as its judges allow.
void add_literature(Fabricated& run) {
  using Plane = segments::PlaneRow;
  std::vector<Plane> plane;
  for (const auto& [clipper, divisions] : {std::pair{"window/cohen_sutherland", 2.5},
                                           {"window/liang_barsky", 3.0},
                                           {"window/nicholl_lee_nicholl", 2.0},
                                           {"window/skala", 2.0},
                                           {"window/midpoint_subdivision", 0.0}}) {
    plane.push_back(row_with<Plane>(&Plane::mix, "both_ends_out", &Plane::clipper, clipper,
                                    &Plane::divisions, divisions, &Plane::multiplications, 50.0,
                                    &Plane::comparisons, 150.0));
  }
  run.set(plane);
  using Convex = segments::ConvexRow;
  std::vector<Convex> convex;
  for (const std::int64_t edges : {4, 1024}) {
    convex.push_back(row_with<Convex>(&Convex::edges, edges, &Convex::method, "convex/skala",
                                      &Convex::divisions, 1.5));
    convex.push_back(row_with<Convex>(&Convex::edges, edges, &Convex::method,
                                      "convex/dual_subdivision", &Convex::timing, timing(20, 1)));
  }
  run.set(convex);
}

Fabricated all_confirmed() {
  Fabricated run;
  run.set(costs());
  run.set<cost::OperationsRow>({{"soup", "view/sutherland_hodgman", 20, 30, 4, 20},
                                {"soup", "homogeneous/sutherland_hodgman", 10, 10, 4, 20},
                                {"soup", "cvv/near_first", 12, 10, 8, 20},
                                {"soup", "cvv/naive", 12, 10, 12, 20}});
  run.set(contests());
  run.set<segments::TimeRow>({{"inside", "homogeneous/liang_barsky", "float", timing(10, 1)},
                              {"outside", "homogeneous/liang_barsky", "float", timing(10, 1)}});
  run.set(segment_operations());
  add_literature(run);
  run.set<segments::IntersectionRow>(
      {{"any plane: n . (x - p) >= 0", {0, 6, 1}},
       {"side of the frustum in view space: near x + left z >= 0", {0, 4, 1}},
       {"clip space, perspective: w + x >= 0", {0, 0, 1}},
       {"clip space, oblique parallel", {0, 0, 1}}});
  const auto bounded = [](const char* bound, double closer) {
    return row_with<bounds::Row>(&bounds::Row::bound, bound, &bounds::Row::closer_percent, closer);
  };
  run.set<bounds::Row>({bounded("box", 20), bounded("sphere", 30)});
  add_geometry(run);
  add_rounding(run);
  add_depth(run);
  return run;
}

using Alter = std::function<void(Fabricated&)>;

// What one changed row makes of a claim.
struct Alteration {
  int claim;
  Alter alter;
  Verdict verdict;
};

// Changes the first row that has the values.
template <class Row, class... Conditions>
Alter altered(void (*change)(Row&), Conditions... conditions) {
  return [=](Fabricated& run) { run.alter(change, conditions...); };
}

// Gives a clipper another time.
Alter timed(const char* clipper, double ns, double speedup) {
  return [=](Fabricated& run) {
    std::vector<cost::Row> rows = costs();
    for (cost::Row& row : rows) {
      if (row.clipper == clipper) row.timing = timing(ns, speedup);
    }
    run.set(rows);
  };
}

// Counts other cases for or against a claim.
Alter counted(const char* quantity, std::int64_t count) {
  return [=](Fabricated& run) {
    std::vector<CountRow> rows = counts();
    for (CountRow& row : rows) {
      if (row.quantity == quantity) row.count = count;
    }
    run.set(rows);
  };
}

constexpr auto kConditional = Verdict::conditional;
constexpr auto kRefuted = Verdict::refuted;
constexpr auto kConfirmed = Verdict::confirmed;

std::vector<Alteration> alterations_of_cost() {
  using Contest = frontier::Row;
  using Segments = segments::OperationsRow;
  using Cut = perspective::CutRow;
  return {
      {1, timed("view/sutherland_hodgman", 20, 5), kConditional},
      {1, timed("view/batch", 5, 20), kConditional},
      {2, timed("cvv/near_first", 25, 4), kConditional},
      {2, timed("homogeneous/batch", 10, 10), kConditional},
      {3, timed("cvv/near_first", 20, 5), kRefuted},
      {4,
       altered(
           +[](Cut& row) { row.max_error = 0; }, &Cut::clipper, "cvv/naive"),
       kRefuted},
      {4,
       altered(
           +[](Cut& row) { row.max_error = 0.1; }, &Cut::clipper, "cvv/perspective"),
       kRefuted},
      {7, altered(+[](pictures::Row& row) { row.holes_px = 0; }), kRefuted},
      {7, timed("whole/any_outside", 26, 3.9), kConditional},
      {13, altered(+[](Segments& row) { row.rejected_free_percent = 20; }), kConditional},
      {14,
       altered(
           +[](Segments& row) { row.divisions_per_rejected = 0.5; }, &Segments::clipper,
           "homogeneous/liang_barsky"),
       kConditional},
      {15, timed("homogeneous/pipeline", 50, 2), kRefuted},
      {17, altered(+[](bounds::Row& row) { row.closer_percent = 80; }), kConditional},
      {17, altered(+[](bounds::Row& row) { row.visible_lost = 1; }), kRefuted},
      {18,
       altered(
           +[](segments::IntersectionRow& row) { row.cut.multiplications = 2; },
           &segments::IntersectionRow::form, "clip space, oblique parallel"),
       kRefuted},
      {19,
       altered(
           +[](cost::OperationsRow& row) { row.divisions = 4; }, &cost::OperationsRow::clipper,
           "cvv/naive"),
       kRefuted},
      {29, altered(+[](PictureRow& row) { row.speedup->median = 1.1; }), kRefuted},
      {31, timed("view/exact_sign", 160, 0.6), kRefuted},
      {32,
       altered(
           +[](Contest& row) { row.timing->ns.median = 27; }, &Contest::scalar, "exact"),
       kConditional},
      {32,
       altered(
           +[](Contest& row) { row.timing->ns.median = 5.2; }, &Contest::clipper,
           "barycentric/correctly_rounded_batch"),
       kConditional},
      {32,
       altered(
           +[](Contest& row) { row.timing.reset(); }, &Contest::clipper,
           "barycentric/correctly_rounded_batch"),
       kConfirmed},
  };
}

std::vector<Alteration> alterations_of_geometry() {
  return {
      {5, counted("disagrees, depth [0, 1]", 8), kConditional},
      {5, counted("disagrees, depth [-1, 1]", 1), kRefuted},
      {6, counted("fan triangles wound the other way, divided first", 4), kConditional},
      {6, counted("fan triangles wound the other way, cut in clip space", 4), kRefuted},
      {8, counted("leaves fewer: another vertex is on the plane", 3), kConditional},
      {8, counted("leaves anything else", 3), kRefuted},
      {9, counted("attribute at t after the divide is wrong", 9), kConditional},
      {10, counted("corners off the plane, aspect not 1", 20), kConditional},
      {12, counted("homogeneous/sutherland_hodgman differs", 1), kRefuted},
      {16, counted("a concave polygon leaves several", 0), kRefuted},
      {22, altered(+[](guard_band::PictureRow& row) { row.extra_px = 2; }), kConditional},
      {22, altered(+[](guard_band::PointsRow& row) { row.tally.differ = 1; }), kRefuted},
      {24, counted("t in clip space is not t in view space", 1), kRefuted},
      {25, counted("denominator 0", 1), kRefuted},
      {26, counted("more than 9 vertices", 1), kRefuted},
      {26, counted("9 vertices", 0), Verdict::undecided},
      {27,
       altered(
           +[](accuracy::Row& row) { row.figures.px->max = 0.1; }, &accuracy::Row::clipper,
           "homogeneous/sutherland_hodgman"),
       kConditional},
      {28, counted("clip coordinates are (1, 1, -20/9, 0)", 0), kRefuted},
  };
}

std::vector<Alteration> alterations_of_rounding() {
  using Orders = plane_order::OrdersRow;
  return {
      {11, altered(+[](w_sign::EpsilonRow& row) { row.loss.lost_percent = 33; }), kConditional},
      {11, altered(+[](w_sign::PreventedRow& row) { row.hazards.zero_w = 0; }), kRefuted},
      {20, altered(+[](Orders& row) { row.exact.wrong = 0; }), kRefuted},
      {20, altered(+[](Orders& row) {
         row.exact.wrong = 0;
         row.in_float.wrong_near_last = 12;
       }),
       kConditional},
      {21, altered(+[](Orders& row) { row.in_float.differs = 8; }), kConditional},
      {21, altered(+[](Orders& row) { row.exact.differs = 3; }), kRefuted},
      {23,
       altered(
           +[](depth::FormRow& row) { row.violations = 1; }, &depth::FormRow::property,
           "lines stay straight"),
       kRefuted},
      {30, altered(+[](depth::PrecisionRow& row) { row.tied_percent = 20; }), kRefuted},
      {33,
       altered(
           +[](hard_cases::SummaryRow& row) { row.failures = 34; },
           &hard_cases::SummaryRow::clipper, "homogeneous/w_first_1e-5"),
       kRefuted},
  };
}

std::vector<Alteration> alterations_of_literature() {
  using Plane = segments::PlaneRow;
  using Convex = segments::ConvexRow;
  using Segments = segments::OperationsRow;
  const auto divides_more = +[](Plane& row) { row.divisions = 2.6; };
  return {{38, altered(divides_more, &Plane::clipper, "window/nicholl_lee_nicholl"), kRefuted},
          {51, altered(divides_more, &Plane::clipper, "window/midpoint_subdivision"), kRefuted},
          {52, altered(divides_more, &Plane::clipper, "window/skala"), kRefuted},
          {53,
           altered(
               +[](Convex& row) { row.divisions = 3; }, &Convex::method, "convex/skala"),
           kRefuted},
          {54,
           altered(
               +[](Convex& row) { row.timing->ns.median = 40; }, &Convex::edges, 1024,
               &Convex::method, "convex/dual_subdivision"),
           kRefuted},
          {55,
           altered(
               +[](Segments& row) { row.cut_divisions = 6; }, &Segments::clipper,
               "homogeneous/pruning"),
           kConditional},
          {61,
           altered(
               +[](frontier::Row& row) { row.correctly_rounded_percent = 79.5; },
               &frontier::Row::clipper, "homogeneous/nearer_end"),
           kRefuted}};
}

std::vector<Alteration> alterations() {
  std::vector<Alteration> all = alterations_of_cost();
  for (const Alteration& a : alterations_of_literature()) all.push_back(a);
  for (const Alteration& a : alterations_of_geometry()) all.push_back(a);
  for (const Alteration& a : alterations_of_rounding()) all.push_back(a);
  return all;
}

// Those that test_ranking.cpp gives figures to: no run confirms all of them, since they name
// several as the fastest.
std::set<int> rankings() {
  std::set<int> numbers;
  for (const Ranking& ranking : published_rankings()) numbers.insert(ranking.number);
  return numbers;
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
    CHECK(judge(claim, results).verdict == kConfirmed);
  }
}

TEST_CASE("claims: altered figures change the verdict") {
  const std::vector<Claim> claims = all_claims();
  for (const Alteration& a : alterations()) {
    Fabricated run = all_confirmed();
    a.alter(run);
    const Judgement judgement =
        judge(claims.at(static_cast<std::size_t>(a.claim) - 1), run.results());
    INFO("claim " << a.claim << ": " << judgement.because);
    CHECK(judgement.verdict == a.verdict);
  }
}

TEST_CASE("claims: every claim has a figure that changes its verdict") {
  std::set<int> altered = rankings();
  for (const Alteration& a : alterations()) altered.insert(a.claim);
  CHECK(altered.size() == all_claims().size());
}

TEST_CASE("claims: without its figures every claim is undecided and says what is missing") {
  for (const Claim& claim : all_claims()) {
    const Judgement judgement = judge(claim, Fabricated().results());
    INFO("claim " << claim.number);
    CHECK(judgement.verdict == Verdict::undecided);
    CHECK(judgement.because.find("table ") != std::string::npos);
  }
}

}  // namespace
}  // namespace clipscope::experiments::claims
