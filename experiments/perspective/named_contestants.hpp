// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contestants of an experiment that shows a few clippers unless others are asked for.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "experiments/commands/selection.hpp"

namespace clipscope::experiments {

// The clippers of the names in the scalars selected, or those of --clipper where it was given.
// Errors: UsageError.
inline std::vector<AnyContestant> named_contestants(const Selection& selection,
                                                    std::span<const std::string_view> names) {
  if (selection.clipper != Selection{}.clipper) return selected_contestants(selection);
  std::vector<AnyContestant> all;
  for (const std::string_view name : names) {
    for (const AnyContestant& c : select_contestants(name, selection.scalars)) all.push_back(c);
  }
  return all;
}

}  // namespace clipscope::experiments
