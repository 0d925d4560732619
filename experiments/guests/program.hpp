// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs as contestants: any command line that reads primitives as text until its input ends, and
// writes what is left of them as CSV (program_text.hpp). It is started once for each batch of some
// thousand primitives, knows nothing of the batches before, and is judged, not timed.
//
// The environment tells it what it is asked (names in program_environment.hpp). It is asked for
// what its options say it takes, and nothing else.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "spaces/vertex.hpp"

namespace clipscope::experiments {

struct ProgramOptions {
  std::string command;  // run by /bin/sh -c
  std::string name;     // empty: the stem of its file
  Space space = Space::clip;
  std::vector<Primitive> primitives = {Primitive::triangle};
  std::array<bool, 3> depths = {true, false, false};  // by DepthRange
  int most_attributes = 0;                            // clip distances included
  bool clip_distances = false, depth_clamp = false, open_sides = false;
  bool hex = false;     // it reads hex floats instead of decimals
  double seconds = 10;  // it may take for a batch
};

// Adds what a program takes, as a user lists it: "segments,attributes=4". Of spaces, depths and
// primitives those in the list are all that it takes. Errors: UsageError.
void set_takes(const std::vector<std::string>& list, ProgramOptions& options);
// The words of such a list, for a help text.
std::string_view takes_words();
// The list that says what is not taken without it; empty if there is nothing to say.
std::string takes_list(const ProgramOptions& options);

// Adds the program as a contestant in float and in double; its name. It is tried on one primitive
// inside the volume. Errors: GuestError unless it starts and ends without an error.
std::string_view add_program(const ProgramOptions& options);

// The first word of a command that is a file; empty if none is.
std::string program_file(const std::string& command);
// The stem of that file, or else of the first word: "python3 tools/mine.py" is "mine".
std::string program_name(const std::string& command);

}  // namespace clipscope::experiments
