// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pushes a component too many, with assertions on: exit code 0 if that is found out, else 1.
#undef NDEBUG
#include <csignal>
#include <cstdlib>

#include "spaces/expansion.hpp"

int main() {
  clipscope::Expansion<2> full(1, 0x1p-60);
  full.push(0);  // takes no room
  if (full.size() != 2) return 1;
  std::signal(SIGABRT, [](int) { std::_Exit(0); });
  full.push(2);
  return 1;
}
