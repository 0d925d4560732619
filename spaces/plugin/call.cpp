// SPDX-License-Identifier: MIT
#include "spaces/plugin/call.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <type_traits>

#include "spaces/projection.hpp"

namespace clipscope::plugin {
namespace {

// What lies in front of the output is known, so that it is seen if it is written to.
constexpr std::size_t kCanaryBytes = 64;
constexpr unsigned char kCanary = 0xc5;

std::span<unsigned char> canary(const Guarded& area, void* output) {
  auto* end = static_cast<unsigned char*>(output);
  const std::size_t room = static_cast<std::size_t>(end - area.begin());
  return {end - std::min(room, kCanaryBytes), end};
}

void set(std::span<unsigned char> canary) { std::ranges::fill(canary, kCanary); }
bool is_alive(std::span<unsigned char> canary) {
  return std::ranges::all_of(canary, [](unsigned char c) { return c == kCanary; });
}

// The last so many of an area.
template <class T>
T* last(const Guarded& area, std::size_t count) {
  return reinterpret_cast<T*>(area.end() - count * sizeof(T));
}

template <class T>
MatrixRows<T> matrix_of(const clipscope_task& task) {
  MatrixRows<T> rows;
  for (std::size_t i = 0; i < 16; ++i) {
    rows[i / 4][static_cast<int>(i % 4)] = static_cast<T>(task.matrix[i]);
  }
  return rows;
}

// Its rows alone: as a projection of the frustum has them, whose zeros are not multiplied by.
template <class T>
Projection<T> projection_of(const clipscope_task& task) {
  const MatrixRows<T> m = matrix_of<T>(task);
  Projection<T> p;
  p.x = {m[0][0], m[0][2], m[0][3]};
  p.y = {m[1][1], m[1][2], m[1][3]};
  p.z = {T(0), m[2][2], m[2][3]};
  p.w = {T(0), m[3][2], m[3][3]};
  return p;
}

template <class T, class P>
void project(const P& projection, const clipscope_task& task, const T* from, T* to) {
  for (std::size_t v = 0; v < task.vertices; ++v) {
    const Vec4<T> p = to_clip(projection, Vec3<T>(from[0], from[1], from[2]));
    for (int i = 0; i < 4; ++i) *to++ = p[i];
    to = std::copy_n(from + 3, task.attributes, to);
    from += task.stride;
  }
}

// The input in clip space, in memory that the plug-in can't write.
template <class T>
const T* projected(const Request& request, const T* numbers, TwoFaced& memory) {
  const clipscope_task& task = request.task;
  const std::size_t bytes = task.vertices * (task.stride + 1) * sizeof(T);
  if (!memory.reserve(bytes)) return nullptr;
  T* to = static_cast<T*>(memory.last_to_write(bytes));
  if (request.by_matrix) {
    project(matrix_of<T>(task), task, numbers, to);
  } else {
    project(projection_of<T>(task), task, numbers, to);
  }
  return static_cast<const T*>(memory.last_to_read(bytes));
}

// Divides in place. (0, 0, 0, 0), outside by definition, is left out; any other w is divided by.
template <class T>
void divide(const clipscope_task& task, const clipscope_answer& answer, T* numbers) {
  T* to = numbers;
  std::size_t from = 0, kept = 0;
  for (std::size_t i = 0; i < task.count; ++i) {
    for (; from < answer.ends[i]; ++from) {
      const T* v = numbers + from * answer.stride;
      const Vec4<T> clip(v[0], v[1], v[2], v[3]);
      if (clip == Vec4<T>(T(0))) continue;
      const Vec4<T> ndc = to_ndc(clip);
      for (int k = 0; k < 4; ++k) to[k] = ndc[k];
      if (to != v) std::copy(v + 4, v + answer.stride, to + 4);
      to += answer.stride;
      ++kept;
    }
    answer.ends[i] = kept;
  }
}

Result first_malformed(const clipscope_task& task, const clipscope_answer& answer) {
  std::size_t before = 0;
  for (std::size_t i = 0; i < task.count; ++i) {
    const std::size_t end = answer.ends[i];
    if (end < before) return {.fault = Fault::ends_descend, .at = i};
    if (end - before > answer.most_vertices) {
      return {.fault = Fault::too_many_vertices, .at = i, .vertices = end - before};
    }
    before = end;
  }
  return {};
}

template <class T>
void set_numbers(const T* numbers, clipscope_task& task) {
  if constexpr (std::is_same_v<T, float>) task.floats = numbers;
  if constexpr (std::is_same_v<T, double>) task.doubles = numbers;
}
template <class T>
void set_numbers(T* numbers, clipscope_answer& answer) {
  if constexpr (std::is_same_v<T, float>) answer.floats = numbers;
  if constexpr (std::is_same_v<T, double>) answer.doubles = numbers;
}

template <class T>
clipscope_task task_of(const Request& request, const Memory& memory, Output& output) {
  clipscope_task task = request.task;
  const auto* numbers =
      reinterpret_cast<const T*>(memory.inputs[request.input].begin() + request.input_at);
  if (request.projects) {
    numbers = projected(request, numbers, output.projected);
    task.space = CLIPSCOPE_CLIP_SPACE;
    ++task.stride;
  }
  if (task.space == CLIPSCOPE_CLIP_SPACE) {
    task.frustum = {};
    std::ranges::fill(task.matrix, 0.0);
  }
  set_numbers(numbers, task);
  if (task.primitive == CLIPSCOPE_POLYGONS) {
    task.ends = last<std::size_t>(memory.input_ends, task.count);
  }
  return task;
}

template <class T>
Result call_in(const clipscope_plugin& plugin, const Request& request, const Memory& memory,
               Output& output) {
  const clipscope_task task = task_of<T>(request, memory, output);
  clipscope_answer answer{};
  answer.struct_size = sizeof answer;
  answer.stride = 4 + task.attributes;
  answer.most_vertices = request.most_vertices;
  answer.capacity = task.count * answer.most_vertices;
  T* const numbers = last<T>(output.numbers, answer.capacity * answer.stride);
  set_numbers(numbers, answer);
  answer.ends = last<std::size_t>(output.ends, task.count);
  const auto in_front = canary(output.numbers, numbers), of_ends = canary(output.ends, answer.ends);
  set(in_front);
  set(of_ends);
  const clipscope_answer given = answer;  // a plug-in may use its own as it likes
  const std::int32_t code = plugin.clip(&task, &answer);
  if (!is_alive(in_front) || !is_alive(of_ends)) return {.fault = Fault::wrote_before_output};
  if (code != CLIPSCOPE_DONE) return {.fault = Fault::returned_error, .code = code};
  const Result malformed = first_malformed(task, given);
  if (malformed.fault != Fault::none) return malformed;
  if (plugin.capabilities & CLIPSCOPE_ANSWERS_IN_CLIP_SPACE) divide(task, given, numbers);
  return {};
}

}  // namespace

Result call(const clipscope_plugin& plugin, const Request& request, const Memory& memory,
            Output& output) {
  return request.task.scalar == CLIPSCOPE_FLOAT ? call_in<float>(plugin, request, memory, output)
                                                : call_in<double>(plugin, request, memory, output);
}

}  // namespace clipscope::plugin
