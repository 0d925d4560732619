// SPDX-License-Identifier: MIT
//
// A hierarchy of bounding volumes over a triangle mesh, held against the view volume: of boxes,
// spheres or oriented boxes.
//
// Oriented boxes: Gottschalk, Lin and Manocha, "OBBTree: A Hierarchical Structure for Rapid
// Interference Detection", SIGGRAPH 1996; here along the principal axes of the vertices. The tree
// is the same for every kind of volume, which is then all that differs.
//
// Nodes lie in one array in depth-first order; a node whose subtree needs no look leads to the node
// after it, so that a query needs no stack: Smits, "Efficiency Issues for Ray Tracing", Journal of
// Graphics Tools 3(2), 1998. Split at the median of the triangles' middles along the longest side
// of their box. Planes that a volume is inside of are not tested again below it (Assarsson and
// Moeller, 2000): all triangles of the subtree are inside of them, be the volumes below it or not.
//
// Guarantees: each range of triangles reported gets what visibility() promises, so a rejected range
// can be left out and an accepted one drawn without clipping. The ranges reported are all
// triangles, once each, in order. A query allocates nothing and does not recurse. A triangle with a
// NaN or infinite coordinate gets look_closer, in a leaf with its neighbours.
// Does not guarantee: a shape that is best for ray tracing; no surface area heuristic is at work.
#pragma once

#include <cassert>
#include <numeric>
#include <span>
#include <vector>

#include "spaces/bounds/enclose.hpp"
#include "spaces/bounds/visibility.hpp"

namespace clipscope {

// Triangles order()[first], ..., order()[first + count - 1] of a hierarchy.
struct TriangleRange {
  std::uint32_t first = 0, count = 0;
};

namespace bounds {

// The volume around all of the points.
template <std::floating_point T>
void set_around(std::span<const Vec3<T>> points, AxisBox<T>& box) {
  box = bounding_box(points);
}
template <std::floating_point T>
void set_around(std::span<const Vec3<T>> points, Sphere<T>& sphere) {
  sphere = bounding_sphere(points);
}
template <std::floating_point T>
void set_around(std::span<const Vec3<T>> points, OrientedBox<T>& box) {
  box = bounding_oriented_box(points);
}

}  // namespace bounds

// Volume: AxisBox<T>, Sphere<T> or OrientedBox<T>.
template <std::floating_point T, class Volume>
class Hierarchy {
 public:
  struct Node {
    Volume volume;
    TriangleRange range;
    std::uint32_t next = 0;  // the first node after the subtree; a leaf's is the one after it
    std::uint32_t level = 0;
  };

  // An upper bound of the levels: each halves the number of triangles, which has 32 bits.
  static constexpr std::uint32_t kMaxLevels = 34;

  Hierarchy() = default;

