// SPDX-License-Identifier: GPL-3.0-or-later
//
// Variants: a batch of triangles, changed in ways that a clipper may be asked about once more,
// since the right answer to each follows from the answer before.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "experiments/contestants/batch.hpp"

namespace clipscope::experiments {

inline constexpr int kScaleExponent = 8;

// A batch of triangles with numbers of its own, in double.
class Variant {
 public:
  explicit Variant(const Batch& original);
  // Other triangles of the same kind. Pre-condition: a whole number of them.
  Variant(const Batch& description, std::vector<double> numbers);
  Variant(const Variant&) = delete;  // the batch refers to the numbers
  Variant& operator=(const Variant&) = delete;
  Variant(Variant&&) = default;
  Variant& operator=(Variant&&) = default;

  const Batch& batch() const { return batch_; }
  std::span<const double> numbers() const { return numbers_; }
  Batch& batch() { return batch_; }
  // Number i of a vertex: its position, then its attributes.
  double& number(std::size_t triangle, std::size_t vertex, std::size_t i) {
    return numbers_[(3 * triangle + vertex) * batch_.stride() + i];
  }
  double number(std::size_t triangle, std::size_t vertex, std::size_t i) const {
    return numbers_[(3 * triangle + vertex) * batch_.stride() + i];
  }

 private:
  std::vector<double> numbers_;
  Batch batch_;
};

// Whether a triangle's numbers, and those of its matrix or frustum, are such that no product of a
// few of them over- or underflows: each |x| in [2^-40, 2^40] or 0. Of each triangle.
std::vector<char> room_of(const Batch& batch);

// Each triangle begins with another of its vertices.
Variant rotated(const Batch& batch, std::size_t by);

// All triangles that have room times 2^kScaleExponent, in a volume that is scaled with them.
Variant scaled(const Batch& batch, const std::vector<char>& has_room);

// Attributes have one value at all vertices of a triangle; clip distances stay as they are.
Variant with_constants(const Batch& batch, const std::vector<double>& values);

// The last attribute is 0 at the first two vertices and `mark` at the third.
// Pre-condition: no clip distance is the last attribute.
Variant marked(const Batch& batch, const std::vector<char>& has_room, double mark);

// In place of each triangle that has room the one on the other side of the edge from its first to
// its second vertex, with its third vertex across; as floats where they shall be.
Variant neighbours(const Batch& batch, const std::vector<char>& has_room, bool as_floats);

// The last triangle first.
Variant reversed(const Batch& batch);

// One triangle alone.
Variant alone(const Batch& batch, std::size_t triangle);

}  // namespace clipscope::experiments
