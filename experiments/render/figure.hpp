// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figure: the tested clipper's picture on the left, on the right where and by how much it is
// wrong, beneath both a legend with counts and a colour scale; and writing it to a file.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "experiments/render/heat_map.hpp"
#include "experiments/render/image.hpp"
#include "experiments/render/rasterizer.hpp"

namespace clipscope::experiments {

struct PictureOptions {
  double cells_per_unit = 8;  // checkerboard cells per unit of u and of v
};

// The picture that a person looks at, of the frame buffer's size, shaded with a checkerboard: see
// picture.cpp. Silhouettes are left as the rasterizer decided them.
Image shade(const FrameBuffer& buffer, const PictureOptions& options = {});

// ASCII; what is too long is set smaller.
struct FigureTitles {
  std::string scene;              // "canyon, view 2"
  std::string clipper;            // "homogeneous/sutherland_hodgman"
  std::string scalar;             // "float"
  std::string against = "exact";  // what the heat map compares with
};

struct Figure {
  const FrameBuffer* tested = nullptr;  // never null when composed or written
  const HeatMap* heat_map = nullptr;    // null: the picture alone
  FigureTitles titles;
  PictureOptions picture;
};

// The figure as an image on white. Small buffers are enlarged by a whole factor, so that text fits.
// Pre-condition: the heat map has the size of the tested buffer.
// Throws OutputError if there is no font (see canvas.hpp).
Image compose(const Figure& figure);

struct CaptionedImage {
  std::string caption;  // ASCII
  Image image;
};

// Pictures in a row on white, each under its caption, the last one a heat map with its scale
// beneath.
// Pre-condition: at least one panel; all images have the same size, at least 320 px wide.
// Throws OutputError if there is no font.
Image compose_row(const std::string& title, std::span<const CaptionedImage> panels,
                  const HeatMap& map);

// Throws UsageError, naming the option --out, unless the path ends in .png or .exr (in any case).
void check_image_path(const std::filesystem::path& path);

// Writes the figure by the path's extension:
//   .png  the composed figure, 8 bit sRGB
//   .exr  the data, pixel for pixel, in 32-bit float channels: R G B (the picture, linear light),
//         depth, inv_w, u, v, facing (1 front, -1 back, 0 nothing), triangle (-1: none; exact below
//         2^24); with a heat map also heat.R heat.G heat.B, error (in texels), fate (the
//         number of the PixelFate)
// The file appears complete or not at all: it is written beside its place under the name with
// ".partial" appended, and renamed.
// Throws UsageError as check_image_path, OutputError with path and reason if it can't be written.
void write_image(const std::filesystem::path& path, const Figure& figure);

// Writes an image as 8 bit sRGB PNG, complete or not at all. Pre-condition: the path ends in .png.
// Throws OutputError with path and reason if it can't be written.
void write_png(const std::filesystem::path& path, const Image& image, const std::string& title);

}  // namespace clipscope::experiments
