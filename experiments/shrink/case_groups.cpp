// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/shrink/case_groups.hpp"

#include <utility>

#include "experiments/catalogue/catalogue.hpp"

namespace clipscope::experiments {

std::deque<CaseGroup> grouped(std::span<const HardCase> cases) {
  std::vector<const HardCase*> finite;
  for (const HardCase& c : cases) {
    if (is_finite(c)) finite.push_back(&c);
  }
  std::deque<CaseGroup> groups;
  for (const std::vector<const HardCase*>& group : alike(finite, cases.size())) {
    std::vector<std::size_t> places;
    for (const HardCase* c : group) places.push_back(static_cast<std::size_t>(c - cases.data()));
    groups.emplace_back(group, std::move(places));
  }
  return groups;
}

}  // namespace clipscope::experiments
