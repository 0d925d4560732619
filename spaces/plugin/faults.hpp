// SPDX-License-Identifier: MIT
//
// Signals that a plug-in's mistakes raise: each is told to the program, and ends the process.
#pragma once

#include "spaces/plugin/call.hpp"
#include "spaces/plugin/channel.hpp"

namespace clipscope::plugin {

// From now on. Both live as long as the process.
void report_faults(Control& control, const Memory& memory);

// While it lives the calling thread has a stack for that, so that the end of its own is reported,
// too. Sanitizers want the one back that was there before.
class FaultStack {
 public:
  explicit FaultStack(std::size_t thread);  // 0 or 1
  ~FaultStack();
  FaultStack(const FaultStack&) = delete;
  FaultStack& operator=(const FaultStack&) = delete;

 private:
  void* before_ = nullptr;
  std::size_t before_bytes_ = 0;
  int before_flags_ = 0;
};

}  // namespace clipscope::plugin
