// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>

#include "experiments/cost/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/measuring.hpp"
#include "spaces/planes.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::cost;

namespace {

const GrowthOptions kSmall{
    .seed = 1,
    .soup = 2000,
    .most = 10'000,
    .attribute_soup = 300,
    .crossing = 8,
    .clock = {.rounds = 3, .milliseconds_per_run = 0.05, .check = {.triangles = 300, .exact = 4}}};

std::vector<GrowthRow> rows_of(Growing growing) {
  TableOf<GrowthRow> table;
  PieceRecord record;
  measure_growth(growing, kSmall, table, record);
  CHECK(record.samples.size() == table.rows().size());
  return table.rows();
}

}  // namespace

TEST_CASE("growth: crossing triangles cross exactly so many planes, and each comes as often") {
  for (int planes = 1; planes <= kPlanes; ++planes) {
    const StageInput input = crossing_input(planes, 6, 3, 1);
    REQUIRE(input.array_size() > 0);
    CHECK(input.array_size() % 3 == 0);
    for (std::size_t t = 0; t < input.array_size(); ++t) {
      Outcode all = ~Outcode{0}, any = 0;
      for (std::size_t v = 0; v < 3; ++v) {
        const float* p = input.vertex(Contract::copy, t, v);
        const Outcode code = clip_outcode(input.volume.depth, Vec4<float>(p[0], p[1], p[2], p[3]));
        all &= code;
        any |= code;
      }
      CHECK(all == 0);
      CHECK(std::popcount(any) == planes);
    }
  }
}

TEST_CASE("growth: triangles grow tenfold, and beyond the soup it streams through again") {
  std::vector<std::int64_t> sizes;
  for (const GrowthRow& row : rows_of(Growing::triangles)) {
    REQUIRE(row.ns);
    if (sizes.empty() || sizes.back() != row.n) sizes.push_back(row.n);
    CHECK(row.triangles.value() >= static_cast<double>(row.n));
    CHECK(row.ns->median > 0);
    CHECK_FALSE((row.clipper == "textbook" && row.n > 2000));
  }
  CHECK(sizes == std::vector<std::int64_t>{1000, 10'000});
}

TEST_CASE(
    "growth: each of the others has a point per step for the textbook and the batch clippers") {
  const auto steps = [](Growing growing) {
    const std::vector<GrowthRow> rows = rows_of(growing);
    for (const GrowthRow& row : rows) {
      CHECK(row.ns.value().median > 0);
      CHECK(row.speedup.value() > 0);
    }
    return rows.size() / 5;
  };
  CHECK(steps(Growing::attributes) == 7);
  CHECK(steps(Growing::planes) == 6);
  CHECK(steps(Growing::threads) == std::min<std::size_t>(2, allowed_processors().size()));
}

TEST_CASE("growth: threads clip their parts four times, of the slow baseline an eighth") {
  for (const GrowthRow& row : rows_of(Growing::threads)) {
    CHECK(row.triangles == (row.clipper == "textbook" ? 250 : 8000));
  }
}

TEST_CASE("growth: two threads are compared with one in the same rounds") {
  for (const GrowthRow& row : rows_of(Growing::threads)) {
    REQUIRE(row.speedup_by_threads);
    CHECK(row.speedup_by_threads->median > 0);
    if (row.n == 1) CHECK(row.speedup_by_threads->low == 1);
  }
  for (const GrowthRow& row : rows_of(Growing::planes)) CHECK_FALSE(row.speedup_by_threads);
}

TEST_CASE("growth: what fits into a cache is said to come from there, the rest from memory") {
  for (const GrowthRow& row : rows_of(Growing::attributes)) CHECK(row.from == InputFrom::cache);
  GrowthOptions large = kSmall;
  large.soup = 2 * level2_cache_bytes() / (3 * 8 * sizeof(float));
  TableOf<GrowthRow> table;
  PieceRecord record;
  measure_growth(Growing::triangles, large, table, record);
  const auto from = [&](std::int64_t n) {
    return distinct(rows_where(table.rows(), &GrowthRow::n, n), &GrowthRow::from);
  };
  CHECK(from(1000) == std::vector{InputFrom::cache, InputFrom::memory});
  CHECK(from(10'000).back() == InputFrom::memory);
}
