// SPDX-License-Identifier: GPL-3.0-or-later
//
// The comparison that a hunt ranks by: an answer against that of the same method in a wider scalar,
// in doubles. It costs a hundredth of the exact one, is right but next to where vertices come and
// go, and decides nothing: what it puts first is compared with the exact answer.
#pragma once

#include <array>
#include <vector>

#include "experiments/hunt/measure.hpp"

namespace clipscope::experiments::hunt {

// A polygon's numbers as doubles: x y z 1/w, then attributes; repeated vertices once.
class Sketch {
 public:
  Sketch() = default;
  explicit Sketch(const PolygonView& polygon);
  // Of the exact answer.
  explicit Sketch(const TruthPolygon& truth);

  std::size_t size() const { return stride_ == 0 ? 0 : numbers_.size() / stride_; }
  const double* operator[](std::size_t i) const { return numbers_.data() + i * stride_; }
  std::size_t stride() const { return stride_; }
  bool is_finite() const { return is_finite_; }

 private:
  void drop_repeats();

  std::size_t stride_ = 0;
  bool is_finite_ = true;
  std::vector<double> numbers_;
};

// What seems to have become of a triangle: the errors where it has as many vertices, and a category
// that is exact, vertex_count, missing, extra, not_finite or one of those without an answer. Of the
// attributes none is known to be the largest.
Errors sketched_errors(const PolygonView& polygon, const Sketch& answer, const Sketch& wide);

// The measure `crack` of a triangle and its neighbour, whose edge goes from the vertices 0 and 1 to
// 1 and 0. Each comes with the answer in a wider scalar or the exact one, which says by the
// attribute `third`, the barycentric coordinate of the third vertex, what lies on the edge. 0 where
// either has another number of vertices than that.
struct Side {
  const Sketch& answer;
  const Sketch& wide;
};
double crack_between(const Side& triangle, const Side& neighbour, std::size_t third);

}  // namespace clipscope::experiments::hunt
