// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gnuplot commands that draw a plot.
#pragma once

#include <string>

#include "experiments/report/plot.hpp"

namespace clipscope::experiments {

// Commands that write plot.svg, plot.pdf and plot.png into the folder that gnuplot runs in. Names and
// titles are quoted such that gnuplot takes nothing in them as a command or as markup; control characters
// become blanks.
std::string plot_script(const Plot& plot);

// A text as a string of gnuplot's, quotes included: all but letters, digits and little else as octal escapes.
std::string gnuplot_string(const std::string& text);

}  // namespace clipscope::experiments
