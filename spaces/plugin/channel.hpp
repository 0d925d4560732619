// SPDX-License-Identifier: MIT
//
// What the program and the host of a plug-in share: memory, and whose turn it is.
//
// The program asks, the host answers; both see the same memory, so that no number is copied. Areas
// of memory are files without a name (memfd), handed over through a socket. An order is a number in
// a Turn, on which the other side waits: for some microseconds awake, then asleep (futex).
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "spaces/plugin/clipscope_plugin.h"

namespace clipscope::plugin {

// Where the host finds its end of the socket.
inline constexpr int kSocket = 3;

// A number that one side writes and the other waits for. Each on a cache line of its own.
struct alignas(64) Turn {
  std::atomic<std::uint32_t> number = 0;
  std::atomic<std::uint32_t> is_slept_on = 0;
};

// How long a side waits awake, in microseconds: with one processor not at all, since the other one
// needs it.
struct Patience {
  double awake_us = 0;
  double seconds = 0;  // in all
};

void pass(Turn& turn, std::uint32_t number);
// Whether the number came in time.
bool await(Turn& turn, std::uint32_t number, const Patience& patience);

// What areas of memory are for. The host can't write to input.
enum class Use : std::uint32_t { control, input, input_ends, output, output_ends };

// Hands an area over. The file descriptor goes beside it.
struct AreaMessage {
  Use use = Use::control;
  std::uint32_t index = 0;  // among those of that use
  std::uint64_t bytes = 0;  // whole pages
};

// Sends a message and a file descriptor, or receives them: whether that worked.
bool send_area(int socket, const AreaMessage& message, int file);
bool receive_area(int socket, AreaMessage& message, int& file);

enum class Order : std::uint32_t {
  load,        // and describe the plug-in
  wake,        // say how often the processor was lost
  take_area,   // from the socket
  clip,        // the request
  clip_twice,  // in two threads at once, each with an output of its own
};

// A call of the plug-in. Data ends where its area does, but for input, which may hold more.
struct Request {
  clipscope_task task = {};    // as the input is; its pointers are the host's business
  std::uint32_t input = 0;     // index of the area
  std::uint64_t input_at = 0;  // bytes from the start of the area
  std::uint64_t most_vertices = 0;
  // The input is in view space, and the plug-in is asked in clip space: by the matrix of the task,
  // or by its frustum.
  bool projects = false, by_matrix = false;
};

// What was wrong. The first two end the process.
enum class Fault : std::uint32_t {
  none,
  out_of_bounds,  // an access where there is none: see Reach
  signal,         // any other one
  returned_error,
  wrote_before_output,  // not as far as the guard, but into what lies in front of the output
  ends_descend,
  too_many_vertices,
  loads_not  // the text says why
};

// An access that memory does not grant.
struct Reach {
  enum class Side : std::uint32_t { before, inside, after };
  enum class Access : std::uint32_t { unknown, read, write };
  Use use = Use::input;
  Side side = Side::after;
  Access access = Access::unknown;
};

inline constexpr std::size_t kMostTextBytes = 512;
using Text = std::array<char, kMostTextBytes>;

// Cuts what does not fit.
void copy_text(const char* from, Text& to);

struct Description {
  Text name = {}, summary = {}, source = {};
  std::uint32_t capabilities = 0, most_attributes = 0;
};

// The area `control`.
struct Control {
  Turn asked, answered;

  alignas(64) Order order = Order::load;
  Request request;
  double awake_us = 0;  // how long the host waits for the next order awake
  int scheduling_class = 0, scheduling_priority = 0;  // of the thread that asks
  std::array<std::uint64_t, 16> processors = {};      // bits of those that the host may run on

  alignas(64) Fault fault = Fault::none;
  std::int32_t code = 0;       // of the signal, or what the plug-in returned
  Reach reach = {};            // out of bounds
  std::uint64_t at = 0;        // the primitive where an answer is malformed
  std::uint64_t vertices = 0;  // of the polygon that has too many
  std::int64_t lost_processor = 0;
  Text text = {};
  Description description;
};

}  // namespace clipscope::plugin
