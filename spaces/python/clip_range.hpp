// SPDX-License-Identifier: MIT
//
// One clipper over many primitives: the loop that a call from Python runs.
#pragma once

#include <algorithm>
#include <array>

#include "spaces/clipper.hpp"
#include "spaces/python/rows.hpp"
#include "spaces/python/task.hpp"

namespace clipscope::python {

// number(i): coordinate i.
template <Space S, class T, class F>
Position<S, T> position_of(const F& number) {
  if constexpr (S == Space::view) {
    return Vec3<T>(number(0), number(1), number(2));
  } else {
    return Vec4<T>(number(0), number(1), number(2), number(3));
  }
}

// Primitives are read in blocks, so that the reading is compiled once for all clippers. Those that
// are packed are read in the loop of each clipper instead, as a C++ program does: by up to 20 %
// faster.
inline constexpr std::size_t kBlockOfPrimitives = 16;

// Reads primitives as vertices of space S. Attributes that K has beyond those of the task are 0.
template <Space S, class T, int K, std::size_t N>
class Reader {
 public:
  explicit Reader(const Task<T>& task) : task_(task) {
    for (Simplex<S, T, K, N>& primitive : block_) {
      for (std::size_t v = 0; v < N; ++v) {
        auto& numbers = primitive[v].attributes;
        numbers.resize(task.numbers());
        for (int k = 0; k < numbers.size(); ++k) numbers[k] = T(0);
        if (task.weights > 0) numbers[task.attribute_count + static_cast<int>(v)] = T(1);
      }
    }
  }

  // `count` primitives from `first` on. Pre-condition: 0 < count <= kBlockOfPrimitives.
  [[gnu::noinline]] const Simplex<S, T, K, N>* operator()(std::size_t first, std::size_t count) {
    const auto as_is = [](const auto& number) { return position_of<S, T>(number); };
    if constexpr (S == Space::clip) {
      const auto by = [](const auto& to_clip_space) {
        return [&to_clip_space](const auto& number) {
          return to_clip(to_clip_space, position_of<Space::view, T>(number));
        };
      };
      // Copies, which no store to the block can change.
      if (task_.projection) {
        const Projection<T> projection = *task_.projection;
        read_packed_or_not(first, count, by(projection));
      } else if (task_.matrix) {
        const MatrixRows<T> matrix = *task_.matrix;
        read_packed_or_not(first, count, by(matrix));
      } else {
        read_packed_or_not(first, count, as_is);
      }
    } else {
      read_packed_or_not(first, count, as_is);
    }
    return block_.data();
  }

  // Whether primitives are as the arrays have them: in space S, K attributes, number after number.
  bool are_packed() const {
    const bool as_they_are = S == Space::view || (!task_.projection && !task_.matrix);
    return as_they_are && task_.weights == 0 && has_packed_numbers();
  }
  // Pre-condition: they are packed.
  void read_packed(std::size_t i, Simplex<S, T, K, N>& primitive) const {
    if constexpr (K != kRunTime) {
      for (std::size_t v = 0; v < N; ++v) {
        const T* const at = task_.positions.template at<T>(i, v);
        primitive[v].position = position_of<S, T>([&](int c) { return at[c]; });
        const T* const beside = task_.attributes.template at<T>(i, v);
        for (int k = 0; k < K; ++k) primitive[v].attributes[k] = beside[k];
      }
    }
  }

 private:
  bool has_packed_numbers() const {
    return task_.attribute_count == K && task_.positions.number == sizeof(T) &&
           (K == 0 || task_.attributes.number == sizeof(T));
  }

  template <class P>
  void read_packed_or_not(std::size_t first, std::size_t count, const P& position) {
    if (has_packed_numbers()) {
      const auto next = [](const Layout&, const T* from, int i) { return from[i]; };
      read<K>(first, count, position, next);
    } else {
      const auto next = [](const Layout& l, const T* from, int i) { return l.next(from, i); };
      read<kRunTime>(first, count, position, next);
    }
  }

  // next(layout, from, i): number i of a vertex; position(next of a vertex) its position.
  // kAttributes: how many, or kRunTime.
  template <int kAttributes, class P, class F>
  void read(std::size_t first, std::size_t count, const P& position, const F& next) {
    const int attributes = kAttributes == kRunTime ? task_.attribute_count : kAttributes;
    const Layout positions = task_.positions, values = task_.attributes;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t v = 0; v < N; ++v) {
        auto& vertex = block_[i][v];
        const T* const at = positions.at<T>(first + i, v);
        vertex.position = position([&](int c) { return next(positions, at, c); });
        const T* const beside = values.at<T>(first + i, v);
        for (int k = 0; k < attributes; ++k) vertex.attributes[k] = next(values, beside, k);
      }
    }
  }

  const Task<T>& task_;
  std::array<Simplex<S, T, K, N>, kBlockOfPrimitives> block_;
};

// kNumbers: those of a vertex behind its position, or kRunTime for `numbers`.
template <int kNumbers, class Vertices, class T>
void add_polygon(const Vertices& polygon, std::size_t primitive, int numbers, Rows<T>& out) {
  const auto count = static_cast<std::size_t>(polygon.size());
  T* to = out.numbers.room(count * out.stride);
  for (const auto& v : polygon) {
    for (int c = 0; c < 4; ++c) *to++ = v.position[c];
    for (int k = 0; k < (kNumbers == kRunTime ? numbers : kNumbers); ++k) *to++ = v.attributes[k];
  }
  out.end_polygon(count, primitive);
}

// C against the task, in the space of the vertices; points have their size in clip space.
template <class C, Space S, class T, int K, std::size_t N>
void clip_one(const Task<T>& task, const Simplex<S, T, K, N>& primitive, NdcPolygon<T, K>& out) {
  if constexpr (S == Space::view) {
    C{}(*task.projection, primitive, out);
  } else if constexpr (N == 1) {
    C{}(task.volume, primitive, task.point_size, out);
  } else {
    C{}(task.volume, primitive, out);
  }
}

// Pre-conditions: task.numbers() is at most K, or K is kRunTime; S is view only where a task has a
// projection.
template <class C, Space S, class T, int K, std::size_t N>
void clip_range(const Task<T>& task, std::size_t first, std::size_t last, Rows<T>& out) {
  Reader<S, T, K, N> read(task);
  const bool are_packed = read.are_packed();
  Simplex<S, T, K, N> packed;
  const Simplex<S, T, K, N>* block = nullptr;
  NdcPolygon<T, K> polygon;
  const int numbers = task.numbers();
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t place = (i - first) % kBlockOfPrimitives;
    if (are_packed) {
      read.read_packed(i, packed);
    } else if (place == 0) {
      block = read(i, std::min(kBlockOfPrimitives, last - i));
    }
    clip_one<C>(task, are_packed ? packed : block[place], polygon);
    if (polygon.empty()) continue;
    if (numbers == K) {
      add_polygon<K>(polygon, i, K, out);
    } else {
      add_polygon<kRunTime>(polygon, i, numbers, out);
    }
  }
}

}  // namespace clipscope::python
