// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table as part of an HTML page whose script sorts and filters it (page/page.js).
#pragma once

#include <set>
#include <string>

#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// A figure with the title, the rows, the notes, and the tools that the script brings to life. Numbers are
// shown as people read them and carry their full value in data-v. The cells of a column with the key
// "verdict" are coloured by what they say; those of "experiment" lead to the part of the page with that id,
// if it is among `parts`.
std::string table_html(const Table& table, const std::set<std::string>& parts = {});

// A verdict on a claim, coloured by what it is.
std::string verdict_html(const std::string& verdict);

}  // namespace clipscope::experiments
