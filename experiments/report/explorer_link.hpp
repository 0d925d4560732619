// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inputs as the explorer shows them (experiments/explorer/README.md): the fragment of its page's
// address, which has the names and values of the program's options.
#pragma once

#include <string>

#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

// The explorer's page, where it lies beside a page of results.
inline constexpr const char* kExplorerFile = "explorer.html";

// "v1&space=clip&..." with the contestant that is wrong beside an accurate one. Nothing where the
// explorer has no such question: it has triangles, frusta, four clip distances at most, and the
// project's own clippers in float and double.
std::string explorer_fragment(const std::string& experiment, const WorstInput& worst);

}  // namespace clipscope::experiments
