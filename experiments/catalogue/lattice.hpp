// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exhaustive lattices: all clip-space triangles whose vertices are in coordinates^3 x ws, one for
// each class of symmetric ones.
//
// A triangle is a multiset of three points: the order of vertices does not matter, repeated
// vertices are included. Two triangles are in one class if a symmetry of the volume takes one to
// the other: x negated, y negated, x and y exchanged, and, where the depth range is symmetric, z
// negated: a group of 8 or 16. The class is visited in its lexicographically first image (the
// canonical representative, as in orderly generation: McKay, "Isomorph-free exhaustive generation",
// 1998). A mirror image has the other winding, so that classes are not split by winding; a clipper
// must be tested separately for keeping it, and for not depending on the order of the vertices (see
// catalogue.hpp).
//
// Nothing is stored per triangle: chunks are visited independently, so that threads may share them,
// and what a chunk visits does not depend on the others.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "spaces/volume.hpp"

namespace clipscope::experiments {

using LatticePoint = std::array<float, 4>;  // x, y, z, w

struct LatticeTriangle {
  std::array<LatticePoint, 3> vertices;
  int class_size;  // the number of triangles that it stands for: 1 to 16
};

class Lattice {
 public:
  // Pre-conditions: coordinates hold with each value its negative; no value is there twice; at most
  // 65535 points.
  Lattice(std::span<const float> coordinates, std::span<const float> ws, DepthRange depth);

  DepthRange depth() const { return depth_; }
  std::size_t points() const { return points_.size(); }
  std::uint64_t triangles() const;  // n (n + 1) (n + 2) / 6
  std::uint64_t classes() const;    // by Burnside's lemma

  std::size_t chunks() const { return chunks_.size(); }

  // Calls visit(const LatticeTriangle&) for each class of the chunk, in a fixed order.
  template <class Visit>
  void visit_chunk(std::size_t chunk, Visit&& visit) const {
    const auto [a, b] = chunks_[chunk];
    for (std::size_t c = b; c < points_.size(); ++c) {
      if (const int size = class_size({a, b, static_cast<Index>(c)}); size > 0) {
        visit(LatticeTriangle{{points_[a], points_[b], points_[c]}, size});
      }
    }
  }

 private:
  using Index = std::uint16_t;
  using Triple = std::array<Index, 3>;

  // The size of the class if the triple, in ascending order, is its first image; else 0.
  int class_size(const Triple& triple) const {
    // The first image begins with the smallest index that any of its points can be taken to.
    if (lowest_image_[triple[2]] < triple[0]) return 0;
    int fixed = 0;
    for (const std::vector<Index>& symmetry : symmetries_) {
      Triple image = {symmetry[triple[0]], symmetry[triple[1]], symmetry[triple[2]]};
      if (image[0] > image[1]) std::swap(image[0], image[1]);
      if (image[1] > image[2]) std::swap(image[1], image[2]);
      if (image[0] > image[1]) std::swap(image[0], image[1]);
      if (image < triple) return 0;
      fixed += image == triple ? 1 : 0;
    }
    return static_cast<int>(symmetries_.size()) / fixed;
  }

  void add_symmetries();

  DepthRange depth_;
  std::vector<LatticePoint> points_;            // in lexicographic order
  std::vector<std::vector<Index>> symmetries_;  // permutations of the points, the identity too
  std::vector<Index> lowest_image_;             // of each point
  std::vector<std::array<Index, 2>> chunks_;    // the first two points of their triangles
};

// Named lattices, by size (points, triangles, classes for the depth range gl):
//   small   {-2, -1, 0, 1, 2}^3 x {-1, 0, 1}                         375      8859500    581274
//   medium  {-2, -1, 0, 1, 2}^3 x {-1, 0, 1/2, 1, 2}                 625     40885625   2673030
//   full    {-2, -1, -1/2, 0, 1/2, 1, 2}^3 x {-1, 0, 1/2, 1, 2}     1715    842171330  53480200
std::span<const std::string_view> lattice_names();
// Pre-condition: the name is one of lattice_names().
Lattice named_lattice(std::string_view name);

}  // namespace clipscope::experiments
