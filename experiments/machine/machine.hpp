// SPDX-License-Identifier: GPL-3.0-or-later
//
// The machine that a timing was measured on, in words: the one place where tables, the page of
// results, the README's findings, the claims and the paper have it from.
#pragma once

#include <cstddef>
#include <ctime>
#include <fmt/chrono.h>
#include <string>

namespace clipscope::experiments {

// What does not change while it is on: processor, how many there are, the instruction set that the
// batch clippers run on.
std::string machine_name();

// Of a processor's second-level cache; what does not fit comes from memory, as experiments have it,
// though a third level may hold it. 256 KiB where the system doesn't say.
std::size_t level2_cache_bytes();

// How times are measured: frequency governor and scheduling class.
std::string measuring_conditions();

// These, and of what was timed so far the runs that lost the processor and the share of the
// processors that other programs took meanwhile (a hypervisor's other machines, too).
std::string machine_state();

// One line: the machine, compiler and version, flags, commit. Of what was timed also its state.
std::string machine_description();
std::string timing_description();

// Dates in UTC: "2026-03-01T12:34:56Z" (ISO 8601).
inline std::string date_of(std::time_t time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(time));
}

inline std::string date_now() { return date_of(std::time(nullptr)); }

}  // namespace clipscope::experiments
