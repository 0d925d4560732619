// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons one after the other, as clippers write them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "spaces/polygon.hpp"

namespace clipscope::experiments {

// Cleared and filled again, it keeps its memory and, for exact types, that of its numbers.
template <Scalar T, int K, Space S = Space::ndc>
class PolygonStream {
 public:
  void clear() {
    used_ = 0;
    ends_.clear();
    overflowed_ = false;
  }
  void append(const Polygon<S, T, K>& polygon) {
    if (vertices_.size() < used_ + kMaxPolygonVertices) {
      vertices_.resize(2 * vertices_.size() + kMaxPolygonVertices);
    }
    std::copy(polygon.begin(), polygon.end(), vertices_.data() + used_);
    used_ += static_cast<std::size_t>(polygon.size());
    ends_.push_back(used_);
    overflowed_ = overflowed_ || polygon.overflowed();
  }
  std::size_t size() const { return ends_.size(); }
  // Whether a polygon had more vertices than a clipper has room for.
  bool overflowed() const { return overflowed_; }
  std::span<const Vertex<S, T, K>> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return {vertices_.data() + begin, ends_[i] - begin};
  }

 private:
  std::vector<Vertex<S, T, K>> vertices_;
  std::vector<std::size_t> ends_;  // polygon i has the vertices [ends[i - 1], ends[i])
  std::size_t used_ = 0;
  bool overflowed_ = false;
};

}  // namespace clipscope::experiments
