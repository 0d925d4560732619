// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles for the plug-in that misbehaves (misbehaving.cpp), one of them or more marked.
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "experiments/guests/plugin.hpp"
#include "experiments/selection/select.hpp"

namespace clipscope::experiments {

inline constexpr float kMarker = 42;

// Each time a plug-in of its own: the name says what it does. Half a second for a batch.
inline const Contestant& misbehaving_guest(const char* behaviour, int vertices = 3) {
  setenv("CLIPSCOPE_MISBEHAVIOUR", behaviour, 1);
  const std::string name = std::string("test/") + behaviour;
  if (find_in_contract(name, "float", Contract::full, vertices) == nullptr) {
    add_plugin(CLIPSCOPE_MISBEHAVING, 0.5);
  }
  return find_contestant(name, "float", vertices);
}

// In clip space, without attributes. Triangle i starts at x = i / 128, the marked one at 42.
class MarkedBatch {
 public:
  MarkedBatch(std::size_t count, std::size_t marked) {
    for (std::size_t i = 0; i < count; ++i) {
      const float x = static_cast<float>(i) / 128;
      numbers_.insert(numbers_.end(), {x, 0, 0, 1, x + 1, 0, 0, 1, x, 1, 0, 1});
    }
    mark(marked);
  }
  void mark(std::size_t i) { numbers_[12 * i] = kMarker; }
  Batch batch() const {
    return {.space = Space::clip, .numbers = std::span<const float>(numbers_)};
  }

 private:
  std::vector<float> numbers_;
};

}  // namespace clipscope::experiments
