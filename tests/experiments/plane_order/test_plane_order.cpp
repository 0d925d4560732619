// SPDX-License-Identifier: GPL-3.0-or-later
//
// Orders of planes: the tree cuts as clippers do, and a dependence on the order is found where one
// is.
#include <bit>
#include <map>
#include <set>

#include "experiments/plane_order/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::plane_order;

namespace {

constexpr int K = kSceneAttributes;

TriangleSet set_of(const std::string& name, std::size_t limit) {
  Selection selection;
  selection.quick = true;
  return make_set(selection, name, limit);
}

template <class Clipper>
NdcPolygon<float, K> clipped(const TriangleSet& set, const CutTriangle& t) {
  NdcPolygon<float, K> out;
  Clipper{}(ClipVolume{.depth = set.depth}, t.triangle, out);
  return out;
}

void check_same(const NdcPolygon<float, K>& a, const NdcPolygon<float, K>& b) {
  REQUIRE(a.size() == b.size());
  for (int i = 0; i < a.size(); ++i) {
    CHECK(a[i].position == b[i].position);
    CHECK(a[i].attributes.values == b[i].attributes.values);
  }
}

}  // namespace

TEST_CASE("orders: there are 720, each once") {
  std::set<std::string> texts;
  for (const Order& order : kAllOrders) texts.insert(order_text(order));
  CHECK(texts.size() == 720);
  CHECK(texts.contains("NFLRBT"));
  CHECK(order_text(plane_order::kNearFirst) == "NFLRBT");
  CHECK(order_text(kNearLast) == "LRBTFN");
  CHECK(plane_order::kNearFirst.front() == Plane::near);
  CHECK(kNearLast.back() == Plane::near);
}

TEST_CASE("orders: n planes have n! orders, and as many of the 720 amount to each") {
  for (Outcode planes = 1; planes < 64; ++planes) {
    std::map<std::size_t, int> counts;
    for (const Order& order : kAllOrders) ++counts[restricted(order, planes)];
    const int n = std::popcount(planes);
    int factorial = 1;
    for (int i = 2; i <= n; ++i) factorial *= i;
    CHECK(counts.size() == static_cast<std::size_t>(factorial));
    CHECK(counts.rbegin()->first + 1 == counts.size());
    for (const auto& [number, count] : counts) CHECK(count == 720 / factorial);
  }
}

TEST_CASE("orders: the tree's results have the bits of the clippers with that order") {
  for (const char* name : {"mixed_w", "slivers", "hard_cases"}) {
    const TriangleSet set = set_of(name, 60);
    for (const CutTriangle& t : set.triangles) {
      const auto all = OrderTree<float, K>::cut_all(set.depth, t.planes, t.triangle);
      check_same(all[restricted(plane_order::kNearFirst, t.planes)].polygon,
                 clipped<HomogeneousSutherlandHodgman>(set, t));
      check_same(all[restricted(kNearLast, t.planes)].polygon,
                 clipped<HomogeneousNearLast>(set, t));
    }
  }
}

TEST_CASE("orders: in exact arithmetic no order differs, with w <= 0 and on planes too") {
  for (const char* name : {"mixed_w", "lattice", "hard_cases"}) {
    INFO(name);
    const ExactOrders exact = measure_exact(set_of(name, 200), 12);
    CHECK(exact.triangles >= 10);
    CHECK(exact.mixed_w > 0);
    CHECK(exact.runs > exact.triangles);
    CHECK(exact.differs == 0);
    CHECK(exact.wrong == 0);
  }
}

TEST_CASE("orders: a plane left out is found wrong by the exact comparison") {
  TriangleSet set = set_of("mixed_w", 40);
  for (CutTriangle& t : set.triangles) t.planes &= ~bit(Plane::near);
  CHECK(measure_exact(set, 40).wrong > 0);
}

TEST_CASE("orders: float bits depend on the order; wrong answers are seen as such") {
  const RoundedOrders rounded = measure_rounded<float>(set_of("slivers", 100));
  CHECK(rounded.differs > 0);
  CHECK(rounded.wrong_in_some > 0);
  CHECK(rounded.near_last_px > 0);
  std::size_t reference = 0;
  while (kAllOrders[reference] != plane_order::kNearFirst) ++reference;
  CHECK(rounded.orders[reference].differs == 0);
  CHECK(rounded.orders[reference].moved_px == 0);
  for (const OrderTally& tally : rounded.orders) {
    CHECK(tally.differs <= rounded.differs);
    CHECK(tally.wrong <= rounded.wrong_in_some);
    CHECK(tally.wrong >= rounded.wrong_in_all);
    CHECK(tally.largest <= 9);
  }
}

