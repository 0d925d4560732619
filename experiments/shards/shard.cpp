// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shards/shard.hpp"

#include <fmt/format.h>

#include <charconv>

namespace clipscope::experiments {
std::vector<std::size_t> Shard::units(std::size_t total, std::size_t together) const {
  std::vector<std::size_t> mine;
  for (std::size_t first = index * together; first < total; first += count * together) {
    for (std::size_t i = first; i < first + together && i < total; ++i) mine.push_back(i);
  }
  return mine;
}

std::optional<Shard> parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const char* const slash = std::from_chars(text.data(), end, shard.index).ptr;
  const bool is_pair = slash != text.data() && slash != end && *slash == '/' &&
                       std::from_chars(slash + 1, end, shard.count).ptr == end && slash + 1 != end;
  if (is_pair && shard.index < shard.count && shard.count <= kMostShards) return shard;
  return std::nullopt;
}

std::string text_of(const Shard& shard) { return fmt::format("{}/{}", shard.index, shard.count); }

}  // namespace clipscope::experiments
