// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene drawn without perspective correction, drawn with it, and the difference: side by side.
//
// Affine drawing is the rasterizer's with 1/w = 1 at every vertex and the true attributes there. What it shows
// depends on the pieces that a triangle is drawn in.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/pictures/draw_scene.hpp"
#include "experiments/render/heat_map.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

// The pieces that a triangle is drawn in.
enum class Pieces {
  near_cut,  // what the near plane leaves of it, however far it reaches beyond the screen
  clipped,   // what all planes leave of it
  split  // that, each triangle of the fan cut into 64 by halving its edges in view space three times
};

std::string_view pieces_name(Pieces pieces);

struct AffinePicture {
  FrameBuffer affine, correct;
  HeatMap error;  // of the texture coordinates, in texels of a 1024-texel texture
};

AffinePicture draw_affine(const Scene& scene, const View& view, Pieces pieces,
                          const PictureSize& size);

// Writes the three as one PNG with titles and the scale of the error into the folder, and names it.
// Throws OutputError.
Picture write_affine_picture(const std::filesystem::path& folder, const Scene& scene, Pieces pieces,
                             const AffinePicture& picture);

}  // namespace clipscope::experiments
