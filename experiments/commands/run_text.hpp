// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `clipscope run` says at its end: the answers, where the page is, how to ask further. It fits
// one screen.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "experiments/table/table.hpp"

namespace clipscope::experiments::commands {

inline constexpr std::size_t kScreenLines = 40;

// answers: the table of that name, with the columns question and answer; nothing where the run
// has none. page: the file. folder: of the run, where further questions are asked. Answers that
// the screen has no room for are counted.
std::string closing_text(const std::optional<Table>& answers, const std::string& page,
                         const std::string& folder);

}  // namespace clipscope::experiments::commands
