// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/catch.hpp"

namespace clipscope::experiments {

// The message of the error E that `action` throws; fails the test if it throws none.
template <class E, class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const E& error) {
    return error.what();
  }
  FAIL("no error was thrown");
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace clipscope::experiments
