// SPDX-License-Identifier: GPL-3.0-or-later
//
// Single solids, as a user names them, against one view volume: what each bounding volume around
// them answers, and the exact answer beside it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/table/row.hpp"
#include "reference/overlap.hpp"
#include "spaces/bounds/enclose.hpp"
#include "spaces/bounds/separating_axes.hpp"

namespace clipscope::experiments::bounds {

// A view volume: in float for what is tested, exactly for what is true.
struct Region {
  DepthRange depth = DepthRange::minus_one_to_one;
  MatrixRows<float> rows;  // of the matrix to clip space
  CullingPlanes<float> planes;
  CullingHull<float> hull;
  std::vector<reference::LinearForm> half_spaces;
};

// The exact frustum, in view space; its rows are those of its rounded matrix. Pre-condition:
// is_valid(frustum).
Region region_of(const Frustum<float>& frustum);
// What the matrix as given cuts out, in the space that it leads from. The hull of a singular matrix
// is not known.
Region region_of(DepthRange depth, const MatrixRows<float>& rows);

enum class SolidKind { box, sphere, obb, points, polygon };

struct Solid {
  std::string name;  // what its rows are headed with
  SolidKind kind = SolidKind::points;
  // box x0 y0 z0 x1 y1 z1; sphere x y z r; obb centre and three half axes; else x y z per point.
  std::vector<float> numbers;
};

// The solid of a line "KIND NUMBER ...". Pre-condition: finite numbers. Errors: InputError naming
// the place, what was given and what is expected, for another kind, a wrong count, a box inside out
// and a negative radius.
Solid solid_of(const std::string& place, std::string_view kind, std::vector<float> numbers);
std::string_view kind_names();  // "box, sphere, ...", for messages and help

// The points of a polygon or point set.
std::vector<Vec3<float>> points_of(const Solid& solid);
// Points whose convex hull the solid is. Pre-condition: it is no sphere.
std::vector<reference::ExactPoint> exact_hull(const Solid& solid);

using Volume = std::variant<AxisBox<float>, Sphere<float>, OrientedBox<float>>;

struct Bound {
  std::string name;
  Volume volume;
};

// A box, a sphere or an oriented box is its own bound; around points there are three.
std::vector<Bound> bounds_around(std::span<const Vec3<float>> points);
std::vector<Bound> bounds_of(const Solid& solid);

// Rejected, accepted or neither, exactly.
Visibility exact_answer(const Region& region, const Volume& volume);
// Of the convex hull of the points of a polygon or point set, else of the solid itself.
Visibility exact_answer(const Region& region, const Solid& solid);
// Of triangles, three points each: rejected or accepted if all are.
Visibility exact_answer(const Region& region, std::span<const Vec3<float>> corners);

struct AnswerRow {
  std::string solid, bound, by_planes, by_axes, exact, content, needless;

  static constexpr std::string_view kName = "bounds_answers";
  static constexpr std::string_view kTitle = "Bounding volumes against the view volume";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "planes: by the planes and the box of the view volume; axes: then by every separating axis; exact: of the bound itself, in exact arithmetic; content: of what it bounds.",
      "needless: who says `look closer` where exact arithmetic settles the bound."};
  static constexpr auto columns() {
    using R = AnswerRow;
    return std::tuple(column("solid", &R::solid), column("bound", &R::bound),
                      column("by_planes", "planes", &R::by_planes),
                      column("by_axes", "axes", &R::by_axes), column("exact", &R::exact),
                      column("content", &R::content), column("needless", &R::needless));
  }
};

AnswerRow answer_row(const Region& region, const std::string& solid, const Bound& bound,
                     Visibility content);

}  // namespace clipscope::experiments::bounds
