// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plug-in that does what no plug-in should. It copies its input, whatever it is clipped against,
// until it meets a primitive whose first coordinate is 42: what it does then the environment
// variable CLIPSCOPE_MISBEHAVIOUR says, as its name does after "test/".
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include "spaces/plugin/clipscope_plugin.h"

namespace {

constexpr float kMarker = 42;

const std::string& behaviour() {
  static const std::string name = [] {
    const char* given = std::getenv("CLIPSCOPE_MISBEHAVIOUR");
    return std::string(given == nullptr ? "none" : given);
  }();
  return name;
}

bool is(const char* name) { return behaviour() == name; }

struct Call {
  const clipscope_task& task;
  clipscope_answer& answer;
  std::size_t dimension() const { return task.space == CLIPSCOPE_VIEW_SPACE ? 3 : 4; }
  std::size_t first(std::size_t i) const {
    if (task.primitive == CLIPSCOPE_POLYGONS) return i == 0 ? 0 : task.ends[i - 1];
    return i * per_primitive();
  }
  std::size_t per_primitive() const {
    return task.primitive == CLIPSCOPE_TRIANGLES ? 3 : task.primitive == CLIPSCOPE_SEGMENTS ? 2 : 1;
  }
};

volatile int never = 0;
int depth_of_stack(int n) {
  volatile char room[4096];
  room[0] = static_cast<char>(n);
  return n < 0 ? room[0] : depth_of_stack(n + 1) + room[0];
}

// What happens at the marked primitive. Whether its answer is the usual one.
void misbehave(const Call& call, std::size_t i, std::size_t at) {
  const clipscope_task& task = call.task;
  const std::size_t all = call.answer.capacity * call.answer.stride;
  if (is("crash")) *const_cast<volatile int*>(static_cast<int*>(nullptr)) = 1;
  if (is("abort")) std::abort();
  if (is("last_words") || is("last_bytes")) {
    std::puts(is("last_words") ? "\nmine: an invariant is broken" : "bad \377 byte");
    std::fflush(stdout);
    std::abort();
  }
  if (is("exit")) _exit(3);
  if (is("loop")) {
    while (never == 0) {
    }
  }
  if (is("stack")) depth_of_stack(0);
  if (is("write_beyond")) call.answer.floats[all] = 1;
  if (is("write_beyond_ends")) call.answer.ends[task.count] = 1;
  if (is("write_before")) call.answer.floats[-1] = 1;
  if (is("write_input")) const_cast<float*>(task.floats)[0] = 1;
  if (is("read_beyond")) call.answer.floats[at] = task.floats[task.vertices * task.stride];
  if (is("descend")) call.answer.ends[i] = i == 0 ? 1 : call.answer.ends[i - 1] - 1;
  if (is("writes_later")) {
    std::thread([ends = call.answer.ends] {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      ends[0] = std::size_t{1} << 40;
    }).detach();
  }
  if (is("nan")) call.answer.floats[at] = std::nanf("");
}

int calls = 0;
float before = 0;           // the first number of the primitive before
float between_threads = 0;  // written by one, read by the other

float first_number(float usual) {
  if (is("counts")) return static_cast<float>(calls);
  if (is("remembers")) return before;
  if (is("races")) {
    const float mine = between_threads + 1;
    std::this_thread::sleep_for(std::chrono::microseconds(20));
    between_threads = mine;
    std::this_thread::sleep_for(std::chrono::microseconds(20));
    return usual + (between_threads == mine ? 0 : 1);  // somebody else wrote
  }
  return usual;
}

// Copies a vertex: x y z and 1, where no w is given.
void copy(const Call& call, const float* from, float* to) {
  const std::size_t dimension = call.dimension();
  std::memcpy(to, from, dimension * sizeof(float));
  if (dimension == 3) to[3] = 1;
  std::memcpy(to + 4, from + dimension, call.task.attributes * sizeof(float));
}

std::int32_t clip(const clipscope_task* task, clipscope_answer* answer) {
  const Call call{*task, *answer};
  ++calls;
  std::size_t written = 0;
  bool met_another = false;
  for (std::size_t i = 0; i < task->count; ++i) {
    const std::size_t first = call.first(i), end = call.first(i + 1);
    const float* from = task->floats + first * task->stride;
    const bool is_marked = *from == kMarker;
    if (is_marked && is("error")) return 7;
    if (is_marked && is("crash_after_another") && met_another) std::abort();
    if (is_marked && is("too_many")) {
      for (int v = 0; v < 30 && written < answer->capacity; ++v) {
        copy(call, from, answer->floats + written++ * answer->stride);
      }
      answer->ends[i] = i == 0 ? 30 : answer->ends[i - 1] + 30;
      continue;
    }
    for (std::size_t v = first; v < end; ++v, ++written) {
      if (is_marked && is("unwritten")) continue;
      copy(call, from + (v - first) * task->stride, answer->floats + written * answer->stride);
    }
    const std::size_t at = (written - (end - first)) * answer->stride;
    answer->ends[i] = written;
    if (is_marked) {
      if (!is("unwritten")) answer->floats[at] = first_number(*from);
      misbehave(call, i, at);
    }
    before = *from;
    met_another = true;
  }
  return CLIPSCOPE_DONE;
}

std::uint32_t capabilities() {
  std::uint32_t bits = CLIPSCOPE_FLOAT | CLIPSCOPE_TRIANGLES | CLIPSCOPE_CLIP_SPACE |
                       CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE | CLIPSCOPE_DEPTH_ZERO_TO_ONE;
  if (is("none")) bits |= CLIPSCOPE_POINTS | CLIPSCOPE_SEGMENTS | CLIPSCOPE_POLYGONS;
  if (is("races")) bits |= CLIPSCOPE_THREAD_SAFE;
  if (is("in_clip_space")) return bits | CLIPSCOPE_ANSWERS_IN_CLIP_SPACE;
  if (is("no_primitive")) return CLIPSCOPE_FLOAT | CLIPSCOPE_VIEW_SPACE;
  if (is("unknown_bits")) return bits | 1u << 30;
  return bits | CLIPSCOPE_VIEW_SPACE;
}

}  // namespace

const clipscope_plugin* clipscope_plugin_entry(std::uint32_t) {
  static const std::string name = is("bad_name") ? "Not A Name" : "test/" + behaviour();
  static clipscope_plugin plugin = {sizeof(clipscope_plugin),
                                    CLIPSCOPE_PLUGIN_ABI,
                                    name.c_str(),
                                    nullptr,
                                    nullptr,
                                    capabilities(),
                                    32,
                                    clip};
  if (is("crash_at_once")) std::abort();
  if (is("other_version")) plugin.abi_version = 99;
  if (is("no_version")) return nullptr;
  if (is("too_small")) plugin.struct_size = 8;
  if (is("many_attributes")) plugin.most_attributes = 33;
  return &plugin;
}
