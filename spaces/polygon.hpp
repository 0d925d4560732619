// SPDX-License-Identifier: MIT
//
// Polygon: a convex polygon of fixed capacity that lives on the stack; nothing is allocated.
//
// A triangle cut by n planes has at most 3 + n vertices. The capacity covers the six planes of the
// volume, eight user planes and a guard plane for w, with room left for the extra crossings that
// rounding can invent. What still does not fit is dropped and `overflowed` says so: clippers are
// total, and a failure is data.
#pragma once

#include <algorithm>
#include <array>

#include "spaces/vertex.hpp"

namespace clipscope {

inline constexpr int kMaxPolygonVertices = 24;

template <Space S, Scalar T, int K>
class Polygon {
 public:
  using VertexType = Vertex<S, T, K>;

  constexpr Polygon() = default;
  // A copy costs what is in the polygon, not what it could hold.
  constexpr Polygon(const Polygon& other) { *this = other; }
  constexpr Polygon& operator=(const Polygon& other) {
    std::copy(other.begin(), other.end(), vertices_.begin());
    size_ = other.size_;
    overflowed_ = other.overflowed_;
    return *this;
  }

  constexpr int size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr bool overflowed() const { return overflowed_; }

  constexpr VertexType& operator[](int i) { return vertices_[i]; }
  constexpr const VertexType& operator[](int i) const { return vertices_[i]; }
  constexpr const VertexType* begin() const { return vertices_.data(); }
  constexpr const VertexType* end() const { return vertices_.data() + size_; }

  constexpr void clear() {
    size_ = 0;
    overflowed_ = false;
  }
  constexpr void push_back(const VertexType& v) {
    if (size_ < kMaxPolygonVertices) {
      vertices_[size_++] = v;
    } else {
      overflowed_ = true;
    }
  }
  constexpr void assign(const Triangle<S, T, K>& triangle) {
    clear();
    for (const VertexType& v : triangle) {
      push_back(v);
    }
  }
  // Fewer than three vertices enclose nothing: a polygon that degenerated to a point or a segment
  // becomes the empty one.
  constexpr void drop_if_degenerate() {
    if (size_ < 3) {
      clear();
    }
  }

 private:
  std::array<VertexType, kMaxPolygonVertices> vertices_;
  int size_ = 0;
  bool overflowed_ = false;
};

template <Scalar T, int K>
using ViewPolygon = Polygon<Space::view, T, K>;
template <Scalar T, int K>
using ClipPolygon = Polygon<Space::clip, T, K>;
template <Scalar T, int K>
using NdcPolygon = Polygon<Space::ndc, T, K>;

}  // namespace clipscope
