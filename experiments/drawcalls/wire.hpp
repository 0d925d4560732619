// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the program and the process that has a driver in it, its host, talk: frames over a socket,
// each a length (32 bits, of this machine's byte order) and so many bytes. The host has it as
// kHostSocket; a driver may print, and what it prints is its last words.
//
//   host to program, once      a Greeting: who the driver is, or why there is none
//   program to host            a DrawCall
//   host to program            what was Drawn
//
// The end of the program, or of its side of the socket, ends the host whatever it does meanwhile.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

inline constexpr int kHostSocket = 3;
inline constexpr std::uint32_t kMostFrameBytes = std::uint32_t{1} << 30;

// Or why there is no driver, for people.
using Greeting = std::variant<DriverInfo, std::string>;

std::string to_bytes(const Greeting& greeting);
std::string to_bytes(const DrawCall& call);
std::string to_bytes(const Drawn& drawn);

// Nothing if the bytes are not those of one, to the last byte: a driver may have written over them.
// Sizes are checked before memory is taken, so that no bytes make it take more than they promise.
std::optional<Greeting> greeting_of(std::span<const char> bytes);
std::optional<DrawCall> draw_call_of(std::span<const char> bytes);
std::optional<Drawn> drawn_of(std::span<const char> bytes);

// Blocking, for the host. Nothing at the end of the input. Writing: false if nobody reads.
std::optional<std::string> read_frame(int file);
bool write_frame(int file, std::span<const char> bytes);

// Lets this process keep the memory that pixels take from one draw call to the next. Given back and
// taken anew each time, some megabytes take longer than drawing them.
void keep_memory_of_pixels();

// The whole of a host's life: greets, and draws what it is asked for until the program ends. A null
// driver greets with the reason. Returns the process's exit code.
int serve(Driver* driver, const std::string& reason_for_none);

}  // namespace clipscope::experiments
