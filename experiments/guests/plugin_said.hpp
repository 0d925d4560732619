// SPDX-License-Identifier: GPL-3.0-or-later
//
// What was left in the memory that a plug-in shares with the program.
//
// Its host checks what the plug-in answers. But the plug-in lives in the same process and may write
// there itself, at any time: from a thread that it left behind, or by a wild pointer. So nothing
// that is read here is believed, and what decides is read once.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "experiments/contestants/answers.hpp"
#include "spaces/plugin/channel.hpp"

namespace clipscope::experiments {

// A value that may change while it is looked at.
template <class T>
T read_once(const T& shared) {
  return static_cast<const volatile T&>(shared);
}

// As far as its end, or the end of its room; bytes that are no UTF-8 are replaced.
std::string text_of(const plugin::Text& text);

// What is wrong with an answer that was given, by its host.
std::optional<Failure> malformed(const plugin::Control& said);

// Whether the host said that an access or a signal is about to end it.
bool says_why_it_ends(const plugin::Control& said);

// Why a host that has ended did so. status: as of waitpid.
Failure failure_of_end(const plugin::Control& said, int status);

// The polygons of a call, in its output.
template <class T>
struct LeftPolygons {
  const T* numbers = nullptr;  // count * most_vertices * stride
  const std::size_t* ends = nullptr;
  std::size_t count = 0, most_vertices = 0, stride = 0;
};

// Adds the polygon of each primitive, or that it has none. It reads within `numbers` alone.
template <class T>
void read_polygons(const LeftPolygons<T>& left, Answers& answers) {
  std::size_t before = 0;
  for (std::size_t i = 0; i < left.count; ++i) {
    const std::size_t end = read_once(left.ends[i]);
    if (end < before || end - before > left.most_vertices) {
      answers.fail({Failure::Kind::malformed, "changes its answer after it was given"});
      continue;
    }
    for (std::size_t n = before * left.stride; n < end * left.stride; ++n) {
      answers.add(left.numbers[n]);
    }
    answers.end_polygon();
    before = end;
  }
}

}  // namespace clipscope::experiments
