// SPDX-License-Identifier: MIT
//
// One call of a plug-in: what it needs before (the projection) and after (the divide, where it
// answers in clip space; whether its answer is one).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "spaces/plugin/channel.hpp"
#include "spaces/plugin/guarded.hpp"

namespace clipscope::plugin {

// Where one thread puts its answer.
struct Output {
  Guarded numbers, ends;
  TwoFaced projected;  // its input, where that had to be projected
};

struct Memory {
  std::vector<Guarded> inputs;
  Guarded input_ends;
  std::array<Output, 2> outputs;  // the second one for a second thread
};

struct Result {
  Fault fault = Fault::none;
  std::int32_t code = 0;
  std::uint64_t at = 0, vertices = 0;
};

// Pre-condition: the areas that the request speaks of are there, and large enough.
Result call(const clipscope_plugin& plugin, const Request& request, const Memory& memory,
            Output& output);

}  // namespace clipscope::plugin
