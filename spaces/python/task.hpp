// SPDX-License-Identifier: MIT
//
// What a call from Python asks: primitives in arrays of any layout, and what they are clipped by.
#pragma once

#include <cstddef>
#include <optional>

#include "spaces/point/points.hpp"
#include "spaces/projection.hpp"

namespace clipscope::python {

// Numbers in memory, with the bytes from one primitive, vertex and number to the next.
struct Layout {
  const char* data = nullptr;
  std::ptrdiff_t primitive = 0, vertex = 0, number = 0;

  template <class T>
  const T* at(std::size_t p, std::size_t v) const {
    return reinterpret_cast<const T*>(data + static_cast<std::ptrdiff_t>(p) * primitive +
                                      static_cast<std::ptrdiff_t>(v) * vertex);
  }
  template <class T>
  const T& next(const T* from, int i) const {
    return *reinterpret_cast<const T*>(reinterpret_cast<const char*>(from) + i * number);
  }
};

template <class T>
struct Task {
  std::size_t count = 0;  // primitives
  Layout positions, attributes;
  int attribute_count = 0;
  // Behind the attributes each vertex gets the weights of the primitive's vertices: 0 or as many as
  // the primitive has.
  int weights = 0;

  ClipVolume volume;
  // One of them where positions are x, y, z; none where they are x, y, z, w.
  std::optional<Projection<T>> projection;
  std::optional<MatrixRows<T>> matrix;
  PointSize<T> point_size;

  int numbers() const { return attribute_count + weights; }  // of a vertex behind its position
};

template <class T>
struct Rows;
// Clips the primitives [first, last) and adds what is left of them.
template <class T>
using ClipRange = void (*)(const Task<T>&, std::size_t first, std::size_t last, Rows<T>&);

}  // namespace clipscope::python
