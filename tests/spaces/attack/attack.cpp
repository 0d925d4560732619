// SPDX-License-Identifier: GPL-3.0-or-later
//
// See attack.hpp.
#include "tests/spaces/attack/attack.hpp"

namespace clipscope::attack {

Attacked attack(const Kind& kind, std::uint64_t seed, std::span<const Contestant> contestants,
                const std::function<bool(int)>& goes_on) {
  Attacked r;
  for (; goes_on(r.batches) && !r.failure; ++r.batches) {
    Dice dice(seed ^ static_cast<std::uint64_t>(r.batches) << 32);
    dice.word();  // seeds that differ in a bit are far apart after one
    r.failure = judge(kind.make(dice), contestants, r.tally);
  }
  return r;
}

std::string missing_facts(const Kind& kind, const Facts& facts) {
  std::string r;
  for (const Fact fact : kind.reaches) {
    if (facts[fact] != 0) continue;
    if (!r.empty()) r += ", ";
    r += kFactNames[static_cast<std::size_t>(fact)];
  }
  return r;
}

}  // namespace clipscope::attack
