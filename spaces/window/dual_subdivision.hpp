// SPDX-License-Identifier: MIT
//
// The lines of the plane, divided into cells, and for each cell the edges of a convex window that
// its lines can cross.
//
// A line v = k u + q is the point (k, q) of the dual plane; u is x for lines nearer to horizontal,
// else y, so that |k| <= 1. Both halves of the dual plane are divided into n x n cells. In a strip
// of cells between two slopes an edge can be crossed for the q of its ends and what lies between,
// and it is listed in the cells there: 2 n N steps to prepare. With n in proportion to N a cell
// holds a number of edges that does not grow with N, but where lines touch the window.
// Numbers: cells and lists are made in double, each strip and each list wider by 1/16 of a cell
// than need be.
// Does not guarantee: that a cell lists all edges of a line that rounding moves by more than that,
// as it does where a segment begins some 1e4 times as far away as the window is large (float).
#pragma once

#include <cstdint>
#include <vector>

#include "spaces/counting.hpp"
#include "spaces/rounding.hpp"
#include "spaces/window/convex_window.hpp"

namespace clipscope {

// The number that decides a cell. Exact scalars have none that is cheap.
template <std::floating_point T>
constexpr double to_double(const T& x) {
  return static_cast<double>(x);
}
template <std::floating_point T>
constexpr double to_double(const Counting<T>& x) {
  return static_cast<double>(x.value());
}

template <class T>
concept HasDualSubdivision = Scalar<T> && requires(const T& x) {
  { to_double(x) } -> std::same_as<double>;
};

template <Scalar T>
class DualSubdivision {
 public:
  using Edges = std::span<const std::uint32_t>;

  // cells: along each axis of each half.
  DualSubdivision(const ConvexWindow<T>& window, std::size_t cells) requires HasDualSubdivision<T>
      : cells_(cells) {
    for (int c = 0; c < 2; ++c) {
      double sum = 0;
      for (std::size_t i = 0; i < window.size(); ++i) sum += to_double(window.vertex(i)[c]);
      centre_[c] = T(rounded_to_float(sum / static_cast<double>(window.size())));
    }
    double reach = 0;
    for (std::size_t i = 0; i < window.size(); ++i) {
      reach = std::max(reach, std::abs(offset(window, i, 0)) + std::abs(offset(window, i, 1)));
    }
    reach_ = T(rounded_to_float(reach * 1.0001));
    cells_per_slope_ = T(static_cast<float>(cells)) / T(2);
    cells_per_offset_ = cells_per_slope_ / reach_;
    starts_.assign(2 * cells * cells + 1, 0);
    for_each_entry(window, [&](std::size_t cell, std::size_t) { ++starts_[cell + 1]; });
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    edges_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for_each_entry(window, [&](std::size_t cell, std::size_t edge) {
      edges_[next[cell]++] = static_cast<std::uint32_t>(edge);
    });
  }

  // The edges, in ascending order, that the line of a segment can cross. None for a segment of no
  // length or with a coordinate that is not finite. One division.
  constexpr Edges edges(const Segment2<T>& segment) const {
    Vec2<T> d, size;
    for (int c = 0; c < 2; ++c) {
      d[c] = segment[1][c] - segment[0][c];
      size[c] = d[c] < T(0) ? T(-d[c]) : d[c];
    }
    const int u = size[1] <= size[0] ? 0 : 1, v = 1 - u;
    if (!(T(0) < size[u])) return {};
    const T k = d[v] / d[u];
    const T q = (segment[0][v] - centre_[v]) - k * (segment[0][u] - centre_[u]);
    const double slope_place = to_double(T((k + T(1)) * cells_per_slope_));
    const double offset_place = to_double(T((q + reach_) * cells_per_offset_));
    const auto cells = static_cast<double>(cells_);
    if (!(0 <= slope_place && 0 <= offset_place && offset_place < cells)) return {};
    const std::size_t strip = std::min(static_cast<std::size_t>(slope_place), cells_ - 1);
    const std::size_t cell = cell_of(u, strip, static_cast<std::size_t>(offset_place));
    return Edges(edges_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
  }

 private:
  static constexpr double kMargin = 1.0 / 16;  // in cells

  constexpr std::size_t cell_of(int half, std::size_t strip, std::size_t place) const {
    return (static_cast<std::size_t>(half) * cells_ + strip) * cells_ + place;
  }

  double offset(const ConvexWindow<T>& window, std::size_t vertex, int c) const {
    return to_double(window.vertex(vertex)[c]) - to_double(centre_[c]);
  }

  struct Range {
    double low, high;
  };

  // The offsets of lines with slopes in a range that cross an edge.
  Range offsets(const ConvexWindow<T>& window, std::size_t edge, int half,
                const Range& slopes) const {
    Range r{2 * to_double(reach_), -2 * to_double(reach_)};
    for (const std::size_t end : {edge, window.wrapped(edge + 1)}) {
      for (const double k : {slopes.low, slopes.high}) {
        const double q = offset(window, end, 1 - half) - k * offset(window, end, half);
        r = {std::min(r.low, q), std::max(r.high, q)};
      }
    }
    return r;
  }

  // Calls f(cell, edge) for each edge in each cell that lists it, by ascending edges.
  template <class F>
  void for_each_entry(const ConvexWindow<T>& window, F&& f) const {
    const auto n = static_cast<double>(cells_);
    const auto place = [&](double offset, double margin) {
      const double cells = (offset / to_double(reach_) + 1) * n / 2 + margin;
      return static_cast<std::size_t>(std::clamp(cells, 0.0, n - 1));
    };
    for (std::size_t row = 0; row < 2 * cells_; ++row) {
      const int half = row < cells_ ? 0 : 1;
      const std::size_t strip = row % cells_;
      const double from = 2 * (static_cast<double>(strip) - kMargin) / n - 1;
      const Range slopes{from, from + 2 * (1 + 2 * kMargin) / n};
      for (std::size_t edge = 0; edge < window.size(); ++edge) {
        const Range q = offsets(window, edge, half, slopes);
        const std::size_t last = place(q.high, kMargin);
        for (std::size_t i = place(q.low, -kMargin); i <= last; ++i) {
          f(cell_of(half, strip, i), edge);
        }
      }
    }
  }

  std::size_t cells_;
  Vec2<T> centre_;
  T reach_, cells_per_slope_, cells_per_offset_;
  std::vector<std::uint32_t> starts_,
      edges_;  // of cell c: edges_ from starts_[c] to starts_[c + 1]
};

}  // namespace clipscope
