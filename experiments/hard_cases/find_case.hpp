// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finding a hard case by its name.
#pragma once

#include <span>
#include <string_view>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// The case of that name, "theme/name", or "name" if only one theme has it. Errors: UsageError that names
// those whose names are most like it.
const HardCase& find_case(std::span<const HardCase> cases, std::string_view name);

}  // namespace clipscope::experiments
