// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which part of some work is done here: shard i of N, i from 0.
//
// The work is a list of units, each a pure function of its number, so that every N gives the same
// total. Neighbours go to different shards, since what is next to each other takes equally long.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace clipscope::experiments {

struct Shard {
  std::size_t index = 0, count = 1;

  bool is_whole() const { return count == 1; }
  // Of `total` units those that are the shard's, ascending. `together` neighbours, from one whose
  // number is a multiple of that on, have the same shard.
  std::vector<std::size_t> units(std::size_t total, std::size_t together = 1) const;

  friend bool operator==(const Shard&, const Shard&) = default;
};

// "3/16"; nothing unless it is i/N with 0 <= i < N <= kMostShards.
inline constexpr std::size_t kMostShards = 1'000'000;
std::optional<Shard> parse_shard(const std::string& text);
std::string text_of(const Shard& shard);

}  // namespace clipscope::experiments
