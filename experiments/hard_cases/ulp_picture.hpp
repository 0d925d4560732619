// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture of an ulp grid: the exact signs and those of each predicate side by side, wrong ones
// marked, counts beneath, a legend.
//
// Colours differ in lightness by steps that remain in grey print, and stay at least 25 apart in
// CIELAB also with simulated protanopia, deuteranopia and tritanopia (Machado, Oliveira and
// Fernandes, 2009).
#pragma once

#include "experiments/catalogue/ulp_grid.hpp"
#include "experiments/render/image.hpp"

namespace clipscope::experiments::hard_cases {

// The colour of a point: by its exact sign if the computed one is right, else by what is wrong.
Rgb sign_colour(int computed, int exact);

// One pixel per point, the first row at the bottom. Pre-condition: both maps have the same size.
Image sign_image(const SignMap& computed, const SignMap& exact);

// All panels: the exact signs first, then one for each predicate of the grid. Throws OutputError
// without a font (see render/canvas.hpp).
Image ulp_picture(const UlpGrid& grid);

}  // namespace clipscope::experiments::hard_cases