  // Triangle i has the positions of indices 3 i, 3 i + 1 and 3 i + 2. Allocates.
  // Pre-conditions: every index < positions.size(); indices.size() is a multiple of 3 and below
  // 2^32; leaf_size >= 1.
  Hierarchy(std::span<const Vec3<T>> positions, std::span<const std::uint32_t> indices,
            std::uint32_t leaf_size = 8) {
    assert(indices.size() % 3 == 0 && leaf_size >= 1);
    const auto count = static_cast<std::uint32_t>(indices.size() / 3);
    std::vector<AxisBox<T>> boxes;
    boxes.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::array<Vec3<T>, 3> triangle = corners_of(positions, indices, i);
      boxes.push_back(bounding_box(std::span<const Vec3<T>>(triangle)));
    }
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0u);
    if (count > 0) build(boxes, leaf_size);
    set_volumes(positions, indices);
  }

  const std::vector<Node>& nodes() const { return nodes_; }
  // Indices of the mesh's triangles: the order that ranges refer to.
  const std::vector<std::uint32_t>& order() const { return order_; }

  // Calls report(TriangleRange, Visibility) for ranges that together are all triangles, in order.
  template <class Report>
  void query(const CullingPlanes<T>& planes, Report&& report) const {
    std::array<PlaneMask, kMaxLevels> masks;  // of the node's ancestors, by level
    masks[0] = all_planes(planes);
    for (std::uint32_t i = 0; i < nodes_.size();) {
      const Node& node = nodes_[i];
      PlaneMask mask = masks[node.level];
      const Visibility answer = visibility(planes, node.volume, mask);
      const bool is_leaf = node.next == i + 1;
      if (answer != Visibility::look_closer || is_leaf) {
        report(node.range, answer);
        i = node.next;
      } else {
        masks[node.level + 1] = mask;
        ++i;
      }
    }
  }

 private:
  struct Task {
    TriangleRange range;
    std::uint32_t level;
  };

  void build(const std::vector<AxisBox<T>>& boxes, std::uint32_t leaf_size) {
    std::vector<Task> tasks = {{{0, static_cast<std::uint32_t>(order_.size())}, 0}};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      nodes_.push_back({{}, task.range, 0, task.level});
      const auto [first, count] = task.range;
      if (count > leaf_size) {
        split(boxes, task.range);
        const std::uint32_t half = count / 2;
        tasks.push_back({{first + half, count - half}, task.level + 1});
        tasks.push_back({{first, half}, task.level + 1});
      }
    }
    link(leaf_size);
  }

  // Puts the half of the triangles with the lesser middles first.
  void split(const std::vector<AxisBox<T>>& boxes, const TriangleRange& range) {
    const auto first = order_.begin() + range.first, last = first + range.count;
    AxisBox<T> box;
    for (auto i = first; i != last; ++i) box = enclose(box, boxes[*i]);
    int axis = 0;
    const auto side = [&](int i) { return T(0.5) * box.upper[i] - T(0.5) * box.lower[i]; };
    for (int i = 1; i < 3; ++i) axis = side(i) > side(axis) ? i : axis;
    // Not finite: all boxes of such triangles are infinite both ways; their middle is taken to be
    // 0.
    const auto middle = [&](std::uint32_t triangle) {
      const T m = T(0.5) * boxes[triangle].lower[axis] + T(0.5) * boxes[triangle].upper[axis];
      return std::isfinite(m) ? m : T(0);
    };
    std::nth_element(first, first + range.count / 2, last,
                     [&](std::uint32_t a, std::uint32_t b) { return middle(a) < middle(b); });
  }

  static std::array<Vec3<T>, 3> corners_of(std::span<const Vec3<T>> positions,
                                           std::span<const std::uint32_t> indices,
                                           std::uint32_t triangle) {
    const std::size_t first = std::size_t{3} * triangle;
    return {positions[indices[first]], positions[indices[first + 1]],
            positions[indices[first + 2]]};
  }

  // Each volume is made around the vertices below it, not around smaller volumes.
  void set_volumes(std::span<const Vec3<T>> positions, std::span<const std::uint32_t> indices) {
    std::vector<Vec3<T>> points;
    points.reserve(indices.size());
    for (const std::uint32_t triangle : order_) {
      const std::array<Vec3<T>, 3> corners = corners_of(positions, indices, triangle);
      points.insert(points.end(), corners.begin(), corners.end());
    }
    for (Node& node : nodes_) {
      const auto [first, count] = node.range;
      bounds::set_around(
          std::span<const Vec3<T>>(points).subspan(std::size_t{3} * first, std::size_t{3} * count),
          node.volume);
    }
  }

  // Sets `next`. The left child of node i is i + 1; the right one comes after the left one's
  // subtree.
  void link(std::uint32_t leaf_size) {
    for (auto i = static_cast<std::uint32_t>(nodes_.size()); i-- > 0;) {
      const bool is_leaf = nodes_[i].range.count <= leaf_size;
      nodes_[i].next = is_leaf ? i + 1 : nodes_[nodes_[i + 1].next].next;
    }
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

template <std::floating_point T>
using BoxHierarchy = Hierarchy<T, AxisBox<T>>;
template <std::floating_point T>
using SphereHierarchy = Hierarchy<T, Sphere<T>>;
template <std::floating_point T>
using OrientedBoxHierarchy = Hierarchy<T, OrientedBox<T>>;

}  // namespace clipscope
