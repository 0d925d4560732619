// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/camera/exact_rows.hpp"

#include "tests/catch.hpp"

namespace clipscope::experiments::camera {
namespace {

MatrixRows<double> rows(Vec4<double> a, Vec4<double> b, Vec4<double> c, Vec4<double> d) {
  return {a, b, c, d};
}

TEST_CASE("exact rows: three planes share the point that all of them take to 0") {
  // x = 1, y = 2, z = 3.
  const Exact4 p = common_point({1, 0, 0, -1}, {0, 1, 0, -2}, {0, 0, 1, -3});
  CHECK(p[0] / p[3] == 1);
  CHECK(p[1] / p[3] == 2);
  CHECK(p[2] / p[3] == 3);
  // x = 0, y = 0 and x + y = 1 meet at infinity, along z.
  const Exact4 far = common_point({1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, -1});
  CHECK(far[0] == 0);
  CHECK(far[1] == 0);
  CHECK(far[2] != 0);
  CHECK(far[3] == 0);
}

TEST_CASE("exact rows: what a singular matrix flattens is a direction or a point") {
  const auto flat = rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, -1}, {0, 0, 0, 1});
  CHECK(rank(exact(flat)) == 3);
  CHECK(lost_point(exact(flat)) == std::array<double, 4>{0, 0, 1, 0});
  // All rows are 0 at (2, 0, -1).
  const auto point = rows({1, 0, 2, 0}, {0, 1, 0, 0}, {0, 0, 1, 1}, {1, 0, 3, 1});
  CHECK(rank(exact(point)) == 3);
  CHECK(lost_point(exact(point)) == std::array<double, 4>{2, 0, -1, 1});
}

TEST_CASE("exact rows: a matrix that is singular but for one ulp has full rank") {
  const double next = 1 + 0x1p-52;
  CHECK(rank(exact(rows({1, 1, 0, 0}, {1, next, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}))) == 4);
  CHECK(rank(exact(rows({1, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}))) == 3);
}

}  // namespace
}  // namespace clipscope::experiments::camera
