// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/warning.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <mutex>
#include <set>

namespace clipscope::experiments {

void warn(const std::string& text) {
  static std::mutex mutex;
  static std::set<std::string> printed;
  const std::lock_guard lock(mutex);
  if (printed.insert(text).second) fmt::print(stderr, "clipscope: warning: {}\n", text);
}

}  // namespace clipscope::experiments
