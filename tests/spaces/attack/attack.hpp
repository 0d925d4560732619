// SPDX-License-Identifier: GPL-3.0-or-later
//
// One kind of input against all contestants.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "tests/spaces/attack/judge.hpp"
#include "tests/spaces/attack/kinds.hpp"

namespace clipscope::attack {

struct Attacked {
  Tally tally;
  int batches = 0;
  std::optional<Failure> failure;
};

// Batches numbered from 0 on, as long as goes_on(batches so far); batch i of a seed is always the
// same. Ends at the first failure.
Attacked attack(const Kind& kind, std::uint64_t seed, std::span<const Contestant> contestants,
                const std::function<bool(int)>& goes_on);

// What a kind claims to reach and did not: the names of the facts; empty if nothing is missing.
std::string missing_facts(const Kind& kind, const Facts& facts);

}  // namespace clipscope::attack
