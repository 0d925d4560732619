// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error budget: one answer's way from the exact polygon to the rounded one, a stage at a time.
//
// A stage is the polygon that comes out if everything up to it is rounded as the clipper rounds and
// everything after it is exact. Two stages in a row differ by one part; the parts sum to the total,
// vertex by vertex and coordinate by coordinate:
//
//   clip space   T_frustum | matrix | transform | cut    | divide = the answer
//   view space   T_frustum | cut    | matrix | transform | divide = the answer
//   CVV          T_frustum | matrix | transform | divide | cut    = the answer
//
//   matrix     T_matrix: the matrix rounded to the scalar, all else exact
//   transform  T_clip of the transformed vertices
//   cut        clip space: the clipper's polygon before its divide, divided exactly
//              view space: the clipper's view-space polygon, projected exactly
//   divide     CVV: the divided vertices, cut exactly
//
// The polygons after a cut come from the contestant under Contract::cut. The distance matrix
// divides sums whose weights are not 1; its `cut` is the rounding of weights and of weighted sums.
// There is no budget where a stage has other vertices than the answer, and none for methods that do
// not cut, promise less than all of a triangle, or cut by other planes. CVV clippers have one for
// triangles in front of the near plane alone: others are cut both before and after the divide.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/table/statistics.hpp"
#include "reference/exact_clip.hpp"
#include "reference/fraction.hpp"
#include "reference/truth.hpp"

namespace clipscope::experiments::budget {

enum class Part { matrix, transform, cut, divide, total };
inline constexpr std::array kParts = {Part::matrix, Part::transform, Part::cut, Part::divide,
                                      Part::total};
constexpr std::array<std::string_view, 5> names_of(Part) {
  return {"matrix", "transform", "cut", "divide", "total"};
}

enum class StageOrder { none, view_space, clip_space, cvv };

// The folder of a clipper and its promise tell its order: a bound that grows with w_max / w_min
// means that it cuts after the divide.
constexpr StageOrder stage_order(std::string_view clipper, const Promise& promise) {
  const bool cuts = promise.covers && promise.domain != Promise::Domain::all_or_nothing;
  const bool after_divide = promise.amplification == Promise::Amplification::w_ratio;
  if (!cuts || promise.correctly_rounded) return StageOrder::none;  // nothing is rounded on the way
  if (clipper.starts_with("view/")) return StageOrder::view_space;
  if (clipper.starts_with("cvv/")) return StageOrder::cvv;
  return after_divide ? StageOrder::none : StageOrder::clip_space;
}

// x, y, z, 1/w of each vertex, exactly.
using StagePolygon = std::vector<std::array<reference::Fraction, 4>>;

// The stages of an answer, from T_frustum to the answer itself, their vertices in its order; and
// the part that leads to each but the first.
struct Stages {
  std::vector<StagePolygon> polygons;
  std::vector<Part> parts;
};

// What a part adds to one triangle's error: the largest over its vertices.
struct PartError {
  double px = 0;   // in x and y, on a screen of 3840 x 2160
  double ulp = 0;  // over x, y, z and 1/w, in the scalar's own ulp at the exact value
};
using PartErrors = std::array<PartError, kParts.size()>;  // by part

PartErrors errors_of(const Stages& stages, const Format& format);

// What all contestants in a scalar have in common on one view: the input, and the three truths.
class StagedView {
 public:
  // In float or double. The exact polygons are computed here, in parallel.
  StagedView(const Format& format, const View& view, std::vector<SceneTriangle> triangles);

  const std::vector<SceneTriangle>& triangles() const { return triangles_; }
  bool is_visible(std::size_t triangle) const { return truths_[triangle][0].size() >= 3; }

  // The contestant's answers; and its polygons after the cut, where that is not the last step.
  Answers answers(const Contestant& contestant) const;
  Answers cuts(const Contestant& contestant) const;

  // Nothing where there is no budget. `after_cut`: of the same triangle.
  std::optional<Stages> stages(const Contestant& contestant, std::size_t triangle,
                               const PolygonView& answer, const PolygonView& after_cut) const;

 private:
  StagePolygon cut_after_divide(std::size_t triangle) const;
  // A view-space polygon by the exact frustum, by the rounded matrix, by the scalar's transform.
  std::array<StagePolygon, 3> projected(const PolygonView& polygon) const;

  const Format& format_;
  View view_;
  std::vector<SceneTriangle> triangles_;
  std::function<Vec4<double>(const Vec4<double>&)> to_clip_;  // as the scalar rounds it, from x y z
  reference::Truth frustum_truth_, matrix_truth_;
  std::vector<ClipTriangle<double, 0>> transformed_;  // the scalar's numbers
  std::vector<std::array<StagePolygon, 3>> truths_;   // T_frustum, T_matrix, T_clip
};

// The budget over all triangles of a scene. They are split in parallel and tallied in order: the
// result does not depend on the threads.
struct Tally {
  struct Errors {
    LogHistogram px, ulp;  // one value per triangle with a budget
  };
  std::array<Errors, kParts.size()> parts;
  std::int64_t triangles = 0;  // with a budget
  std::int64_t left_out = 0;   // visible, but without one
  // The triangle with the largest total [px]: view and number in the mesh.
  std::size_t worst_view = 0, worst_triangle = 0;

  const Errors& part(Part p) const { return parts[static_cast<std::size_t>(p)]; }
};

// Contestants in float and double, as far as these are selected, whose clipper has a budget. The
// other scalars have no rounding to speak of.
Contestants budget_contestants(std::string_view clipper_pattern,
                               const std::vector<std::string>& scalars);

// One tally per contestant, over evenly spaced triangles; advances progress by triangle and
// contestant. Pre-condition: contestants of budget_contestants.
std::vector<Tally> measure(const Scene& scene, const Contestants& contestants,
                           std::size_t triangles_per_view, Progress& progress);

}  // namespace clipscope::experiments::budget
