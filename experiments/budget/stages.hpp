// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error budget: one answer's way from the exact polygon to the rounded one, a stage at a time.
//
// A stage is the polygon that comes out if everything up to it is rounded as the clipper rounds and
// everything after it is exact. Two stages in a row differ by one part; the parts sum to the total, vertex
// by vertex and coordinate by coordinate:
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
// A polygon before the divide comes from the clipper itself, in a scalar that remembers its last quotient
// (traced.hpp); one in view space from the clipper itself with an identity for a matrix, since the
// cut reads the frustum alone. For the distance matrix, `cut` is the rounding of weights and of weighted
// sums.
// There is no budget where a stage has other vertices than the answer, and none for methods that do not
// cut, promise less than all of a triangle, or cut by other planes. Of CVV clippers only triangles in front
// of the near plane have one: others are cut both before and after the divide.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/budget/traced.hpp"
#include "experiments/contestants/contestant.hpp"
#include "reference/fraction.hpp"

namespace clipscope::experiments {

enum class BudgetPart { matrix, transform, cut, divide, total };
inline constexpr std::array kBudgetParts = {BudgetPart::matrix, BudgetPart::transform,
                                            BudgetPart::cut, BudgetPart::divide, BudgetPart::total};
std::string_view budget_part_name(BudgetPart part);

enum class StageOrder { none, view_space, clip_space, cvv };

// By the folder of the clipper and what it promises: a bound that grows with w_max / w_min means that it
// cuts after the divide.
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

// What a part adds to one triangle's error: the largest over its vertices.
struct PartError {
  double px = 0;   // in x and y, on a screen of 3840 x 2160
  double ulp = 0;  // over x, y, z and 1/w, in the scalar's own ulp at the exact value
};

using PartErrors = std::array<PartError, kBudgetParts.size()>;

// What all contestants in a scalar have in common on one view: the input, and the three truths.
// T is float or double.
template <class T>
class StagedView {
 public:
  using Answer = std::span<const NdcVertex<T, kSceneAttributes>>;

  // The exact polygons are computed here, in parallel.
  StagedView(const View& view, std::vector<SceneTriangle> triangles);

  const Projection<T>& projection() const { return projection_; }
  const std::vector<ViewTriangle<T, kSceneAttributes>>& triangles() const { return triangles_; }
  const SceneTriangle& source(std::size_t triangle) const { return source_[triangle]; }
  bool is_visible(std::size_t triangle) const { return truths_[triangle][0].size() >= 3; }

  // The stages of an answer, from T_frustum to the answer itself, their vertices in its order; and the
  // part that leads to each but the first. Nothing where there is no budget.
  struct Stages {
    std::vector<StagePolygon> polygons;
    std::vector<BudgetPart> parts;
  };
  std::optional<Stages> stages(const Contestant<T>& contestant, std::size_t triangle,
                               Answer answer) const;

  // By part; nothing where there is no budget.
  std::optional<PartErrors> errors(const Contestant<T>& contestant, std::size_t triangle,
                                   Answer answer) const;

 private:
  StagePolygon before_divide(std::string_view clipper, std::size_t triangle, Answer answer) const;
  std::vector<Vec3<T>> view_polygon(const Contestant<T>& contestant, std::size_t triangle) const;
  StagePolygon cut_after_divide(std::size_t triangle) const;

  Projection<T> projection_;
  Projection<Traced<T>> traced_projection_;
  reference::Truth frustum_truth_, matrix_truth_;
  std::vector<SceneTriangle> source_;
  std::vector<ViewTriangle<T, kSceneAttributes>> triangles_;
  std::vector<std::array<StagePolygon, 3>> truths_;  // T_frustum, T_matrix, T_clip
};

}  // namespace clipscope::experiments
