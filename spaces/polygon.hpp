// SPDX-License-Identifier: MIT
//
// Polygon: a convex polygon of fixed capacity that lives on the stack; nothing is allocated. A
// clipped segment is a polygon of two vertices, a clipped point one of one.
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

// A list of at most kMaxPolygonVertices vertices of type V.
template <class V>
class VertexList {
 public:
  using VertexType = V;

  constexpr VertexList() = default;
  // A copy costs what is in the list, not what it could hold.
  constexpr VertexList(const VertexList& other) { *this = other; }
  constexpr VertexList& operator=(const VertexList& other) {
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
  template <std::size_t N>
  constexpr void assign(const std::array<VertexType, N>& primitive) {
    clear();
    for (const VertexType& v : primitive) push_back(v);
  }
  // Drops all but the first `size` vertices. Pre-condition: there are as many.
  constexpr void truncate(int size) { size_ = size; }
  // Fewer vertices than the primitive needs (three for a polygon) enclose nothing: what degenerated
  // to a point or a segment becomes the empty list.
  constexpr void drop_if_degenerate(int needed = 3) {
    if (size_ < needed) clear();
  }

 private:
  std::array<VertexType, kMaxPolygonVertices> vertices_;
  int size_ = 0;
  bool overflowed_ = false;
};

template <Space S, Scalar T, int K>
using Polygon = VertexList<Vertex<S, T, K>>;

// Clippers are total: where a result overflowed on its way, nothing is drawn rather than a NaN or
// an infinite x, y or z.
template <Scalar T, int K>
constexpr void clear_if_overflowed(Polygon<Space::ndc, T, K>& polygon) {
  for (const NdcVertex<T, K>& v : polygon) {
    const auto& p = v.position;
    if (!(is_finite(p[0]) && is_finite(p[1]) && is_finite(p[2])) || is_nan(p[3])) {
      polygon.clear();
      return;
    }
  }
}

template <Scalar T, int K>
using ViewPolygon = Polygon<Space::view, T, K>;
template <Scalar T, int K>
using ClipPolygon = Polygon<Space::clip, T, K>;
template <Scalar T, int K>
using NdcPolygon = Polygon<Space::ndc, T, K>;

}  // namespace clipscope
