// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/claims/confirmed_run.hpp"

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

namespace clipscope::experiments::claims {

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

std::vector<CountRow> counts() {
  std::vector<CountRow> rows;
  const auto add = [&](const char* quantity, std::int64_t count, std::int64_t cases = 100) {
    rows.push_back({0, "random cases", quantity, cases, count});
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
  add("view space differs", 0);
  add("clip space differs", 0);
  add("the CVV differs", 0);
  add("clip coordinates are (1, 1, -20/9, 0)", 1, 1);
  return rows;
}

namespace {

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
  add(Contract::full, "homogeneous/from_inside", "float", 25, 78);
  add(Contract::full, "homogeneous/from_outside", "float", 25, 80);
  add(Contract::full, "homogeneous/weighted_ends", "float", 25, 79);
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
  run.set<guard_band::PictureRow>({row_with<guard_band::PictureRow>(
      &guard_band::PictureRow::scene, "floor", &guard_band::PictureRow::vertices, "float")});
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
  orders.in_float.wrong_near_first = 5;
  orders.in_float.wrong_near_last = 10;
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

}  // namespace

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
  const auto bounded = [](const char* scene, const char* bound, double closer) {
    return row_with<bounds::Row>(&bounds::Row::scene, scene, &bounds::Row::bound, bound,
                                 &bounds::Row::closer_percent, closer,
                                 &bounds::Row::settleable_percent, closer > 50 ? 10 : 90);
  };
  run.set<bounds::Row>(
      {bounded("teapot", "box", 20), bounded("teapot", "sphere", 30), bounded("soup", "box", 10)});
  add_geometry(run);
  add_rounding(run);
  add_depth(run);
  return run;
}

}  // namespace clipscope::experiments::claims