TEST_CASE(
    "orders: the row of all sets adds counts, recomputes shares and takes the largest distance") {
  std::vector<OrdersRow> rows;
  for (const char* name : {"mixed_w", "lattice"}) {
    const TriangleSet set = set_of(name, 30);
    rows.push_back(orders_row(name, {.differs = 2}, measure_rounded<float>(set),
                              measure_rounded<double>(set)));
  }
  const OrdersRow all = total(rows);
  const OrdersRow::Rounded &a = rows[0].in_float, &b = rows[1].in_float;
  CHECK(all.set == "all");
  CHECK(all.triangles == 60);
  CHECK(all.exact.differs == 4);
  CHECK(all.in_float.max_px == std::max(a.max_px, b.max_px));
  CHECK(all.in_float.differs_percent == Approx((a.differs_percent + b.differs_percent) / 2));
  CHECK(all.in_float.wrong_near_first == a.wrong_near_first + b.wrong_near_first);
}

TEST_CASE("orders: each place of the near plane has 120 orders; near first is not moved") {
  const TriangleSet set = set_of("slivers", 40);
  const std::vector<ClassRow> rows = class_rows("slivers", measure_rounded<double>(set));
  REQUIRE(rows.size() == 8);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(rows[i].orders_class == near_at(static_cast<int>(i) + 1));
    CHECK(rows[i].orders == 120);
    CHECK(rows[i].fewest_wrong <= rows[i].most_wrong);
  }
  CHECK(rows[6].orders_class == "NFLRBT");
  CHECK(rows[6].orders == 1);
  CHECK(rows[6].max_px == 0);
  CHECK(rows[7].orders_class == "LRBTFN");
  for (const ClassRow& row : rows) CHECK(row.scalar == "double");
}

TEST_CASE("orders: the finding follows the rows") {
  OrdersRow all{.set = "all", .triangles = 200, .exact = {.triangles = 20, .mixed_w = 7}};
  all.in_float = {.differs = 100,
                  .differs_percent = 50,
                  .max_px = 3,
                  .wrong_near_first = 2,
                  .wrong_near_last = 2};
  TimeRow timed{"soup", "homogeneous/near_last", "float", {}, MedianInterval{1.5, 1.25, 2}};
  const auto checked = [&] {
    const std::string text = finding(all, {timed});
    INFO(text);
    CHECK(faults_of_prose(text).empty());
    return text;
  };
  CHECK(
      checked() ==
      "In exact arithmetic the order of the planes does not matter, even where w <= 0. In float it changes bits of 50.0 % of the triangles and moves vertices by up to 3.00 px; as many triangles are wrong with the near plane last as with it first. With the near plane last clipping is slower on the game-like mix.");
  all.exact.differs = 2;
  all.in_float.wrong_near_last = 1;
  timed.ratio = MedianInterval{1, 0.9, 1.1};
  CHECK(
      checked() ==
      "Even in exact arithmetic the order of the planes matters, for few triangles. In float it changes bits of 50.0 % of the triangles and moves vertices by up to 3.00 px; fewer triangles are wrong with the near plane last than with it first. With the near plane last clipping is as fast as with it first on every mix.");
  timed.ratio = MedianInterval{0.5, 0.4, 0.6};
  CHECK(checked().ends_with("clipping is faster on the game-like mix."));
  timed.ratio.reset();
  CHECK(checked().find("clipping is") == std::string::npos);
}

TEST_CASE("orders: without triangles the finding says so") {
  CHECK(finding({}, {}) == "No order was tried in exact arithmetic.");
}

TEST_CASE("orders: the plots are made from rows alone") {
  const std::vector<ClassRow> rows = {
      {.set = "a", .scalar = "float", .orders_class = near_at(1), .wrong_percent = 4},
      {.set = "a", .scalar = "float", .orders_class = near_at(3), .wrong_percent = 5},
      {.set = "a", .scalar = "double", .orders_class = near_at(2), .wrong_percent = 6}};
  const Plot plot = wrong_plot(rows);
  REQUIRE(plot.series.size() == 1);
  CHECK(plot.series[0].x == std::vector<double>{1, 3});
  CHECK(plot.series[0].y == std::vector<double>{4, 5});
}
