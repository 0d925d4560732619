// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/mutation_table.hpp"

#include <algorithm>
#include <map>

namespace clipscope::experiments {

std::vector<std::string> caught_by(reference::Bug bug, std::span<const HardCase> cases) {
  std::vector<std::string> names;
  for (const HardCase& c : cases) {
    if (reference::catches(bug, truth_of(c), c.vertices, c.attribute_count)) {
      names.push_back(c.name);
    }
  }
  return names;
}

std::vector<MutationRow> mutation_table(std::span<const HardCase> cases) {
  std::vector<MutationRow> rows;
  std::map<std::string, int> bugs_caught;
  for (const reference::BugInfo& info : reference::all_bugs()) {
    rows.push_back({info.bug, info.name, info.summary, caught_by(info.bug, cases), {}});
    for (const std::string& name : rows.back().caught_by) {
      ++bugs_caught[name];
    }
  }
  for (MutationRow& row : rows) {
    const auto sharpest = std::ranges::min_element(
        row.caught_by, {}, [&](const std::string& name) { return bugs_caught[name]; });
    if (sharpest != row.caught_by.end()) {
      row.sharpest = *sharpest;
    }
  }
  return rows;
}

}  // namespace clipscope::experiments
