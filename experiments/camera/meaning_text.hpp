// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a matrix means, in sentences and tables for people, and as JSON for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "experiments/camera/matrix_meaning.hpp"

namespace clipscope::experiments {

// Sentences and three tables: depth conventions, planes, digits of depth. Lines have at most 100
// columns. is_chosen: somebody asked for the depth convention.
std::string meaning_text(const MatrixMeaning& meaning, bool is_chosen);

// The same as {"kind": "perspective", ..., "planes": [...], "depth_digits": [...]}. What is
// infinite is the text "inf".
nlohmann::json meaning_json(const MatrixMeaning& meaning);

}  // namespace clipscope::experiments
