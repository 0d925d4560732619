// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds vertices of a mesh that have the same bits, in a hash table of indices that takes some 10
// bytes per vertex that stays.
//
// Source: Knuth, "The Art of Computer Programming", volume 3, section 6.4, algorithm L (linear
// probing).
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// A set of numbers 0, 1, 2, … of things that differ.
class NumberedSet {
 public:
  // The number of the thing that equals a new one, by a hash and a test of equality with a number;
  // the next number if there is none, which the thing has from now on. hash_of: of a number.
  template <class Equals, class HashOf>
  std::uint32_t add(std::uint64_t hash, const Equals& equals, const HashOf& hash_of) {
    if (2 * (std::size_t{size_} + 1) > slots_.size()) grow(hash_of);
    std::size_t slot = place_of(hash);
    while (slots_[slot] != kEmpty) {
      if (equals(slots_[slot])) return slots_[slot];
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slots_[slot] = size_++;
  }

  std::uint32_t size() const { return size_; }

 private:
  static constexpr std::uint32_t kEmpty = UINT32_MAX;

  std::size_t place_of(std::uint64_t hash) const {
    return static_cast<std::size_t>(hash >> (64 - std::countr_zero(slots_.size())));
  }

  template <class HashOf>
  void grow(const HashOf& hash_of) {
    slots_.assign(std::max<std::size_t>(16, 2 * slots_.size()), kEmpty);
    for (std::uint32_t i = 0; i < size_; ++i) {
      std::size_t slot = place_of(hash_of(i));
      while (slots_[slot] != kEmpty) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = i;
    }
  }

  std::vector<std::uint32_t> slots_;  // a power of two, at most half of them in use
  std::uint32_t size_ = 0;
};

// Of an array of numbers, by its bits.
template <class Array>
std::uint64_t bit_hash(const Array& values, std::uint64_t hash = 0) {
  for (const auto value : values) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof value);
    hash = (std::rotl(hash, 23) ^ bits) * 0x9E3779B97F4A7C15u;
  }
  return hash;
}

template <class Array>
bool have_same_bits(const Array& a, const Array& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// The number of values that differ in a bit.
template <class Array>
std::size_t count_distinct(const std::vector<Array>& values) {
  NumberedSet distinct;
  std::vector<std::uint32_t> first;  // of each number, the index of its value
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const std::uint32_t number = distinct.add(
        bit_hash(values[i]),
        [&](std::uint32_t n) { return have_same_bits(values[first[n]], values[i]); },
        [&](std::uint32_t n) { return bit_hash(values[first[n]]); });
    if (number == first.size()) first.push_back(i);
  }
  return first.size();
}

// The vertices of a mesh that are kept, moved down to its beginning.
class EqualVertices {
 public:
  explicit EqualVertices(Mesh& mesh) : mesh_(mesh) {}

  // The new index of vertex i. To be called with rising i, so that vertices only ever move down,
  // onto places that have been read already.
  std::uint32_t keep(std::size_t i) {
    const std::uint32_t index = kept_.add(
        hash_of(i), [&](std::uint32_t n) { return are_equal(n, i); },
        [&](std::uint32_t n) { return hash_of(n); });
    const auto move = [&](auto& values) {
      if (!values.empty()) values[index] = values[i];
    };
    move(mesh_.positions);
    move(mesh_.double_positions);
    move(mesh_.attributes);
    return index;
  }

  void drop_others() {
    const auto shrink = [this](auto& values) {
      if (values.empty()) return;
      values.resize(kept_.size());
      values.shrink_to_fit();
    };
    shrink(mesh_.positions);
    shrink(mesh_.double_positions);
    shrink(mesh_.attributes);
  }

 private:
  std::uint64_t hash_of(std::size_t i) const {
    const std::uint64_t hash = mesh_.double_positions.empty() ? bit_hash(mesh_.positions[i])
                                                              : bit_hash(mesh_.double_positions[i]);
    return mesh_.attributes.empty() ? hash : bit_hash(mesh_.attributes[i], hash);
  }

  bool are_equal(std::size_t a, std::size_t b) const {
    const auto equal = [=](const auto& values) {
      return values.empty() || have_same_bits(values[a], values[b]);
    };
    return equal(mesh_.positions) && equal(mesh_.double_positions) && equal(mesh_.attributes);
  }

  Mesh& mesh_;
  NumberedSet kept_;
};

}  // namespace clipscope::experiments
