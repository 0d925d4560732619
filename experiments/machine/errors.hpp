// SPDX-License-Identifier: GPL-3.0-or-later
//
// Errors that a person can mend, and the exit codes of the program.
#pragma once

#include <stdexcept>

namespace clipscope::experiments {

enum ExitCode {
  kExitOk = 0,
  kExitPromiseBroken = 1,  // `verify` found a triangle that breaks the clipper's promise
  kExitMoved = 1,          // `diff` found a figure that moved
  kExitUsage = 2,          // an option or a name is wrong
  kExitInput = 3,          // a file or a line of input is wrong
  kExitOutput = 4,         // results can't be written
  kExitGuest = 5,          // a clipper of the user's can't be asked: it does not load or start
  kExitNothingJudged = 6   // a check found nothing that it could judge
};

// Bad input: the message names the file and the place in it, what was found and what was expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A wrong option value or name: the message names the option and what it takes.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Results that can't be written: the message names the path and the reason.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A clipper of the user's that can't be asked: the message says which and why.
struct GuestError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace clipscope::experiments
