// SPDX-License-Identifier: MIT
//
// Signals that a plug-in's mistakes raise: each is told to the program, and ends the process.
#pragma once

#include "spaces/plugin/call.hpp"
#include "spaces/plugin/channel.hpp"

namespace clipscope::plugin {

// From now on. Both live as long as the process.
void report_faults(Control& control, const Memory& memory);
// Gives the calling thread a stack for it, so that the end of its own is reported, too.
void use_fault_stack(std::size_t thread);

}  // namespace clipscope::plugin
