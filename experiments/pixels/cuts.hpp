// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts: how far the border that clipping makes may be from the plane that makes it.
//
// A clipper finds a cut between vertices i and j as t between 0 and 1, from either end, and with an
// error of kClip operations of 1 part in 10^5 of 1 (accuracy.hpp). The vertex that it makes is then
// on the edge, but beside the plane: its signed distance d is not 0, but as large as that part of
// |d_j - d_i|, and divided by its w in the window. If i is far away that is a lot: where an edge
// from x = -10^8 to 10^8 is cut at w = 1, x / w is 1 up to some thousand; in float still up to 10.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

class Cuts {
 public:
  // Of a triangle.
  Cuts(const DrawCall& call, std::span<const std::uint32_t> vertices);

  // How far the border may be from the plane that has the distances d at the three vertices: a
  // bound of |d / w| there. 0 if none is outside.
  double slack(const std::array<double, 3>& d) const;

 private:
  // A vertex of the clipped polygon: its barycentric coordinates in clip space, and w.
  struct Corner {
    std::array<double, 3> weights = {};
    double w = 0;
  };

  std::array<double, 3> w_ = {};
  std::vector<Corner> corners_;
};

}  // namespace clipscope::experiments
