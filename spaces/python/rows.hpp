// SPDX-License-Identifier: MIT
//
// The memory of results: what numpy arrays look at and what later calls use again.
//
// A result is never overwritten while an array looks at it: a call takes memory that nobody looks
// at, or new memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace clipscope::python {

// A vector whose room is not written before it is used.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() { std::free(data_); }

  const T* data() const { return data_; }
  T* data() { return data_; }
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  // Room for `count` more behind the last. Errors: std::bad_alloc.
  T* room(std::size_t count) {
    if (size_ + count > capacity_) grow(size_ + count);
    return data_ + size_;
  }
  // `count` of the room were written.
  void commit(std::size_t count) { size_ += count; }
  // Pre-condition: there is room.
  void push_back(const T& value) { data_[size_++] = value; }
  void append(const T* values, std::size_t count) {
    if (count == 0) return;
    std::memcpy(room(count), values, count * sizeof(T));
    commit(count);
  }

 private:
  void grow(std::size_t needed) {
    const std::size_t capacity = needed < 2 * capacity_ ? 2 * capacity_ : needed + 64;
    void* const grown = std::realloc(data_, capacity * sizeof(T));
    if (grown == nullptr) throw std::bad_alloc();
    data_ = static_cast<T*>(grown);
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

// Polygons one after the other: polygon i has the vertices [offsets[i], offsets[i + 1]) and comes
// from primitive source[i]. A vertex is a row of `stride` numbers.
template <class T>
struct Rows {
  Buffer<T> numbers;
  Buffer<std::int64_t> offsets, source;
  std::size_t stride = 4, vertices = 0;

  // At most so many polygons will be added.
  void begin(std::size_t numbers_per_vertex, std::size_t polygons) {
    stride = numbers_per_vertex;
    vertices = 0;
    numbers.clear();
    source.clear();
    source.room(polygons);
    offsets.clear();
    offsets.room(polygons + 1);
    offsets.push_back(0);
  }
  // `count` vertices, written to the room of `numbers`, are the polygon of the primitive.
  void end_polygon(std::size_t count, std::size_t primitive) {
    numbers.commit(count * stride);
    vertices += count;
    offsets.push_back(static_cast<std::int64_t>(vertices));
    source.push_back(static_cast<std::int64_t>(primitive));
  }
  void append(const Rows& next) {
    numbers.append(next.numbers.data(), next.numbers.size());
    source.append(next.source.data(), next.source.size());
    offsets.room(next.source.size());
    const auto shift = static_cast<std::int64_t>(vertices);
    for (std::size_t i = 1; i < next.offsets.size(); ++i) {
      offsets.push_back(next.offsets.data()[i] + shift);
    }
    vertices += next.vertices;
  }
};

// Blocks of memory that calls use in turn.
template <class Block>
class Pool {
 public:
  // One that nobody else looks at.
  std::shared_ptr<Block> take() {
    for (const std::shared_ptr<Block>& block : blocks_) {
      if (block.use_count() == 1) return block;
    }
    auto block = std::make_shared<Block>();
    if (blocks_.size() == kMost) blocks_.erase(blocks_.begin());
    blocks_.push_back(block);
    return block;
  }

 private:
  // The last result and the one in work, and some that are looked at for longer.
  static constexpr std::size_t kMost = 4;
  std::vector<std::shared_ptr<Block>> blocks_;
};

}  // namespace clipscope::python
