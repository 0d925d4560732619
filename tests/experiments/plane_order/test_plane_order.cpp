// SPDX-License-Identifier: GPL-3.0-or-later
//
// Orders of planes: the tree cuts as clippers do, and a dependence on the order is found where there is one.
#include <bit>
#include <map>
#include <set>

#include "experiments/plane_order/tables.hpp"
#include "experiments/report/row_view.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

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
  for (const Order& order : all_orders()) texts.insert(order_text(order));
  CHECK(texts.size() == 720);
  CHECK(texts.contains("NFLRBT"));
  CHECK(order_text(near_first_order()) == "NFLRBT");
  CHECK(order_text(near_last_order()) == "LRBTFN");
  CHECK(position_of(Plane::near, near_first_order()) == 1);
  CHECK(position_of(Plane::near, near_last_order()) == 6);
}

TEST_CASE("orders: n planes have n! orders, and as many of the 720 amount to each") {
  for (Outcode planes = 1; planes < 64; ++planes) {
    std::map<std::size_t, int> counts;
    for (const Order& order : all_orders()) ++counts[restricted(order, planes)];
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
      check_same(all[restricted(near_first_order(), t.planes)].polygon,
                 clipped<HomogeneousSutherlandHodgman>(set, t));
      check_same(all[restricted(near_last_order(), t.planes)].polygon,
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
  while (all_orders()[reference] != near_first_order()) ++reference;
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
  Table table = orders_table();
  for (const char* name : {"mixed_w", "lattice"}) {
    SetResult result{set_of(name, 30), {}, {}, {}};
    result.in_float = measure_rounded<float>(result.set);
    result.in_double = measure_rounded<double>(result.set);
    result.exact.differs = 2;
    add_set(result, table);
  }
  const Table with = with_all(table);
  const RowView a(with, 0), b(with, 1), all(with, 2);
  CHECK(all.text("set") == "all");
  CHECK(all.count("triangles") == 60);
  CHECK(all.count("exact_differs") == 4);
  CHECK(all.number("max_px") == std::max(a.number("max_px"), b.number("max_px")));
  CHECK(all.number("float_differs_percent") ==
        Approx((a.number("float_differs_percent") + b.number("float_differs_percent")) / 2));
}
