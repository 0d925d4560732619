// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture that a person looks at: a frame buffer shaded with a checkerboard.
//
// Cells come from texture coordinates u and v, filtered over the pixel (Quilez, "Box filtering a
// checkers pattern", 2013), tinted softly by the third attribute. Light falls from the viewer's upper
// left on the plane that 1/w (in a parallel projection, depth) spans around the pixel. Back faces
// are reddish, so that a flip is seen; pixels without a finite value are black.
// Does not guarantee: photometric truth; the field of view that shading assumes is about 60 degrees.
#pragma once

#include "experiments/render/image.hpp"
#include "experiments/render/rasterizer.hpp"

namespace clipscope::experiments {

struct PictureOptions {
  double cells_per_unit = 8;  // checkerboard cells per unit of u and of v
};

// An image of the frame buffer's size. Silhouettes are left as the rasterizer decided them.
Image shade(const FrameBuffer& buffer, const PictureOptions& options = {});

}  // namespace clipscope::experiments
