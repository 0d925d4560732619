// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plug-ins as contestants: libraries with the interface of spaces/plugin/clipscope_plugin.h, each
// in processes of its own.
#pragma once

#include <string>
#include <string_view>

#include "experiments/contestants/contestant.hpp"
#include "experiments/guests/plugin_channel.hpp"

namespace clipscope::experiments {

// Loads the library in a process of its own, and adds a contestant for each scalar and primitive
// that it takes. seconds: what a batch may take. The clipper's name.
// Errors: GuestError, which says why it can't be asked.
std::string_view add_plugin(const std::string& library, double seconds = kPluginSeconds);

}  // namespace clipscope::experiments
