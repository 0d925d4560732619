// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shards/shard.hpp"

#include <algorithm>
#include <numeric>

#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("shard: every unit belongs to one shard, whatever their number") {
  const std::size_t total = GENERATE(0, 1, 7, 48, 49);
  const std::size_t together = GENERATE(1, 2);
  for (const std::size_t count : {1u, 3u, 16u, 60u}) {
    std::vector<std::size_t> all, expected(total);
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<std::size_t> units = Shard{i, count}.units(total, together);
      CHECK(std::ranges::is_sorted(units));
      all.insert(all.end(), units.begin(), units.end());
    }
    std::ranges::sort(all);
    std::iota(expected.begin(), expected.end(), std::size_t{0});
    CHECK(all == expected);
  }
}

TEST_CASE("shard: neighbours that go together have the same shard") {
  CHECK(Shard{1, 3}.units(9, 2) == std::vector<std::size_t>{2, 3, 8});
  CHECK(Shard{1, 3}.units(9) == std::vector<std::size_t>{1, 4, 7});
}

TEST_CASE("shard: i/N is read, and nothing else") {
  CHECK(parse_shard("0/1") == Shard{0, 1});
  CHECK(parse_shard("15/16") == Shard{15, 16});
  CHECK(text_of({3, 16}) == "3/16");
  for (const char* text :
       {"", "/", "1", "1/", "/2", "2/2", "-1/2", "1/2/3", "1 /2", "0/1000001", "0x1/2", "0/0"}) {
    INFO(text);
    CHECK(!parse_shard(text));
  }
}
