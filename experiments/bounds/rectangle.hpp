// SPDX-License-Identifier: GPL-3.0-or-later
//
// The screen rectangles of single solids: as computed in float from corners that a float matrix
// product gives, and exactly.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bounds/solid.hpp"
#include "spaces/bounds/sphere_rectangle.hpp"

namespace clipscope::experiments::bounds {

// Which part of a solid is bounded.
enum class Part {
  in_front,     // w > 0
  beyond_near,  // and before the near plane
  on_screen     // and within -1 <= x, y <= 1
};

// The computed rectangle, outwards. Of a sphere it contains the exact one. Of other solids it
// contains that of the corners as they are rounded to float; bounds of a point set are those of its
// axis box.
ScreenRectangle<float> rectangle_of(const Region& region, const Solid& solid, Part part);

// Left, bottom, right and top of the exact solid under the exact matrix, each rounded once to
// double; infinite where it has no end. None where nothing is visible.
using ExactRectangle = std::optional<ScreenRectangle<double>>;

// Errors: none. Pre-conditions: the solid is no sphere; the part is not on_screen.
ExactRectangle exact_rectangle(const Region& region, const Solid& solid, Part part);

struct RectangleRow {
  std::string solid, part, unit, left, bottom, right, top;

  static constexpr std::string_view kName = "bounds_rectangles";
  static constexpr std::string_view kTitle = "Screen rectangles";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Computed outwards in float from the corners that a float matrix product gives, of spheres from the matrix as given; exact: from the matrix and the solid as given. -: nothing is visible. px: y points down."};
  static constexpr auto columns() {
    using R = RectangleRow;
    return std::tuple(column("solid", &R::solid), column("part", &R::part),
                      column("unit", "in", &R::unit), column("x_from", "x from", &R::left),
                      column("y_from", "y from", &R::bottom), column("x_to", "x to", &R::right),
                      column("y_to", "y to", &R::top));
  }
};

// The rows of a solid; in px too, where there is a viewport of so many px.
std::vector<RectangleRow> rectangle_rows(const Region& region, const Solid& solid,
                                         const std::optional<std::array<double, 2>>& viewport);

}  // namespace clipscope::experiments::bounds
