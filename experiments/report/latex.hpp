// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text for LaTeX.
#pragma once

#include <string>

namespace clipscope::experiments {

// The text with every character that LaTeX gives a meaning to escaped. UTF-8 stays as it is.
std::string latex_escape(const std::string& text);

// Three significant digits, powers of ten in mathematics: 0.125, 13.4, $2.1\cdot10^{-7}$.
std::string latex_number(double value);

}  // namespace clipscope::experiments
