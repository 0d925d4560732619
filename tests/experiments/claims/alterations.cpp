// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/accuracy/rows.hpp"
#include "experiments/bounds/rows.hpp"
#include "experiments/depth/rows.hpp"
#include "experiments/guard_band/rows.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/perspective/rows.hpp"
#include "experiments/pictures/rows.hpp"
#include "experiments/plane_order/rows.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/w_sign/rows.hpp"
#include "tests/experiments/claims/confirmed_run.hpp"

namespace clipscope::experiments::claims {
namespace {

using Alter = std::function<void(Fabricated&)>;

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
      {29, altered(+[](PictureRow& row) {
         row.speedup = {1.1, 1.1, 1.1};
       }),
       kRefuted},
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
      {12, counted("clip space differs", 1), kRefuted},
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
      {20, altered(+[](Orders& row) {
         row.exact.wrong = 0;
         row.in_float.wrong_near_first = 10;
       }),
       kRefuted},
      {20, altered(+[](Orders& row) { row.in_float.wrong_near_first = 10; }), kConditional},
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
               +[](frontier::Row& row) { row.correctly_rounded_percent = 80.5; },
               &frontier::Row::clipper, "homogeneous/from_outside"),
           kRefuted}};
}

}  // namespace

std::vector<Alteration> alterations() {
  std::vector<Alteration> all = alterations_of_cost();
  for (const Alteration& a : alterations_of_literature()) all.push_back(a);
  for (const Alteration& a : alterations_of_geometry()) all.push_back(a);
  for (const Alteration& a : alterations_of_rounding()) all.push_back(a);
  return all;
}

}  // namespace clipscope::experiments::claims
