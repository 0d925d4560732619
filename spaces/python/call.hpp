// SPDX-License-Identifier: MIT
//
// From Python's arrays to tasks and from results to arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

#include "spaces/python/rows.hpp"
#include "spaces/python/task.hpp"

namespace clipscope::python {

namespace py = pybind11;

// An array that looks at memory of the block, which lives as long as the array does.
template <class T, class Block>
py::array view_of(const T* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                  const std::shared_ptr<Block>& block) {
  using Owner = std::shared_ptr<Block>;
  auto owner = std::make_unique<Owner>(block);
  const py::capsule base(owner.get(), [](void* p) { delete static_cast<Owner*>(p); });
  owner.release();
  // An empty array has no memory to look at.
  static const T kNothing{};
  return py::array(py::dtype::of<T>(), std::move(shape), std::move(strides),
                   data == nullptr ? &kNothing : data, base);
}

template <class T, class Block>
py::array view_of(const T* data, std::size_t count, const std::shared_ptr<Block>& block) {
  return view_of(data, {static_cast<py::ssize_t>(count)}, {static_cast<py::ssize_t>(sizeof(T))},
                 block);
}

template <class T, class Block>
py::array rows_of_numbers(const T* data, std::size_t rows, std::size_t columns,
                          const std::shared_ptr<Block>& block) {
  const auto width = static_cast<py::ssize_t>(columns);
  const auto size = static_cast<py::ssize_t>(sizeof(T));
  return view_of(data, {static_cast<py::ssize_t>(rows), width}, {width * size, size}, block);
}

// Of an array (primitives, vertices, numbers).
inline Layout layout_of(const py::array& array) {
  return {static_cast<const char*>(array.data()), array.strides(0), array.strides(1),
          array.strides(2)};
}

// Parts of [0, count) that threads do at once: at least `least` each, `threads` at most, as many as
// there are processors for threads = 0.
inline std::vector<std::size_t> parts_of(std::size_t count, int threads, std::size_t least) {
  const std::size_t wanted = threads > 0 ? static_cast<std::size_t>(threads)
                                         : std::max(1u, std::thread::hardware_concurrency());
  const std::size_t parts = std::clamp<std::size_t>(count / least, 1, wanted);
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i <= parts; ++i) begins.push_back(count * i / parts);
  return begins;
}

// Calls f(part) for all parts, each in a thread, the first in this one. Errors: the first one that
// f has.
template <class F>
void in_threads(std::size_t parts, const F& f) {
  std::vector<std::exception_ptr> errors(parts);
  const auto run = [&](std::size_t part) {
    try {
      f(part);
    } catch (...) {
      errors[part] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t part = 1; part < parts; ++part) threads.emplace_back(run, part);
  run(0);
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

// Adds what Python can call, beside module.cpp's own.
void add_batch(py::module_& module);

}  // namespace clipscope::python
